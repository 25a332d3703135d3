// Where a ray meets one primitive, in double: the position with what tells how far it may be off.
#pragma once

#include <cmath>

#include "bvh/hit.h"
#include "bvh/prepared_ray.h"
#include "scene/world.h"

namespace lray::bvh {

/// More rounded operations than any kernel performs between a ray's origin and the side of a
/// surface it takes it to be on.
inline constexpr int kKernelOperations = 32;

/// A position on a surface F = 0 that is positive outside, in double, with what tells how far the
/// position and the kernels may be off.
struct Site {
    DVec3 position{};
    DVec3 gradient{};        // of F, in the world: points outward
    double value = 0.0;      // |F| at the position
    double magnitude = 0.0;  // sum of the absolute terms of F, by which its rounding errors scale
    DVec3 position_error{};  // of the way to the position through instances
    double curvature = 0.0;  // bound on the normal curvatures, 1 / world unit
    DVec3 position_local{};  // in the space of the geometry that holds the primitive
};

inline DVec3 absolute(DVec3 v) {
    return {std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)};
}

inline DMat3 absolute(const DMat3& m) {
    return {absolute(m[0]), absolute(m[1]), absolute(m[2])};
}

inline double sum_of_squares(const Mat3& m) {
    const DMat3 d{m};
    return dot(d[0], d[0]) + dot(d[1], d[1]) + dot(d[2], d[2]);
}

/// Turns a gradient in object space into a covector of the world.
inline DVec3 world_gradient(const scene::AffineFrame& frame, DVec3 gradient_object) {
    return gradient_object * DMat3{frame.object_from_world};  // the transpose times the vector
}

/// Returns the site of a hit in the space of the geometry that holds the primitive. Of the ray only
/// what set_out() makes is looked at.
Site find_site(const scene::Geometry& geometry, const PreparedRay& ray, const Hit& hit);

}  // namespace lray::bvh
