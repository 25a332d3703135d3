#include "parser/operators.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/assert.h"

namespace lray::parser {

namespace {

/// Floored modulo: the sign of the divisor.
double modulo(double a, double b) {
    const double remainder = std::fmod(a, b);
    return remainder != 0.0 && (remainder < 0.0) != (b < 0.0) ? remainder + b : remainder;
}

double arithmetic(TokenKind op, double a, double b) {
    if (op == TokenKind::plus) return a + b;
    if (op == TokenKind::minus) return a - b;
    if (op == TokenKind::star) return a * b;
    if (op == TokenKind::slash) return a / b;
    if (op == TokenKind::percent) return modulo(a, b);
    LRAY_ASSERT(op == TokenKind::caret);
    return std::pow(a, b);
}

std::string_view verb(TokenKind op) {
    if (op == TokenKind::plus) return "add";
    if (op == TokenKind::minus) return "subtract";
    if (op == TokenKind::star) return "multiply";
    if (op == TokenKind::slash) return "divide";
    if (op == TokenKind::percent) return "take the remainder of";
    return "raise";
}

bool is_numeric(const Value& value) {
    return value.is(ValueKind::number) || value.is(ValueKind::numbers);
}

Value no_result(TokenKind op, double a, double b, Span span, Diagnostics& diagnostics) {
    if (b == 0.0 && (op == TokenKind::slash || op == TokenKind::percent)) {
        diagnostics.error(Code::E0503, span, "division by zero");
    } else if (std::isnan(arithmetic(op, a, b))) {
        diagnostics.error(Code::E0503, span,
                          fmt::format("{} to the power of {} is not a real number",
                                      format_number(a), format_number(b)));
    } else {
        diagnostics.error(Code::E0503, span, "the result is too large for a number");
    }
    return Value::poison();
}

// Numbers and vectors: element by element, a number with each element.
Value numeric(TokenKind op, const Value& left, const Value& right, Span span, Arena& arena,
              Diagnostics& diagnostics) {
    const bool is_left_list = left.is(ValueKind::numbers);
    const bool is_right_list = right.is(ValueKind::numbers);
    if (!is_left_list && !is_right_list) {
        const double result = arithmetic(op, left.number, right.number);
        if (std::isfinite(result)) return Value::of(result);
        return no_result(op, left.number, right.number, span, diagnostics);
    }
    if (is_left_list && is_right_list && left.count != right.count) {
        diagnostics.error(
            Code::E0302, span,
            fmt::format("cannot {} {} and {} elements", verb(op), left.count, right.count));
        return Value::poison();
    }
    const std::uint32_t count = is_left_list ? left.count : right.count;
    double* const results =
        static_cast<double*>(arena.allocate(count * sizeof(double), alignof(double)));
    for (std::uint32_t i = 0; i < count; ++i) {
        const double a = is_left_list ? left.numbers[i] : left.number;
        const double b = is_right_list ? right.numbers[i] : right.number;
        results[i] = arithmetic(op, a, b);
        if (!std::isfinite(results[i])) return no_result(op, a, b, span, diagnostics);
    }
    return Value::of_numbers({results, count});
}

bool is_comparison_of_order(TokenKind op) {
    return is_one_of(op, TokenKind::less, TokenKind::less_equal, TokenKind::greater,
                     TokenKind::greater_equal);
}

bool compare(TokenKind op, double a, double b) {
    if (op == TokenKind::less) return a < b;
    if (op == TokenKind::less_equal) return a <= b;
    if (op == TokenKind::greater) return a > b;
    return a >= b;
}

}  // namespace

bool take_step(Budget& budget, Span span, Diagnostics& diagnostics) {
    if (budget.steps > 0) {
        --budget.steps;
        return true;
    }
    diagnostics
        .error(Code::E0512, span,
               fmt::format("evaluating the scene takes more than {} steps", budget.max_steps))
        .with_help("raise the limit with `--max-steps N`");
    return false;
}

Value apply(TokenKind op, const Value& left, const Value& right, Span span, Arena& arena,
            Budget& budget, Diagnostics& diagnostics) {
    if (left.is(ValueKind::poison) || right.is(ValueKind::poison)) return Value::poison();
    if (is_one_of(op, TokenKind::equal_equal, TokenKind::not_equal)) {
        const bool equal = is_equal(left, right, budget);
        if (budget.steps == 0 && !take_step(budget, span, diagnostics)) return Value::poison();
        return Value::of(equal == (op == TokenKind::equal_equal));
    }
    if (is_comparison_of_order(op)) {
        if (left.is(ValueKind::number) && right.is(ValueKind::number)) {
            return Value::of(compare(op, left.number, right.number));
        }
        diagnostics.error(Code::E0301, span,
                          fmt::format("only numbers have an order, these are {} and {}",
                                      describe(left), describe(right)));
        return Value::poison();
    }
    if (is_numeric(left) && is_numeric(right)) {
        return numeric(op, left, right, span, arena, diagnostics);
    }
    if (op == TokenKind::plus && left.is(ValueKind::string) && right.is(ValueKind::string)) {
        const std::uint64_t size = std::uint64_t{left.count} + right.count;
        if (arena.size() + size > budget.value_bytes) {
            diagnostics
                .error(Code::E0516, span,
                       fmt::format("the values of this scene need more than {} bytes",
                                   budget.value_bytes))
                .with_help("raise the limit with `--max-value-bytes N`");
            return Value::poison();
        }
        std::string joined(left.string());
        joined += right.string();
        return Value::of_string(arena.copy(std::string_view(joined)), left.source);
    }
    diagnostics.error(
        Code::E0301, span,
        fmt::format("cannot {} {} and {}", verb(op), describe(left), describe(right)));
    return Value::poison();
}

Value apply_sign(TokenKind op, const Value& operand, Span span, Arena& arena,
                 Diagnostics& diagnostics) {
    if (operand.is(ValueKind::poison)) return operand;
    if (!is_numeric(operand)) {
        diagnostics.error(Code::E0301, span,
                          fmt::format("a sign needs a number, this is {}", describe(operand)));
        return Value::poison();
    }
    if (op == TokenKind::plus) return operand;
    if (operand.is(ValueKind::number)) return Value::of(-operand.number);
    const std::span<double> negated =
        arena.copy(std::span<const double>(operand.numbers, operand.count));
    for (double& number : negated) number = -number;
    return Value::of_numbers(negated);
}

bool is_equal(const Value& a, const Value& b, Budget& budget) {
    if (budget.steps == 0 || a.kind != b.kind) return false;
    --budget.steps;
    switch (a.kind) {
        case ValueKind::none:
        case ValueKind::poison:
            return true;
        case ValueKind::number:
            return a.number == b.number;
        case ValueKind::boolean:
            return a.boolean == b.boolean;
        case ValueKind::string:
            return a.string() == b.string();
        case ValueKind::numbers:
        case ValueKind::color:
        case ValueKind::rows: {
            if (a.count != b.count || a.width != b.width) return false;
            const std::size_t size =
                a.is(ValueKind::rows) ? std::size_t{a.count} * a.width : a.count;
            for (std::size_t i = 0; i < size; ++i) {
                if (a.numbers[i] != b.numbers[i]) return false;
            }
            return true;
        }
        case ValueKind::list: {
            if (a.count != b.count) return false;
            for (std::uint32_t i = 0; i < a.count; ++i) {
                if (!is_equal(a.elements[i], b.elements[i], budget)) return false;
            }
            return true;
        }
        case ValueKind::transform:
            return a.transform == b.transform;
        case ValueKind::material:
        case ValueKind::node:
            return a.made == b.made;
    }
    LRAY_ASSERT(false);
}

Value make_list(std::span<const Value> elements, Arena& arena) {
    bool are_numbers = !elements.empty();
    bool are_rows = !elements.empty();
    for (const Value& value : elements) {
        if (value.is(ValueKind::poison)) return Value::poison();
        are_numbers = are_numbers && value.is(ValueKind::number);
        are_rows = are_rows && value.is(ValueKind::numbers) && value.count == elements[0].count &&
                   value.count <= 4;
    }
    if (are_numbers || are_rows) {
        std::vector<double> numbers;
        for (const Value& value : elements) {
            if (are_numbers) numbers.push_back(value.number);
            if (are_rows) numbers.insert(numbers.end(), value.numbers, value.numbers + value.count);
        }
        Value result = Value::of_numbers(arena.copy(numbers));
        if (are_rows) {
            result.kind = ValueKind::rows;
            result.width = static_cast<std::uint8_t>(elements[0].count);
            result.count = static_cast<std::uint32_t>(elements.size());
        }
        return result;
    }
    Value result;
    result.kind = ValueKind::list;
    result.count = static_cast<std::uint32_t>(elements.size());
    result.elements = arena.copy(elements).data();
    return result;
}

Value element(const Value& list, std::uint32_t index) {
    LRAY_ASSERT(list.is_list() && index < list.count);
    if (list.is(ValueKind::numbers)) return Value::of(list.numbers[index]);
    if (list.is(ValueKind::rows)) {
        return Value::of_numbers({list.numbers + std::size_t{index} * list.width, list.width});
    }
    return list.elements[index];
}

}  // namespace lray::parser
