// Evaluates the properties of a block and its transform steps.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

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

/// True if a value fits as it is: the usual case, told apart without the ceremony of messages.
bool fits_plainly(const PropertySchema& property, const Value& value) {
    const PropertyType type = property.type;
    if (type == PropertyType::point) return value.is_vector(3);
    if (type == PropertyType::number || type == PropertyType::angle) {
        return value.is(ValueKind::number) && property.range.contains(value.number);
    }
    if (type == PropertyType::material) return value.is(ValueKind::material);
    if (type == PropertyType::any) return !value.is(ValueKind::poison);
    return false;
}

}  // namespace

void Evaluator::property(PropertyItem& item, OpenBlock& open) {
    const Value value = eval(*item.value);
    if (open.schema.takes_any_string || open.schema.takes_any_value) {
        free_field(item, value, open);
        return;
    }
    if (item.known_schema != &open.schema) {
        const PropertyPlace place = find_place(open.schema, symbols_.text(item.name));
        LRAY_ASSERT(place.schema != nullptr);
        item.known_schema = &open.schema;
        item.property = place.schema;
        item.slot = static_cast<std::uint32_t>(place.slot);
        item.is_common = place.is_common;
    }
    const Value fitted = fits_plainly(*item.property, value)
                             ? value
                             : fit(*item.property, value, item.value->span, diagnostics_,
                                   name_of(*item.value, sources_));
    if (fitted.is(ValueKind::poison)) {
        ++failures_;
        open.is_poisoned = true;
    } else if (item.is_common) {
        common_property(static_cast<CommonProperty>(item.slot), fitted, item, open);
    } else if (set_once(open.value_spans[item.slot], item)) {
        open.values.set(item.slot, fitted);
    } else {
        open.is_poisoned = true;
    }
}

// A field of `info` or of a record.
void Evaluator::free_field(const PropertyItem& item, const Value& value, OpenBlock& open) {
    if (value.is(ValueKind::poison)) {
        ++failures_;
        open.is_poisoned = true;
        return;
    }
    if (open.schema.kind == BlockKind::record) {
        const std::size_t cost = open.record.unindexed_count();
        if (!take_steps(budget_, cost, item.name_span, diagnostics_)) return;
        open.record.set(item.name, value);
        return;
    }
    if (!value.is(ValueKind::string)) {
        ++failures_;
        error(Code::E0301, item.value->span,
              fmt::format("`{}` needs a string, this is {}", symbols_.text(item.name),
                          describe(value)));
        return;
    }
    if (!take_kept_bytes(budget_, value.count, item.value->span, diagnostics_)) return;
    scene_.info.emplace_back(symbols_.text(item.name), value.string());
}

// What is set in loops and choices is seen only here.
bool Evaluator::set_once(Span& first, const PropertyItem& item) {
    if (first.is_nowhere()) {
        first = item.value->span;
        return true;
    }
    ++failures_;
    error(Code::E0402, item.name_span, fmt::format("`{}` is set twice", symbols_.text(item.name)))
        .with_label(first, "first set here");
    return false;
}

void Evaluator::common_property(CommonProperty property, const Value& value,
                                const PropertyItem& item, OpenBlock& open) {
    if (is_transform_step(property)) {
        step(property, value, *item.value, open);
        return;
    }
    const std::size_t place =
        static_cast<std::size_t>(property) - static_cast<std::size_t>(CommonProperty::material);
    if (!set_once(open.common_spans[place], item)) {
        open.is_poisoned = true;
    } else if (property == CommonProperty::material) {
        open.material_id = scene::MaterialId(value.made->id);
    } else if (property == CommonProperty::visible) {
        open.visible = value.boolean;
    } else {
        open.casts_shadow = value.boolean;
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
    if (value.is(ValueKind::list) && !take_steps(budget_, value.count, expr.span, diagnostics_)) {
        return;
    }
    open.transform = with_step(open.transform, step, value);
    open.has_steps = true;
    if (!open.transform.is_finite()) {
        error(Code::E0310, expr.span, "this step makes the transform larger than numbers go");
        open.is_poisoned = true;
        ++failures_;
    } else if (!open.transform.inverse()) {
        error(Code::E0310, expr.span, "this transform cannot be inverted: it flattens the object");
        open.is_poisoned = true;
        ++failures_;
    }
}

}  // namespace lray::parser
