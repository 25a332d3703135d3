// What a surface reflects of light from one direction into another: the choice among the reflection
// models, each in its own file. Mirrors and refraction are not here: they have no such density.
//
// Frame: the shading frame, z the unit normal on the side of wo, x along the surface's u.
// Directions are unit and point away from the surface. Measure: solid angle. All values are pi
// f(wi, wo), f the bidirectional reflectance distribution function, times the cosine of wi (wi.z):
// light that would make a white matt surface facing it as bright as 1 is 1. Then what leaves is
// irradiance / pi times this, and the formula of the Blinn-Phong model has no factors of pi.
#pragma once

#include <optional>

#include "base/vec.h"
#include "shade/material_point.h"
#include "shade/models/blinn_phong.h"
#include "shade/models/cook_torrance.h"
#include "shade/models/lambert.h"
#include "shade/models/phong.h"
#include "shade/models/ward.h"

namespace lray::shade {

/// Returns pi f cos of the material's model: diffuse and specular part. 0 unless wi.z and wo.z are
/// greater than 0.
inline Color reflected(const MaterialPoint& material, const Vec3& wi, const Vec3& wo) {
    if (!(wi.z > 0.0f && wo.z > 0.0f)) return Color{0.0f};
    switch (material.model) {
        case scene::ReflectionModel::lambert:
            return lambert_reflected(material, wi);
        case scene::ReflectionModel::phong:
            return phong_reflected(material, wi, wo);
        case scene::ReflectionModel::blinn_phong:
            return blinn_phong_reflected(material, wi, wo);
        case scene::ReflectionModel::cook_torrance:
            return cook_torrance_reflected(material, wi, wo);
        case scene::ReflectionModel::ward:
            return ward_reflected(material, wi, wo);
    }
    return Color{0.0f};
}

/// True if some directions are reflected much more than others.
inline bool has_highlight(const MaterialPoint& material) {
    return material.model != scene::ReflectionModel::lambert && material.specular != Color{0.0f};
}

/// A direction chosen at random, and the density of choosing it.
struct DirectionSample {
    Vec3 wi{};
    float pdf = 0.0f;  // per solid angle; greater than 0
};

/// Chooses wi about as reflected() is distributed. `choice` and `u` are uniform in [0, 1).
/// Errors: empty where nothing is reflected, or the direction lies below the surface.
std::optional<DirectionSample> sample_reflected(const MaterialPoint& material, Vec3 wo,
                                                double choice, DVec2 u);

/// Returns the density with which sample_reflected() chooses wi; 0 for directions it never does.
float reflected_pdf(const MaterialPoint& material, Vec3 wi, Vec3 wo);

/// Returns an estimate of the share of light from wo's direction that is reflected, per channel:
/// what chooses between this and mirror or refraction at random. Shape: at most 1 for materials
/// that keep energy; need not be exact.
Color reflected_share(const MaterialPoint& material, Vec3 wo);

}  // namespace lray::shade
