// How a tree of boxes lies in memory. Plain structs without functions that a compiler may emit on
// their own: code compiled for one processor reads them beside code for another.
#pragma once

#include <cstdint>

namespace lray::bvh {

/// Children of a node, primitives of a block.
inline constexpr std::uint32_t kBoxWidth = 8;

/// No path from the root has more nodes.
inline constexpr std::uint32_t kMaxBoxDepth = 64;

/// What a child is. Nodes: where one lies. Leaves: `count` blocks, framed primitives or instances
/// from `first` on.
enum class BoxChildKind : std::uint32_t { node, triangles, spheres, framed, instances };

inline constexpr unsigned kBoxKindShift = 29;
inline constexpr unsigned kBoxCountShift = 26;
inline constexpr std::uint32_t kMaxLeafCount = 8;  // stored less one, in three bits
inline constexpr std::uint32_t kMaxLeafFirst = (std::uint32_t{1} << kBoxCountShift) - 1;

/// A BoxChildKind in the three top bits. A node: its index times kNodeUnits below, so that its
/// address takes a shift. A leaf: the count less one in three bits, then `first`.
using BoxChild = std::uint32_t;
inline constexpr BoxChild kFirstLeaf = BoxChild{1} << kBoxKindShift;

/// Shape: planes[axis][side][child], side 0 the lower. A child that is not there has +infinity
/// for its lower planes and -infinity for its upper ones: no ray meets it.
struct alignas(32) BoxNode {
    float planes[3][2][kBoxWidth];
    BoxChild children[kBoxWidth];
};
inline constexpr std::uint32_t kNodeUnitBytes = 32;
inline constexpr std::uint32_t kNodeUnits = 7;
static_assert(sizeof(BoxNode) == kNodeUnits * kNodeUnitBytes);

inline constexpr std::uint32_t kMaxBoxNodes = kFirstLeaf / kNodeUnits;

/// In place of the id of a primitive: a lane that holds nothing.
inline constexpr std::uint32_t kNoLane = 0xffffffffu;

/// Triangles, and halves of rectangles, by lane. Shape: corners[vertex][axis][lane]; ids are
/// values of PrimitiveId. Lanes are filled from the first on; the others have kNoLane and corners
/// of 0.
struct alignas(32) TriangleBlock {
    float corners[3][3][kBoxWidth];
    std::uint32_t ids[kBoxWidth];
};
static_assert(sizeof(TriangleBlock) == 320);

/// Spheres by lane, as in TriangleBlock. Shape: center[axis][lane].
struct alignas(32) SphereBlock {
    float center[3][kBoxWidth];
    float radius[kBoxWidth];
    std::uint32_t ids[kBoxWidth];
};
static_assert(sizeof(SphereBlock) == 160);

/// A primitive of a kind with an affine frame, and what it is inside of: a cylinder of radius 1
/// around +Y of a space of its own, from y = bottom to y = top. Shape:
/// bound_from_world[column][row]. One line of the cache.
struct alignas(64) RoundBound {
    float origin[3];
    float bound_from_world[3][3];
    float bottom;
    float top;
    float stretch;  // the sum of the sizes of the numbers of the map
    std::uint32_t id;
};
static_assert(sizeof(RoundBound) == 64);

/// A tree as it is traced. The root is a child of no node; planes are not in the tree.
struct BoxTreeView {
    BoxChild root = 0;
    bool is_empty = true;
    const BoxNode* nodes = nullptr;
    const TriangleBlock* triangles = nullptr;
    const SphereBlock* spheres = nullptr;
    const RoundBound* framed = nullptr;
    const std::uint32_t* instances = nullptr;  // values of PrimitiveId
};

}  // namespace lray::bvh
