// Axis-aligned bounding boxes.
#pragma once

#include <algorithm>

#include "base/numerics.h"
#include "base/vec.h"

namespace lray {

/// The box [min, max]. A default-made one is empty and takes the bounds of what is added.
struct Bounds {
    Vec3 min{kInfinity};
    Vec3 max{-kInfinity};

    bool is_empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }

    void add(Vec3 point) {
        for (int axis = 0; axis < 3; ++axis) {
            min[axis] = std::min(min[axis], point[axis]);
            max[axis] = std::max(max[axis], point[axis]);
        }
    }

    /// Adds a point known in double, rounding outward.
    void add(DVec3 point) {
        for (int axis = 0; axis < 3; ++axis) {
            min[axis] = std::min(min[axis], round_down(point[axis]));
            max[axis] = std::max(max[axis], round_up(point[axis]));
        }
    }

    void add(const Bounds& other) {
        for (int axis = 0; axis < 3; ++axis) {
            min[axis] = std::min(min[axis], other.min[axis]);
            max[axis] = std::max(max[axis], other.max[axis]);
        }
    }

    bool contains(const Bounds& other) const {
        for (int axis = 0; axis < 3; ++axis) {
            if (other.min[axis] < min[axis] || other.max[axis] > max[axis]) return false;
        }
        return true;
    }
};

}  // namespace lray
