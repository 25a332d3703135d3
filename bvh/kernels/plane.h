// Ray against infinite plane.
#pragma once

#include "bvh/kernels/kernel_hit.h"
#include "bvh/prepared_ray.h"
#include "scene/world.h"

namespace lray::bvh {

/// A ray in the plane does not hit it. u and v of the hit are 0.
inline Crossings crossings(const scene::Plane& plane, const PreparedRay& ray) {
    const DVec3 normal{plane.normal};
    Crossings result;
    result.add(dot(normal, DVec3{plane.point} - ray.origin) / dot(normal, ray.dir));
    return result;
}

}  // namespace lray::bvh
