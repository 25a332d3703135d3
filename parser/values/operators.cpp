#include "parser/values/operators.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/assert.h"
#include "parser/syntax/ast.h"

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
              Budget& budget, Diagnostics& diagnostics) {
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
    if (!take_numbers(budget, count, span, diagnostics)) return Value::poison();
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

/// How a list of some elements is held.
enum class Packing : std::uint8_t { poisoned, numbers, rows, values };

Packing packing_of(std::span<const Value> elements) {
    bool are_numbers = !elements.empty();
    bool are_rows = !elements.empty();
    for (const Value& value : elements) {
        if (value.is(ValueKind::poison)) return Packing::poisoned;
        are_numbers = are_numbers && value.is(ValueKind::number);
        are_rows = are_rows && value.is(ValueKind::numbers) && value.count == elements[0].count &&
                   value.count <= 4;
    }
    if (are_numbers) return Packing::numbers;
    return are_rows ? Packing::rows : Packing::values;
}

/// Returns the field of a record, which most likely is in a given place; null if there is none.
const RecordField* field_of(const Value& record, Symbol name, std::uint32_t likely) {
    if (record.fields[likely].name == name) return record.fields + likely;
    const RecordField* const end = record.fields + record.count;
    const RecordField* const found = std::find_if(
        record.fields, end, [&](const RecordField& field) { return field.name == name; });
    return found != end ? found : nullptr;
}

/// Of values of one kind, lists, records and functions excepted.
bool is_equal_flat(const Value& a, const Value& b) {
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
            const std::size_t width = a.is(ValueKind::rows) ? a.width : 1;
            return std::equal(a.numbers, a.numbers + a.count * width, b.numbers);
        }
        case ValueKind::transform:
            return a.transform->linear() == b.transform->linear() &&
                   a.transform->offset() == b.transform->offset();
        case ValueKind::texture:
        case ValueKind::material:
        case ValueKind::node:
            return a.made == b.made;
        case ValueKind::function:
        case ValueKind::record:
        case ValueKind::list:
            break;
    }
    LRAY_ASSERT(false);
}

}  // namespace

bool take_steps(Budget& budget, std::uint64_t count, Span span, Diagnostics& diagnostics) {
    if (budget.is_spent) return false;
    if (budget.steps >= count) {
        budget.steps -= count;
        return true;
    }
    budget.spend();
    diagnostics
        .error(Code::E0512, span,
               fmt::format("evaluating the scene takes more than {} steps", budget.max_steps))
        .with_help("raise the limit with `--max-steps N`");
    return false;
}

bool take_bytes(Budget& budget, std::uint64_t size, Span span, Diagnostics& diagnostics) {
    if (budget.is_spent) return false;
    if (budget.value_bytes >= size) {
        budget.value_bytes -= size;
        return true;
    }
    budget.spend();
    diagnostics
        .error(
            Code::E0516, span,
            fmt::format("the values of this scene need more than {} bytes", budget.max_value_bytes))
        .with_help("raise the limit with `--max-value-bytes N`");
    return false;
}

bool take_kept_bytes(Budget& budget, std::uint64_t size, Span span, Diagnostics& diagnostics) {
    if (!take_bytes(budget, size, span, diagnostics)) return false;
    budget.kept_bytes += size;
    return true;
}

bool take_numbers(Budget& budget, std::uint64_t count, Span span, Diagnostics& diagnostics) {
    constexpr std::uint64_t kFree = 4;  // vectors cost what numbers cost
    return take_bytes(budget, count * sizeof(double), span, diagnostics) &&
           (count <= kFree || take_steps(budget, count, span, diagnostics));
}

bool may_have_elements(const Budget& budget, double count, Span span, Diagnostics& diagnostics) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
    const std::uint64_t limit = std::min(budget.max_list_size, kMost);
    if (count <= static_cast<double>(limit)) return true;
    if (budget.is_spent) return false;
    diagnostics
        .error(Code::E0514, span,
               fmt::format("this list would have {} elements, more than the limit of {} "
                           "(`--max-list-size`)",
                           format_number(count), limit))
        .with_help("raise the limit with `--max-list-size N`");
    return false;
}

