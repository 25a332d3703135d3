// What of a ray is kept in float: for boxes, and for the edges of triangles. A plain struct, which
// code compiled for one processor reads beside code for another.
#pragma once

#include <cstdint>

namespace lray::bvh {

/// Along an axis a ray runs at least so fast, for slabs: inverses are finite, none gives a NaN, and
/// by them a box on whose face a ray runs is not left.
inline constexpr float kLeastSpeed = 0x1p-124f;

/// A box counts as left by so much later than computed. The slabs have three roundings, gamma(3);
/// the sheared vertices of the triangle kernel are off by as much again; the rest is room to spare.
/// Source: Ize 2013, "Robust BVH Ray Traversal", sec. 3.
inline constexpr float kSlabSlack = 0x1p-17f;
inline constexpr float kExitFactor = 1.0f + kSlabSlack;

/// A hit at t may lie so much before the computed entry of its box.
inline constexpr float kEntryFactor = 1.0f - kSlabSlack;

/// The sine of the angle between a ray and a plane, squared: below it what float loses along the
/// ray is more than the slack of slabs. A sheared corner is off by six roundings at most, which
/// this makes 96 of t; the slack is 128.
inline constexpr double kGrazing = 1.0 / 256.0;

/// How far the two origins lie from the true one, in parts of it and at least: over kLeastSpeed,
/// that is farther than the world reaches.
inline constexpr float kOriginSlack = 0x1p-22f;
inline constexpr float kLeastOriginSlack = 0x1p-60f;

/// Shape: [axis]; the fourth is there for vectors of four and means nothing. Made by set_out() and
/// prepare_floats() of prepared_ray.h.
struct alignas(16) FloatRay {
    float origin_float[4];
    float dir_float[4];

    // Slabs: 1 / dir, of at least kLeastSpeed; and the origin as the planes of a box see it that
    // the ray passes first (near) and last (far), moved apart by its error.
    float origin_near[4];
    float origin_far[4];
    float inv_dir[4];
    float inv_dir_far[4];        // larger by the slack of slabs: it makes them be left later
    std::uint32_t near_side[4];  // of a box, that the ray passes first: 0 the lower, 1 the upper

    // Triangles: axes[2] is the one along which the ray runs fastest, and adding
    // (-shear_x, -shear_y) z to the x and y of a vertex (along axes[0], axes[1], z along axes[2],
    // relative to the origin) makes the ray the z axis.
    std::uint32_t axes[3];
    float shear_x;
    float shear_y;
};

}  // namespace lray::bvh
