#include "bvh/boxes/scalar_walk.h"

#include <algorithm>
#include <array>
#include <bit>

#include "bvh/boxes/box_tree.h"
#include "bvh/kernels/triangle.h"

namespace lray::bvh {

namespace {

/// A child that waits, and where the ray enters it.
struct Waiting {
    BoxChild child = 0;
    float entry = 0.0f;
};

bool meet_triangles(const TriangleBlock& block, Walk& walk) {
    const FloatRay& ray = *walk.ray;
    TriangleFinds finds;
    for (std::uint32_t lane = 0; lane < kBoxWidth && block.ids[lane] != kNoLane; ++lane) {
        ++walk.primitive_tests;
        const Vec3 a = corner_of(block, 0, lane);
        const Vec3 b = corner_of(block, 1, lane);
        const Vec3 c = corner_of(block, 2, lane);
        const auto areas = edge_areas<float>(sheared(a, ray), sheared(b, ray), sheared(c, ray));
        if (areas.have_two_signs()) continue;
        const Stretch stretch = triangle_stretch(a, b, c, ray);
        if (!(stretch.entry <= stretch.exit) || !stretch.overlaps(walk.lo, walk.reach)) continue;
        finds.area_a[lane] = areas.a;
        finds.area_b[lane] = areas.b;
        finds.area_c[lane] = areas.c;
        finds.entry[lane] = stretch.entry;
        finds.exit[lane] = stretch.exit;
        const PlaneHit plane = plane_hit(a, b, c, stretch, static_cast<const PreparedRay&>(ray));
        finds.t[lane] = plane.t;
        for (int axis = 0; axis < 3; ++axis) finds.normal[axis][lane] = plane.normal[axis];
        finds.grazing = (plane.is_grazing ? 1u : 0u) << lane;
        if (walk.calls->meet_triangle(walk, block, lane, finds) == Met::end) return true;
    }
    return false;
}

bool meet_spheres(const SphereBlock& block, Walk& walk) {
    for (std::uint32_t lane = 0; lane < kBoxWidth && block.ids[lane] != kNoLane; ++lane) {
        ++walk.primitive_tests;
        if (walk.calls->meet_sphere(walk, block, lane) == Met::end) return true;
    }
    return false;
}

bool meet_leaf(const BoxTreeView& tree, BoxChild leaf, Walk& walk) {
    const std::uint32_t first = leaf_first(leaf);
    const std::uint32_t count = leaf_count(leaf);
    switch (kind_of(leaf)) {
        case BoxChildKind::triangles:
            return std::any_of(
                tree.triangles + first, tree.triangles + first + count,
                [&](const TriangleBlock& block) { return meet_triangles(block, walk); });
        case BoxChildKind::spheres:
            return std::any_of(tree.spheres + first, tree.spheres + first + count,
                               [&](const SphereBlock& block) { return meet_spheres(block, walk); });
        case BoxChildKind::framed:
            walk.primitive_tests += count;
            return std::any_of(tree.framed + first, tree.framed + first + count,
                               [&](const RoundBound& bound) {
                                   return walk.calls->meet_framed(walk, bound.id) == Met::end;
                               });
        case BoxChildKind::instances:
            return walk.calls->meet_instances(walk, tree.instances + first, count) == Met::end;
        case BoxChildKind::node:
            break;
    }
    return false;
}

bool walk_tree(const BoxTreeView& tree, Walk& walk) {
    if (tree.is_empty) return false;
    prepare_floats(*walk.ray);
    std::array<Waiting, kMaxWaiting> stack;
    std::size_t waiting_count = 0;
    stack[waiting_count++] = {tree.root, walk.lo};
    while (waiting_count > 0) {
        const Waiting next = stack[--waiting_count];
        if (next.entry > walk.reach) continue;
        if (kind_of(next.child) != BoxChildKind::node) {
            if (meet_leaf(tree, next.child, walk)) return true;
            continue;
        }
        ++walk.node_tests;
        const std::size_t bottom = waiting_count;
        const BoxNode& node = node_of(tree, next.child);
        for (std::size_t child = 0; child < kBoxWidth; ++child) {
            const Stretch stretch = stretch_in(box_of(node, child), *walk.ray);
            if (!stretch.overlaps(walk.lo, walk.reach)) continue;
            stack[waiting_count++] = {node.children[child], stretch.entry};
        }
        std::stable_sort(stack.begin() + static_cast<std::ptrdiff_t>(bottom),
                         stack.begin() + static_cast<std::ptrdiff_t>(waiting_count),
                         [](const Waiting& a, const Waiting& b) { return a.entry > b.entry; });
    }
    return false;
}

/// One ray after the other.
bool walk_tile(const BoxTreeView& tree, Tile& tile) {
    for (std::uint64_t rays = tile.active; rays != 0; rays &= rays - 1) {
        const int ray = std::countr_zero(rays);
        if (tile.walks[ray] == nullptr) {
            tile.walks[ray] = tile.start(tile, static_cast<std::uint32_t>(ray));
        }
        if (walk_tree(tree, *tile.walks[ray])) tile.active &= ~(std::uint64_t{1} << ray);
    }
    return true;
}

}  // namespace

Walks scalar_walks() {
    return {walk_tree, walk_tree, walk_tile, walk_tile, "scalar"};
}

}  // namespace lray::bvh