bool take_text_steps(Budget& budget, std::uint64_t size, Span span, Diagnostics& diagnostics) {
    constexpr std::uint64_t kBytesPerStep = 16;
    return take_steps(budget, size / kBytesPerStep, span, diagnostics);
}

Value apply(TokenKind op, const Value& left, const Value& right, Span span, Arena& arena,
            Budget& budget, Diagnostics& diagnostics) {
    if (left.is(ValueKind::poison) || right.is(ValueKind::poison)) return Value::poison();
    if (is_one_of(op, TokenKind::equal_equal, TokenKind::not_equal)) {
        const std::optional<bool> equal = is_equal(left, right, span, budget, diagnostics);
        return equal ? Value::of(*equal == (op == TokenKind::equal_equal)) : Value::poison();
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
        return numeric(op, left, right, span, arena, budget, diagnostics);
    }
    if (op == TokenKind::plus && left.is(ValueKind::string) && right.is(ValueKind::string)) {
        const std::uint64_t size = std::uint64_t{left.count} + right.count;
        constexpr std::uint64_t kMaxSize = std::numeric_limits<std::uint32_t>::max();
        if (size > kMaxSize) {
            diagnostics.error(Code::E0516, span, "a string must be smaller than 4 GiB");
            return Value::poison();
        }
        const bool is_paid = take_bytes(budget, size, span, diagnostics) &&
                             take_text_steps(budget, size, span, diagnostics);
        if (!is_paid) return Value::poison();
        char* const joined = static_cast<char*>(arena.allocate(size, 1));
        std::copy_n(left.text, left.count, joined);
        std::copy_n(right.text, right.count, joined + left.count);
        return Value::of_string({joined, size}, left.source);
    }
    Diagnostic& diagnostic = diagnostics.error(
        Code::E0301, span,
        fmt::format("cannot {} {} and {}", verb(op), describe(left), describe(right)));
    if (left.is(ValueKind::color) || right.is(ValueKind::color)) {
        diagnostic.with_help(
            "colours are mixed: `mix(black, gold, 0.5)` is half as bright as gold");
    }
    return Value::poison();
}

Value apply_sign(TokenKind op, const Value& operand, Span span, Arena& arena, Budget& budget,
                 Diagnostics& diagnostics) {
    if (operand.is(ValueKind::poison)) return operand;
    if (!is_numeric(operand)) {
        diagnostics.error(Code::E0301, span,
                          fmt::format("a sign needs a number, this is {}", describe(operand)));
        return Value::poison();
    }
    if (op == TokenKind::plus) return operand;
    if (operand.is(ValueKind::number)) return Value::of(-operand.number);
    if (!take_numbers(budget, operand.count, span, diagnostics)) return Value::poison();
    const std::span<double> negated =
        arena.copy(std::span<const double>(operand.numbers, operand.count));
    for (double& number : negated) number = -number;
    return Value::of_numbers(negated);
}

