// Phong's model: diffuse (N.I) + specular (R.V)^shininess, R the direction of light mirrored at the
// normal, V that of the eye; no highlight where R.V <= 0.
//
// Frame, measure and cosine as in reflection.h: values are pi f cos, so that f of the highlight is
// specular (R.V)^shininess / (pi cos).
// Source: Phong 1975, "Illumination for Computer Generated Pictures".
#pragma once

#include "shade/material_point.h"
#include "shade/models/cosine_power.h"
#include "shade/models/half_vector.h"

namespace lray::shade {

/// Returns (R.V)^shininess; the tangent by the cross product: it stays exact where R meets V.
inline float phong_highlight(float shininess, const Vec3& wi, const Vec3& wo) {
    const DVec3 r(-wi.x, -wi.y, wi.z);
    const DVec3 v(wo);
    const double cosine = dot(r, v);
    if (!(cosine > 0.0)) return 0.0f;
    const DVec3 across = cross(r, v);
    return cosine_power(dot(across, across) / (cosine * cosine), shininess);
}

inline Color phong_reflected(const MaterialPoint& material, const Vec3& wi, const Vec3& wo) {
    return material.diffuse * wi.z +
           material.specular * phong_highlight(material.shininess, wi, wo);
}

/// Chooses R about V; wi may point below the surface.
inline Vec3 phong_lobe_direction(const MaterialPoint& material, Vec3 wo, DVec2 u) {
    const DVec3 about_z = cosine_power_direction(u, material.shininess);
    // The half vector that mirrors +z onto the mirror direction of wo turns the lobe there.
    const DVec3 mirror(-wo.x, -wo.y, wo.z);
    const DVec3 half = glm::normalize(mirror + DVec3{0.0, 0.0, 1.0});
    const DVec3 turned = 2.0 * dot(half, about_z) * half - about_z;
    return Vec3(turned);
}

inline float phong_lobe_pdf(const MaterialPoint& material, Vec3 wi, Vec3 wo) {
    return cosine_power_pdf(phong_highlight(material.shininess, wi, wo), material.shininess);
}

/// Returns an estimate of what the highlight reflects in all for specular 1: its integral where no
/// part of it lies below the surface.
inline float phong_lobe_share(const MaterialPoint& material) {
    return 2.0f / (material.shininess + 1.0f);
}

}  // namespace lray::shade
