// Ray against ellipsoid: the unit sphere in object space.
#pragma once

#include "bvh/kernels/object_ray.h"
#include "bvh/kernels/quadratic.h"

namespace lray::bvh {

/// u and v of the hit are 0.
inline Crossings crossings(const scene::Ellipsoid& ellipsoid, const PreparedRay& ray) {
    const ObjectRay local = object_ray(ellipsoid.frame, ray);
    return ball_crossings(local.origin, local.dir, 1.0);
}

}  // namespace lray::bvh
