#include "parser/builtins/blend.h"

#include <fmt/format.h>

#include "parser/builtins/results.h"

namespace lray::parser {

namespace {

Value blend_colors(Call& call, const Value& a, const Value& b, double t) {
    if (!fits(ParameterType::color, a) || !fits(ParameterType::color, b)) {
        call.diagnostics.error(
            Code::E0301, call.span,
            fmt::format("there is nothing between {} and {}", describe(a), describe(b)));
        return Value::poison();
    }
    const auto channel = [&](std::size_t i) {
        return lerp(a.is(ValueKind::number) ? a.number : a.numbers[i],
                    b.is(ValueKind::number) ? b.number : b.numbers[i], t);
    };
    return of_rgb(call, channel(0), channel(1), channel(2));
}

}  // namespace

Value blend(Call& call, const Value& a, const Value& b, double t) {
    if (a.is(ValueKind::color) || b.is(ValueKind::color)) return blend_colors(call, a, b, t);
    if (!a.is_list() && !b.is_list()) return finite(call, lerp(a.number, b.number, t));
    if (a.is_list() && b.is_list() && a.count != b.count) {
        return lengths_differ(call, a.count, b.count);
    }
    const std::uint32_t size = a.is_list() ? a.count : b.count;
    double* const results = take_list_of_numbers(call, size);
    if (results == nullptr) return Value::poison();
    for (std::uint32_t i = 0; i < size; ++i) {
        results[i] =
            lerp(a.is_list() ? a.numbers[i] : a.number, b.is_list() ? b.numbers[i] : b.number, t);
    }
    return finite(call, std::span<const double>(results, size));
}

}  // namespace lray::parser
