// Evaluates expressions.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "base/assert.h"
#include "base/did_you_mean.h"
#include "parser/blocks/schemas.h"
#include "parser/builtins/builtins.h"
#include "parser/builtins/prelude.h"
#include "parser/check/constant_value.h"
#include "parser/evaluate/evaluator_state.h"

namespace lray::parser {

// Only of wide rows is anything made.
Value Evaluator::packed_list(const PackedListExpr& expr) {
    if (expr.has_wide_rows()) {
        const std::uint64_t size = std::uint64_t{expr.count} * sizeof(Value);
        const bool is_paid =
            take_share(expr.count, expr.span) && take_bytes(budget_, size, expr.span, diagnostics_);
        if (!is_paid) return Value::poison();
    }
    return *constant_value(expr, arena());
}

Value Evaluator::eval(const Expr& expr) {
    if (budget_.steps == 0) [[unlikely]] {
        take_steps(budget_, 1, expr.span, diagnostics_);
        return Value::poison();
    }
    --budget_.steps;
    switch (expr.kind) {
        case ExprKind::error:
            return Value::poison();
        case ExprKind::number:
            return Value::of(static_cast<const NumberExpr&>(expr).value);
        case ExprKind::boolean:
            return Value::of(static_cast<const BooleanExpr&>(expr).value);
        case ExprKind::string:
        case ExprKind::color:
            return *constant_value(expr, arena());
        case ExprKind::packed_list:
            return packed_list(static_cast<const PackedListExpr&>(expr));
        case ExprKind::name:
            return name(static_cast<const NameExpr&>(expr));
        case ExprKind::unary:
            return unary(static_cast<const UnaryExpr&>(expr));
        case ExprKind::binary:
            return binary(static_cast<const BinaryExpr&>(expr));
        case ExprKind::conditional:
            return conditional(static_cast<const ConditionalExpr&>(expr));
        case ExprKind::call:
            return call(static_cast<const CallExpr&>(expr));
        case ExprKind::index:
            return index(static_cast<const IndexExpr&>(expr));
        case ExprKind::member:
            return member(static_cast<const MemberExpr&>(expr));
        case ExprKind::list:
            return list(static_cast<const ListExpr&>(expr));
        case ExprKind::block:
            // What the evaluator learns of a block is kept in it.
            return block_value(const_cast<BlockExpr&>(static_cast<const BlockExpr&>(expr)));
        case ExprKind::comprehension:
            return comprehension(static_cast<const ComprehensionExpr&>(expr));
        case ExprKind::function:
            return function_value(checked_.uses[static_cast<const FunctionExpr&>(expr).use]);
    }
    LRAY_ASSERT(false);
}

Value Evaluator::name(const NameExpr& expr) {
    switch (expr.meaning) {
        case Meaning::local: {
            const Value& value = frame_[expr.index];
            return value.is(ValueKind::none) ? no_value_yet(expr) : value;
        }
        case Meaning::global: {
            const Value& value = globals_[expr.index];
            return value.is(ValueKind::none) ? no_value_yet(expr) : value;
        }
        case Meaning::constant:
            return prelude_constants()[expr.index].value;
        case Meaning::function:
            return function_value(checked_.uses[expr.index]);
        case Meaning::builtin: {
            FunctionValue value;
            value.builtin = expr.index;
            if (!take_bytes(budget_, sizeof value, expr.span, diagnostics_)) return Value::poison();
            return Value::of_function(arena().make<FunctionValue>(value), 1);
        }
        case Meaning::time:
            return Value::of(environment_.time);
        case Meaning::frame:
            return Value::of(environment_.settings.frame);
        case Meaning::colors:
            return failed(Code::E0301, expr.span, "`colors` needs a name: `colors.red`");
        case Meaning::component:
        case Meaning::module:
        case Meaning::block:
        case Meaning::unknown:
            return Value::poison();
    }
    LRAY_ASSERT(false);
}

// A function that stands above what it names was called before that had its value.
Value Evaluator::no_value_yet(const NameExpr& expr) {
    error(Code::E0202, expr.span,
          fmt::format("`{}` has no value yet when this runs", symbols_.text(expr.symbol)))
        .with_label(expr.definition, "it gets its value here");
    return Value::poison();
}

Value Evaluator::function_value(const FunctionUse& use) {
    const std::size_t count = use.capture_slots.size();
    const std::uint64_t size = sizeof(FunctionValue) + count * sizeof(Value);
    const Span span = use.function->name_span;
    if (!take_bytes(budget_, size, span, diagnostics_)) return Value::poison();
    const FunctionValue value = captured(use);
    std::uint8_t depth = 0;
    for (std::size_t i = 0; i < count; ++i) depth = std::max(depth, value.captures[i].depth());
    if (depth >= kMaxValueDepth) {
        return failed(Code::E0514, span,
                      fmt::format("values are nested more than {} deep", kMaxValueDepth));
    }
    return Value::of_function(arena().make<FunctionValue>(value),
                              static_cast<std::uint8_t>(depth + 1));
}

Value Evaluator::unary(const UnaryExpr& expr) {
    if (expr.op == TokenKind::kw_not) {
        const std::optional<bool> operand = condition(*expr.operand);
        return operand ? Value::of(!*operand) : Value::poison();
    }
    return apply_sign(expr.op, eval(*expr.operand), expr.span, arena(), budget_, diagnostics_);
}

Value Evaluator::binary(const BinaryExpr& expr) {
    using enum TokenKind;
    if (is_one_of(expr.op, kw_and, kw_or)) return logical(expr);
    const Value left = eval(*expr.left);
    if (left.is(ValueKind::poison)) return left;
    const Value right = eval(*expr.right);
    if (left.is(ValueKind::number) && right.is(ValueKind::number)) {
        const double a = left.number;
        const double b = right.number;
        double result = std::numeric_limits<double>::quiet_NaN();
        if (expr.op == plus) result = a + b;
        if (expr.op == minus) result = a - b;
        if (expr.op == star) result = a * b;
        if (expr.op == slash) result = a / b;
        if (expr.op == less) return Value::of(a < b);
        if (expr.op == less_equal) return Value::of(a <= b);
        if (expr.op == greater) return Value::of(a > b);
        if (expr.op == greater_equal) return Value::of(a >= b);
        if (expr.op == equal_equal) return Value::of(a == b);
        if (expr.op == not_equal) return Value::of(a != b);
        if (std::isfinite(result)) return Value::of(result);
    }
    return binary_slow(expr, left, right);
}

Value Evaluator::binary_slow(const BinaryExpr& expr, const Value& left, const Value& right) {
    const bool is_division = is_one_of(expr.op, TokenKind::slash, TokenKind::percent);
    const bool is_zero = is_division && right.is(ValueKind::number) && right.number == 0.0;
    if (is_zero && !left.is(ValueKind::poison)) {
        Diagnostic& diagnostic = error(Code::E0503, expr.op_span, "division by zero");
        explain_zero(*expr.right, diagnostic);
        return Value::poison();
    }
    return apply(expr.op, left, right, expr.op_span, arena(), budget_, diagnostics_);
}

// "`n` is 0, defined here"
void Evaluator::explain_zero(const Expr& divisor, Diagnostic& diagnostic) {
    if (divisor.kind != ExprKind::name) return;
    const NameExpr& variable = static_cast<const NameExpr&>(divisor);
    if (variable.definition.is_nowhere()) return;
    diagnostic.with_label(variable.definition,
                          fmt::format("`{}` is 0, defined here", text(divisor)));
}

std::optional<bool> Evaluator::condition(const Expr& expr) {
    const Value value = eval(expr);
    if (value.is(ValueKind::boolean)) return value.boolean;
    if (!value.is(ValueKind::poison)) {
        error(Code::E0301, expr.span,
              fmt::format("a condition is true or false, this is {}", describe(value)))
            .with_help("compare it: `a > 0`, `a == b`");
    }
    return std::nullopt;
}

Value Evaluator::logical(const BinaryExpr& expr) {
    const std::optional<bool> left = condition(*expr.left);
    if (!left) return Value::poison();
    const bool decides = expr.op == TokenKind::kw_or;
    if (*left == decides) return Value::of(decides);
    const std::optional<bool> right = condition(*expr.right);
    return right ? Value::of(*right) : Value::poison();
}

Value Evaluator::conditional(const ConditionalExpr& expr) {
    const std::optional<bool> chosen = condition(*expr.condition);
    if (!chosen) return Value::poison();
    return eval(*chosen ? *expr.then_value : *expr.else_value);
}

Value Evaluator::index(const IndexExpr& expr) {
    const Value object = eval(*expr.object);
    const Value at = eval(*expr.index);
    if (object.is(ValueKind::poison) || at.is(ValueKind::poison)) return Value::poison();
    if (!object.is_list()) {
        error(Code::E0301, expr.object->span,
              fmt::format("only lists have elements, `{}` is {}", text(*expr.object),
                          describe(object)));
        return Value::poison();
    }
    if (!at.is(ValueKind::number)) {
        error(Code::E0301, expr.index->span,
              fmt::format("an index is a number, this is {}", describe(at)));
        return Value::poison();
    }
    if (at.number != std::floor(at.number)) {
        error(Code::E0308, expr.index->span,
              fmt::format("an index is a whole number, this is {}", format_number(at.number)));
        return Value::poison();
    }
    if (at.number < 0.0 || at.number >= object.count) {
        const std::string has =
            object.count == 0 ? "is empty" : fmt::format("has elements 0 to {}", object.count - 1);
        error(Code::E0504, expr.index->span,
              fmt::format("index {}, but `{}` {}", format_number(at.number), text(*expr.object),
                          has));
        return Value::poison();
    }
    return element(object, static_cast<std::uint32_t>(at.number));
}

Value Evaluator::member(const MemberExpr& expr) {
    const std::string_view field = symbols_.text(expr.name);
    if (expr.object->kind == ExprKind::name &&
        static_cast<const NameExpr&>(*expr.object).meaning == Meaning::colors) {
        const std::optional<std::uint32_t> constant = find_constant(field);
        if (constant && prelude_constants()[*constant].value.is(ValueKind::color)) {
            return prelude_constants()[*constant].value;
        }
        error(Code::E0409, expr.name_span, fmt::format("there is no colour `{}`", field));
        return Value::poison();
    }
    if (expr.imported != nullptr) return name(*expr.imported);
    const Value object = eval(*expr.object);
    if (object.is(ValueKind::poison)) return object;
    if (object.is(ValueKind::record)) return record_member(expr, object);
    if (object.is(ValueKind::material)) return material_member(expr, *object.made);
    if (object.is(ValueKind::node) || object.is(ValueKind::texture)) {
        return node_member(expr, *object.made);
    }
    constexpr std::string_view kAxes = "xyzw";
    constexpr std::string_view kChannels = "rgba";
    const bool is_vector = object.is(ValueKind::numbers) && object.count >= 2 && object.count <= 4;
    const bool is_color = object.is(ValueKind::color);
    const std::size_t component = is_color ? kChannels.find(field) : kAxes.find(field);
    const bool has_it = field.size() == 1 && component != std::string_view::npos &&
                        component < object.count && (is_vector || is_color);
    if (has_it) return Value::of(object.numbers[component]);
    Diagnostic& diagnostic = error(Code::E0409, expr.name_span,
                                   fmt::format("{} has no field `{}`", describe(object), field));
    if (is_vector) {
        diagnostic.with_help("a vector has x, y, z and w, as far as it goes");
    } else if (is_color) {
        diagnostic.with_help("a colour has r, g, b and a");
    }
    return Value::poison();
}

Value Evaluator::material_member(const MemberExpr& expr, const Made& made) {
    const std::string_view field = symbols_.text(expr.name);
    const std::size_t slot = find_property(made.schema->properties, field);
    if (slot == made.schema->properties.size()) {
        error(Code::E0409, expr.name_span, fmt::format("a material has no field `{}`", field));
        return Value::poison();
    }
    const Value& value = made.values[slot];
    if (!value.is(ValueKind::none)) return value;
    const scene::Material& material = scene_.materials[made.id];
    const PropertySchema& property = made.schema->properties[slot];
    const auto color = [&](const Color& linear) {
        const std::array<double, 4> rgba = {linear.x, linear.y, linear.z, 1.0};
        return Value::of_color(arena().copy(std::span<const double>(rgba)).data());
    };
    using namespace schemas;
    if (property.type == PropertyType::boolean) return Value::of(property.default_value[0] != 0.0);
    if (property.type == PropertyType::option) return Value::of_string("blinn_phong", kNoSource);
    if (slot == schemas::slot(kMaterial, "ambient")) {
        const Value& diffuse = made.values[schemas::slot(kMaterial, "diffuse")];
        return diffuse.is(ValueKind::texture) ? diffuse : color(material.diffuse.constant);
    }
    if (slot == schemas::slot(kMaterial, "specular")) {
        const bool is_microfacet = material.model == scene::ReflectionModel::cook_torrance ||
                                   material.model == scene::ReflectionModel::ward;
        return color(Color{is_microfacet ? 1.0f : 0.2f});
    }
    if (property.type == PropertyType::color) {
        PropertyValues values(made.schema->properties);
        values.set(slot, value);
        return color(Color{values.color(slot)});
    }
    return Value::of(property.default_value[0]);
}

// A property of a shape: as it was set, or its default.
Value Evaluator::node_member(const MemberExpr& expr, const Made& made) {
    const std::string_view field = symbols_.text(expr.name);
    const std::span<const PropertySchema> properties = made.schema->properties;
    const std::size_t slot = find_property(properties, field);
    if (slot == properties.size()) {
        error(Code::E0409, expr.name_span,
              fmt::format("a {} has no field `{}`", made.schema->name, field));
        return Value::poison();
    }
    const Value& value = made.values[slot];
    if (!value.is(ValueKind::none)) return value;
    const PropertySchema& property = properties[slot];
    const std::span<const double> fallback = property.default_value;
    if (property.type == PropertyType::option) {
        const std::string_view quoted = property.default_text;
        return Value::of_string(quoted.substr(1, quoted.size() - 2), kNoSource);
    }
    if (property.type == PropertyType::color) {
        const std::array<double, 4> rgba = {fallback[0], fallback[1], fallback[2], 1.0};
        return Value::of_color(arena().copy(std::span<const double>(rgba)).data());
    }
    const bool has_numbers =
        property.default_text.starts_with('[') && property.type != PropertyType::stops;
    if (has_numbers) {
        const bool is_plane = property.type == PropertyType::size2;
        return Value::of_numbers(fallback.first(is_plane ? 2 : 3));
    }
    if (property.type == PropertyType::boolean) return Value::of(fallback[0] != 0.0);
    const bool is_number = property.type == PropertyType::number ||
                           property.type == PropertyType::integer ||
                           property.type == PropertyType::angle;
    if (is_number && !property.default_text.empty()) {
        return Value::of(fallback[0]);
    }
    error(Code::E0409, expr.name_span,
          fmt::format("`{}` is not set in this {}", field, made.schema->name));
    return Value::poison();
}

Value Evaluator::record_member(const MemberExpr& expr, const Value& record) {
    if (!take_share(record.count, expr.span)) return Value::poison();
    for (std::uint32_t i = 0; i < record.count; ++i) {
        if (record.fields[i].name == expr.name) return record.fields[i].value;
    }
    std::vector<std::string_view> names;
    for (std::uint32_t i = 0; i < record.count; ++i) {
        names.push_back(symbols_.text(record.fields[i].name));
    }
    const std::string_view field = symbols_.text(expr.name);
    error(Code::E0409, expr.name_span, fmt::format("this record has no field `{}`", field))
        .with_hint(did_you_mean(field, names));
    return Value::poison();
}

Value Evaluator::list(const ListExpr& expr) {
    const std::size_t count = expr.elements.size();
    // A vector, the usual case, is put together without a detour.
    constexpr std::size_t kVector = 4;
    if (count <= kVector && count > 0) {
        std::array<Value, kVector> elements;
        bool are_numbers = true;
        for (std::size_t i = 0; i < count; ++i) {
            elements[i] = eval(*expr.elements[i]);
            are_numbers = are_numbers && elements[i].is(ValueKind::number);
        }
        if (are_numbers) {
            const std::uint64_t size = count * sizeof(double);
            if (!take_bytes(budget_, size, expr.span, diagnostics_)) return Value::poison();
            double* const numbers = static_cast<double*>(arena().allocate(size, alignof(double)));
            for (std::size_t i = 0; i < count; ++i) numbers[i] = elements[i].number;
            return Value::of_numbers({numbers, count});
        }
        return list_of({elements.data(), count}, expr.span);
    }
    std::vector<Value> elements;
    elements.reserve(count);
    for (const Expr* element_expr : expr.elements) elements.push_back(eval(*element_expr));
    return list_of(elements, expr.span);
}

Value Evaluator::list_of(std::span<const Value> elements, Span span) {
    const std::uint64_t size = elements.size() * sizeof(Value);
    if (!take_bytes(budget_, size, span, diagnostics_)) return Value::poison();
    const Value list = make_list(elements, arena());
    if (list.depth() > kMaxValueDepth) {
        return failed(Code::E0514, span,
                      fmt::format("lists are nested more than {} deep", kMaxValueDepth));
    }
    return list;
}

Value Evaluator::comprehension(const ComprehensionExpr& expr) {
    const std::optional<Sequence> from = sequence(*expr.sequence);
    if (!from) return Value::poison();
    std::vector<Value> elements;
    for (std::uint64_t i = 0; i < from->count; ++i) {
        if (!take_steps(budget_, 1, expr.span, diagnostics_)) return Value::poison();
        const Region region = memory_.begin();
        if (expr.index_name != kNoSymbol) {
            frame_[expr.index_slot] = Value::of(static_cast<double>(i));
        }
        frame_[expr.element_slot] = from->at(i);
        if (expr.condition != nullptr) {
            const std::optional<bool> is_wanted = condition(*expr.condition);
            if (!is_wanted) return Value::poison();
            if (!*is_wanted) {
                memory_.end(region);
                continue;
            }
        }
        const Value value = eval(*expr.value);
        if (value.is(ValueKind::poison)) return value;
        if (elements.size() >= budget_.max_list_size) {
            error(Code::E0514, expr.span,
                  fmt::format("a list has more than {} elements", budget_.max_list_size))
                .with_help("raise the limit with `--max-list-size N`");
            return Value::poison();
        }
        elements.push_back(memory_.end_with(region, value));
        if (!take_bytes(budget_, sizeof(Value), expr.span, diagnostics_)) return Value::poison();
    }
    return list_of(elements, expr.span);
}

}  // namespace lray::parser
