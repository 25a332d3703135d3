// The surface at a hit: position with its error, normal, and where rays that leave it begin. What
// textures need is surface_detail.h's.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "base/numerics.h"
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

/// Returns position + offset, rounded away from the position: the float after the nearest. Without
/// branches on signs, which nobody foresees.
inline float moved_away(float position, double offset) {
    const float moved = static_cast<float>(static_cast<double>(position) + offset);
    if (moved == 0.0f || !(std::fabs(moved) < kInfinity)) {
        return offset > 0.0 ? next_up(moved) : offset < 0.0 ? next_down(moved) : moved;
    }
    const int is_outward = (moved < 0.0f) == (offset < 0.0) ? 1 : 0;
    const int step = offset != 0.0 ? 2 * is_outward - 1 : 0;
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(moved) +
                                static_cast<std::uint32_t>(step));
}

/// Returns where a ray in that direction begins, so that it does not meet the surface it leaves:
/// just off it, on the side the direction points to. Holds for directions further than 2^-23 from
/// the tangent plane, which is all the normal can tell.
/// Source: Pharr, Jakob, Humphreys 2023, "Physically Based Rendering", 4th ed., sec. 6.8.6.
inline Vec3 offset_origin(const Vec3& position, const Vec3& error, const Vec3& normal,
                          const Vec3& direction) {
    const DVec3 n{normal};
    const double reach = std::fabs(n.x) * static_cast<double>(error.x) +
                         std::fabs(n.y) * static_cast<double>(error.y) +
                         std::fabs(n.z) * static_cast<double>(error.z);
    // (1 + gamma(4)): the float normal may be a little shorter than 1.
    const double distance = reach * (1.0 + static_cast<double>(gamma<float>(4)));
    const DVec3 offset = n * (dot(n, DVec3{direction}) < 0.0 ? -distance : distance);
    return {moved_away(position.x, offset.x), moved_away(position.y, offset.y),
            moved_away(position.z, offset.z)};
}

}  // namespace lray::bvh
