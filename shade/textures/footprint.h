// What part of space one lookup of a texture stands for.
#pragma once

#include <algorithm>

#include "base/noise.h"
#include "base/vec.h"

namespace lray::shade {

/// A pixel as it lies on the surface, in the space of a texture. All 0: a point.
struct Footprint {
    /// Along each axis, of a footprint whose plane is known: a pattern is averaged over it.
    DVec3 extent{0.0};
    /// Across, of one whose plane is not known. It must not be averaged over: a pattern may end in
    /// the surface itself, and what lies behind would show.
    double across = 0.0;

    double width() const {
        return std::max(std::max(extent.x, extent.y), std::max(extent.z, across));
    }
};

/// Returns how much is left of a pattern that changes in steps of the size 1 when it is looked up
/// once in each width: as of noise, all up to half a step, and nothing from a step on.
constexpr double pattern_left(double width) {
    return noise_left(width);
}

}  // namespace lray::shade
