// Bounding spheres: how they are made around objects, and how a ray meets them.
#pragma once

#include <cmath>
#include <optional>

#include "bvh/prepared_ray.h"
#include "bvh/slab.h"
#include "scene/world.h"

namespace lray::bvh {

/// Holds everything within `radius` of `center`.
struct BoundingSphere {
    Vec3 center{};
    float radius = 0.0f;
};

/// Returns the sphere around a box: the box is inside, rounding included.
BoundingSphere sphere_around(const Bounds& box);

/// Returns a sphere that holds all of a primitive: a sphere itself, or the sphere around its box.
/// Errors: asserts that it is not a plane.
BoundingSphere bounding_sphere(const scene::Geometry& geometry, scene::PrimitiveId id);

/// Returns a box that holds all of a sphere.
Bounds box_around(const BoundingSphere& sphere);

/// Returns the t at which a ray enters a sphere that is larger than the given one by the errors of
/// what is hit inside: kSlabSlack of the distance, along each of three axes, and as much for the
/// rounding of t; and twice by how much slabs take the origin for elsewhere. Empty when the ray
/// misses it or is in it only outside of (lo, hi).
/// Below lo when the ray begins inside.
inline std::optional<double> entry_into(const BoundingSphere& sphere, const PreparedRay& ray,
                                        Interval interval) {
    constexpr double kSlack = 4.0 * static_cast<double>(kSlabSlack);
    const DVec3 to_center = DVec3{sphere.center} - ray.origin;
    const double squared = dot(ray.dir, ray.dir);
    const double middle = dot(to_center, ray.dir) / squared;
    const DVec3 across = to_center - middle * ray.dir;
    const double radius = static_cast<double>(sphere.radius);
    constexpr double kOriginError = 2.0 * static_cast<double>(kOriginSlack);
    constexpr double kLeastError = 4.0 * static_cast<double>(kLeastOriginSlack);
    const double origin_size =
        std::fabs(ray.origin.x) + std::fabs(ray.origin.y) + std::fabs(ray.origin.z);
    const double reach = radius + kSlack * (std::sqrt(dot(to_center, to_center)) + radius) +
                         kOriginError * origin_size + kLeastError;
    const double inside = reach * reach - dot(across, across);
    if (!(inside >= 0.0)) return std::nullopt;
    const double half = std::sqrt(inside / squared);
    const double entry = middle - half;
    const bool is_ahead = middle + half >= static_cast<double>(interval.lo) &&
                          entry <= static_cast<double>(interval.hi);
    return is_ahead ? std::optional<double>(entry) : std::nullopt;
}

}  // namespace lray::bvh
