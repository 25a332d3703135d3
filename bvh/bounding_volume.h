// The volumes of a hierarchy as they are shown, level by level.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace lray::bvh {

/// All points center + a x + b y + c z of the half axes x, y and z: of a box with a, b and c in
/// [-1, 1], of an ellipsoid with a^2 + b^2 + c^2 <= 1. The half axes are at right angles outside of
/// instances; the frames of those may skew them, and may flatten them to nothing.
struct BoundingVolume {
    enum class Shape : std::uint8_t { box, ellipsoid };

    Shape shape = Shape::box;
    bool is_leaf = false;      // of its tree: it holds primitives
    bool is_instance = false;  // around all of an instance: the root of its prototype's tree
    std::uint32_t depth = 0;   // level at which a cut has it first; that of the root is 0
    DVec3 center{};
    std::array<DVec3, 3> half_axes{};
};

/// A cut through a tree at a level: the volumes of that depth, and the leaves above it. Whatever
/// the level, everything that a ray can hit, planes apart, is in one of them.
struct BoundingVolumes {
    std::vector<BoundingVolume> volumes{};
    bool is_cut_short = false;      // some are those of a level above, as more would be too many
    std::uint32_t level_count = 0;  // no level below the last of these adds anything
};

}  // namespace lray::bvh
