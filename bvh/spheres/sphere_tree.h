// The hierarchy of level 2: a binary tree of bounding spheres, built top-down with the surface-area
// cost of every plane through a centre.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bvh/spheres/bounding_sphere.h"

namespace lray::bvh {

/// What it costs to test a volume and an object with a ray. Their ratio alone matters.
inline constexpr double kSphereVolumeCost = 1.0;
inline constexpr double kSphereObjectCost = 2.0;

inline constexpr std::uint32_t kMaxSphereLeaf = 4;

/// No path from the root is longer.
inline constexpr std::uint32_t kMaxSphereDepth = 64;

/// A bounding sphere and what is in it: two nodes, or 1 to kMaxSphereLeaf objects.
struct SphereNode {
    BoundingSphere sphere{};
    std::uint32_t first = 0;         // of its objects in SphereTree::order; else the right child
    std::uint32_t object_count = 0;  // 0: an inner node, whose left child comes right after it

    bool is_leaf() const { return object_count > 0; }
};

/// The nodes in the order of a walk that goes left first; the root is the first. Empty without
/// objects. Every object is in exactly one leaf; the sphere of a node holds those of its objects.
struct SphereTree {
    std::vector<SphereNode> nodes{};
    std::vector<std::uint32_t> order{};  // indices of objects
    std::uint32_t depth = 0;             // nodes on the longest path
    double cost = 0.0;                   // expected, of a ray that meets the root
};

/// Builds the tree over the spheres of objects, on all cores of the task arena it is called in.
/// A node of N objects is split on that axis and plane where T = T_left + T_right is least, with
/// T_child = T_volume + A(child) / A(node) N(child) T_object: for each axis the objects stand in
/// the order of their centres, each centre is a plane, a centre before the plane goes left, any
/// other right, planes with nothing on their left are no choice, and A is the area of the sphere
/// around the box of the child's spheres, gathered in sweeps from both ends. Where all centres are
/// the same, or the way down has become long, half go left by their index. A node of at most
/// kMaxSphereLeaf objects stays a leaf if N T_object is no more than T.
/// The orders are sorted once and split with the nodes: O(n log n) in all.
SphereTree build_sphere_tree(std::span<const BoundingSphere> objects);

}  // namespace lray::bvh
