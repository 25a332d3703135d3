// Logarithm, exponential, sine, cosine and arctangent made of IEEE operations alone: those of the C
// library differ in the last bit from one processor to another, and what is random or noise must
// not.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "base/vec.h"

namespace lray {

/// Returns the point of the unit circle at an angle in turns, 0 at +X and 1/4 at +Y.
/// Shape: `turns` in [0, 1]. Off by less than 1e-15.
constexpr DVec2 unit_circle_point(double turns) {
    const int quarter = static_cast<int>(turns * 4.0 + 0.5);               // the nearest one
    const double x = (turns - quarter * 0.25) * (2.0 * std::numbers::pi);  // an eighth at most
    // Taylor's series from their far ends; the first term left out is below 1e-16.
    double sine = 1.0;
    for (int k = 15; k >= 3; k -= 2) sine = 1.0 - sine * (x * x) / (k * (k - 1));
    sine *= x;
    double cosine = 1.0;
    for (int k = 16; k >= 2; k -= 2) cosine = 1.0 - cosine * (x * x) / (k * (k - 1));
    switch (quarter & 3) {
        case 0:
            return {cosine, sine};
        case 1:
            return {-sine, cosine};
        case 2:
            return {-cosine, -sine};
        default:
            return {sine, -cosine};
    }
}

namespace detail {

/// The arctangent of |t| <= 1/15 by Taylor's series: the first term left out is below 1e-16.
constexpr double small_arctangent(double t) {
    const double s = t * t;
    double sum = 0.0;
    for (int k = 11; k >= 3; k -= 2) sum = s * (1.0 / k - sum);
    return t - t * sum;
}

/// The angles, in turns, whose tangents are eighths.
constexpr std::array<double, 9> turns_of_eighths() {
    std::array<double, 9> result{};
    double angle = 0.0;
    for (std::size_t i = 1; i < result.size(); ++i) {
        // In two halves, each less than 1/15: the tangent of a difference is
        // (a - b) / (1 + a b).
        const double middle = (static_cast<double>(i) - 0.5) / 8.0;
        const double low = (static_cast<double>(i) - 1.0) / 8.0;
        const double high = static_cast<double>(i) / 8.0;
        angle += small_arctangent(0.0625 / (1.0 + middle * low)) +
                 small_arctangent(0.0625 / (1.0 + high * middle));
        result[i] = angle / (2.0 * std::numbers::pi);
    }
    return result;
}
inline constexpr std::array<double, 9> kTurnsOfEighths = turns_of_eighths();

}  // namespace detail

/// Returns the angle of a direction in turns, 0 at +X and 1/4 at +Y: what unit_circle_point() makes
/// a point of. 0 for the null vector.
/// Shape: finite components; the result is in [0, 1]. Off by less than 1e-15.
constexpr double turns_of(DVec2 direction) {
    const double x = direction.x < 0.0 ? -direction.x : direction.x;
    const double y = direction.y < 0.0 ? -direction.y : direction.y;
    const double most = x < y ? y : x;
    const double least = x < y ? x : y;
    if (!(most > 0.0)) return 0.0;
    // The rest to the nearest eighth of the tangent, by the tangent of a difference.
    const int eighths = static_cast<int>(8.0 * (least / most) + 0.5);
    const double tangent = eighths / 8.0;
    const double rest = (least - tangent * most) / (most + tangent * least);
    double turns = detail::kTurnsOfEighths[static_cast<std::size_t>(eighths)] +
                   detail::small_arctangent(rest) * (0.5 / std::numbers::pi);
    if (y > x) turns = 0.25 - turns;
    if (direction.x < 0.0) turns = 0.5 - turns;
    return direction.y < 0.0 ? 1.0 - turns : turns;
}

/// Returns the natural logarithm of a normal number greater than 0, to a few units in the last
/// place.
constexpr double natural_logarithm(double x) {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    int exponent = static_cast<int>(bits >> 52) - 1023;
    double m = std::bit_cast<double>((bits & 0xfffffffffffffu) | 0x3ff0000000000000u);  // [1, 2)
    if (m > std::numbers::sqrt2) {
        m *= 0.5;
        ++exponent;
    }
    // log m = 2 artanh(t) = 2 (t + t^3/3 + t^5/5 + ...), |t| < 0.1716: the rest is below 1e-17.
    const double t = (m - 1.0) / (m + 1.0);
    const double s = t * t;
    double sum = 0.0;
    for (int k = 21; k >= 3; k -= 2) sum = (sum + 1.0 / k) * s;
    return exponent * std::numbers::ln2 + 2.0 * (t + t * sum);
}

/// Returns e to the power of x, to a few units in the last place. Shape: x in [-700, 700].
constexpr double exponential(double x) {
    // The nearest multiple of ln 2, whose high part times a small integer is exact.
    constexpr double kLn2High = 0x1.62e42fefa3800p-1;
    constexpr double kLn2Low = 0x1.ef35793c76730p-45;
    const double turns = x * (1.0 / std::numbers::ln2);
    const int n = static_cast<int>(turns + (turns < 0.0 ? -0.5 : 0.5));
    const double r = (x - n * kLn2High) - n * kLn2Low;  // 0.347 at most
    // Taylor's series from its far end; the first term left out is below 1e-17.
    double sum = 1.0;
    for (int k = 13; k >= 1; k -= 1) sum = 1.0 + sum * r * (1.0 / k);
    return sum * std::bit_cast<double>(static_cast<std::uint64_t>(1023 + n) << 52);
}

}  // namespace lray
