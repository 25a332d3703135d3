// The way into an instance: the ray as its prototype sees it, and the stretch in which it counts.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "bvh/accel.h"
#include "bvh/kernels/object_ray.h"
#include "bvh/slab.h"
#include "scene/world.h"

namespace lray::bvh {

/// Returns the ray as it sets out in the space of the instance's prototype; t stays the world's.
inline PreparedRay set_out_in(const scene::WorldInstance& instance, const PreparedRay& ray) {
    const ObjectRay local = object_ray(instance.frame, ray);
    return set_out(local.origin, local.dir);
}

/// Likewise, all of it.
inline PreparedRay ray_in(const scene::WorldInstance& instance, const PreparedRay& ray) {
    PreparedRay result = set_out_in(instance, ray);
    prepare_floats(result);
    return result;
}

/// How far the planes of bounds are moved apart for the rounding of the way into an instance in
/// double, in parts of the ray's origin and of t: instances within instances make it some hundred
/// roundings.
inline constexpr double kInstanceSlack = 0x1p-44;

/// Returns where the ray is in the bounds, in double: of instances much smaller than their distance
/// the float of stretch_in() cannot tell one from the next. Not ordered when the ray misses them.
inline std::pair<double, double> fine_stretch_in(const Bounds& bounds, const PreparedRay& ray) {
    double entry = -std::numeric_limits<double>::infinity();
    double exit = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = ray.origin[axis];
        const double inverse = 1.0 / ray.dir[axis];
        const double slack = std::fabs(origin) * kInstanceSlack;
        const double low = (static_cast<double>(bounds.min[axis]) - slack - origin) * inverse;
        const double high = (static_cast<double>(bounds.max[axis]) + slack - origin) * inverse;
        const double near = inverse < 0.0 ? high : low;
        const double far = inverse < 0.0 ? low : high;
        if (near > entry) entry = near;  // NaN, of a ray that runs on a face, does not cut
        if (far < exit) exit = far;
    }
    return {entry - std::fabs(entry) * kInstanceSlack, exit + std::fabs(exit) * kInstanceSlack};
}

/// Returns the part of an interval in which hits of an instance count: where the ray is in its
/// bounds, by the slabs of trees and more finely. Every hierarchy keeps to it, so that none finds
/// what another skips with the bounds. Empty (hi <= lo) when the ray misses them.
inline Interval interval_in(const scene::WorldInstance& instance, const PreparedRay& ray,
                            Interval interval) {
    const Stretch stretch = stretch_in(instance.bounds, ray);
    if (!(stretch.entry <= stretch.exit)) return {0.0f, 0.0f};
    const auto [fine_entry, fine_exit] = fine_stretch_in(instance.bounds, ray);
    if (!(fine_entry <= fine_exit)) return {0.0f, 0.0f};
    const float lo = next_down(std::max(stretch.entry * kEntryFactor, round_down(fine_entry)));
    const float hi = next_up(std::min(stretch.exit, round_up(fine_exit)));
    return {lo > interval.lo ? lo : interval.lo, hi < interval.hi ? hi : interval.hi};
}

/// Likewise, counted; empty once tracing was ended.
inline Interval interval_in(const scene::WorldInstance& instance, const PreparedRay& ray,
                            Interval interval, TraceCounts& counts) {
    constexpr std::uint64_t kBetweenLooks = 4096;
    if (++counts.instance_tests % kBetweenLooks == 0 && counts.cancel != nullptr) {
        counts.is_ended = counts.cancel->load(std::memory_order_relaxed);
    }
    return counts.is_ended ? Interval{0.0f, 0.0f} : interval_in(instance, ray, interval);
}

}  // namespace lray::bvh
