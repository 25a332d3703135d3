// The surface at a hit: position with its error, normal, and where rays that leave it begin.
#pragma once

#include "base/ray.h"
#include "bvh/hit.h"
#include "scene/world.h"

namespace lray::bvh {

/// Space: world. `error` bounds, per axis, how far `position` is from the surface that the kernels
/// meet, their own rounding and the curvature of the surface over that distance included.
/// `normal` is unit and outward: the counter-clockwise side of triangles, +normal of flat shapes,
/// away from the inside of solids.
struct SurfacePoint {
    Vec3 position{};
    Vec3 error{};
    Vec3 normal{};
};

/// Returns the surface at a hit that `ray` found. The crossing is worked out again in double and
/// rounded once: the position does not suffer from t being a float.
/// Errors: asserts that the hit is not none.
SurfacePoint surface_at(const scene::World& world, const Ray& ray, const Hit& hit);

/// What textures and smooth shading need of the surface beside its position.
/// Space: world, but for `position_object`.
struct SurfaceDetail {
    /// Unit, on the side of the normal: interpolated between the normals of a mesh's or triangle's
    /// corners where it has them, else the normal.
    Vec3 shading_normal{};
    DVec2 uv{0.0};
    /// How the position changes with u and with v, in the tangent plane of `shading_normal`, at
    /// right angles to it; 0 where uv does not change or has no direction (at a pole).
    Vec3 dp_du{0.0f};
    Vec3 dp_dv{0.0f};
    /// In the space of the shape, before its own steps.
    DVec3 position_object{0.0};
    double object_per_world = 1.0;  // length there of a unit of length in the world, on average
};

/// Returns the detail at a hit whose surface point is known.
SurfaceDetail surface_detail(const scene::World& world, const Ray& ray, const Hit& hit,
                             const SurfacePoint& point);

/// Likewise, the shading normal alone.
Vec3 shading_normal(const scene::World& world, const Hit& hit, const SurfacePoint& point);

/// Returns where a ray in that direction begins, so that it does not meet the surface it leaves:
/// just off it, on the side the direction points to. Holds for directions further than 2^-23 from
/// the tangent plane, which is all the normal can tell.
/// Source: Pharr, Jakob, Humphreys 2023, "Physically Based Rendering", 4th ed., sec. 6.8.6.
Vec3 offset_origin(Vec3 position, Vec3 error, Vec3 normal, Vec3 direction);

}  // namespace lray::bvh
