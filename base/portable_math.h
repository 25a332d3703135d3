// Logarithm, exponential, sine and cosine made of IEEE operations alone: those of the C library
// differ in the last bit from one processor to another, and what is random or noise must not.
#pragma once

#include <bit>
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
