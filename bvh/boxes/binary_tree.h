// The binary tree that a tree of boxes is gathered from: sets of references divided again and
// again, and for each how its subtree is cheapest spread over the children of an eight-wide node.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "bvh/accel.h"
#include "bvh/boxes/build_refs.h"
#include "bvh/boxes/ref_set.h"

namespace lray::bvh {

/// A set of references and the two it is divided into. A node may become a node or a leaf of the
/// wide tree, or vanish in a wide node above.
struct BinaryNode {
    Box4 box{};
    const BinaryNode* left = nullptr;  // none: not divided
    const BinaryNode* right = nullptr;
    std::uint32_t first = 0;  // of its references
    std::uint32_t last = 0;
    std::uint32_t left_slots = 0;             // 4 bits for each number of slots from 2 on
    RefClass ref_class = RefClass::triangle;  // of a leaf
    bool is_leaf = true;                      // where it has one slot: of the wide tree

    std::uint32_t count() const { return last - first; }

    /// Of `slots` (2 to 8) children that the subtree may have in a wide node, how many are left's;
    /// 0: it is cheaper with a slot less.
    unsigned slots_of_left(unsigned slots) const { return left_slots >> 4 * (slots - 2) & 15; }
};

/// Binary nodes, which stay where they are.
class BinaryNodes {
 public:
    BinaryNode& add();

 private:
    std::vector<std::vector<BinaryNode>> chunks_{};
};

/// A tree and what holds its nodes.
struct BinaryTree {
    std::vector<BinaryNodes> nodes{};
    const BinaryNode* root = nullptr;
};

/// Divides the references [0, count), at least one, and brings them into the order of the leaves.
/// Those behind are room for parts of primitives.
/// No path from the root is longer than kMaxBoxDepth.
BinaryTree build_binary_tree(const scene::Geometry& geometry, std::span<BuildRef> refs,
                             std::uint32_t count, BuildQuality quality);

}  // namespace lray::bvh
