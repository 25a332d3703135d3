// Lays a grown tree out in memory, and fills its leaves with triangles, spheres and ids.
#pragma once

#include <span>

#include "bvh/boxes/box_tree.h"
#include "bvh/boxes/build_refs.h"
#include "bvh/boxes/grow_tree.h"

namespace lray::bvh {

/// Returns the tree without planes and statistics: in one arena the nodes, the blocks of triangles,
/// those of spheres and the lists, each in the order in which it was grown.
BoxTree fill_tree(const scene::Geometry& geometry, std::span<const BuildRef> refs,
                  const GrownPart& part);

}  // namespace lray::bvh
