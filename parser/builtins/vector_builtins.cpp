// Functions of vectors: lengths, directions, products.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/angle.h"
#include "parser/builtins/families.h"
#include "parser/builtins/results.h"

namespace lray::parser {

namespace {

double length_of(std::span<const double> v) {
    double largest = 0.0;  // taken out first, so that squares stay finite
    for (const double x : v) largest = std::max(largest, std::fabs(x));
    if (largest == 0.0) return 0.0;
    double sum = 0.0;
    for (const double x : v) sum += (x / largest) * (x / largest);
    return largest * std::sqrt(sum);
}

bool same_size(Call& call) {
    if (call[0].count != call[1].count) lengths_differ(call, call[0].count, call[1].count);
    return call[0].count == call[1].count;
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
    double* const result = take_list_of_numbers(call, call[0].count);
    if (result == nullptr) return Value::poison();
    for (std::uint32_t i = 0; i < call[0].count; ++i) result[i] = call[0].numbers[i] / length;
    return finite(call, std::span<const double>(result, call[0].count));
}

Value vector_dot(Call& call) {
    if (!same_size(call)) return Value::poison();
    return finite(call, dot_of(numbers_of(call[0]), numbers_of(call[1])));
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

using enum ParameterType;

constexpr Parameter kVector{"v", vector};

// clang-format off
constexpr std::array kBuiltins = {
    Builtin{"length", {kVector}, vector_length, "length of a vector"},
    Builtin{"distance", {{{"a", vector}, {"b", vector}}}, vector_distance, "distance of two points"},
    Builtin{"normalize", {kVector}, vector_normalize, "the vector of length 1"},
    Builtin{"dot", {{{"a", vector}, {"b", vector}}}, vector_dot, "scalar product"},
    Builtin{"cross", {{{"a", vec3}, {"b", vec3}}}, vector_cross, "vector product"},
    Builtin{"reflect", {{{"v", vec3}, {"normal", vec3}}}, vector_reflect, "v mirrored at a plane with a unit normal"},
    Builtin{"angle_between", {{{"a", vector}, {"b", vector}}}, vector_angle_between, "angle of two vectors, in degrees"},
};
// clang-format on

}  // namespace

std::span<const Builtin> vector_builtins() {
    return kBuiltins;
}

}  // namespace lray::parser
