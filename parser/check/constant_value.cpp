#include "parser/check/constant_value.h"

#include <limits>
#include <vector>

#include "base/assert.h"
#include "parser/builtins/prelude.h"
#include "parser/values/operators.h"

namespace lray::parser {

namespace {

std::optional<Value> signed_number(const UnaryExpr& expr, Arena& arena) {
    const std::optional<Value> operand = constant_value(*expr.operand, arena);
    if (!operand || !operand->is(ValueKind::number)) return std::nullopt;
    if (expr.op == TokenKind::minus) return Value::of(-operand->number);
    if (expr.op == TokenKind::plus) return operand;
    return std::nullopt;
}

std::optional<Value> list(const ListExpr& expr, Arena& arena) {
    std::vector<Value> elements;
    for (const Expr* element : expr.elements) {
        const std::optional<Value> value = constant_value(*element, arena);
        if (!value) return std::nullopt;
        elements.push_back(*value);
    }
    return make_list(elements, arena);
}

std::optional<Value> packed_list(const PackedListExpr& expr, Arena& arena) {
    if (!expr.is_nested) return Value::of_numbers({expr.values, expr.count});
    if (!expr.has_wide_rows()) {
        Value value;
        value.kind = ValueKind::rows;
        value.width = static_cast<std::uint8_t>(expr.width);
        value.count = expr.count;
        value.numbers = expr.values;
        return value;
    }
    std::vector<Value> rows;
    for (std::size_t i = 0; i < expr.count; ++i) {
        rows.push_back(Value::of_numbers({expr.values + i * expr.width, expr.width}));
    }
    return make_list(rows, arena);
}

}  // namespace

std::optional<Value> constant_value(const Expr& expr, Arena& arena) {
    switch (expr.kind) {
        case ExprKind::number:
            return Value::of(static_cast<const NumberExpr&>(expr).value);
        case ExprKind::boolean:
            return Value::of(static_cast<const BooleanExpr&>(expr).value);
        case ExprKind::string:
            return Value::of_string(static_cast<const StringExpr&>(expr).value, expr.span.source);
        case ExprKind::color:
            return Value::of_color(static_cast<const ColorExpr&>(expr).rgba);
        case ExprKind::name: {
            const NameExpr& name = static_cast<const NameExpr&>(expr);
            if (name.meaning != Meaning::constant) return std::nullopt;
            return prelude_constants()[name.index].value;
        }
        case ExprKind::unary:
            return signed_number(static_cast<const UnaryExpr&>(expr), arena);
        case ExprKind::list:
            return list(static_cast<const ListExpr&>(expr), arena);
        case ExprKind::packed_list:
            return packed_list(static_cast<const PackedListExpr&>(expr), arena);
        case ExprKind::error:
        case ExprKind::binary:
        case ExprKind::conditional:
        case ExprKind::call:
        case ExprKind::index:
        case ExprKind::member:
        case ExprKind::block:
        case ExprKind::comprehension:
        case ExprKind::function:
            return std::nullopt;
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::parser
