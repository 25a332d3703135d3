#include "parser/check/check_block.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/suggest_name.h"
#include "parser/blocks/schemas.h"
#include "parser/check/check_complete.h"
#include "parser/syntax/lexer.h"

namespace lray::parser {

namespace {

class BlockCheck {
 public:
    BlockCheck(const BlockSchema& schema, const BlockExpr& block, BlockUse use,
               const Symbols& symbols, const Sources& sources, Diagnostics& diagnostics)
        : schema_(schema),
          block_(block),
          use_(use),
          symbols_(symbols),
          sources_(sources),
          diagnostics_(diagnostics) {}

    bool check() {
        items(block_.body.items, true);
        if (!schema_.takes_any_string && !schema_.takes_any_value) {
            // Of two forms mixed, what else is missing depends on which one is meant.
            if (!has_conditions_) {
                is_right_ = check_complete(schema_, set_, block_.head->span, use_ == BlockUse::make,
                                           diagnostics_) &&
                            is_right_;
            }
            if (schema_.kind == BlockKind::material && !has_conditions_) unused_by_model();
        }
        return is_right_;
    }

 private:
    Diagnostic& error(Code code, Span span, std::string message) {
        is_right_ = false;
        return diagnostics_.error(code, span, std::move(message));
    }

    std::string head() const { return std::string(sources_.text(block_.head->span)); }

    void items(std::span<Item* const> list, bool is_certain);
    void property(const PropertyItem& item, bool is_certain);
    void unknown_property(const PropertyItem& item, std::string_view name);
    void child(const BlockItem& item, bool is_certain);
    void set_once(Span& first, Span now, std::string_view name);
    void no_children(Span span);
    void unused_by_model();
    std::string_view model() const;

