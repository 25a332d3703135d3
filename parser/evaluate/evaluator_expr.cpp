// Evaluates expressions.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "base/assert.h"
#include "parser/blocks/schemas.h"
#include "parser/builtins/builtins.h"
#include "parser/builtins/prelude.h"
#include "parser/check/constant_value.h"
#include "parser/evaluate/evaluator_state.h"

namespace lray::parser {

Value Evaluator::eval(const Expr& expr) {
    if (!take_steps(budget_, 1, expr.span, diagnostics_)) return Value::poison();
    switch (expr.kind) {
        case ExprKind::error:
            return Value::poison();
        case ExprKind::number:
        case ExprKind::boolean:
        case ExprKind::string:
        case ExprKind::color:
        case ExprKind::packed_list:
            return *constant_value(expr, arena_);
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
            return block_value(static_cast<const BlockExpr&>(expr));
        case ExprKind::comprehension:
        case ExprKind::function:
            return Value::poison();
    }
    LRAY_ASSERT(false);
}

Value Evaluator::name(const NameExpr& expr) {
    switch (expr.meaning) {
        case Meaning::global:
            return variables_[expr.index];
        case Meaning::constant:
            return prelude_constants()[expr.index].value;
        case Meaning::builtin:
            error(Code::E0301, expr.span,
                  fmt::format("`{0}` is a function; call it: `{0}(...)`", text(expr)));
            return Value::poison();
        case Meaning::colors:
            error(Code::E0301, expr.span, "`colors` needs a name: `colors.red`");
            return Value::poison();
        case Meaning::local:
        case Meaning::function:
        case Meaning::component:
        case Meaning::module:
        case Meaning::time:
        case Meaning::frame:
        case Meaning::block:
        case Meaning::unknown:
            return Value::poison();
    }
    LRAY_ASSERT(false);
}

Value Evaluator::unary(const UnaryExpr& expr) {
    if (expr.op == TokenKind::kw_not) {
        const std::optional<bool> operand = condition(*expr.operand);
        return operand ? Value::of(!*operand) : Value::poison();
    }
    return apply_sign(expr.op, eval(*expr.operand), expr.span, arena_, budget_, diagnostics_);
}

Value Evaluator::binary(const BinaryExpr& expr) {
    if (is_one_of(expr.op, TokenKind::kw_and, TokenKind::kw_or)) return logical(expr);
    const Value left = eval(*expr.left);
    const Value right = eval(*expr.right);
    const bool is_division = is_one_of(expr.op, TokenKind::slash, TokenKind::percent);
    const bool is_zero = is_division && right.is(ValueKind::number) && right.number == 0.0;
    if (is_zero && !left.is(ValueKind::poison)) {
        Diagnostic& diagnostic = error(Code::E0503, expr.op_span, "division by zero");
        explain_zero(*expr.right, diagnostic);
        return Value::poison();
    }
    return apply(expr.op, left, right, expr.op_span, arena_, budget_, diagnostics_);
}

// "`n` is 0, defined here"
void Evaluator::explain_zero(const Expr& divisor, Diagnostic& diagnostic) {
    if (divisor.kind != ExprKind::name) return;
    const NameExpr& variable = static_cast<const NameExpr&>(divisor);
    if (variable.meaning != Meaning::global) return;
    diagnostic.with_label(checked_.variables[variable.index],
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

Value Evaluator::call(const CallExpr& expr) {
    LRAY_ASSERT(expr.callee->kind == ExprKind::name);
    const NameExpr& callee = static_cast<const NameExpr&>(*expr.callee);
    if (callee.meaning != Meaning::builtin) return Value::poison();
    const Builtin& builtin = builtins()[callee.index];
    Call made{{}, {}, {}, expr.span, arena_, budget_, diagnostics_, *this, {}, {}};
    std::size_t position = 0;
    for (const Argument& argument : expr.arguments) {
        std::size_t place = position++;
        if (argument.name != kNoSymbol) {
            place = 0;
            while (builtin.parameters[place].name != symbols_.text(argument.name)) ++place;
        }
        made.arguments[place] = eval(*argument.value);
        made.spans[place] = argument.value->span;
    }
    return call_builtin(builtin, made);
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
    const Value object = eval(*expr.object);
    if (object.is(ValueKind::poison)) return object;
    if (object.is(ValueKind::material)) return material_member(expr, *object.made);
    if (object.is(ValueKind::node)) return node_member(expr, *object.made);
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
    const Value& value = (*made.values)[slot];
    if (!value.is(ValueKind::none)) return value;
    const scene::Material& material = scene_.materials[made.id];
    const PropertySchema& property = made.schema->properties[slot];
    const auto color = [&](const Color& linear) {
        const std::array<double, 4> rgba = {linear.x, linear.y, linear.z, 1.0};
        return Value::of_color(arena_.copy(std::span<const double>(rgba)).data());
    };
    using namespace schemas;
    if (property.type == PropertyType::boolean) return Value::of(property.default_value[0] != 0.0);
    if (property.type == PropertyType::option) return Value::of_string("blinn_phong", kNoSource);
    if (slot == schemas::slot(kMaterial, "ambient")) {
        return color(material.ambient.value_or(material.diffuse));
    }
    if (slot == schemas::slot(kMaterial, "specular")) {
        const bool is_microfacet = material.model == scene::ReflectionModel::cook_torrance ||
                                   material.model == scene::ReflectionModel::ward;
        return color(material.specular.value_or(Color{is_microfacet ? 1.0f : 0.2f}));
    }
    if (property.type == PropertyType::color) {
        return color(Color{made.values->color(slot)});
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
    const Value& value = (*made.values)[slot];
    if (!value.is(ValueKind::none)) return value;
    const PropertySchema& property = properties[slot];
    const std::span<const double> fallback = property.default_value;
    if (property.default_text.starts_with('[')) {
        const bool is_plane = property.type == PropertyType::size2;
        return Value::of_numbers(fallback.first(is_plane ? 2 : 3));
    }
    if (property.type == PropertyType::boolean) return Value::of(fallback[0] != 0.0);
    if (property.type == PropertyType::number && !property.default_text.empty()) {
        return Value::of(fallback[0]);
    }
    error(Code::E0409, expr.name_span,
          fmt::format("`{}` is not set in this {}", field, made.schema->name));
    return Value::poison();
}

Value Evaluator::list(const ListExpr& expr) {
    const std::uint64_t size = expr.elements.size() * sizeof(Value);
    if (!take_bytes(budget_, size, expr.span, diagnostics_)) return Value::poison();
    std::vector<Value> elements;
    elements.reserve(expr.elements.size());
    for (const Expr* element_expr : expr.elements) elements.push_back(eval(*element_expr));
    return make_list(elements, arena_);
}

}  // namespace lray::parser
