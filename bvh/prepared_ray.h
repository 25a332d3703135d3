// What of a ray is worked out once instead of at every primitive.
#pragma once

#include <cmath>

#include "base/ray.h"

namespace lray::bvh {

/// A ray in double precision, and in float the axes and the shear of the watertight triangle test:
/// kz is the axis along which the ray runs fastest, and adding (-shear_x, -shear_y) z to the x and
/// y of a vertex (in permuted axes, relative to the origin) makes the ray the z axis.
/// NaN and a direction of 0 make NaN shears: no primitive is hit.
/// Source: Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection", sec. 3.
struct PreparedRay {
    DVec3 origin{};
    DVec3 dir{};
    Vec3 origin_float{};
    int kx = 0;
    int ky = 1;
    int kz = 2;
    float shear_x = 0.0f;
    float shear_y = 0.0f;
    double t_per_z = 0.0;  // 1 / dir[kz]
};

inline PreparedRay prepare(const Ray& ray) {
    PreparedRay result;
    result.origin = DVec3{ray.origin};
    result.dir = DVec3{ray.dir};
    result.origin_float = ray.origin;
    const float x = std::fabs(ray.dir.x);
    const float y = std::fabs(ray.dir.y);
    const float z = std::fabs(ray.dir.z);
    result.kz = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
    result.kx = (result.kz + 1) % 3;
    result.ky = (result.kx + 1) % 3;
    const float dir_z = ray.dir[result.kz];
    result.shear_x = ray.dir[result.kx] / dir_z;
    result.shear_y = ray.dir[result.ky] / dir_z;
    result.t_per_z = 1.0 / static_cast<double>(dir_z);
    return result;
}

}  // namespace lray::bvh
