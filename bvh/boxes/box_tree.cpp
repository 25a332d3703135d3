#include "bvh/boxes/box_tree.h"

#include <utility>

#include "bvh/boxes/binary_tree.h"
#include "bvh/boxes/build_refs.h"
#include "bvh/boxes/collapse_tree.h"
#include "bvh/boxes/fill_tree.h"
#include "bvh/boxes/ref_set.h"
#include "bvh/boxes/split_cost.h"

namespace lray::bvh {

namespace {

/// Of the references of a geometry, how many may be added by cutting.
constexpr double kRoomForParts = 0.5;

Bounds bounds_of(const Box4& box) {
    float lower[4];
    float upper[4];
    store_four(lower, box.lower);
    store_four(upper, box.upper);
    return {{lower[0], lower[1], lower[2]}, {upper[0], upper[1], upper[2]}};
}

}  // namespace

/// While it works it needs 32 bytes a reference beside what the tree keeps (with room for parts,
/// 48), and for the binary tree about as much again, which is gone when the arena is filled: at
/// most 64 for each of 2 n - 1 nodes, if no two of n references fit one leaf.
BoxTree build_box_tree(const scene::Geometry& geometry, BuildQuality quality) {
    BuildRefs refs = make_build_refs(geometry, quality == BuildQuality::high ? kRoomForParts : 0.0);
    BoxTree tree;
    if (refs.count > 0) {
        const Box4 box = summarize(refs.used()).box;
        const double area = half_area(box);
        WidePart whole =
            collapse_tree(build_binary_tree(geometry, refs.all(), refs.count, quality), refs.all());
        tree = fill_tree(geometry, refs.all(), whole);
        tree.box = bounds_of(box);
        tree.stats.cost = area > 0.0 ? tree.stats.cost / area : 0.0;
    }
    tree.planes = std::move(refs.planes);
    tree.planes.shrink_to_fit();
    tree.stats.references += tree.planes.size();
    tree.stats.bytes += tree.planes.capacity() * sizeof(scene::PrimitiveId);
    return tree;
}

}  // namespace lray::bvh
