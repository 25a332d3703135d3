// Blinn's model: diffuse (N.I) + specular (N.H)^shininess, H halfway between the directions of
// light and eye. The highlight has no cosine of its own: near the horizon it reflects more than it
// gets where shininess is low.
//
// Frame, measure and cosine as in reflection.h: values are pi f cos, so that f of the highlight is
// specular (N.H)^shininess / (pi cos).
// Source: Blinn 1977, "Models of Light Reflection for Computer Synthesized Pictures".
#pragma once

#include <algorithm>
#include <cmath>

#include "shade/material_point.h"
#include "shade/models/cosine_power.h"
#include "shade/models/half_vector.h"

namespace lray::shade {

/// Returns (N.H)^shininess.
inline float blinn_phong_highlight(float shininess, const Vec3& wi, const Vec3& wo) {
    const DVec3 h = exactly_unit(wi) + exactly_unit(wo);
    return cosine_power((h.x * h.x + h.y * h.y) / (h.z * h.z), shininess);
}

inline Color blinn_phong_reflected(const MaterialPoint& material, const Vec3& wi, const Vec3& wo) {
    return material.diffuse * wi.z +
           material.specular * blinn_phong_highlight(material.shininess, wi, wo);
}

/// Chooses the half vector by its share of the highlight; may point below the surface.
inline Vec3 blinn_phong_lobe_direction(const MaterialPoint& material, Vec3 wo, DVec2 u) {
    return mirrored_at(wo, cosine_power_direction(u, material.shininess));
}

/// The density of half vectors becomes one of directions by 1 / (4 H.V); H.V is at least what
/// normals can tell from 0.
inline float blinn_phong_lobe_pdf(const MaterialPoint& material, Vec3 wi, Vec3 wo) {
    const DVec3 h = exactly_unit(wi) + exactly_unit(wo);
    const float power = cosine_power((h.x * h.x + h.y * h.y) / (h.z * h.z), material.shininess);
    const float half_cosine = static_cast<float>(std::sqrt(std::max(0.25 * dot(h, h), 0x1p-46)));
    return cosine_power_pdf(power, material.shininess) / (4.0f * half_cosine);
}

/// Returns an estimate of what the highlight reflects in all for specular 1: the integral over
/// half vectors of 4 H.V (N.H)^s / pi, with the root mean square of H.V; no more than the light of
/// the whole hemisphere.
inline float blinn_phong_lobe_share(const MaterialPoint& material, Vec3 wo) {
    const float s = material.shininess;
    const float half_cosine = std::sqrt((1.0f + s * wo.z * wo.z) / (s + 3.0f));
    return std::min(8.0f / (s + 1.0f) * half_cosine, 2.0f);
}

}  // namespace lray::shade
