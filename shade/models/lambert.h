// Lambert's model: matt, as bright from all sides.
//
// Frame, measure and cosine as in reflection.h: values are pi f cos, here diffuse cos.
#pragma once

#include "shade/material_point.h"

namespace lray::shade {

inline Color lambert_reflected(const MaterialPoint& material, const Vec3& wi) {
    return material.diffuse * wi.z;
}

}  // namespace lray::shade
