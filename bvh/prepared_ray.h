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
    DVec3 origin{};
    DVec3 dir{};
};

/// The inverse of 0: it gives no NaN, and by it a box on whose face a ray runs is not left.
inline constexpr float kMaxInverse = 3e37f;

/// A box counts as left by so much later than computed. The slabs have three roundings, gamma(3);
/// the sheared vertices of the triangle kernel are off by as much again; the rest is room to spare.
/// Source: Ize 2013, "Robust BVH Ray Traversal", sec. 3.
inline constexpr float kSlabSlack = 0x1p-19f;
inline constexpr float kExitFactor = 1.0f + kSlabSlack;

/// How far the two origins lie from the true one, in parts of it and at least: times kMaxInverse,
/// that is farther than the world reaches.
inline constexpr float kOriginSlack = 0x1p-22f;
inline constexpr float kLeastOriginSlack = 0x1p-60f;

/// True if the ray can hit anything: all its numbers are finite.
inline bool is_traceable(const Ray& ray) {
    const auto is_finite = [](Vec3 v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    };
    return is_finite(ray.origin) && is_finite(ray.dir);
}

/// One axis of the slabs of a ray.
inline void prepare_slab(float origin, float dir, std::size_t axis, FloatRay& ray) {
    const float inverse = 1.0f / dir;
    const float limited = inverse > kMaxInverse    ? kMaxInverse
                          : inverse < -kMaxInverse ? -kMaxInverse
                                                   : inverse;
    const float slack = std::fabs(origin) * kOriginSlack + kLeastOriginSlack;
    const float ahead = std::copysign(slack, inverse);
    ray.inv_dir[axis] = limited;
    ray.inv_dir_far[axis] = limited * kExitFactor;
    ray.origin_float[axis] = origin;
    ray.origin_near[axis] = origin + ahead;
    ray.origin_far[axis] = origin - ahead;
    ray.near_side[axis] = std::signbit(inverse) ? 1 : 0;
}

/// Space: any, if `dir` keeps the length that the way there gives it: t stays the world's.
inline PreparedRay prepare(DVec3 origin, DVec3 dir) {
    PreparedRay result;
    result.origin = origin;
    result.dir = dir;
    const float d[3] = {static_cast<float>(dir.x), static_cast<float>(dir.y),
                        static_cast<float>(dir.z)};
    prepare_slab(static_cast<float>(origin.x), d[0], 0, result);
    prepare_slab(static_cast<float>(origin.y), d[1], 1, result);
    prepare_slab(static_cast<float>(origin.z), d[2], 2, result);
    // Without branches: rays after each other may run anywhere.
    const float x = std::fabs(d[0]);
    const float y = std::fabs(d[1]);
    const float z = std::fabs(d[2]);
    const std::uint32_t x_or_y = x > y ? 0 : 1;
    const std::uint32_t fastest = (x > y ? x : y) > z ? x_or_y : 2;
    const std::uint32_t next = fastest == 2 ? 0 : fastest + 1;
    const std::uint32_t last = next == 2 ? 0 : next + 1;
    result.axes[0] = next;
    result.axes[1] = last;
    result.axes[2] = fastest;
    result.shear_x = d[next] / d[fastest];
    result.shear_y = d[last] / d[fastest];
    return result;
}

inline PreparedRay prepare(const Ray& ray) {
    return prepare(DVec3{ray.origin}, DVec3{ray.dir});
}

}  // namespace lray::bvh
