// Where a ray passes a box: the one test that every tree of boxes makes at its nodes and the
// triangle kernel makes at its hits. Because both are the same arithmetic, and rounding keeps the
// order of numbers, no tree skips a hit that testing everything finds.
#pragma once

#include "base/bounds.h"
#include "bvh/prepared_ray.h"

namespace lray::bvh {

/// What is entered by reach_of(t) may hold a hit at t: twice the slack, so that
/// entry <= reach_of(t) for every t >= entry * kEntryFactor, both rounded.
inline constexpr float kReachFactor = 1.0f + 2.0f * kSlabSlack;

inline float reach_of(float t) {
    return t * kReachFactor;
}

/// The stretch of a ray in a box, its exit with the slack. Not ordered when the ray misses the box.
struct Stretch {
    float entry = 0.0f;
    float exit = 0.0f;

    /// True if the ray is in the box somewhere in front of `lo` and by `reach`.
    bool overlaps(float lo, float reach) const {
        const float begin = entry > lo ? entry : lo;
        const float end = exit < reach ? exit : reach;
        return begin <= end;
    }
};

/// Grows with the box: a box inside of another has a stretch inside of the other's, to the bit.
inline Stretch stretch_in(const Bounds& box, const FloatRay& ray) {
    const auto near = [&](int axis) {
        const float plane = ray.near_side[axis] != 0 ? box.max[axis] : box.min[axis];
        return (plane - ray.origin_near[axis]) * ray.inv_dir[axis];
    };
    const auto far = [&](int axis) {
        const float plane = ray.near_side[axis] != 0 ? box.min[axis] : box.max[axis];
        return (plane - ray.origin_far[axis]) * ray.inv_dir_far[axis];
    };
    const auto greater = [](float a, float b) { return a > b ? a : b; };
    const auto lesser = [](float a, float b) { return a < b ? a : b; };
    return {greater(greater(near(0), near(1)), near(2)), lesser(lesser(far(0), far(1)), far(2))};
}

}  // namespace lray::bvh
