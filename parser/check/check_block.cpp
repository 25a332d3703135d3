#include "parser/check/check_block.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "base/suggest_name.h"
#include "parser/blocks/schemas.h"
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
        items(block_.body.items);
        if (!schema_.takes_any_string) {
            // Of two forms mixed, what else is missing depends on which one is meant.
            if (!forms() && use_ == BlockUse::make) required();
            if (schema_.kind == BlockKind::material) unused_by_model();
        }
        return is_right_;
    }

 private:
    Diagnostic& error(Code code, Span span, std::string message) {
        is_right_ = false;
        return diagnostics_.error(code, span, std::move(message));
    }

    std::string head() const { return std::string(sources_.text(block_.head->span)); }

    void items(std::span<Item* const> list);
    void property(const PropertyItem& item);
    void unknown_property(const PropertyItem& item, std::string_view name);
    void child(const BlockItem& item);
    void set_once(Span& first, Span now, std::string_view name);
    void no_children(Span span);
    bool forms();
    void required();
    void unused_by_model();
    std::string_view model() const;

    const BlockSchema& schema_;
    const BlockExpr& block_;
    BlockUse use_;
    const Symbols& symbols_;
    const Sources& sources_;
    Diagnostics& diagnostics_;
    std::array<Span, kMaxProperties> set_{};
    std::array<Span, kCommonPropertyCount> set_common_{};
    std::vector<std::pair<Symbol, Span>> set_strings_;
    const Expr* model_ = nullptr;
    bool is_right_ = true;
};

void BlockCheck::items(std::span<Item* const> list) {
    for (const Item* item : list) {
        switch (item->kind) {
            case ItemKind::property:
                property(static_cast<const PropertyItem&>(*item));
                break;
            case ItemKind::block:
                child(static_cast<const BlockItem&>(*item));
                break;
            case ItemKind::literals:
                if (!schema_.has_children || use_ == BlockUse::instance) no_children(item->span);
                break;
            case ItemKind::include: {
                const IncludeItem& include = static_cast<const IncludeItem&>(*item);
                if (schema_.has_children) items(include.items);
                break;
            }
            case ItemKind::let:
            case ItemKind::call:
            case ItemKind::assignment:
            case ItemKind::import:
            case ItemKind::function:
            case ItemKind::conditional:
            case ItemKind::for_loop:
            case ItemKind::while_loop:
            case ItemKind::break_loop:
            case ItemKind::continue_loop:
            case ItemKind::return_value:
                break;
        }
    }
}

void BlockCheck::property(const PropertyItem& item) {
    const std::string_view name = symbols_.text(item.name);
    if (schema_.takes_any_string) {
        for (const auto& [symbol, span] : set_strings_) {
            if (symbol != item.name) continue;
            error(Code::E0402, item.name_span, fmt::format("`{}` is set twice", name))
                .with_label(span, "first set here");
            return;
        }
        set_strings_.emplace_back(item.name, item.name_span);
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
        set_once(set_common_[place.slot], item.name_span, name);
    } else {
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
    if (schema_.is_placeable) {
        for (const PropertySchema& property : common_properties()) names.push_back(property.name);
    }
    Diagnostic& diagnostic = error(Code::E0401, item.name_span,
                                   fmt::format("{} has no property `{}`", schema_.name, name));
    const std::string_view habit = property_habit(name);
    const bool habit_is_ours = !habit.empty() && find_place(schema_, habit).schema != nullptr;
    const bool is_surface =
        !habit_is_ours && schema_.is_placeable &&
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

void BlockCheck::child(const BlockItem& item) {
    const Expr& child_head = *item.block->head;
    const BlockSchema* made = nullptr;
    if (child_head.kind == ExprKind::name) {
        const NameExpr& name = static_cast<const NameExpr&>(child_head);
        if (name.meaning == Meaning::unknown) return;
        made = find_block(name.symbol);
    }
    if (made == nullptr) {  // a value: the evaluator knows what it is
        if (!schema_.has_children || use_ == BlockUse::instance) no_children(child_head.span);
        return;
    }
    if (made->kind == BlockKind::material && schema_.is_placeable) {
        constexpr std::size_t kMaterial = static_cast<std::size_t>(CommonProperty::material);
        set_once(set_common_[kMaterial], child_head.span, "material");
    } else if (!schema_.has_children || use_ == BlockUse::instance) {
        no_children(child_head.span);
    } else if (!made->is_placeable) {
        error(Code::E0412, child_head.span,
              fmt::format("`{}` stands at the top level, not in a {}", made->name, schema_.name));
    }
}

// Returns true if two forms are mixed.
bool BlockCheck::forms() {
    const std::span<const PropertySchema> properties = schema_.properties;
    std::size_t first = properties.size();
    std::size_t second = properties.size();
    for (std::size_t slot = properties.size(); slot-- > 0;) {
        if (set_[slot].is_nowhere()) continue;
        if (properties[slot].form == Form::first) first = slot;
        if (properties[slot].form == Form::second) second = slot;
    }
    if (first == properties.size() || second == properties.size()) return false;
    const bool first_is_later = set_[first].offset > set_[second].offset;
    const Span later = set_[first_is_later ? first : second];
    const Span earlier = set_[first_is_later ? second : first];
    error(
        Code::E0411, later,
        fmt::format("give `{}` or `{}`, not both", properties[first].name, properties[second].name))
        .with_label(earlier, "the other one");
    return true;
}

void BlockCheck::required() {
    bool has_second = false;
    bool has_first_required = false;
    const std::span<const PropertySchema> properties = schema_.properties;
    for (std::size_t slot = 0; slot < properties.size(); ++slot) {
        const bool is_set = !set_[slot].is_nowhere();
        has_second = has_second || (is_set && properties[slot].form == Form::second);
        has_first_required = has_first_required ||
                             (properties[slot].form == Form::first && properties[slot].is_required);
    }
    std::vector<std::string_view> missing;
    for (std::size_t slot = 0; slot < properties.size(); ++slot) {
        const PropertySchema& property = properties[slot];
        const bool is_needed =
            property.is_required && set_[slot].is_nowhere() &&
            (property.form == Form::any || (property.form == Form::second && has_second) ||
             (property.form == Form::first && !has_second));
        if (is_needed) missing.push_back(property.name);
    }
    if (missing.empty()) return;
    std::string names;
    for (std::size_t i = 0; i < missing.size(); ++i) {
        const std::string_view joint = i == 0 ? "" : i + 1 == missing.size() ? " and " : ", ";
        names += fmt::format("{}`{}`", joint, missing[i]);
    }
    if (schema_.kind == BlockKind::mesh && !has_second) {
        names = "`file`, or `positions` and `triangles`";
    }
    error(Code::E0406, block_.head->span, fmt::format("{} needs {}", schema_.name, names));
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
    if (!schema.is_placeable) return {};
    const std::span<const PropertySchema> common = common_properties();
    slot = find_property(common, name);
    if (slot == common.size()) return {};
    return {&common[slot], slot, true};
}

bool check_block(const BlockSchema& schema, const BlockExpr& block, BlockUse use,
                 const Symbols& symbols, const Sources& sources, Diagnostics& diagnostics) {
    return BlockCheck(schema, block, use, symbols, sources, diagnostics).check();
}

}  // namespace lray::parser
