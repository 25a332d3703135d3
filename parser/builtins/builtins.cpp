#include "parser/builtins/builtins.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/angle.h"
#include "base/assert.h"
#include "base/transform.h"
#include "image/srgb.h"
#include "parser/builtins/random_families.h"
#include "parser/values/transform_values.h"

namespace lray::parser {

namespace {

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

template <double (*function)(double)>
Value of_number(Call& call) {
    return finite(call, function(call.number(0)));
}

/// Calls `function` on each element of one to three arguments; numbers stand for each element.
template <std::size_t kCount, class Function>
Value by_elements(Call& call, Function function) {
    std::uint32_t size = 0;  // 0: numbers only
    for (std::size_t i = 0; i < kCount; ++i) {
        const Value& argument = call[i];
        if (!argument.is(ValueKind::numbers)) continue;
        if (size != 0 && argument.count != size) {
            call.diagnostics.error(
                Code::E0302, call.span,
                fmt::format("these have {} and {} elements", size, argument.count));
            return Value::poison();
        }
        size = argument.count;
    }
    const auto at = [&](std::size_t i, std::uint32_t k) {
        return call[i].is(ValueKind::numbers) ? call[i].numbers[k] : call[i].number;
    };
    const auto apply = [&](std::uint32_t k) {
        if constexpr (kCount == 1) return function(at(0, k));
        if constexpr (kCount == 2) return function(at(0, k), at(1, k));
        if constexpr (kCount == 3) return function(at(0, k), at(1, k), at(2, k));
    };
    if (size == 0) return finite(call, apply(0));
    if (!take_numbers(call.budget, size, call.span, call.diagnostics)) return Value::poison();
    double* const results =
        static_cast<double*>(call.arena.allocate(size * sizeof(double), alignof(double)));
    for (std::uint32_t k = 0; k < size; ++k) {
        results[k] = apply(k);
        if (!std::isfinite(results[k])) return finite(call, results[k]);
    }
    return Value::of_numbers({results, size});
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
double lerp_of(double a, double b, double t) {
    return a + (b - a) * t;
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

Value min_of(Call& call) {
    return by_elements<2>(call, [](double a, double b) { return std::min(a, b); });
}
Value max_of(Call& call) {
    return by_elements<2>(call, [](double a, double b) { return std::max(a, b); });
}
Value clamp_of(Call& call) {
    return by_elements<3>(
        call, [](double x, double lo, double hi) { return std::max(lo, std::min(x, hi)); });
}
Value lerp_values(Call& call) {
    return by_elements<3>(call, lerp_of);
}

Value smoothstep_of(Call& call) {
    const double lo = call.number(0);
    const double hi = call.number(1);
    if (lo == hi) return no_value(call, "the two edges of `smoothstep` are the same");
    const double t = std::clamp((call.number(2) - lo) / (hi - lo), 0.0, 1.0);
    return Value::of(t * t * (3.0 - 2.0 * t));
}
Value hypot_of(Call& call) {
    return finite(call, std::hypot(call.number(0), call.number(1)));
}
Value atan2_of(Call& call) {
    return finite(call, degrees(std::atan2(call.number(0), call.number(1))));
}

std::span<const double> numbers_of(const Value& value) {
    return {value.numbers, value.count};
}

double length_of(std::span<const double> v) {
    double largest = 0.0;  // taken out first, so that squares stay finite
    for (const double x : v) largest = std::max(largest, std::fabs(x));
    if (largest == 0.0) return 0.0;
    double sum = 0.0;
    for (const double x : v) sum += (x / largest) * (x / largest);
    return largest * std::sqrt(sum);
}

bool same_size(Call& call) {
    if (call[0].count == call[1].count) return true;
    call.diagnostics.error(
        Code::E0302, call.span,
        fmt::format("these have {} and {} elements", call[0].count, call[1].count));
    return false;
}

double dot_of(std::span<const double> a, std::span<const double> b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

Value vector_length(Call& call) {
    return finite(call, length_of(numbers_of(call[0])));
}

Value vector_distance(Call& call) {
    if (!same_size(call)) return Value::poison();
    std::array<double, 4> difference{};
    for (std::uint32_t i = 0; i < call[0].count; ++i) {
        difference[i] = call[1].numbers[i] - call[0].numbers[i];
    }
    return finite(call, length_of({difference.data(), call[0].count}));
}

Value vector_normalize(Call& call) {
    const double length = length_of(numbers_of(call[0]));
    if (length == 0.0) return no_value(call, "a vector of length 0 has no direction");
    const std::span<double> result = call.arena.copy(numbers_of(call[0]));
    for (double& x : result) x /= length;
    return Value::of_numbers(result);
}

Value vector_dot(Call& call) {
    if (!same_size(call)) return Value::poison();
    return finite(call, dot_of(numbers_of(call[0]), numbers_of(call[1])));
}

Value of_vec3(Call& call, DVec3 v) {
    const std::array<double, 3> numbers = {v.x, v.y, v.z};
    return Value::of_numbers(call.arena.copy(std::span<const double>(numbers)));
}

Value vector_cross(Call& call) {
    return of_vec3(call, cross(call[0].vec3(), call[1].vec3()));
}

Value vector_reflect(Call& call) {
    const DVec3 incoming = call[0].vec3();
    const DVec3 normal = call[1].vec3();
    return of_vec3(call, incoming - 2.0 * dot(incoming, normal) * normal);
}

// Kahan: accurate for small and for nearly straight angles.
Value vector_angle_between(Call& call) {
    if (!same_size(call)) return Value::poison();
    const double a = length_of(numbers_of(call[0]));
    const double b = length_of(numbers_of(call[1]));
    if (a == 0.0 || b == 0.0) return no_value(call, "a vector of length 0 has no direction");
    std::array<double, 4> sum{};
    std::array<double, 4> difference{};
    for (std::uint32_t i = 0; i < call[0].count; ++i) {
        sum[i] = call[0].numbers[i] / a + call[1].numbers[i] / b;
        difference[i] = call[0].numbers[i] / a - call[1].numbers[i] / b;
    }
    return Value::of(2.0 * degrees(std::atan2(length_of({difference.data(), call[0].count}),
                                              length_of({sum.data(), call[0].count}))));
}

Value of_rgb(Call& call, double r, double g, double b) {
    const std::array<double, 4> rgba = {r, g, b, 1.0};
    return Value::of_color(call.arena.copy(std::span<const double>(rgba)).data());
}

Value color_rgb(Call& call) {
    return of_rgb(call, call.number(0), call.number(1), call.number(2));
}
Value color_srgb(Call& call) {
    return of_rgb(call, image::srgb_decode(call.number(0)), image::srgb_decode(call.number(1)),
                  image::srgb_decode(call.number(2)));
}
Value color_gray(Call& call) {
    return of_rgb(call, call.number(0), call.number(0), call.number(0));
}

/// One channel of a hue in degrees: a trapezoid, 1 within 60 degrees of its own hue.
double hue_channel(double hue, double own) {
    const double away = std::fabs(std::remainder(hue - own, 360.0));
    return std::clamp(2.0 - away / 60.0, 0.0, 1.0);
}

Value of_display(Call& call, double lo, double hi, double hue) {
    const auto channel = [&](double own) {
        return image::srgb_decode(lo + (hi - lo) * hue_channel(hue, own));
    };
    return of_rgb(call, channel(0.0), channel(120.0), channel(240.0));
}

Value color_hsv(Call& call) {
    const double saturation = std::clamp(call.number(1), 0.0, 1.0);
    const double value = std::clamp(call.number(2), 0.0, 1.0);
    return of_display(call, value * (1.0 - saturation), value, call.number(0));
}

Value color_hsl(Call& call) {
    const double saturation = std::clamp(call.number(1), 0.0, 1.0);
    const double lightness = std::clamp(call.number(2), 0.0, 1.0);
    const double reach = saturation * std::min(lightness, 1.0 - lightness);
    return of_display(call, lightness - reach, lightness + reach, call.number(0));
}

Value color_mix(Call& call) {
    const auto channel = [&](const Value& color, unsigned i) {
        return color.is(ValueKind::number) ? color.number : color.numbers[i];
    };
    const double t = call.number(2);
    std::array<double, 3> mixed{};
    for (unsigned i = 0; i < 3; ++i)
        mixed[i] = lerp_of(channel(call[0], i), channel(call[1], i), t);
    return of_rgb(call, mixed[0], mixed[1], mixed[2]);
}

Value of_transform(Call& call, const Transform& transform) {
    if (!transform.is_finite()) return no_value(call, "this transform is not finite");
    return Value::of_transform(call.arena.make<Transform>(transform));
}

Value make_translation(Call& call) {
    return of_transform(call, Transform::translation(call[0].vec3()));
}
Value make_rotation(Call& call) {
    if (call[0].vec3() == DVec3{0.0}) return no_value(call, "an axis of length 0 has no direction");
    const Transform turn = Transform::rotation(call[0].vec3(), call.number(1));
    if (call[2].is(ValueKind::none)) return of_transform(call, turn);
    const DVec3 about = call[2].vec3();
    return of_transform(
        call, Transform::translation(-about).then(turn).then(Transform::translation(about)));
}
Value make_rotation_x(Call& call) {
    return of_transform(call, Transform::rotation_x(call.number(0)));
}
Value make_rotation_y(Call& call) {
    return of_transform(call, Transform::rotation_y(call.number(0)));
}
Value make_rotation_z(Call& call) {
    return of_transform(call, Transform::rotation_z(call.number(0)));
}
Value make_scaling(Call& call) {
    return of_transform(call, scaling_of(call[0]));
}
Value make_matrix(Call& call) {
    return of_transform(call, matrix_of(call[0]));
}
Value make_inverse(Call& call) {
    const std::optional<Transform> inverse = call[0].transform->inverse();
    if (inverse) return of_transform(call, *inverse);
    call.diagnostics.error(Code::E0310, call.span, "this transform cannot be inverted");
    return Value::poison();
}
Value apply_transform(Call& call) {
    return of_vec3(call, call[0].transform->point(call[1].vec3()));
}

using enum ParameterType;

constexpr Parameter kX{"x", elements};
constexpr Parameter kNumber{"x", number};
constexpr Parameter kAngle{"angle", number};
constexpr Parameter kVector{"v", vector};

// clang-format off
constexpr std::array kBuiltins = {
    Builtin{"abs", {kX}, each<abs_of>, "without its sign"},
    Builtin{"sign", {kX}, each<sign_of>, "-1, 0 or 1"},
    Builtin{"min", {{{"a", elements}, {"b", elements}}}, min_of, "the lesser"},
    Builtin{"max", {{{"a", elements}, {"b", elements}}}, max_of, "the greater"},
    Builtin{"clamp", {{{"x", elements}, {"lo", elements}, {"hi", elements}}}, clamp_of, "kept between lo and hi"},
    Builtin{"lerp", {{{"a", elements}, {"b", elements}, {"t", elements}}}, lerp_values, "a at t = 0, b at t = 1"},
    Builtin{"smoothstep", {{{"lo", number}, {"hi", number}, {"x", number}}}, smoothstep_of, "0 to 1, smoothly, as x goes from lo to hi"},
    Builtin{"floor", {kX}, each<floor_of>, "the whole number below"},
    Builtin{"ceil", {kX}, each<ceil_of>, "the whole number above"},
    Builtin{"round", {kX}, each<round_of>, "the nearest whole number, halves away from 0"},
    Builtin{"trunc", {kX}, each<trunc_of>, "the whole number towards 0"},
    Builtin{"frac", {kX}, each<frac_of>, "x - floor(x)"},
    Builtin{"sqrt", {kX}, each<sqrt_of>, "square root"},
    Builtin{"exp", {kNumber}, of_number<exp_of>, "e to the power of x"},
    Builtin{"log", {kNumber}, of_number<log_of>, "natural logarithm"},
    Builtin{"log2", {kNumber}, of_number<log2_of>, "logarithm to base 2"},
    Builtin{"log10", {kNumber}, of_number<log10_of>, "logarithm to base 10"},
    Builtin{"hypot", {{{"x", number}, {"y", number}}}, hypot_of, "sqrt(x * x + y * y)"},
    Builtin{"sin", {kAngle}, of_number<sin_of>, "sine of degrees"},
    Builtin{"cos", {kAngle}, of_number<cos_of>, "cosine of degrees"},
    Builtin{"tan", {kAngle}, of_number<tan_of>, "tangent of degrees"},
    Builtin{"asin", {kNumber}, of_number<asin_of>, "arc sine, in degrees"},
    Builtin{"acos", {kNumber}, of_number<acos_of>, "arc cosine, in degrees"},
    Builtin{"atan", {kNumber}, of_number<atan_of>, "arc tangent, in degrees"},
    Builtin{"atan2", {{{"y", number}, {"x", number}}}, atan2_of, "angle of the point (x, y), in degrees"},
    Builtin{"radians", {kX}, each<radians_of>, "degrees to radians"},
    Builtin{"degrees", {kX}, each<degrees_of>, "radians to degrees"},
    Builtin{"length", {kVector}, vector_length, "length of a vector"},
    Builtin{"distance", {{{"a", vector}, {"b", vector}}}, vector_distance, "distance of two points"},
    Builtin{"normalize", {kVector}, vector_normalize, "the vector of length 1"},
    Builtin{"dot", {{{"a", vector}, {"b", vector}}}, vector_dot, "scalar product"},
    Builtin{"cross", {{{"a", vec3}, {"b", vec3}}}, vector_cross, "vector product"},
    Builtin{"reflect", {{{"v", vec3}, {"normal", vec3}}}, vector_reflect, "v mirrored at a plane with a unit normal"},
    Builtin{"angle_between", {{{"a", vector}, {"b", vector}}}, vector_angle_between, "angle of two vectors, in degrees"},
    Builtin{"rgb", {{{"r", number}, {"g", number}, {"b", number}}}, color_rgb, "a colour, linear"},
    Builtin{"srgb", {{{"r", number}, {"g", number}, {"b", number}}}, color_srgb, "a colour as displays show it, 0 to 1"},
    Builtin{"gray", {{{"value", number}}}, color_gray, "a grey, linear"},
    Builtin{"hsv", {{{"hue", number}, {"saturation", number}, {"value", number}}}, color_hsv, "a colour by hue in degrees"},
    Builtin{"hsl", {{{"hue", number}, {"saturation", number}, {"lightness", number}}}, color_hsl, "a colour by hue in degrees"},
    Builtin{"mix", {{{"a", color}, {"b", color}, {"t", number}}}, color_mix, "a at t = 0, b at t = 1"},
    Builtin{"translation", {{{"offset", vec3}}}, make_translation, "moves"},
    Builtin{"rotation", {{{"axis", vec3}, {"angle", number}, {"about", vec3, true}}}, make_rotation, "turns about an axis through a point"},
    Builtin{"rotation_x", {kAngle}, make_rotation_x, "turns about X"},
    Builtin{"rotation_y", {kAngle}, make_rotation_y, "turns about Y"},
    Builtin{"rotation_z", {kAngle}, make_rotation_z, "turns about Z"},
    Builtin{"scaling", {{{"factor", any_scale}}}, make_scaling, "scales by a number or by three"},
    Builtin{"matrix", {{{"rows", rows}}}, make_matrix, "3 or 4 rows of 4 numbers"},
    Builtin{"inverse", {{{"t", transform}}}, make_inverse, "undoes a transform"},
    Builtin{"apply", {{{"t", transform}, {"p", vec3}}}, apply_transform, "where a point goes"},
};
// clang-format on

bool fits(ParameterType type, const Value& value) {
    switch (type) {
        case number:
            return value.is(ValueKind::number);
        case elements:
            return value.is(ValueKind::number) || value.is(ValueKind::numbers);
        case vector:
            return value.is(ValueKind::numbers) && value.count >= 2 && value.count <= 4;
        case vec3:
            return value.is_vector(3);
        case ParameterType::color:
            return value.is(ValueKind::color) || value.is(ValueKind::number) || value.is_vector(3);
        case transform:
            return value.is(ValueKind::transform);
        case rows:
            return value.is(ValueKind::rows) && value.width == 4 &&
                   (value.count == 3 || value.count == 4);
        case any_scale:
            return value.is(ValueKind::number) || value.is_vector(3);
        case any:
            return true;
        case integer:
            return value.is(ValueKind::number) && value.number == std::floor(value.number);
        case string:
            return value.is(ValueKind::string);
        case list:
            return value.is_list();
        case numbers:
            return value.is(ValueKind::numbers) || (value.is_list() && value.count == 0);
        case function:
            return value.is(ValueKind::function);
        case node:
            return value.is(ValueKind::node);
        case position:
            return value.is(ValueKind::number) || value.is_vector(2) || value.is_vector(3);
        case key:
            return value.is(ValueKind::number) || value.is(ValueKind::string);
    }
    LRAY_ASSERT(false);
}

std::string_view in_words(ParameterType type) {
    switch (type) {
        case number:
            return "a number";
        case elements:
            return "a number or a vector";
        case vector:
            return "a vector";
        case vec3:
            return "3 numbers, like [1, 2, 3]";
        case ParameterType::color:
            return "a colour";
        case transform:
            return "a transform";
        case rows:
            return "3 or 4 rows of 4 numbers";
        case any_scale:
            return "a number or three";
        case any:
            return "a value";
        case integer:
            return "a whole number";
        case string:
            return "a string";
        case list:
            return "a list";
        case numbers:
            return "a list of numbers";
        case function:
            return "a function";
        case node:
            return "a node, like a group or a sphere";
        case position:
            return "a number or a vector of 2 or 3";
        case key:
            return "a number or a string";
    }
    LRAY_ASSERT(false);
}

}  // namespace

std::size_t Builtin::parameter_count() const {
    std::size_t count = 0;
    while (count < kMaxParameters && !parameters[count].name.empty()) ++count;
    return count;
}

std::size_t Builtin::required_count() const {
    std::size_t count = 0;
    while (count < parameter_count() && !parameters[count].is_optional) ++count;
    return count;
}

std::span<const Builtin> builtins() {
    static const std::vector<Builtin> all = [] {
        std::vector<Builtin> list(kBuiltins.begin(), kBuiltins.end());
        for (const auto& family : {noise_builtins(), random_builtins()}) {
            list.insert(list.end(), family.begin(), family.end());
        }
        return list;
    }();
    return all;
}

std::optional<std::uint32_t> find_builtin(std::string_view name) {
    for (std::size_t i = 0; i < builtins().size(); ++i) {
        if (builtins()[i].name == name) return static_cast<std::uint32_t>(i);
    }
    return std::nullopt;
}

Value call_builtin(const Builtin& builtin, Call& call) {
    for (std::size_t i = 0; i < builtin.parameter_count(); ++i) {
        const Value& argument = call.arguments[i];
        if (argument.is(ValueKind::poison)) return argument;
        const Parameter& parameter = builtin.parameters[i];
        if (argument.is(ValueKind::none) || fits(parameter.type, argument)) continue;
        const bool is_vector =
            argument.is(ValueKind::numbers) && (parameter.type == vec3 || parameter.type == vector);
        call.diagnostics.error(
            is_vector ? Code::E0303 : Code::E0301, call.spans[i],
            fmt::format("`{}` of `{}` needs {}, this is {}", parameter.name, builtin.name,
                        in_words(parameter.type), describe(argument)));
        return Value::poison();
    }
    for (std::size_t i = 0; i < call.rest.size(); ++i) {
        const Value& argument = call.rest[i];
        if (argument.is(ValueKind::poison)) return argument;
        if (fits(builtin.rest_type, argument)) continue;
        call.diagnostics.error(Code::E0301, call.rest_spans[i],
                               fmt::format("`{}` needs {}, this is {}", builtin.name,
                                           in_words(builtin.rest_type), describe(argument)));
        return Value::poison();
    }
    call.name = builtin.name;
    return builtin.function(call);
}

}  // namespace lray::parser
