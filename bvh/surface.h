// The surface at a hit: position with its error, normal, and where rays that leave it begin. What
// textures need is surface_detail.h's.
#pragma once

#include "base/ray.h"
#include "bvh/hit.h"
#include "scene/world.h"

namespace lray::bvh {

/// Space: world. `error` bounds, per axis, how far `position` is from the surface that the kernels
/// meet, their own rounding and the curvature of the surface over that distance included.
/// `normal` is unit and outward: the counter-clockwise side of triangles, +normal of flat shapes,
/// away from the inside of solids. `position_local` is the position in the space of the geometry
/// that holds the primitive, not rounded.
struct SurfacePoint {
    Vec3 position{};
    Vec3 error{};
    Vec3 normal{};
    DVec3 position_local{};
};

/// Returns the surface at a hit that `ray` found. The crossing is worked out again in double and
/// rounded once: the position does not suffer from t being a float.
/// Errors: asserts that the hit is not none.
SurfacePoint surface_at(const scene::World& world, const Ray& ray, const Hit& hit);

/// Returns where a ray in that direction begins, so that it does not meet the surface it leaves:
/// just off it, on the side the direction points to. Holds for directions further than 2^-23 from
/// the tangent plane, which is all the normal can tell.
/// Source: Pharr, Jakob, Humphreys 2023, "Physically Based Rendering", 4th ed., sec. 6.8.6.
Vec3 offset_origin(const Vec3& position, const Vec3& error, const Vec3& normal,
                   const Vec3& direction);

}  // namespace lray::bvh
