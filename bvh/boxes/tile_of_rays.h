// Rays that run close together, through the world's own tree.
#pragma once

#include <span>

#include "bvh/boxes/part_walk.h"

namespace lray::bvh {

/// Finds the nearest hit of each of up to kMaxTileRays rays.
/// Shape: all of the same length.
void find_nearest_of_tile(const BoxParts& parts, std::span<const Ray> rays,
                          std::span<const Interval> intervals, std::span<Hit> hits,
                          TraceCounts& counts);

/// Likewise, whether anything that casts a shadow is hit.
void find_any_of_tile(const BoxParts& parts, std::span<const Ray> rays,
                      std::span<const Interval> intervals, std::span<bool> are_hit,
                      TraceCounts& counts);

}  // namespace lray::bvh
