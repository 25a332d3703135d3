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

    // For slabs: 1 / dir, at most kMaxInverse; and the origin as the planes of a box see it that
    // the ray passes first (near) and last (far), moved apart by its error.
    Vec3 inv_dir{};
    Vec3 inv_dir_far{};  // larger by the slack of slabs: it makes them be left later
    Vec3 origin_near{};
    Vec3 origin_far{};
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

/// Space: any, if `dir` keeps the length that the way there gives it: t stays the world's.
inline PreparedRay prepare(DVec3 origin, DVec3 dir) {
    PreparedRay result;
    result.origin = origin;
    result.dir = dir;
    result.origin_float = Vec3{origin};
    const Vec3 dir_float{dir};
    const float x = std::fabs(dir_float.x);
    const float y = std::fabs(dir_float.y);
    const float z = std::fabs(dir_float.z);
    result.kz = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
    result.kx = (result.kz + 1) % 3;
    result.ky = (result.kx + 1) % 3;
    const float dir_z = dir_float[result.kz];
    result.shear_x = dir_float[result.kx] / dir_z;
    result.shear_y = dir_float[result.ky] / dir_z;
    for (int axis = 0; axis < 3; ++axis) {
        const float inverse = 1.0f / dir_float[axis];
        result.inv_dir[axis] = inverse > kMaxInverse    ? kMaxInverse
                               : inverse < -kMaxInverse ? -kMaxInverse
                                                        : inverse;
        result.inv_dir_far[axis] = result.inv_dir[axis] * kExitFactor;
        const float origin_float = result.origin_float[axis];
        const float slack = std::fabs(origin_float) * kOriginSlack + kLeastOriginSlack;
        const float ahead = inverse < 0.0f ? -slack : slack;
        result.origin_near[axis] = origin_float + ahead;
        result.origin_far[axis] = origin_float - ahead;
    }
    return result;
}

inline PreparedRay prepare(const Ray& ray) {
    return prepare(DVec3{ray.origin}, DVec3{ray.dir});
}

}  // namespace lray::bvh
