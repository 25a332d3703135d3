// Degrees and radians. Users write degrees; everything inside is radians (they end at the
// evaluator), but for sines and cosines of whole quarter turns, which must be exact.
#pragma once

#include <cmath>
#include <numbers>

namespace lray {

constexpr double radians(double degrees) {
    return degrees * (std::numbers::pi / 180.0);
}
constexpr double degrees(double radians) {
    return radians * (180.0 / std::numbers::pi);
}

/// Returns the sine of an angle in degrees: exact at multiples of 30 that have a short value.
inline double sin_degrees(double angle) {
    const double folded = std::fmod(angle, 360.0);  // exact
    const double magnitude = std::fabs(folded);
    const double sign = folded < 0.0 ? -1.0 : 1.0;
    // Symmetry about 90 and 180 degrees brings the angle to [0, 90]; the subtractions are exact.
    const double half = magnitude > 180.0 ? magnitude - 180.0 : magnitude;
    const double quarter = half > 90.0 ? 180.0 - half : half;
    const double outer = magnitude > 180.0 ? -sign : sign;
    if (quarter == 0.0) return 0.0;
    if (quarter == 30.0) return outer * 0.5;
    if (quarter == 90.0) return outer;
    return outer * std::sin(radians(quarter));
}

/// Returns the cosine of an angle in degrees; exact where sin_degrees is.
inline double cos_degrees(double angle) {
    return sin_degrees(90.0 - std::fabs(std::fmod(angle, 360.0)));
}

}  // namespace lray
