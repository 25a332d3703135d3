// Powers of the cosine of an angle that is known by its tangent, and directions so distributed:
// what the highlights of Phong and Blinn are made of.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "base/vec.h"
#include "shade/models/hemisphere.h"

namespace lray::shade {

/// Returns cos^exponent = (1 + tan^2)^(-exponent / 2). The cosine itself, rounded to float, would
/// lose the highlight: 6e-8 of it are 10000 * 6e-8 of its power. The exponential of x is off by
/// x e^-x <= 0.37 times the relative error of x, whatever the exponent: the result by 2e-7 at most.
inline float cosine_power(double tan_squared, float exponent) {
    // 1e30 is as good as the horizon, and a float.
    const float t = static_cast<float>(std::min(tan_squared, 1e30));
    // log(1 + t) to a few units in the last place, by the logarithm of the rounded sum alone.
    // Source: Goldberg 1991, "What Every Computer Scientist Should Know About Floating-Point
    // Arithmetic", theorem 4.
    const float sum = 1.0f + t;
    const float logarithm = sum == 1.0f ? t : std::log(sum) * (t / (sum - 1.0f));
    const float x = 0.5f * exponent * logarithm;
    constexpr float kNothing = 87.0f;  // e^-87 is next to the least normal float
    return x < kNothing ? std::exp(-x) : 0.0f;
}

/// Returns a unit direction about +z with the density (exponent + 1) / (2 pi) z^exponent.
inline DVec3 cosine_power_direction(DVec2 u, float exponent) {
    const double l = -2.0 * natural_logarithm(1.0 - u.x) / (static_cast<double>(exponent) + 1.0);
    const double cos_squared = exponential(-l);
    const double sine = std::sqrt(std::max(1.0 - cos_squared, 0.0));
    const float angle = 2.0f * kPi * static_cast<float>(u.y);
    return {sine * static_cast<double>(std::cos(angle)),
            sine * static_cast<double>(std::sin(angle)), std::sqrt(cos_squared)};
}

/// Its density, the power already known.
inline float cosine_power_pdf(float power, float exponent) {
    return (exponent + 1.0f) * (0.5f * kInversePi) * power;
}

}  // namespace lray::shade
