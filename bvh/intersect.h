// One ray against one primitive of any kind: the entry to the kernels.
#pragma once

#include "bvh/hit.h"
#include "bvh/prepared_ray.h"
#include "scene/world.h"

namespace lray::bvh {

/// Returns the nearest hit of the primitive in the open interval; none if there is none, or when
/// the ray holds a NaN. Whether the primitive is visible does not matter
/// here.
/// Errors: asserts that it is not an instance, which has no surface of its own.
Hit intersect(const scene::Geometry& geometry, scene::PrimitiveId id, const PreparedRay& ray,
              Interval interval);

}  // namespace lray::bvh
