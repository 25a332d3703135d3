// Where to divide a set of references: the plane of least expected cost, found over bins.
#pragma once

#include <span>

#include "bvh/accel.h"
#include "bvh/boxes/ref_set.h"
#include "bvh/boxes/split_cost.h"
#include "scene/world.h"

namespace lray::bvh {

/// What all splits of a tree have in common.
struct SplitRules {
    const scene::Geometry& geometry;
    BuildQuality quality = BuildQuality::medium;
    Measure measure;
};

/// Chooses how to divide a set. SplitKind::none when it is better, and possible, to make a leaf of
/// it. Sets that no plane divides are halved.
/// Source: Wald 2007, "On fast Construction of SAH-based Bounding Volume Hierarchies", sec. 3.
Split find_split(const SplitRules& rules, std::span<const BuildRef> refs, const RefSet& set);

/// Leaves hold one class, and not too many.
bool can_be_leaf(const RefSet& set);

}  // namespace lray::bvh
