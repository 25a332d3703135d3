// The rays of trace_speed: of a camera, to a light, and scattered, tile by tile.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/ray.h"
#include "bench/trace_scenes.h"
#include "bvh/hit.h"

namespace lray::bench {

/// Rays of a tile of 8 x 8 pixels follow each other, those of its quarters and of their quarters
/// likewise (Morton's order): any 64 and any 16 in a row run close together.
inline constexpr int kTileWidth = 8;
inline constexpr std::size_t kTileRays = 64;

/// Shape: one interval for each ray.
struct RaySet {
    std::string_view kind{};
    bool is_any_hit = false;
    std::vector<Ray> rays{};
    std::vector<Interval> intervals{};

    std::size_t size() const { return rays.size(); }
};

/// Returns a ray through the middle of each pixel of a square picture.
/// Shape: `width` is a multiple of kTileWidth.
RaySet primary_rays(const TraceScene& scene, int width);

/// Returns a ray from each hit to the light.
/// Shape: one hit for each ray of `primary`, with normals of any length, on either side.
RaySet shadow_rays(const TraceScene& scene, const RaySet& primary, std::span<const bvh::Hit> hits);

/// Returns a ray from each hit, cosine-distributed about the normal on the side it was seen from.
/// Shape: as for shadow_rays().
RaySet bounce_rays(const RaySet& primary, std::span<const bvh::Hit> hits);

}  // namespace lray::bench
