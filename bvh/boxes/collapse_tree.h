// Gathers the nodes of a binary tree into those of a tree of boxes, eight wide. What its leaves
// hold is filled in later (fill_tree.h), when it is known where everything lies.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bvh/boxes/binary_tree.h"
#include "bvh/boxes/box_layout.h"

namespace lray::bvh {

/// How many there are of each array of a tree.
struct BoxTreeCounts {
    std::uint32_t nodes = 0;
    std::uint32_t triangle_blocks = 0;
    std::uint32_t sphere_blocks = 0;
    std::uint32_t framed = 0;
    std::uint32_t instances = 0;

    /// Of what leaves of that kind index.
    std::uint32_t& of(BoxChildKind kind) {
        return kind == BoxChildKind::node        ? nodes
               : kind == BoxChildKind::triangles ? triangle_blocks
               : kind == BoxChildKind::spheres   ? sphere_blocks
               : kind == BoxChildKind::framed    ? framed
                                                 : instances;
    }
    BoxTreeCounts& operator+=(const BoxTreeCounts& other) {
        nodes += other.nodes;
        triangle_blocks += other.triangle_blocks;
        sphere_blocks += other.sphere_blocks;
        framed += other.framed;
        instances += other.instances;
        return *this;
    }
};

/// A leaf, in terms of the references.
struct WideLeaf {
    std::uint32_t first_ref = 0;
    std::uint32_t ref_count = 0;
    BoxChildKind kind = BoxChildKind::triangles;
};

struct WideBranch;

/// What one task made: nodes in the order of a walk that takes each child with all below it before
/// the next. Indices count from the first of this part.
struct WidePart {
    std::vector<BoxNode> nodes{};
    std::vector<WideLeaf> leaves{};      // each with the next index of its kind
    std::vector<WideBranch> branches{};  // where others went on, in order; then there is one node
    BoxChild root = 0;
    BoxTreeCounts counts{};   // without branches
    std::uint32_t depth = 0;  // of the deepest leaf; that of the root is 1
    double cost = 0.0;        // of split_cost.h, times half the area of the tree
    std::uint64_t ref_count = 0;
};

/// The child of the only node of a part.
struct WideBranch {
    std::size_t lane = 0;
    WidePart part{};
};

/// Makes the wide tree that is cheapest by the costs that the binary tree was built with. Brings
/// the references of each leaf together, where there was room between them.
WidePart collapse_tree(const BinaryTree& tree, std::span<BuildRef> refs);

}  // namespace lray::bvh
