// Ray against disk, with or without a hole.
#pragma once

#include "bvh/kernels/kernel_hit.h"
#include "bvh/kernels/object_ray.h"

namespace lray::bvh {

/// The rim and the edge of the hole belong to the disk; a ray in its plane does not hit it. u and
/// v of the hit are 0.
inline Crossings crossings(const scene::Disk& disk, const PreparedRay& ray) {
    const ObjectRay local = object_ray(disk.frame, ray);
    const double t = -local.origin.y / local.dir.y;
    const double x = local.origin.x + t * local.dir.x;
    const double z = local.origin.z + t * local.dir.z;
    const double hole = static_cast<double>(disk.hole);
    const double distance2 = x * x + z * z;  // NaN or infinite for a ray in the plane
    Crossings result;
    if (distance2 <= 1.0 && distance2 >= hole * hole) result.add(t);
    return result;
}

}  // namespace lray::bvh
