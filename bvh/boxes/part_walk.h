// A ray on its way through the tree of one geometry, and what it does with what it comes upon.
#pragma once

#include <cstdint>
#include <vector>

#include "bvh/accel.h"
#include "bvh/boxes/box_tree.h"
#include "bvh/prepared_ray.h"
#include "bvh/simd/walk.h"
#include "bvh/slab.h"

namespace lray::bvh {

/// A geometry with its tree.
struct BoxPart {
    const scene::Geometry* geometry = nullptr;
    BoxTree tree{};
    bool all_cast_shadows = true;
};

/// The trees of a world, and how they are walked.
struct BoxParts {
    Walks walks{};
    BoxPart world{};
    std::vector<BoxPart> prototypes{};
};

/// Where a walk begins: not before 0, and not at -0, as walks sort floats by their bits.
inline float walk_begin(Interval interval) {
    return interval.lo > 0.0f ? interval.lo : 0.0f;
}

/// What walks to the nearest hit, and to any hit, do with what they come upon.
extern const WalkCalls kNearestCalls;
extern const WalkCalls kAnyCalls;

/// What all walks of a ray through a world share.
struct PartWalk : Walk {
    /// The ray and the counts must outlive the walk.
    PartWalk(const BoxParts& the_parts, const BoxPart& the_part, scene::PlaceOffset the_place,
             PreparedRay& the_ray, Interval the_interval, TraceCounts& the_counts)
        : parts(&the_parts),
          part(&the_part),
          place(the_place),
          interval(the_interval),
          counts(&the_counts) {
        ray = &the_ray;
        origin = &the_ray.origin.x;
        dir = &the_ray.dir.x;
        lo = walk_begin(interval);
        reach = reach_of(interval.hi);
        node_tests = 0;
        primitive_tests = 0;
        has_block_ray = false;
    }

    const BoxParts* parts;
    const BoxPart* part;
    scene::PlaceOffset place;
    Interval interval;
    TraceCounts* counts;
    Hit* best = nullptr;  // of a walk to the nearest hit

    /// Sets out for the nearest hit: `best`, if that is nearer, or what becomes the best.
    void seek_nearest(Hit& the_best) {
        calls = &kNearestCalls;
        best = &the_best;
        narrow();
    }

    /// Sets out for any hit.
    void seek_any() { calls = &kAnyCalls; }

    /// Planes are in no tree: they are met before it is walked.
    void meet_planes();
    bool meets_plane();

    const PreparedRay& prepared() const { return static_cast<const PreparedRay&>(*ray); }
    const scene::Geometry& geometry() const { return *part->geometry; }

    /// Adds what the walk cost to the counts. Call once, last.
    void add_counts() const {
        counts->node_tests += node_tests;
        counts->primitive_tests += primitive_tests;
    }

    /// Keeps a hit if it is the best; then nothing farther counts. Returns whether it did.
    bool keep(const Hit& hit);

    /// Leaves of the interval what may hold a closer hit than the best.
    void narrow() {
        interval = up_to(*best, interval);
        reach = reach_of(interval.hi);
    }

    bool casts_shadow(scene::PrimitiveId id) const;
};

/// Finds the nearest hit in a part of a ray that sets out, if it is nearer than `best`.
inline void find_nearest(const BoxParts& parts, const BoxPart& part, scene::PlaceOffset place,
                         PreparedRay& ray, Interval interval, Hit& best, TraceCounts& counts) {
    PartWalk walk(parts, part, place, ray, interval, counts);
    walk.seek_nearest(best);
    if (!part.tree.planes.empty()) walk.meet_planes();
    parts.walks.nearest(part.tree.view, walk);
    walk.add_counts();
}

/// Returns whether anything in a part that casts a shadow is hit by a ray that sets out.
inline bool find_any(const BoxParts& parts, const BoxPart& part, PreparedRay& ray,
                     Interval interval, TraceCounts& counts) {
    PartWalk walk(parts, part, 0, ray, interval, counts);
    walk.seek_any();
    const bool is_hit =
        (!part.tree.planes.empty() && walk.meets_plane()) || parts.walks.any(part.tree.view, walk);
    walk.add_counts();
    return is_hit;
}

}  // namespace lray::bvh
