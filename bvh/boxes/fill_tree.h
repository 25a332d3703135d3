// Lays a collapsed tree out in memory, and fills its leaves with triangles, spheres and ids.
#pragma once

#include <span>

#include "bvh/boxes/box_tree.h"
#include "bvh/boxes/build_refs.h"
#include "bvh/boxes/collapse_tree.h"

namespace lray::bvh {

/// Returns the tree without its planes: in one arena the nodes, the blocks of triangles,
/// those of spheres and the lists, each in the order of a walk that takes each child with all below
/// it before the next.
BoxTree fill_tree(const scene::Geometry& geometry, std::span<const BuildRef> refs, WidePart& whole);

}  // namespace lray::bvh
