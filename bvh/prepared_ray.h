// What of a ray is worked out once instead of at every primitive.
#pragma once

#include <cmath>

#include "base/ray.h"
#include "bvh/float4.h"
#include "bvh/float_ray.h"

namespace lray::bvh {

/// A ray in double precision, and what is needed of it in float.
/// NaN and a direction of 0 make NaN shears: no primitive is hit.
/// Source: Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection", sec. 3.
struct PreparedRay : FloatRay {
    DVec3 origin;
    DVec3 dir;
};

/// The six numbers of a ray.
inline const float* numbers_of(const Ray& ray) {
    static_assert(sizeof(Ray) == 6 * sizeof(float));
    return reinterpret_cast<const float*>(&ray);
}

/// True if the ray can hit anything: all its numbers are finite.
inline bool is_traceable(const Ray& ray) {
    const float* const numbers = numbers_of(ray);
    return are_finite(load_four(numbers)) && are_finite(load_four(numbers + 2));
}

/// Returns the ray without that which prepare_floats() works out.
inline PreparedRay set_out(const Ray& ray) {
    const Float4 origin = load_four(numbers_of(ray));
    const Float4 dir = rotated(load_four(numbers_of(ray) + 2));
    PreparedRay result;
    store_four(result.origin_float, origin);
    store_four(result.dir_float, dir);
    store_three_wide(&result.origin.x, origin);
    store_three_wide(&result.dir.x, dir);
    return result;
}

/// Likewise. Space: any, if `dir` keeps the length that the way there gives it: t stays the
/// world's.
inline PreparedRay set_out(DVec3 origin, DVec3 dir) {
    const Vec3 origin_float{origin};
    const Vec3 dir_float{dir};
    PreparedRay result;
    store_four(result.origin_float, Float4::of(origin_float.x, origin_float.y, origin_float.z));
    store_four(result.dir_float, Float4::of(dir_float.x, dir_float.y, dir_float.z));
    result.origin = origin;
    result.dir = dir;
    return result;
}

/// Works out the rest of a ray. Walks do it for themselves, with vectors (simd/slabs-inl.h).
inline void prepare_floats(FloatRay& ray) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float speed = std::fabs(ray.dir_float[axis]);
        const float inverse =
            1.0f / std::copysign(speed > kLeastSpeed ? speed : kLeastSpeed, ray.dir_float[axis]);
        const float origin = ray.origin_float[axis];
        const float slack = std::fabs(origin) * kOriginSlack + kLeastOriginSlack;
        const float ahead = std::copysign(slack, ray.dir_float[axis]);
        ray.inv_dir[axis] = inverse;
        ray.inv_dir_far[axis] = inverse * kExitFactor;
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
    PreparedRay result = set_out(ray);
    prepare_floats(result);
    return result;
}

}  // namespace lray::bvh
