#include "parser/builtins/function_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <vector>

#include "parser/builtins/results.h"
#include "parser/builtins/sequence.h"

namespace lray::parser {

namespace {

Value call_with(Call& call, std::size_t function, const Value& argument) {
    return call.runtime.call_function(call[function], {&argument, 1}, call.spans[function]);
}

bool has_one_order(std::span<const Value> keys) {
    const auto is_like_first = [&](const Value& key) { return key.kind == keys[0].kind; };
    return keys.empty() || ((keys[0].is(ValueKind::number) || keys[0].is(ValueKind::string)) &&
                            std::ranges::all_of(keys, is_like_first));
}

bool is_before(const Value& a, const Value& b) {
    return a.is(ValueKind::number) ? a.number < b.number : a.string() < b.string();
}

/// Takes what sorting costs: comparisons, of strings by their length.
bool take_sorting_steps(Call& call, std::span<const Value> keys) {
    const std::uint64_t rounds = std::bit_width(keys.size());
    std::uint64_t longest = 0;
    for (const Value& key : keys) longest = std::max<std::uint64_t>(longest, key.count);
    return take_steps(call, keys.size() * rounds * (1 + longest / 64));
}

}  // namespace

Value map_of(Call& call) {
    Sequence results(call);
    for (std::uint32_t i = 0; i < call[0].count; ++i) {
        const Value result = call_with(call, 1, element(call[0], i));
        if (result.is(ValueKind::poison) || !results.add(result)) return Value::poison();
    }
    return results.finish();
}

Value filter_of(Call& call) {
    Sequence results(call);
    for (std::uint32_t i = 0; i < call[0].count; ++i) {
        const Value one = element(call[0], i);
        const Value is_kept = call_with(call, 1, one);
        if (is_kept.is(ValueKind::poison)) return Value::poison();
        if (!is_kept.is(ValueKind::boolean)) {
            call.diagnostics.error(
                Code::E0301, call.spans[1],
                fmt::format("`filter` needs a function that returns true or false, this returned "
                            "{}",
                            describe(is_kept)));
            return Value::poison();
        }
        if (is_kept.boolean && !results.add(one)) return Value::poison();
        if (!is_kept.boolean && !take_steps(call, 1)) return Value::poison();
    }
    return results.finish();
}

Value reduce_of(Call& call) {
    const bool has_start = !call[2].is(ValueKind::none);
    if (!has_start && call[0].count == 0) return nothing_in_list(call, 0);
    Value result = has_start ? call[2] : element(call[0], 0);
    for (std::uint32_t i = has_start ? 0 : 1; i < call[0].count; ++i) {
        if (!take_steps(call, 1)) return Value::poison();
        const std::array arguments = {result, element(call[0], i)};
        result = call.runtime.call_function(call[1], arguments, call.spans[1]);
        if (result.is(ValueKind::poison)) return result;
    }
    return result;
}

Value sort_of(Call& call) {
    Sequence elements(call);
    if (!elements.add_all(call[0])) return Value::poison();
    const bool has_key = !call[1].is(ValueKind::none);
    Sequence computed_keys(call);
    if (has_key) {
        for (const Value& element : elements.elements()) {
            const Value key = call_with(call, 1, element);
            if (key.is(ValueKind::poison) || !computed_keys.add(key)) return Value::poison();
        }
    }
    const std::span<const Value> keys = has_key ? computed_keys.elements() : elements.elements();
    if (!has_one_order(keys)) {
        call.diagnostics
            .error(Code::E0301, call.spans[has_key ? 1 : 0],
                   has_key ? "only numbers, or only strings, have an order; this key returns others"
                           : "only numbers, or only strings, have an order; here are others")
            .with_help("sort by a number of each element: `sort(points, key: fn(p) = p.x)`");
        return Value::poison();
    }
    if (!take_sorting_steps(call, keys)) return Value::poison();
    std::vector<std::uint32_t> order(keys.size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return is_before(keys[a], keys[b]); });
    std::vector<Value> sorted;
    sorted.reserve(order.size());
    for (const std::uint32_t index : order) sorted.push_back(elements.elements()[index]);
    return list_of(call, sorted);
}

}  // namespace lray::parser
