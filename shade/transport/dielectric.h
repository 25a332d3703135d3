// Smooth boundaries between transparent media: how much is reflected, and where the rest goes.
// Frame: any; all directions are unit. Nothing here depends on the colour of the light.
#pragma once

#include <cmath>
#include <optional>

#include "base/vec.h"

namespace lray::shade {

/// Returns the share of unpolarised light that a boundary reflects; 1 beyond the critical angle, 0
/// where there is no boundary (eta 1).
/// Shape: `cos_in` in [0, 1] is that of the angle to the normal; `eta` greater than 0 is the index
/// of refraction behind the boundary by that before it.
/// Source: Fresnel's equations; Pharr, Jakob, Humphreys 2023, "Physically Based Rendering", 4th
/// ed., sec. 9.3.5.
inline float fresnel_reflectance(float cos_in, float eta) {
    if (eta == 1.0f) return 0.0f;
    const double c = static_cast<double>(cos_in);
    const double n = static_cast<double>(eta);
    const double sin2_out = (1.0 - c * c) / (n * n);
    if (sin2_out >= 1.0) return 1.0f;
    const double cos_out = std::sqrt(1.0 - sin2_out);
    const double parallel = (n * c - cos_out) / (n * c + cos_out);
    const double across = (c - n * cos_out) / (c + n * cos_out);
    return static_cast<float>(0.5 * (parallel * parallel + across * across));
}

/// Returns the direction in which a ray goes on behind the boundary; empty beyond the critical
/// angle. `wo` points back along the ray, `normal` is on its side.
/// Source: Snell's law.
inline std::optional<Vec3> refracted(Vec3 wo, Vec3 normal, float eta) {
    if (eta == 1.0f) return -wo;
    const DVec3 n{normal};
    const DVec3 o{wo};
    const double c = dot(n, o);
    const double inverse = 1.0 / static_cast<double>(eta);
    const DVec3 across = inverse * (c * n - o);  // of the refracted ray, along the boundary
    const double along2 = 1.0 - dot(across, across);
    if (!(along2 > 0.0)) return std::nullopt;
    const DVec3 direction = across - std::sqrt(along2) * n;
    return Vec3{direction / std::sqrt(dot(direction, direction))};
}

/// Returns the mirror direction of `wo` about the normal.
inline Vec3 mirrored(Vec3 wo, Vec3 normal) {
    const DVec3 n{normal};
    const DVec3 o{wo};
    const DVec3 direction = 2.0 * dot(n, o) * n - o;
    return Vec3{direction / std::sqrt(dot(direction, direction))};
}

}  // namespace lray::shade
