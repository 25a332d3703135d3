// What bounds a primitive of a kind with an affine frame.
#pragma once

#include "bvh/boxes/box_layout.h"
#include "scene/world.h"

namespace lray::bvh {

/// Returns the round bound of a primitive, rounded to float: by less than what the tests of
/// simd/bounds-inl.h allow for. Errors: asserts that its kind has a frame.
RoundBound round_bound(const scene::Geometry& geometry, scene::PrimitiveId id);

}  // namespace lray::bvh
