#include "bvh/boxes/fill_tree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

#include "base/assert.h"
#include "bvh/boxes/round_bound.h"

namespace lray::bvh {

namespace {

std::size_t round_up_to_lines(std::size_t byte_count) {
    constexpr std::size_t kCacheLine = 64;
    return (byte_count + kCacheLine - 1) / kCacheLine * kCacheLine;
}

/// Where each array begins in the arena, and the bytes of all.
struct Layout {
    std::size_t triangles = 0;
    std::size_t spheres = 0;
    std::size_t framed = 0;
    std::size_t instances = 0;
    std::size_t size = 0;

    explicit Layout(const BoxTreeCounts& counts)
        : triangles(round_up_to_lines(counts.nodes * sizeof(BoxNode))),
          spheres(round_up_to_lines(triangles + counts.triangle_blocks * sizeof(TriangleBlock))),
          framed(round_up_to_lines(spheres + counts.sphere_blocks * sizeof(SphereBlock))),
          instances(round_up_to_lines(framed + counts.framed * sizeof(RoundBound))),
          size(instances + counts.instances * sizeof(std::uint32_t)) {}
};

/// The arrays of a tree while they are written.
struct Arrays {
    BoxNode* nodes = nullptr;
    TriangleBlock* triangles = nullptr;
    SphereBlock* spheres = nullptr;
    RoundBound* framed = nullptr;
    std::uint32_t* instances = nullptr;
};

Arrays arrays_in(const Arena& arena, const BoxTreeCounts& counts) {
    const Layout layout(counts);
    std::byte* const data = arena.data();
    Arrays arrays;
    // The memory is mapped as zeros; the structs are trivial.
    arrays.nodes = reinterpret_cast<BoxNode*>(data);
    arrays.triangles = reinterpret_cast<TriangleBlock*>(data + layout.triangles);
    arrays.spheres = reinterpret_cast<SphereBlock*>(data + layout.spheres);
    arrays.framed = reinterpret_cast<RoundBound*>(data + layout.framed);
    arrays.instances = reinterpret_cast<std::uint32_t*>(data + layout.instances);
    return arrays;
}

void fill_block(TriangleBlock& block, const scene::Geometry& geometry,
                std::span<const BuildRef> refs) {
    std::ranges::fill(block.ids, kNoLane);
    for (std::size_t lane = 0; lane < refs.size(); ++lane) {
        const RefCorners corners = corners_of(geometry, refs[lane]);
        for (int axis = 0; axis < 3; ++axis) {
            const auto row = static_cast<std::size_t>(axis);
            block.corners[0][row][lane] = corners.a[axis];
            block.corners[1][row][lane] = corners.b[axis];
            block.corners[2][row][lane] = corners.c[axis];
        }
        block.ids[lane] = refs[lane].id;
    }
}

void fill_block(SphereBlock& block, const scene::Geometry& geometry,
                std::span<const BuildRef> refs) {
    std::ranges::fill(block.ids, kNoLane);
    for (std::size_t lane = 0; lane < refs.size(); ++lane) {
        const std::uint32_t id = refs[lane].id;
        const scene::Sphere& sphere = geometry.spheres[id & scene::PrimitiveId::kMaxIndex];
        for (int axis = 0; axis < 3; ++axis) {
            block.center[static_cast<std::size_t>(axis)][lane] = sphere.center[axis];
        }
        block.radius[lane] = sphere.radius;
        block.ids[lane] = id;
    }
}

template <class Block>
Block* fill_blocks(Block* block, const scene::Geometry& geometry, std::span<const BuildRef> refs) {
    while (!refs.empty()) {
        const std::size_t count = std::min<std::size_t>(refs.size(), kBoxWidth);
        fill_block(*block++, geometry, refs.first(count));
        refs = refs.subspan(count);
    }
    return block;
}

/// Writes from the beginning of the arrays on.
void fill_leaves(Arrays arrays, const scene::Geometry& geometry, std::span<const BuildRef> refs,
                 std::span<const WideLeaf> leaves) {
    for (const WideLeaf& leaf : leaves) {
        const std::span<const BuildRef> members = refs.subspan(leaf.first_ref, leaf.ref_count);
        switch (leaf.kind) {
            case BoxChildKind::triangles:
                arrays.triangles = fill_blocks(arrays.triangles, geometry, members);
                break;
            case BoxChildKind::spheres:
                arrays.spheres = fill_blocks(arrays.spheres, geometry, members);
                break;
            case BoxChildKind::framed:
                for (const BuildRef& ref : members) {
                    *arrays.framed++ = round_bound(geometry, scene::PrimitiveId::of_value(ref.id));
                }
                break;
            case BoxChildKind::instances:
                for (const BuildRef& ref : members) *arrays.instances++ = ref.id;
                break;
            case BoxChildKind::node:
                LRAY_ASSERT(leaf.kind != BoxChildKind::node);
        }
    }
}

/// A part and how much of each array is before it.
struct PlacedPart {
    WidePart* part = nullptr;
    BoxTreeCounts before{};
};

BoxChild relocated(BoxChild child, const BoxTreeCounts& before) {
    // Indices are in the low bits of all kinds; collapse_tree() and place() see to their range.
    BoxTreeCounts counts = before;
    const BoxChildKind kind = kind_of(child);
    return child + counts.of(kind) * (kind == BoxChildKind::node ? kNodeUnits : 1);
}

/// Puts a part and its branches in order, and moves the indices of its children there.
// NOLINTNEXTLINE(misc-no-recursion): kMaxBoxDepth deep at most
BoxChild place(WidePart& part, BoxTreeCounts& next, std::vector<PlacedPart>& placed) {
    const BoxTreeCounts before = next;
    placed.push_back({&part, before});
    next += part.counts;
    for (WideBranch& branch : part.branches) {
        part.nodes[0].children[branch.lane] = place(branch.part, next, placed);
    }
    return relocated(part.root, before);
}

void write_part(const PlacedPart& placed, Arrays arrays, const scene::Geometry& geometry,
                std::span<const BuildRef> refs) {
    const WidePart& part = *placed.part;
    const BoxTreeCounts& before = placed.before;
    BoxNode* const nodes = arrays.nodes + before.nodes;
    std::ranges::copy(part.nodes, nodes);
    if (part.branches.empty()) {
        for (std::size_t i = 0; i < part.nodes.size(); ++i) {
            for (std::size_t lane = 0; lane < kBoxWidth; ++lane) {
                if (nodes[i].planes[0][0][lane] == kInfinity) break;  // no more children
                nodes[i].children[lane] = relocated(nodes[i].children[lane], before);
            }
        }
    }
    arrays.triangles += before.triangle_blocks;
    arrays.spheres += before.sphere_blocks;
    arrays.framed += before.framed;
    arrays.instances += before.instances;
    fill_leaves(arrays, geometry, refs, part.leaves);
}

}  // namespace

BoxTree fill_tree(const scene::Geometry& geometry, std::span<const BuildRef> refs,
                  WidePart& whole) {
    BoxTree tree;
    BoxTreeCounts counts;
    std::vector<PlacedPart> placed;
    const BoxChild root = place(whole, counts, placed);
    LRAY_ASSERT(counts.nodes < kMaxBoxNodes && counts.triangle_blocks <= kMaxLeafFirst &&
                counts.sphere_blocks <= kMaxLeafFirst && counts.framed <= kMaxLeafFirst &&
                counts.instances <= kMaxLeafFirst);
    tree.arena = Arena(Layout(counts).size);
    const Arrays arrays = arrays_in(tree.arena, counts);
    tbb::parallel_for(std::size_t{0}, placed.size(),
                      [&](std::size_t i) { write_part(placed[i], arrays, geometry, refs); });
    tree.view = {root,           false,         arrays.nodes,    arrays.triangles,
                 arrays.spheres, arrays.framed, arrays.instances};
    for (const PlacedPart& some : placed) {
        tree.stats.leaves += some.part->leaves.size();
        tree.stats.references += some.part->ref_count;
        tree.stats.depth = std::max(tree.stats.depth, some.part->depth);
        tree.stats.cost += some.part->cost;
    }
    tree.stats.nodes = counts.nodes;
    tree.stats.bytes = tree.arena.size();
    return tree;
}

}  // namespace lray::bvh
