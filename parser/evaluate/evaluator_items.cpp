// Evaluates what stands in a file or between braces: names, properties, transform steps.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "base/assert.h"
#include "parser/blocks/property_type.h"
#include "parser/check/check_block.h"
#include "parser/evaluate/evaluator_state.h"
#include "parser/values/transform_values.h"

namespace lray::parser {

namespace {

/// True if degrees look like a familiar angle in radians: a multiple of pi / 12, written to at
/// least three decimals, or computed.
bool looks_like_radians(double angle, const Expr& expr) {
    if (expr.kind == ExprKind::number && static_cast<const NumberExpr&>(expr).has_unit) {
        return false;
    }
    const double steps = angle * (12.0 / std::numbers::pi);
    const double nearest = std::round(steps);
    const bool is_literal = expr.kind == ExprKind::number || expr.kind == ExprKind::unary;
    // 3.14 to 3.14159...: a literal is cut short, a computed one is as exact as a double.
    const double tolerance = is_literal ? 6e-4 : 1e-12;
    return nearest != 0.0 && std::fabs(nearest) <= 24.0 &&
           std::fabs(steps - nearest) <= tolerance * std::fabs(nearest) &&
           angle != std::round(angle);
}

}  // namespace

void evaluate(std::span<Item* const> items, const Checked& checked, const Symbols& symbols,
              const Sources& sources, FileLoader& files, const LoadLimits& limits,
              scene::Scene& scene, Diagnostics& diagnostics) {
    Evaluator(checked, symbols, sources, files, limits, scene, diagnostics).run(items);
}

void Evaluator::run(std::span<Item* const> list) {
    OpenBlock root(block_schema(BlockKind::group), Span{});
    items(list, root);
    scene_.root = add_node(root, scene::NodeKind::group, scene_.groups.size(), nullptr);
    scene_.groups.push_back({std::move(root.children)});
}

void Evaluator::items(std::span<Item* const> list, OpenBlock& open) {
    for (const Item* item : list) {
        switch (item->kind) {
            case ItemKind::let: {
                const LetItem& let = static_cast<const LetItem&>(*item);
                variables_[let.slot] = eval(*let.value);
                break;
            }
            case ItemKind::property:
                property(static_cast<const PropertyItem&>(*item), open);
                break;
            case ItemKind::block:
                placed_block(static_cast<const BlockItem&>(*item), open);
                break;
            case ItemKind::literals: {
                const LiteralsItem& literals = static_cast<const LiteralsItem&>(*item);
                for (std::uint32_t i = 0; i < literals.count; ++i) {
                    open.children.push_back(scene::NodeId(literals.first_node + i));
                }
                break;
            }
            case ItemKind::include:
                items(static_cast<const IncludeItem&>(*item).items, open);
                break;
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
                break;  // errors, reported by the checker
        }
    }
}

void Evaluator::property(const PropertyItem& item, OpenBlock& open) {
    const Value value = eval(*item.value);
    if (open.schema.takes_any_string) {
        if (value.is(ValueKind::string)) {
            if (!take_bytes(budget_, value.count, item.value->span, diagnostics_)) return;
            scene_.info.emplace_back(symbols_.text(item.name), value.string());
        } else if (!value.is(ValueKind::poison)) {
            error(Code::E0301, item.value->span,
                  fmt::format("`{}` needs a string, this is {}", symbols_.text(item.name),
                              describe(value)));
        }
        return;
    }
    if (open.schema.takes_any_value) return;
    const PropertyPlace place = find_place(open.schema, symbols_.text(item.name));
    LRAY_ASSERT(place.schema != nullptr);
    const Value fitted =
        fit(*place.schema, value, item.value->span, diagnostics_, name_of(*item.value, sources_));
    if (fitted.is(ValueKind::poison)) {
        open.is_poisoned = true;
    } else if (place.is_common) {
        common_property(static_cast<CommonProperty>(place.slot), fitted, *item.value, open);
    } else {
        open.values.set(place.slot, fitted);
        open.value_spans[place.slot] = item.value->span;
    }
}

void Evaluator::common_property(CommonProperty property, const Value& value, const Expr& expr,
                                OpenBlock& open) {
    if (property == CommonProperty::material) {
        open.material_id = scene::MaterialId(value.made->id);
    } else if (property == CommonProperty::visible) {
        open.visible = value.boolean;
    } else if (property == CommonProperty::casts_shadow) {
        open.casts_shadow = value.boolean;
    } else {
        step(property, value, expr, open);
    }
}

void Evaluator::step(CommonProperty step, const Value& value, const Expr& expr, OpenBlock& open) {
    const bool is_turn = step == CommonProperty::rotate_x || step == CommonProperty::rotate_y ||
                         step == CommonProperty::rotate_z;
    if (is_turn && looks_like_radians(value.number, expr)) {
        const double meant = std::round(value.number * (12.0 / std::numbers::pi)) * 15.0;
        diagnostics_.warning(Code::W1302, expr.span,
                             fmt::format("angles are degrees; did you mean `{}` or `{}rad`?",
                                         format_number(meant), format_number(value.number)));
    }
    if (step == CommonProperty::translate && value.vec3() != DVec3{0.0}) {
        open.has_translated = true;
        open.scale_after_translate = Span{};
    } else if (step == CommonProperty::scale && open.has_translated) {
        open.scale_after_translate = expr.span;
    }
    open.transform = with_step(open.transform, step, value);
    open.has_steps = true;
    if (!open.transform.is_finite()) {
        error(Code::E0310, expr.span, "this step makes the transform larger than numbers go");
        open.is_poisoned = true;
    } else if (!open.transform.inverse()) {
        error(Code::E0310, expr.span, "this transform cannot be inverted: it flattens the object");
        open.is_poisoned = true;
    }
}

void Evaluator::placed_block(const BlockItem& item, OpenBlock& open) {
    const BlockExpr& expr = *item.block;
    const Head made_of = head(expr, true);
    if (made_of.schema == nullptr) return;
    if (made_of.schema->kind == BlockKind::material) {  // inline: `sphere { material { } }`
        const Value value = block_value(expr);
        if (value.is(ValueKind::material)) {
            open.material_id = scene::MaterialId(value.made->id);
        } else {
            open.is_poisoned = true;
        }
        return;
    }
    if (!made_of.schema->is_placeable) {
        view_block(*made_of.schema, expr);
        return;
    }
    std::optional<scene::NodeId> child;
    if (made_of.made != nullptr) {
        child = instance(expr, *made_of.made);
    } else {
        OpenBlock inner(*made_of.schema, expr.span);
        items(expr.body.items, inner);
        child = make_node(inner, expr.label);
    }
    if (child) open.children.push_back(*child);
}

}  // namespace lray::parser
