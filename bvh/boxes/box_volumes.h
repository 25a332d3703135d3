// The volumes of trees of boxes, level by level.
#pragma once

#include <cstddef>
#include <cstdint>

#include "bvh/boxes/part_walk.h"
#include "bvh/volume_cut.h"

namespace lray::bvh {

/// As Accel::volumes(). In an instance a box is a parallelepiped.
BoundingVolumes box_volumes(const BoxParts& parts, const LevelCount& level_count,
                            std::uint32_t level, std::size_t max_count);

}  // namespace lray::bvh
