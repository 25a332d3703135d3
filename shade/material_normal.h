// The shading normal of a surface with its material's bump and normal map.
#pragma once

#include "base/vec.h"
#include "bvh/surface_detail.h"
#include "scene/material.h"
#include "shade/textures/texture_point.h"
#include "shade/textures/texture_set.h"

namespace lray::shade {

/// Returns the shading normal of a material: the shape's, tilted by its normal map and then by its
/// bump. Unit, and never below the surface.
Vec3 material_normal(const scene::Material& material, const bvh::SurfaceDetail& detail,
                     Vec3 surface_normal, const TexturePoint& point, const TextureSet& textures);

}  // namespace lray::shade
