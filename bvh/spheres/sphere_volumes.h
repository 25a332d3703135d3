// The volumes of trees of bounding spheres, level by level.
#pragma once

#include <cstddef>
#include <cstdint>

#include "bvh/spheres/sphere_part.h"
#include "bvh/volume_cut.h"

namespace lray::bvh {

/// As Accel::volumes(). In an instance a sphere is an ellipsoid.
BoundingVolumes sphere_volumes(const SphereParts& parts, const LevelCount& level_count,
                               std::uint32_t level, std::size_t max_count);

}  // namespace lray::bvh
