// Ray against box: the cube [-1, 1]^3 in object space.
#pragma once

#include <cmath>
#include <limits>

#include "bvh/kernels/kernel_hit.h"
#include "bvh/kernels/object_ray.h"

namespace lray::bvh {

/// u of the hit is the face: 2 axis for the negative side, 2 axis + 1 for the positive one.
/// A ray along a face or through an edge hits: the far side is widened by the rounding error of
/// its t (pbrt 4th ed., 6.8.2), so none slips between two boxes that touch.
inline Crossings crossings(const scene::Box& box, const PreparedRay& ray) {
    const ObjectRay local = object_ray(box.frame, ray);
    double entry = -std::numeric_limits<double>::infinity();
    double exit = std::numeric_limits<double>::infinity();
    int entry_face = 0;
    int exit_face = 0;
    Crossings result;
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = local.origin[axis];
        const double dir = local.dir[axis];
        if (dir == 0.0) {
            if (!(std::fabs(origin) <= 1.0)) return result;
            continue;
        }
        const double side = dir > 0.0 ? 1.0 : -1.0;
        const double near = (-side - origin) / dir;
        const double far = (side - origin) / dir;
        if (!(near <= far)) return result;  // NaN
        if (near > entry) {
            entry = near;
            entry_face = 2 * axis + (dir > 0.0 ? 0 : 1);
        }
        if (far < exit) {
            exit = far;
            exit_face = 2 * axis + (dir > 0.0 ? 1 : 0);
        }
    }
    if (!(entry <= exit + 2.0 * gamma<double>(3) * std::fabs(exit))) return result;
    result.add(entry, entry_face);
    result.add(exit < entry ? entry : exit, exit_face);
    return result;
}

}  // namespace lray::bvh
