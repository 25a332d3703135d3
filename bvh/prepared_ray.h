// What of a ray is worked out once instead of at every primitive.
#pragma once

#include <cmath>

#include "base/ray.h"
#include "bvh/float_ray.h"

namespace lray::bvh {

/// A ray in double precision, and what is needed of it in float.
/// NaN and a direction of 0 make NaN shears: no primitive is hit.
/// Source: Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection", sec. 3.
struct PreparedRay : FloatRay {
    DVec3 origin;
    DVec3 dir;
};

/// True if the ray can hit anything: all its numbers are finite.
inline bool is_traceable(const Ray& ray) {
    // What is not finite leaves NaN.
    const Vec3 nothing = (ray.origin - ray.origin) + (ray.dir - ray.dir);
    return nothing.x + nothing.y + nothing.z == 0.0f;
}

/// Returns the ray without that which prepare_floats() works out.
/// Space: any, if `dir` keeps the length that the way there gives it: t stays the world's.
inline PreparedRay set_out(DVec3 origin, DVec3 dir) {
    PreparedRay result;
    result.origin = origin;
    result.dir = dir;
    for (int axis = 0; axis < 3; ++axis) {
        result.origin_float[axis] = static_cast<float>(origin[axis]);
        result.dir_float[axis] = static_cast<float>(dir[axis]);
    }
    result.origin_float[3] = 0.0f;
    result.dir_float[3] = 1.0f;
    return result;
}

inline PreparedRay set_out(const Ray& ray) {
    return set_out(DVec3{ray.origin}, DVec3{ray.dir});
}

/// Works out the rest of a ray. Walks do it for themselves, with vectors (simd/blocks-inl.h).
inline void prepare_floats(FloatRay& ray) {
    for (std::size_t axis = 0; axis < 4; ++axis) {
        const float inverse = 1.0f / ray.dir_float[axis];
        const float limited = inverse > kMaxInverse    ? kMaxInverse
                              : inverse < -kMaxInverse ? -kMaxInverse
                                                       : inverse;
        const float origin = ray.origin_float[axis];
        const float slack = std::fabs(origin) * kOriginSlack + kLeastOriginSlack;
        const float ahead = std::copysign(slack, ray.dir_float[axis]);
        ray.inv_dir[axis] = limited;
        ray.inv_dir_far[axis] = limited * kExitFactor;
        ray.origin_near[axis] = origin + ahead;
        ray.origin_far[axis] = origin - ahead;
        ray.near_side[axis] = std::signbit(ray.dir_float[axis]) ? 1 : 0;
    }
    const float x = std::fabs(ray.dir_float[0]);
    const float y = std::fabs(ray.dir_float[1]);
    const float z = std::fabs(ray.dir_float[2]);
    ray.axes[2] = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
    ray.axes[0] = (ray.axes[2] + 1) % 3;
    ray.axes[1] = (ray.axes[0] + 1) % 3;
    ray.shear_x = ray.dir_float[ray.axes[0]] / ray.dir_float[ray.axes[2]];
    ray.shear_y = ray.dir_float[ray.axes[1]] / ray.dir_float[ray.axes[2]];
}

inline PreparedRay prepare(DVec3 origin, DVec3 dir) {
    PreparedRay result = set_out(origin, dir);
    prepare_floats(result);
    return result;
}

inline PreparedRay prepare(const Ray& ray) {
    return prepare(DVec3{ray.origin}, DVec3{ray.dir});
}

}  // namespace lray::bvh
