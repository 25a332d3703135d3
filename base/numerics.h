// Floating-point ground rules: rounding-error bounds and directed rounding. No epsilon in lray is
// a bare constant: each is derived from what stands here.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace lray {

static_assert(std::numeric_limits<float>::is_iec559 && std::numeric_limits<double>::is_iec559);

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Unit roundoff: the largest relative error of one rounded operation (half an ulp).
template <class Float>
inline constexpr Float kUnitRoundoff = std::numeric_limits<Float>::epsilon() / 2;

/// Returns a bound on the relative error after `n` rounded operations: n u / (1 - n u).
/// Source: Higham 2002, "Accuracy and Stability of Numerical Algorithms", lemma 3.1.
template <class Float = float>
constexpr Float gamma(int n) {
    const Float nu = static_cast<Float>(n) * kUnitRoundoff<Float>;
    return nu / (1 - nu);
}

/// Returns the least float greater than x. +infinity stays; NaN stays NaN.
constexpr float next_up(float x) {
    if (!(x < kInfinity)) return x;
    if (x == 0.0f) return std::bit_cast<float>(std::uint32_t{1});
    const auto bits = std::bit_cast<std::uint32_t>(x);
    return std::bit_cast<float>(x > 0.0f ? bits + 1 : bits - 1);
}

/// Returns the greatest float less than x. -infinity stays; NaN stays NaN.
constexpr float next_down(float x) {
    return -next_up(-x);
}

/// Returns the least float that is not less than x: for the upper side of a bound.
constexpr float round_up(double x) {
    const float nearest = static_cast<float>(x);
    return static_cast<double>(nearest) < x ? next_up(nearest) : nearest;
}

/// Returns the greatest float that is not greater than x: for the lower side of a bound.
constexpr float round_down(double x) {
    return -round_up(-x);
}

/// Returns the nearest whole number; halves, and the numbers next to one half, away from 0.
/// Shape: |x| < 2^62.
constexpr std::int64_t nearest_whole(double x) {
    return static_cast<std::int64_t>(x < 0.0 ? x - 0.5 : x + 0.5);
}

}  // namespace lray
