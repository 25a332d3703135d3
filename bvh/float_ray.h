// What of a ray is kept in float: for boxes, and for the edges of triangles. A plain struct, which
// code compiled for one processor reads beside code for another.
#pragma once

#include <cstdint>

namespace lray::bvh {

/// Shape: [axis]. Made by prepare() of prepared_ray.h.
struct FloatRay {
    // Slabs: 1 / dir, at most kMaxInverse; and the origin as the planes of a box see it that the
    // ray passes first (near) and last (far), moved apart by its error.
    float origin_near[3];
    float origin_far[3];
    float inv_dir[3];
    float inv_dir_far[3];        // larger by the slack of slabs: it makes them be left later
    std::uint32_t near_side[3];  // of a box, that the ray passes first: 0 the lower, 1 the upper

    // Triangles: axes[2] is the one along which the ray runs fastest, and adding
    // (-shear_x, -shear_y) z to the x and y of a vertex (along axes[0], axes[1], z along axes[2],
    // relative to the origin) makes the ray the z axis.
    float origin_float[3];
    std::uint32_t axes[3];
    float shear_x;
    float shear_y;
};

}  // namespace lray::bvh
