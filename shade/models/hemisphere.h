// Maps of the unit square onto the disk and the hemisphere about +z.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vec.h"

namespace lray::shade {

inline constexpr float kPi = std::numbers::pi_v<float>;
inline constexpr float kInversePi = std::numbers::inv_pi_v<float>;

/// Returns a point of the unit disk, uniform when u is uniform in [0, 1)^2; equal areas stay equal,
/// and what lies near stays near.
/// Source: Shirley, Chiu 1997, "A Low Distortion Map Between Disk and Square".
inline Vec2 on_disk(DVec2 u) {
    const float x = static_cast<float>(2.0 * u.x - 1.0);
    const float y = static_cast<float>(2.0 * u.y - 1.0);
    if (x == 0.0f && y == 0.0f) return Vec2{0.0f};
    const bool is_wide = std::abs(x) > std::abs(y);
    const float radius = is_wide ? x : y;
    const float angle = kPi / 4.0f * (is_wide ? y / x : 2.0f - x / y);
    return radius * Vec2{std::cos(angle), std::sin(angle)};
}

/// Returns a unit direction with the density z / pi per solid angle; z is greater than 0.
/// Source: Malley's method; Pharr, Jakob, Humphreys 2023, "Physically Based Rendering", 4th ed.,
/// sec. A.5.3.
inline Vec3 cosine_direction(DVec2 u) {
    const Vec2 p = on_disk(u);
    // On the rim rounding could leave 0: no farther down than a step of u of 2^-32 away from it.
    const float z_squared = std::max(1.0f - dot(p, p), 0x1p-32f);
    return {p.x, p.y, std::sqrt(z_squared)};
}

inline float cosine_pdf(float z) {
    return std::max(z, 0.0f) * kInversePi;
}

}  // namespace lray::shade
