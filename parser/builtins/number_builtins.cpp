// Functions of numbers, and of vectors element by element.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/angle.h"
#include "parser/builtins/families.h"
#include "parser/builtins/results.h"

namespace lray::parser {

namespace {

template <double (*function)(double)>
Value of_number(Call& call) {
    return finite(call, function(call.number(0)));
}

/// Calls `function` on each element of one to three arguments; numbers stand for each element.
template <std::size_t kCount, class Function>
Value by_elements(Call& call, Function function) {
    const Value* first_list = nullptr;
    for (std::size_t i = 0; i < kCount; ++i) {
        const Value& argument = call[i];
        if (!argument.is_list()) continue;
        if (first_list == nullptr) first_list = &argument;
        if (argument.count == first_list->count) continue;
        return lengths_differ(call, first_list->count, argument.count);
    }
    const auto at = [&](std::size_t i, std::uint32_t k) {
        return call[i].is_list() ? call[i].numbers[k] : call[i].number;
    };
    const auto apply = [&](std::uint32_t k) {
        if constexpr (kCount == 1) return function(at(0, k));
        if constexpr (kCount == 2) return function(at(0, k), at(1, k));
        if constexpr (kCount == 3) return function(at(0, k), at(1, k), at(2, k));
    };
    if (first_list == nullptr) return finite(call, apply(0));
    const std::uint32_t size = first_list->count;
    double* const results = take_list_of_numbers(call, size);
    if (results == nullptr) return Value::poison();
    for (std::uint32_t k = 0; k < size; ++k) results[k] = apply(k);
    return finite(call, std::span<const double>(results, size));
}

template <double (*function)(double)>
Value each(Call& call) {
    return by_elements<1>(call, function);
}

double sign_of(double x) {
    return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0;
}
double frac_of(double x) {
    return x - std::floor(x);
}
// Halves away from zero, as people round.
double round_of(double x) {
    return std::round(x);
}
double abs_of(double x) {
    return std::fabs(x);
}
double floor_of(double x) {
    return std::floor(x);
}
double ceil_of(double x) {
    return std::ceil(x);
}
double trunc_of(double x) {
    return std::trunc(x);
}
double sqrt_of(double x) {
    return std::sqrt(x);
}
double exp_of(double x) {
    return std::exp(x);
}
double log_of(double x) {
    return std::log(x);
}
double log2_of(double x) {
    return std::log2(x);
}
double log10_of(double x) {
    return std::log10(x);
}
double sin_of(double x) {
    return sin_degrees(x);
}
double cos_of(double x) {
    return cos_degrees(x);
}
double tan_of(double x) {
    return sin_degrees(x) / cos_degrees(x);
}
double asin_of(double x) {
    return degrees(std::asin(x));
}
double acos_of(double x) {
    return degrees(std::acos(x));
}
double atan_of(double x) {
    return degrees(std::atan(x));
}
double radians_of(double x) {
    return radians(x);
}
double degrees_of(double x) {
    return degrees(x);
}

double least_of(double a, double b) {
    return std::min(a, b);
}
double greatest_of(double a, double b) {
    return std::max(a, b);
}

/// Of two arguments, element by element; of one, among the elements of a list.
template <double (*choose)(double, double)>
Value chosen(Call& call) {
    if (!call[1].is(ValueKind::none)) return by_elements<2>(call, choose);
    if (!call[0].is_list()) return call[0];
    if (call[0].count == 0) return nothing_in_list(call, 0);
    if (!take_steps(call, call[0].count)) return Value::poison();
    double result = call[0].numbers[0];
    for (const double x : numbers_of(call[0])) result = choose(result, x);
    return Value::of(result);
}

Value clamp_of(Call& call) {
    return by_elements<3>(
        call, [](double x, double lo, double hi) { return std::max(lo, std::min(x, hi)); });
}
Value lerp_of(Call& call) {
    return by_elements<3>(call, lerp);
}

Value smoothstep_of(Call& call) {
    const double lo = call.number(0);
    const double hi = call.number(1);
    if (lo == hi) return no_value(call, "the two edges of `smoothstep` are the same");
    // Halved, so that differences stay finite.
    const double t = std::clamp((call.number(2) / 2 - lo / 2) / (hi / 2 - lo / 2), 0.0, 1.0);
    return Value::of(t * t * (3.0 - 2.0 * t));
}
Value hypot_of(Call& call) {
    return finite(call, std::hypot(call.number(0), call.number(1)));
}
Value atan2_of(Call& call) {
    return finite(call, degrees(std::atan2(call.number(0), call.number(1))));
}

using enum ParameterType;

constexpr Parameter kX{"x", elements};
constexpr Parameter kNumber{"x", number};
constexpr Parameter kAngle{"angle", number};

/// A function of one number, and of lists if its parameter takes them.
template <double (*function)(double)>
constexpr Builtin plain(std::string_view name, Parameter parameter, std::string_view doc) {
    const bool takes_lists = parameter.type == elements;
    return {name, {parameter}, takes_lists ? each<function> : of_number<function>, doc, function};
}

// clang-format off
constexpr std::array kBuiltins = {
    plain<abs_of>("abs", kX, "without its sign"),
    plain<sign_of>("sign", kX, "-1, 0 or 1"),
    Builtin{"min", {{{"a", elements}, {"b", elements, true}}}, chosen<least_of>, "the lesser; of a list alone, its least element"},
    Builtin{"max", {{{"a", elements}, {"b", elements, true}}}, chosen<greatest_of>, "the greater; of a list alone, its greatest element"},
    Builtin{"clamp", {{{"x", elements}, {"lo", elements}, {"hi", elements}}}, clamp_of, "kept between lo and hi"},
    Builtin{"lerp", {{{"a", elements}, {"b", elements}, {"t", elements}}}, lerp_of, "a at t = 0, b at t = 1, beyond them outside of 0 to 1"},
    Builtin{"smoothstep", {{{"lo", number}, {"hi", number}, {"x", number}}}, smoothstep_of, "0 to 1, smoothly, as x goes from lo to hi"},
    plain<floor_of>("floor", kX, "the whole number below"),
    plain<ceil_of>("ceil", kX, "the whole number above"),
    plain<round_of>("round", kX, "the nearest whole number, halves away from 0"),
    plain<trunc_of>("trunc", kX, "the whole number towards 0"),
    plain<frac_of>("frac", kX, "x - floor(x)"),
    plain<sqrt_of>("sqrt", kX, "square root"),
    plain<exp_of>("exp", kNumber, "e to the power of x"),
    plain<log_of>("log", kNumber, "natural logarithm"),
    plain<log2_of>("log2", kNumber, "logarithm to base 2"),
    plain<log10_of>("log10", kNumber, "logarithm to base 10"),
    Builtin{"hypot", {{{"x", number}, {"y", number}}}, hypot_of, "sqrt(x * x + y * y)"},
    plain<sin_of>("sin", kAngle, "sine of degrees"),
    plain<cos_of>("cos", kAngle, "cosine of degrees"),
    plain<tan_of>("tan", kAngle, "tangent of degrees"),
    plain<asin_of>("asin", kNumber, "arc sine, in degrees"),
    plain<acos_of>("acos", kNumber, "arc cosine, in degrees"),
    plain<atan_of>("atan", kNumber, "arc tangent, in degrees"),
    Builtin{"atan2", {{{"y", number}, {"x", number}}}, atan2_of, "angle of the point (x, y), in degrees"},
    plain<radians_of>("radians", kX, "degrees to radians"),
    plain<degrees_of>("degrees", kX, "radians to degrees"),
};
// clang-format on

}  // namespace

std::span<const Builtin> number_builtins() {
    return kBuiltins;
}

}  // namespace lray::parser