std::optional<bool> is_equal(const Value& a, const Value& b, Span span, Budget& budget,
                             Diagnostics& diagnostics) {
    // Lists of lists may be nested without bound by way of names: no recursion.
    std::vector<std::pair<Value, Value>> pairs = {{a, b}};
    while (!pairs.empty()) {
        const auto [left, right] = pairs.back();
        pairs.pop_back();
        if (left.kind != right.kind) return false;
        const bool has_count =
            left.is_list() || left.is(ValueKind::string) || left.is(ValueKind::record);
        if (has_count && left.count != right.count) return false;
        const std::uint64_t width = left.is(ValueKind::rows) ? left.width : 1;
        const std::uint64_t size = has_count ? std::max<std::uint64_t>(left.count * width, 1) : 1;
        if (!take_steps(budget, size, span, diagnostics)) return {};
        if (left.is(ValueKind::list)) {
            for (std::uint32_t i = 0; i < left.count; ++i) {
                pairs.emplace_back(left.elements[i], right.elements[i]);
            }
        } else if (left.is(ValueKind::record)) {
            for (std::uint32_t i = 0; i < left.count; ++i) {
                const RecordField* const other = field_of(right, left.fields[i].name, i);
                if (other == nullptr) return false;
                const auto past = static_cast<std::uint64_t>(std::abs(other - (right.fields + i)));
                if (!take_steps(budget, past, span, diagnostics)) return {};
                pairs.emplace_back(left.fields[i].value, other->value);
            }
        } else if (left.is(ValueKind::function)) {
            const FunctionValue& a_function = *left.function;
            const FunctionValue& b_function = *right.function;
            if (a_function.function != b_function.function ||
                a_function.builtin != b_function.builtin) {
                return false;
            }
            const std::size_t count =
                a_function.function == nullptr ? 0 : a_function.function->capture_slots.size();
            if (!take_steps(budget, count, span, diagnostics)) return {};
            for (std::size_t i = 0; i < count; ++i) {
                pairs.emplace_back(a_function.captures[i], b_function.captures[i]);
            }
        } else if (!is_equal_flat(left, right)) {
            return false;
        }
    }
    return true;
}

Value make_list(std::span<const Value> elements, Arena& arena) {
    const Packing packing = packing_of(elements);
    if (packing == Packing::poisoned) return Value::poison();
    Value result;
    result.count = static_cast<std::uint32_t>(elements.size());
    if (packing == Packing::values) {
        result.kind = ValueKind::list;
        result.width = depth_around(elements);
        result.elements = arena.copy(elements).data();
        return result;
    }
    const bool are_rows = packing == Packing::rows;
    const std::size_t width = are_rows ? elements[0].count : 1;
    const std::size_t size = elements.size() * width * sizeof(double);
    double* const numbers = static_cast<double*>(arena.allocate(size, alignof(double)));
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const double* const row = are_rows ? elements[i].numbers : &elements[i].number;
        std::copy_n(row, width, numbers + i * width);
    }
    result.kind = are_rows ? ValueKind::rows : ValueKind::numbers;
    result.width = are_rows ? static_cast<std::uint8_t>(width) : std::uint8_t{0};
    result.numbers = numbers;
    return result;
}

Value make_list(std::span<const Value> elements, Span span, Arena& arena, Budget& budget,
                Diagnostics& diagnostics) {
    const auto count = static_cast<double>(elements.size());
    if (!may_have_elements(budget, count, span, diagnostics)) return Value::poison();
    const Packing packing = packing_of(elements);
    if (packing == Packing::poisoned) return Value::poison();
    if (packing == Packing::values && depth_around(elements) > kMaxValueDepth) {
        diagnostics.error(Code::E0514, span,
                          fmt::format("lists are nested more than {} deep", kMaxValueDepth));
        return Value::poison();
    }
    const std::size_t width = packing == Packing::rows ? elements[0].count : 1;
    const std::size_t element_size =
        packing == Packing::values ? sizeof(Value) : width * sizeof(double);
    const bool is_paid = take_bytes(budget, elements.size() * element_size, span, diagnostics) &&
                         take_steps(budget, elements.size(), span, diagnostics);
    return is_paid ? make_list(elements, arena) : Value::poison();
}

Value list_of_numbers(std::span<const double> numbers) {
    if (!numbers.empty()) return Value::of_numbers(numbers);
    Value empty;
    empty.kind = ValueKind::list;
    empty.width = 1;
    empty.elements = nullptr;
    return empty;
}

std::uint8_t depth_around(std::span<const Value> elements) {
    std::uint8_t deepest = 0;
    for (const Value& value : elements) deepest = std::max(deepest, value.depth());
    // Depths end where they are counted: deeper ones are refused all the same.
    constexpr std::uint8_t kMost = std::numeric_limits<std::uint8_t>::max();
    return deepest == kMost ? kMost : static_cast<std::uint8_t>(deepest + 1);
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