    const BlockSchema& schema_;
    const BlockExpr& block_;
    BlockUse use_;
    const Symbols& symbols_;
    const Sources& sources_;
    Diagnostics& diagnostics_;
    std::array<Span, kMaxProperties> set_{};
    bool has_conditions_ = false;  // what is set in the end is seen when it runs
    std::array<Span, kCommonPropertyCount> set_common_{};
    std::unordered_map<Symbol, Span> set_fields_;
    const Expr* model_ = nullptr;
    bool is_right_ = true;
};

void BlockCheck::items(std::span<Item* const> list, bool is_certain) {
    has_conditions_ = has_conditions_ || !is_certain;
    for (const Item* item : list) {
        switch (item->kind) {
            case ItemKind::property:
                property(static_cast<const PropertyItem&>(*item), is_certain);
                break;
            case ItemKind::block:
                child(static_cast<const BlockItem&>(*item), is_certain);
                break;
            case ItemKind::conditional: {
                const ConditionalItem& choice = static_cast<const ConditionalItem&>(*item);
                items(choice.then_body.items, false);
                items(choice.else_body.items, false);
                break;
            }
            case ItemKind::for_loop:
                items(static_cast<const ForItem&>(*item).body.items, false);
                break;
            case ItemKind::while_loop:
                items(static_cast<const WhileItem&>(*item).body.items, false);
                break;
            case ItemKind::literals:
                if (!schema_.has_children || use_ == BlockUse::instance) no_children(item->span);
                break;
            case ItemKind::include: {
                const IncludeItem& include = static_cast<const IncludeItem&>(*item);
                if (schema_.has_children) items(include.items, is_certain);
                break;
            }
            case ItemKind::let:
            case ItemKind::call:
            case ItemKind::assignment:
            case ItemKind::import:
            case ItemKind::file_view:
            case ItemKind::function:
            case ItemKind::break_loop:
            case ItemKind::continue_loop:
            case ItemKind::return_value:
                break;
        }
    }
}

void BlockCheck::property(const PropertyItem& item, bool is_certain) {
    const std::string_view name = symbols_.text(item.name);
    if (schema_.takes_any_string || schema_.takes_any_value) {
        if (!is_certain) return;
        const auto [first, is_new] = set_fields_.emplace(item.name, item.name_span);
        if (is_new) return;
        error(Code::E0402, item.name_span, fmt::format("`{}` is set twice", name))
            .with_label(first->second, "first set here");
        return;
    }
    const PropertyPlace place = find_place(schema_, name);
    if (place.schema == nullptr && was_reported(name)) {
        is_right_ = false;
    } else if (place.schema == nullptr) {
        unknown_property(item, name);
    } else if (use_ == BlockUse::instance && !place.is_common) {
        error(Code::E0401, item.name_span,
              fmt::format("`{}` is an instance; its `{}` is fixed", head(), name))
            .with_help(
                fmt::format("make another one: `let big = {} {{ {}: ... }}`", schema_.name, name));
    } else if (place.is_common) {
        if (is_transform_step(static_cast<CommonProperty>(place.slot))) return;
        if (is_certain) set_once(set_common_[place.slot], item.name_span, name);
    } else if (is_certain) {
        set_once(set_[place.slot], item.name_span, name);
        if (schema_.kind == BlockKind::material && name == "model") model_ = item.value;
    }
}

void BlockCheck::set_once(Span& first, Span now, std::string_view name) {
    if (first.is_nowhere()) {
        first = now;
        return;
    }
    error(Code::E0402, now, fmt::format("`{}` is set twice", name))
        .with_label(first, "first set here");
}

void BlockCheck::unknown_property(const PropertyItem& item, std::string_view name) {
    if (is_not_yet_available(schema_.kind, name)) {
        error(Code::E0120, item.name_span,
              fmt::format("`{}` is not available in this version of lray", name));
        return;
    }
    std::vector<std::string_view> names;
    for (const PropertySchema& property : schema_.properties) names.push_back(property.name);
    for (std::size_t i = 0; i < kCommonPropertyCount; ++i) {
        const bool is_taken = takes(schema_, static_cast<CommonProperty>(i));
        if (is_taken) names.push_back(common_properties()[i].name);
    }
    Diagnostic& diagnostic = error(Code::E0401, item.name_span,
                                   fmt::format("{} has no property `{}`", schema_.name, name));
    const std::string_view habit = property_habit(name, schema_);
    const bool habit_is_ours = !habit.empty() && find_place(schema_, habit).schema != nullptr;
    const bool is_surface =
        !habit_is_ours && takes(schema_, CommonProperty::material) &&
        (habit == "diffuse" || find_property(schemas::kMaterial, name) < schemas::kMaterial.size());
    if (habit_is_ours) {
        diagnostic.with_hint(fmt::format("here it is called `{}`", habit));
    } else if (is_surface) {
        const std::string_view ours = habit == "diffuse" ? habit : name;
        diagnostic.with_hint(
            fmt::format("it belongs to the material: `material {{ {}: ... }}`", ours));
    } else if (!suggest_name(diagnostic, name, names) && schema_.properties.size() <= 8 &&
               !schema_.properties.empty()) {
        std::string list;
        for (const PropertySchema& property : schema_.properties) {
            list += fmt::format(" {}", property.name);
        }
        diagnostic.with_help(fmt::format("{} has:{}", schema_.name, list));
    }
}

void BlockCheck::no_children(Span span) {
    if (use_ == BlockUse::instance) {
        error(Code::E0412, span, fmt::format("`{}` is an instance; nothing can be added", head()));
        return;
    }
    error(Code::E0412, span, fmt::format("a {} has no children", schema_.name))
        .with_help(schema_.is_placeable ? "put both in a `group`"
                                        : "it holds properties only: `name: value`");
}

void BlockCheck::child(const BlockItem& item, bool is_certain) {
    const Expr& child_head = *item.block->head;
    const BlockSchema* made = nullptr;
    if (child_head.kind == ExprKind::name) {
        const NameExpr& name = static_cast<const NameExpr&>(child_head);
        if (name.meaning == Meaning::unknown) return;
        if (name.meaning == Meaning::block) {
            made = &block_schema(static_cast<BlockKind>(name.index));
        }
    }
    if (made == nullptr) {  // a value: the evaluator knows what it is
        if (!schema_.has_children || use_ == BlockUse::instance) no_children(child_head.span);
        return;
    }
    if (made->kind == BlockKind::material && takes(schema_, CommonProperty::material)) {
        constexpr std::size_t kMaterial = static_cast<std::size_t>(CommonProperty::material);
        if (is_certain) set_once(set_common_[kMaterial], child_head.span, "material");
    } else if (!schema_.has_children || use_ == BlockUse::instance) {
        no_children(child_head.span);
    } else if (is_texture(made->kind)) {
        return;  // the checker says that it cannot be placed
    } else if (!made->is_placeable) {
        error(Code::E0412, child_head.span,
              fmt::format("`{}` stands at the top level, not in a {}", made->name, schema_.name));
    }
}

std::string_view BlockCheck::model() const {
    if (model_ == nullptr) return "blinn_phong";
    return model_->kind == ExprKind::string ? static_cast<const StringExpr*>(model_)->value
                                            : std::string_view{};
}

// Coefficients that the reflection model does not look at.
void BlockCheck::unused_by_model() {
    if (use_ != BlockUse::make) return;
    const std::string_view chosen = model();
    const auto is_one_of_models = [&](std::initializer_list<std::string_view> models) {
        for (const std::string_view known : models) {
            if (chosen == known) return true;
        }
        return false;
    };
    if (!is_one_of_models({"lambert", "phong", "blinn_phong", "cook_torrance", "ward"})) return;
    const auto warn = [&](std::string_view name, bool is_used, std::string_view instead) {
        const Span span = set_[find_property(schemas::kMaterial, name)];
        if (is_used || span.is_nowhere()) return;
        diagnostics_.warning(Code::W1401, span,
                             fmt::format("`{}` is not used by {}; {}", name, chosen, instead));
    };
    const bool is_microfacet = is_one_of_models({"cook_torrance", "ward"});
    const bool is_phong = is_one_of_models({"phong", "blinn_phong"});
    warn("specular", chosen != "lambert", "lambert has no highlight");
    warn("shininess", is_phong,
         is_microfacet ? "did you mean `roughness`?" : "lambert has no highlight");
    warn("roughness", is_microfacet,
         is_phong ? "did you mean `shininess`, or `model: \"cook_torrance\"`?"
                  : "lambert has no highlight");
    warn("fresnel", chosen == "cook_torrance", "it belongs to `model: \"cook_torrance\"`");
}

}  // namespace

PropertyPlace find_place(const BlockSchema& schema, std::string_view name) {
    std::size_t slot = find_property(schema.properties, name);
    if (slot < schema.properties.size()) return {&schema.properties[slot], slot, false};
    const std::span<const PropertySchema> common = common_properties();
    slot = find_property(common, name);
    if (slot == common.size() || !takes(schema, static_cast<CommonProperty>(slot))) return {};
    return {&common[slot], slot, true};
}

void report_placed_value(BlockKind kind, std::string_view head, Span span,
                         Diagnostics& diagnostics) {
    const std::string_view name = block_schema(kind).name;
    const bool is_built_in = head == name;
    if (kind == BlockKind::material) {
        Diagnostic& diagnostic =
            diagnostics.error(Code::E0408, span, "a material cannot be placed");
        if (is_built_in) {
            diagnostic.with_help(
                "give it a name: `let red = material { ... }`, then `material: red` in a shape");
        } else {
            diagnostic.with_hint(fmt::format("use `material: {}` in a shape", head));
        }
    } else if (kind == BlockKind::record) {
        diagnostics.error(Code::E0408, span, "a record cannot be placed")
            .with_help("give it a name: `let r = record { ... }`");
    } else {
        diagnostics.error(Code::E0408, span, "a texture cannot be placed")
            .with_help(is_built_in
                           ? fmt::format("use it in a material: `diffuse: {} {{ ... }}`", head)
                           : fmt::format("use it in a material: `diffuse: {}`", head));
    }
}

bool check_block(const BlockSchema& schema, const BlockExpr& block, BlockUse use,
                 const Symbols& symbols, const Sources& sources, Diagnostics& diagnostics) {
    return BlockCheck(schema, block, use, symbols, sources, diagnostics).check();
}

}  // namespace lray::parser
