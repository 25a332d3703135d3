// Functions of lists that call no functions of the scene, and those that make lists of numbers.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "parser/builtins/families.h"
#include "parser/builtins/function_arguments.h"
#include "parser/builtins/results.h"
#include "parser/builtins/sequence.h"

namespace lray::parser {

namespace {

Value len_of(Call& call) {
    const Value& value = call[0];
    if (value.is_list() || value.is(ValueKind::record))
        return Value::of(static_cast<double>(value.count));
    if (value.is(ValueKind::string)) {
        if (!take_text_steps(call.budget, value.count, call.span, call.diagnostics)) {
            return Value::poison();
        }
        const auto continues = [](char c) { return (c & 0xc0) == 0x80; };  // UTF-8
        const std::string_view text = value.string();
        const auto more = std::count_if(text.begin(), text.end(), continues);
        return Value::of(static_cast<double>(text.size()) - static_cast<double>(more));
    }
    call.diagnostics.error(
        Code::E0301, call.spans[0],
        fmt::format("`len` needs a list, a string or a record, this is {}", describe(value)));
    return Value::poison();
}

// range(end), range(start, end), range(start, end, step)
Value range_of(Call& call) {
    const bool has_start = !call[1].is(ValueKind::none);
    const double start = has_start ? call.number(0) : 0.0;
    const double end = has_start ? call.number(1) : call.number(0);
    const double step = call[2].is(ValueKind::none) ? 1.0 : call.number(2);
    if (step == 0.0) {
        call.diagnostics.error(Code::E0304, call.spans[2], "a range with a step of 0 never ends");
        return Value::poison();
    }
    const double count = range_count(start, end, step);
    if (!may_have_elements(call.budget, count, call.span, call.diagnostics)) {
        return Value::poison();
    }
    double* const numbers = take_list_of_numbers(call, count);
    if (numbers == nullptr) return Value::poison();
    const auto size = static_cast<std::size_t>(count);
    for (std::size_t i = 0; i < size; ++i) numbers[i] = start + static_cast<double>(i) * step;
    return list_of_numbers({numbers, size});
}

Value linspace_of(Call& call) {
    const double a = call.number(0);
    const double b = call.number(1);
    const double count = call.number(2);
    if (count < 2.0) {
        call.diagnostics.error(
            Code::E0304, call.spans[2],
            fmt::format("`linspace` makes 2 numbers at least, this is {}", format_number(count)));
        return Value::poison();
    }
    double* const numbers = take_list_of_numbers(call, count);
    if (numbers == nullptr) return Value::poison();
    const auto size = static_cast<std::size_t>(count);
    for (std::size_t i = 0; i < size; ++i) {
        const double t = static_cast<double>(i) / (count - 1.0);
        numbers[i] = a * (1.0 - t) + b * t;  // exact at both ends, and never too large
    }
    return list_of_numbers({numbers, size});
}

Value concat_of(Call& call) {
    Sequence sequence(call);
    if (!sequence.add_all(call[0])) return Value::poison();
    for (const Value& list : call.rest) {
        if (!sequence.add_all(list)) return Value::poison();
    }
    return sequence.finish();
}

Value flatten_of(Call& call) {
    if (call[0].is(ValueKind::numbers)) return call[0];
    if (call[0].is(ValueKind::rows)) {  // already side by side
        const std::size_t size = std::size_t{call[0].count} * call[0].width;
        const auto count = static_cast<double>(size);
        if (!may_have_elements(call.budget, count, call.span, call.diagnostics)) {
            return Value::poison();
        }
        return list_of_numbers({call[0].numbers, size});
    }
    Sequence sequence(call);
    for (std::uint32_t i = 0; i < call[0].count; ++i) {
        const Value one = element(call[0], i);
        if (!(one.is_list() ? sequence.add_all(one) : sequence.add(one))) return Value::poison();
    }
    return sequence.finish();
}

Value reverse_of(Call& call) {
    Sequence sequence(call);
    if (!sequence.add_all(call[0])) return Value::poison();
    std::ranges::reverse(sequence.elements());
    return sequence.finish();
}

Value sum_of(Call& call) {
    const Value& list = call[0];
    if (list.count == 0) return Value::of(0.0);
    if (list.is(ValueKind::list)) {
        call.diagnostics.error(Code::E0301, call.spans[0],
                               "`sum` needs a list of numbers, or of vectors of one size");
        return Value::poison();
    }
    const std::size_t width = list.is(ValueKind::rows) ? list.width : 1;
    if (!take_steps(call, list.count * width)) return Value::poison();
    std::array<double, 4> sums{};
    for (std::size_t i = 0; i < list.count; ++i) {
        for (std::size_t k = 0; k < width; ++k) sums[k] += list.numbers[i * width + k];
    }
    if (list.is(ValueKind::numbers)) return finite(call, sums[0]);
    double* const results = take_list_of_numbers(call, static_cast<double>(width));
    if (results == nullptr) return Value::poison();
    std::copy_n(sums.begin(), width, results);
    return finite(call, std::span<const double>(results, width));
}

/// Reports an index that is not from 0 to `most`.
bool is_index(Call& call, std::size_t argument, double most) {
    const double index = call.number(argument);
    if (index >= 0.0 && index <= most) return true;
    call.diagnostics.error(Code::E0504, call.spans[argument],
                           fmt::format("a slice begins and ends between 0 and {}, this is {}",
                                       format_number(most), format_number(index)));
    return false;
}

Value slice_of(Call& call) {
    const double size = call[0].count;
    if (!is_index(call, 1, size)) return Value::poison();
    const bool has_end = !call[2].is(ValueKind::none);
    if (has_end && !is_index(call, 2, size)) return Value::poison();
    const auto from = static_cast<std::uint32_t>(call.number(1));
    const auto to = has_end ? static_cast<std::uint32_t>(call.number(2)) : call[0].count;
    if (to < from) {
        call.diagnostics.error(
            Code::E0504, call.spans[2],
            fmt::format("this slice ends at {}, before it begins at {}", to, from));
        return Value::poison();
    }
    if (to == from) return list_of_numbers({});
    Value part = call[0];  // values do not change: a part of a packed list needs no copy
    part.count = to - from;
    if (call[0].is(ValueKind::list)) {
        return list_of(call, {call[0].elements + from, part.count});
    }
    const std::size_t width = part.is(ValueKind::rows) ? part.width : 1;
    part.numbers += from * width;
    // It is paid for all the same: parts that overlap may come apart when memory is given back.
    return take_bytes(call.budget, part.count * width * sizeof(double), call.span, call.diagnostics)
               ? part
               : Value::poison();
}

Value zip_of(Call& call) {
    const std::uint32_t size = call[0].count;
    std::vector<Value> lists = {call[0], call[1]};
    lists.insert(lists.end(), call.rest.begin(), call.rest.end());
    for (const Value& list : lists) {
        if (list.count != size) return lengths_differ(call, size, list.count);
    }
    Sequence rows(call);
    std::vector<Value> row(lists.size());
    for (std::uint32_t i = 0; i < size; ++i) {
        for (std::size_t k = 0; k < lists.size(); ++k) row[k] = element(lists[k], i);
        const Value packed = list_of(call, row);
        if (packed.is(ValueKind::poison) || !rows.add(packed)) return Value::poison();
    }
    return rows.finish();
}

struct Found {
    bool is_known = false;  // false: the budget is spent
    std::optional<std::uint32_t> index{};
};

Found find(Call& call) {
    const Value& list = call[0];
    if (list.is(ValueKind::numbers)) {
        if (!take_steps(call, list.count)) return {};
        const double* const end = list.numbers + list.count;
        const double* const found =
            call[1].is(ValueKind::number) ? std::find(list.numbers, end, call.number(1)) : end;
        if (found == end) return {true, std::nullopt};
        return {true, static_cast<std::uint32_t>(found - list.numbers)};
    }
    for (std::uint32_t i = 0; i < list.count; ++i) {
        const std::optional<bool> is_it =
            is_equal(element(list, i), call[1], call.span, call.budget, call.diagnostics);
        if (!is_it) return {};
        if (*is_it) return {true, i};
    }
    return {true, std::nullopt};
}

Value contains_of(Call& call) {
    const Found found = find(call);
    return found.is_known ? Value::of(found.index.has_value()) : Value::poison();
}

Value index_of(Call& call) {
    const Found found = find(call);
    if (!found.is_known) return Value::poison();
    return Value::of(found.index ? static_cast<double>(*found.index) : -1.0);
}

using enum ParameterType;

constexpr Parameter kList{"list", list};

// clang-format off
constexpr std::array kBuiltins = {
    Builtin{"len", {{{"value", any}}}, len_of, "how many elements, characters or fields it has"},
    Builtin{"range", {{{"a", number}, {"b", number, true}, {"step", number, true}}}, range_of, "from a, or 0 if there is no b, in steps of 1 or step; the end is left out"},
    Builtin{"linspace", {{{"a", number}, {"b", number}, {"count", integer}}}, linspace_of, "so many numbers from a to b at equal distances, both ends included"},
    Builtin{.name = "concat", .parameters = {kList}, .function = concat_of, .doc = "one list of all elements", .is_variadic = true, .rest_type = list},
    Builtin{"flatten", {kList}, flatten_of, "lists in the list replaced by their elements, one level"},
    Builtin{"reverse", {kList}, reverse_of, "the last element first"},
    Builtin{"sort", {{kList, {"key", function, true}}}, sort_of, "numbers or strings in rising order; anything, by what key(element) returns; equal ones stay in order"},
    Builtin{"sum", {kList}, sum_of, "of numbers, or of vectors; 0 of an empty list"},
    Builtin{"slice", {{kList, {"from", integer}, {"to", integer, true}}}, slice_of, "the elements with the indices from, from + 1, ... without to"},
    Builtin{"map", {{kList, {"f", function}}}, map_of, "f(element) of each element"},
    Builtin{"filter", {{kList, {"f", function}}}, filter_of, "the elements for which f(element) is true"},
    Builtin{"reduce", {{kList, {"f", function}, {"start", any, true}}}, reduce_of, "f(f(start, first), second) and so on; without start it begins with the first element"},
    Builtin{.name = "zip", .parameters = {{{"a", list}, {"b", list}}}, .function = zip_of, .doc = "[a[0], b[0]], [a[1], b[1]] and so on; the lists have one length", .is_variadic = true, .rest_type = list},
    Builtin{"contains", {{kList, {"value", any}}}, contains_of, "true if an element equals the value"},
    Builtin{"index_of", {{kList, {"value", any}}}, index_of, "of the first element that equals the value; -1 if there is none"},
};
// clang-format on

}  // namespace

double range_count(double start, double end, double step) {
    const double distance = end - start;
    const double quotient =
        std::isfinite(distance) ? distance / step : (end / 2 - start / 2) / (step / 2);
    const double count = std::max(std::ceil(quotient), 0.0);
    // Rounding may have put the quotient on the other side of a whole number: elements decide.
    const auto is_inside = [&](double i) {
        const double at = start + i * step;
        return step > 0.0 ? at < end : at > end;
    };
    if (count > 0.0 && !is_inside(count - 1.0)) return count - 1.0;
    return count > 0.0 && is_inside(count) ? count + 1.0 : count;
}

std::span<const Builtin> list_builtins() {
    return kBuiltins;
}

}  // namespace lray::parser
