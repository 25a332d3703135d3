// Cutting triangles in two where they lie in each other's way: long ones at a slant, whose boxes
// are mostly empty.
#pragma once

#include <span>

#include "bvh/boxes/ref_set.h"
#include "bvh/boxes/split_cost.h"
#include "scene/world.h"

namespace lray::bvh {

/// Finds the plane at which cutting the triangles that reach over it costs least; its cost is
/// infinite if there is none, or no room for the parts. What is not a triangle goes to the side of
/// its centre.
/// Source: Stich, Friedrich, Dietrich 2009, "Spatial Splits in Bounding Volume Hierarchies",
/// sec. 4.
Split find_cut(const scene::Geometry& geometry, std::span<const BuildRef> refs, const RefSet& set,
               const Measure& measure);

/// Divides a set by a SplitKind::cut. A side may be empty if rounding has it so.
TwoSets divide_by_cut(const scene::Geometry& geometry, std::span<BuildRef> refs, const RefSet& set,
                      const Split& split);

}  // namespace lray::bvh
