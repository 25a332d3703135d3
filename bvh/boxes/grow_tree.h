// Grows the nodes of a tree of boxes from the root down. What its leaves hold is filled in later
// (fill_tree.h), when it is known where everything lies.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "bvh/accel.h"
#include "bvh/boxes/box_layout.h"
#include "bvh/boxes/build_refs.h"
#include "bvh/boxes/ref_set.h"

namespace lray::bvh {

/// How many there are of each array of a tree.
struct BoxTreeCounts {
    std::uint32_t nodes = 0;
    std::uint32_t triangle_blocks = 0;
    std::uint32_t sphere_blocks = 0;
    std::uint32_t listed = 0;

    /// Of what leaves of that kind index.
    std::uint32_t& of(BoxChildKind kind) {
        return kind == BoxChildKind::node        ? nodes
               : kind == BoxChildKind::triangles ? triangle_blocks
               : kind == BoxChildKind::spheres   ? sphere_blocks
                                                 : listed;
    }
    BoxTreeCounts& operator+=(const BoxTreeCounts& other) {
        nodes += other.nodes;
        triangle_blocks += other.triangle_blocks;
        sphere_blocks += other.sphere_blocks;
        listed += other.listed;
        return *this;
    }
};

/// A leaf, in terms of the references.
struct GrownLeaf {
    std::uint32_t first_ref = 0;
    std::uint32_t ref_count = 0;
    BoxChildKind kind = BoxChildKind::triangles;
};

/// The nodes that one task grew, in the order of a walk that takes each child with all below it
/// before the next. Indices of children count from the first of this part.
struct GrownPart {
    std::vector<BoxNode> nodes{};
    std::vector<GrownLeaf> leaves{};  // each with the next index of its kind
    BoxChild root = 0;
    BoxTreeCounts counts{};
    std::uint32_t depth = 0;  // children on the longest path, the root included
    double cost = 0.0;        // by split_cost.h, times half the area of the tree
    std::uint64_t leaf_count = 0;
    std::uint64_t ref_count = 0;
};

/// Grows the tree over references, which it brings into the order of the leaves.
GrownPart grow_tree(std::vector<BuildRef>& refs, BuildQuality quality);

}  // namespace lray::bvh
