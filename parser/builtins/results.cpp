#include "parser/builtins/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace lray::parser {

Value no_value(Call& call, std::string message) {
    call.diagnostics.error(Code::E0503, call.span, std::move(message));
    return Value::poison();
}

Value finite(Call& call, double result) {
    if (std::isfinite(result)) return Value::of(result);
    std::string arguments;
    for (const Value& argument : call.arguments) {
        if (argument.is(ValueKind::none)) continue;
        const bool is_number = argument.is(ValueKind::number);
        arguments += fmt::format("{}{}", arguments.empty() ? "" : ", ",
                                 is_number ? format_number(argument.number) : "...");
    }
    return no_value(call, fmt::format("`{}({})` has no {} value", call.name, arguments,
                                      std::isnan(result) ? "real" : "finite"));
}

Value finite(Call& call, std::span<const double> numbers) {
    const auto wrong =
        std::find_if(numbers.begin(), numbers.end(), [](double x) { return !std::isfinite(x); });
    if (wrong != numbers.end()) return finite(call, *wrong);
    return list_of_numbers(numbers);
}

Value of_vec3(Call& call, DVec3 v) {
    double* const numbers = take_list_of_numbers(call, 3.0);
    if (numbers == nullptr) return Value::poison();
    std::copy_n(&v.x, 3, numbers);
    return finite(call, std::span<const double>(numbers, 3));
}

Value of_rgb(Call& call, double r, double g, double b) {
    for (const double channel : {r, g, b}) {
        if (!std::isfinite(channel)) return finite(call, channel);
    }
    double* const rgba = take_list_of_numbers(call, 4.0);
    if (rgba == nullptr) return Value::poison();
    std::ranges::copy(std::array{r, g, b, 1.0}, rgba);
    return Value::of_color(rgba);
}

Value of_transform(Call& call, const Transform& transform) {
    if (!transform.is_finite()) return no_value(call, "this transform is not finite");
    if (!take_bytes(call.budget, sizeof(Transform), call.span, call.diagnostics)) {
        return Value::poison();
    }
    return Value::of_transform(call.arena.make<Transform>(transform));
}

Value lengths_differ(Call& call, std::size_t a, std::size_t b) {
    call.diagnostics.error(Code::E0302, call.span,
                           fmt::format("these have {} and {} elements", a, b));
    return Value::poison();
}

Value nothing_in_list(Call& call, std::size_t argument) {
    call.diagnostics.error(
        Code::E0505, call.spans[argument],
        fmt::format("`{}` needs a list with elements, this has none", call.name));
    return Value::poison();
}

double* take_list_of_numbers(Call& call, double count) {
    if (!may_have_elements(call.budget, count, call.span, call.diagnostics)) return nullptr;
    const auto size = static_cast<std::uint64_t>(count);
    if (!take_numbers(call.budget, size, call.span, call.diagnostics)) return nullptr;
    return static_cast<double*>(call.arena.allocate(size * sizeof(double), alignof(double)));
}

Value list_of(Call& call, std::span<const Value> elements) {
    return make_list(elements, call.span, call.arena, call.budget, call.diagnostics);
}

bool take_steps(Call& call, std::uint64_t count) {
    return take_steps(call.budget, count, call.span, call.diagnostics);
}

}  // namespace lray::parser
