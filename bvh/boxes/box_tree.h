// The fast hierarchy: a tree of boxes eight wide, whose leaves hold triangles and spheres in blocks
// and all other primitives in lists of one kind.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "bvh/accel.h"
#include "bvh/boxes/arena.h"
#include "bvh/boxes/box_layout.h"
#include "scene/world.h"

namespace lray::bvh {

/// A tree over one geometry. The box of a child holds those of its primitives (or, cut in two, of
/// its part of them), rounding included; every primitive is in exactly one leaf, or in each leaf
/// of its parts.
struct BoxTree {
    Arena arena{};  // what `view` points into
    BoxTreeView view{};
    Bounds box{};                              // of the root
    std::vector<scene::PrimitiveId> planes{};  // every ray tests them
    AccelStats stats{};                        // of this tree; bytes without the struct's own
};

/// Builds the tree over all visible primitives of a geometry, on all cores of the task arena it is
/// called in.
BoxTree build_box_tree(const scene::Geometry& geometry, BuildQuality quality);

inline BoxChildKind kind_of(BoxChild child) {
    return static_cast<BoxChildKind>(child >> kBoxKindShift);
}
inline std::uint32_t leaf_count(BoxChild child) {
    return (child >> kBoxCountShift & (kMaxLeafCount - 1)) + 1;
}
inline std::uint32_t leaf_first(BoxChild child) {
    return child & kMaxLeafFirst;
}
inline Vec3 corner_of(const TriangleBlock& block, std::size_t vertex, std::size_t lane) {
    const auto& axes = block.corners[vertex];
    return {axes[0][lane], axes[1][lane], axes[2][lane]};
}
inline Bounds box_of(const BoxNode& node, std::size_t child) {
    Bounds box;
    for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = node.planes[axis][0][child];
        box.max[axis] = node.planes[axis][1][child];
    }
    return box;
}
inline const BoxNode& node_of(const BoxTreeView& tree, BoxChild child) {
    return tree.nodes[child / kNodeUnits];
}
inline BoxChild make_node(std::size_t index) {
    return static_cast<BoxChild>(index * kNodeUnits);
}
inline BoxChild make_leaf(BoxChildKind kind, std::uint32_t count, std::uint32_t first) {
    return static_cast<std::uint32_t>(kind) << kBoxKindShift | (count - 1) << kBoxCountShift |
           first;
}

}  // namespace lray::bvh
