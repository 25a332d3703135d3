#include "bvh/boxes/scalar_walk.h"

#include <algorithm>
#include <array>
#include <bit>

#include "bvh/boxes/box_tree.h"
#include "bvh/prepared_ray.h"

namespace lray::bvh {

namespace {

/// A child that waits, and where the ray enters it.
struct Waiting {
    BoxChild child = 0;
    float entry = 0.0f;
};

/// stretch_in() of slab.h, for the child of a node.
Waiting enter(const BoxNode& node, std::size_t child, const Walk& walk, bool& is_met) {
    float entry = walk.lo;
    float exit = walk.reach;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t near_side = walk.ray->near_side[axis];
        const float near = (node.planes[axis][near_side][child] - walk.ray->origin_near[axis]) *
                           walk.ray->inv_dir[axis];
        const float far = (node.planes[axis][1 - near_side][child] - walk.ray->origin_far[axis]) *
                          walk.ray->inv_dir_far[axis];
        entry = near > entry ? near : entry;
        exit = far < exit ? far : exit;
    }
    is_met = entry <= exit;
    return {node.children[child], entry};
}

struct Corner {
    float x = 0.0f;
    float y = 0.0f;
};

/// sheared() of kernels/triangle.h.
Corner shear(const TriangleBlock& block, std::size_t corner, std::uint32_t lane,
             const FloatRay& ray) {
    const auto& axes = block.corners[corner];
    const float z = axes[ray.axes[2]][lane] - ray.origin_float[ray.axes[2]];
    const float x = axes[ray.axes[0]][lane] - ray.origin_float[ray.axes[0]];
    const float y = axes[ray.axes[1]][lane] - ray.origin_float[ray.axes[1]];
    return {x - ray.shear_x * z, y - ray.shear_y * z};
}

float area_of(Corner p, Corner q) {
    return p.x * q.y - p.y * q.x;
}

/// triangle_stretch() of kernels/triangle.h. Returns whether the ray is in the box somewhere
/// between `lo` and `reach`.
bool enter_box(const TriangleBlock& block, std::uint32_t lane, const Walk& walk,
               TriangleFind& find) {
    const FloatRay& ray = *walk.ray;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [least, most] =
            std::minmax({block.corners[0][axis][lane], block.corners[1][axis][lane],
                         block.corners[2][axis][lane]});
        const bool is_upper_near = ray.near_side[axis] != 0;
        const float near =
            ((is_upper_near ? most : least) - ray.origin_near[axis]) * ray.inv_dir[axis];
        const float far =
            ((is_upper_near ? least : most) - ray.origin_far[axis]) * ray.inv_dir_far[axis];
        find.entry = axis == 0 || near > find.entry ? near : find.entry;
        find.exit = axis == 0 || far < find.exit ? far : find.exit;
    }
    return find.entry <= find.exit && find.entry <= walk.reach && find.exit >= walk.lo;
}

bool meet_triangles(const TriangleBlock& block, Walk& walk) {
    for (std::uint32_t lane = 0; lane < kBoxWidth && block.ids[lane] != kNoLane; ++lane) {
        ++walk.primitive_tests;
        const Corner a = shear(block, 0, lane, *walk.ray);
        const Corner b = shear(block, 1, lane, *walk.ray);
        const Corner c = shear(block, 2, lane, *walk.ray);
        TriangleFind find{area_of(c, b), area_of(a, c), area_of(b, a), 0.0f, 0.0f};
        const bool has_negative = find.area_a < 0.0f || find.area_b < 0.0f || find.area_c < 0.0f;
        const bool has_positive = find.area_a > 0.0f || find.area_b > 0.0f || find.area_c > 0.0f;
        if (has_negative && has_positive) continue;
        if (!enter_box(block, lane, walk, find)) continue;
        if (walk.calls->meet_triangle(walk, block, lane, find) == Met::end) return true;
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
        case BoxChildKind::list:
            return walk.calls->meet_listed(walk, tree.list + first, count) == Met::end;
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
        for (std::size_t child = 0; child < kBoxWidth; ++child) {
            bool is_met = false;
            const Waiting entered = enter(node_of(tree, next.child), child, walk, is_met);
            if (is_met) stack[waiting_count++] = entered;
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
