// Parts of triangles: what of one lies between two planes.
#pragma once

#include "bvh/boxes/build_refs.h"

namespace lray::bvh {

/// Returns the reference with a box that holds only what of its triangle lies both in its box and
/// in [low, high] along an axis. Its box is empty (min > max) when there is nothing.
///
/// The boxes of the parts of a triangle hold all of it, and overlap where it was cut, by the pad
/// of part_pad(). They have to: a ray that passes between two boxes that only touch may miss both
/// by the rounding of the slabs, and the kernel counts hits of rays that pass the triangle by its
/// own rounding, a few units of roundoff of the coordinates (Woop 2013), which seen at a slant
/// moves the hit along the ray by a multiple of that. What is in proportion to the distance of the
/// ray's origin is not in the pad: the slack of the slabs (bvh/prepared_ray.h) covers it in each
/// axis. No part reaches beyond the box of the whole, which the kernel keeps its hits to.
BuildRef part_of(const scene::Geometry& geometry, const BuildRef& ref, int axis, double low,
                 double high);

inline bool is_empty(const BuildRef& ref) {
    return !(ref.min[0] <= ref.max[0] && ref.min[1] <= ref.max[1] && ref.min[2] <= ref.max[2]);
}

}  // namespace lray::bvh
