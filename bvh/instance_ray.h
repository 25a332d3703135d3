// The way into an instance: the ray as its prototype sees it, and the stretch in which it counts.
#pragma once

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

/// Returns the part of an interval in which hits of an instance count: where the ray is in its
/// bounds. Every hierarchy keeps to it, so that none finds what another skips with the bounds.
/// Empty (hi <= lo) when the ray misses them.
inline Interval interval_in(const scene::WorldInstance& instance, const PreparedRay& ray,
                            Interval interval) {
    const Stretch stretch = stretch_in(instance.bounds, ray);
    if (!(stretch.entry <= stretch.exit)) return {0.0f, 0.0f};
    const float lo = next_down(stretch.entry * kEntryFactor);
    const float hi = next_up(stretch.exit);
    return {lo > interval.lo ? lo : interval.lo, hi < interval.hi ? hi : interval.hi};
}

}  // namespace lray::bvh
