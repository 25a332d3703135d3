// Walking a tree with a tile of rays at once, for the processor that HWY_TARGET names. Included
// once for each. Nodes are tested with bounds of all rays together, each leaf's box with each ray,
// and what is in the leaf with those rays that pass.

#if defined(LRAY_BVH_SIMD_TILE_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LRAY_BVH_SIMD_TILE_WALK_INL_H
#undef LRAY_BVH_SIMD_TILE_WALK_INL_H
#else
#define LRAY_BVH_SIMD_TILE_WALK_INL_H
#endif

#include <hwy/highway.h>

#include "bvh/simd/tile_leaf-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lray::bvh::HWY_NAMESPACE {

/// So few rays go their ways alone.
inline constexpr std::size_t kFewRays = 4;

/// The least and the greatest of one axis of all rays of a tile. Rounding keeps the order of
/// numbers: what holds for a product of bounds holds for the products of the rays.
struct TileAxis {
    FloatVec origin_near;  // that from which planes are entered first
    FloatVec origin_far;   // that from which planes are left last
    FloatVec inv_dir_least;
    FloatVec inv_dir_most;
    FloatVec inv_dir_far_least;
    FloatVec inv_dir_far_most;
    std::size_t near_offset;
    std::size_t far_offset;
};

HWY_INLINE RayVec least_of(const float* values, std::uint32_t count) {
    const RayFloats d;
    RayVec result = hn::Load(d, values);
    for (std::uint32_t i = kRayStep; i < count; i += kRayStep) {
        result = hn::Min(result, hn::Load(d, values + i));
    }
    return hn::MinOfLanes(d, result);
}

HWY_INLINE RayVec most_of(const float* values, std::uint32_t count) {
    const RayFloats d;
    RayVec result = hn::Load(d, values);
    for (std::uint32_t i = kRayStep; i < count; i += kRayStep) {
        result = hn::Max(result, hn::Load(d, values + i));
    }
    return hn::MaxOfLanes(d, result);
}

HWY_INLINE FloatVec spread(RayVec value) {
    return hn::Set(Floats(), hn::GetLane(value));
}

HWY_INLINE TileAxis make_tile_axis(const Tile& tile, std::size_t axis, std::uint32_t count) {
    const bool is_negative = tile.near_side[axis] != 0;
    TileAxis result;
    result.origin_near = spread(is_negative ? least_of(tile.origin_near[axis], count)
                                            : most_of(tile.origin_near[axis], count));
    result.origin_far = spread(is_negative ? most_of(tile.origin_far[axis], count)
                                           : least_of(tile.origin_far[axis], count));
    result.inv_dir_least = spread(least_of(tile.inv_dir[axis], count));
    result.inv_dir_most = spread(most_of(tile.inv_dir[axis], count));
    result.inv_dir_far_least = spread(least_of(tile.inv_dir_far[axis], count));
    result.inv_dir_far_most = spread(most_of(tile.inv_dir_far[axis], count));
    result.near_offset = (axis * 2 + tile.near_side[axis]) * kBoxWidth;
    result.far_offset = (axis * 2 + 1 - tile.near_side[axis]) * kBoxWidth;
    return result;
}

HWY_INLINE FloatVec near_of(const TileAxis& axis, const float* planes) {
    const FloatVec way = hn::Sub(hn::Load(Floats(), planes + axis.near_offset), axis.origin_near);
    return hn::Min(hn::Mul(way, axis.inv_dir_least), hn::Mul(way, axis.inv_dir_most));
}

HWY_INLINE FloatVec far_of(const TileAxis& axis, const float* planes) {
    const FloatVec way = hn::Sub(hn::Load(Floats(), planes + axis.far_offset), axis.origin_far);
    return hn::Max(hn::Mul(way, axis.inv_dir_far_least), hn::Mul(way, axis.inv_dir_far_most));
}

/// prepare_floats() of prepared_ray.h, for slabs, of one axis of many rays. Returns false if they
/// do not all run to the same side.
HWY_INLINE bool prepare_axis(Tile& tile, std::size_t axis, std::uint32_t count) {
    const RayFloats d;
    std::uint32_t negative_count = 0;
    for (std::uint32_t i = 0; i < count; i += kRayStep) {
        const auto slabs =
            make_slabs(d, hn::Load(d, tile.origin[axis] + i), hn::Load(d, tile.dir[axis] + i));
        hn::Store(slabs.origin_near, d, tile.origin_near[axis] + i);
        hn::Store(slabs.origin_far, d, tile.origin_far[axis] + i);
        hn::Store(slabs.inv_dir, d, tile.inv_dir[axis] + i);
        hn::Store(slabs.inv_dir_far, d, tile.inv_dir_far[axis] + i);
        negative_count +=
            static_cast<std::uint32_t>(hn::CountTrue(d, hn::Lt(slabs.inv_dir, hn::Zero(d))));
    }
    tile.near_side[axis] = negative_count != 0 ? 1 : 0;
    return negative_count == 0 || negative_count == count;
}

struct TileBounds {
    TileAxis x;
    TileAxis y;
    TileAxis z;
    FloatVec lo;
};

/// Returns which children any of the rays may be in, a bit each, and where the first enters them.
HWY_INLINE std::uint32_t meet_boxes(const BoxNode& node, const TileBounds& bounds, FloatVec reach,
                                    float* HWY_RESTRICT entries) {
    const Floats d;
    std::uint32_t bits = 0;
    for (std::uint32_t i = 0; i < kBoxWidth; i += kStep) {
        const float* planes = &node.planes[0][0][0] + i;
        const FloatVec entry =
            hn::Max(hn::Max(near_of(bounds.x, planes), near_of(bounds.y, planes)),
                    hn::Max(near_of(bounds.z, planes), bounds.lo));
        const FloatVec exit = hn::Min(hn::Min(far_of(bounds.x, planes), far_of(bounds.y, planes)),
                                      hn::Min(far_of(bounds.z, planes), reach));
        hn::Store(entry, d, entries + i);
        bits |= bits_of(d, hn::Le(entry, exit)) << i;
    }
    return bits;
}

/// Of the rays of `wanted` returns those that are in one box, a bit each: each as meet_boxes() with
/// that ray would.
HWY_INLINE std::uint64_t rays_in(const float* planes, const Tile& tile, std::uint64_t wanted) {
    const RayFloats d;
    std::uint64_t bits = 0;
    RayVec near_plane[3];
    RayVec far_plane[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        near_plane[axis] = hn::Set(d, planes[(axis * 2 + tile.near_side[axis]) * kBoxWidth]);
        far_plane[axis] = hn::Set(d, planes[(axis * 2 + 1 - tile.near_side[axis]) * kBoxWidth]);
    }
    for (std::uint32_t i = 0; wanted >> i != 0; i += kRayStep) {
        if ((wanted >> i & kStepBits) == 0) {
            if (i + kRayStep == kMaxTileRays) break;
            continue;
        }
        RayVec entry = hn::Load(d, tile.lo + i);
        RayVec exit = hn::Load(d, tile.reach + i);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const RayVec near = hn::Sub(near_plane[axis], hn::Load(d, tile.origin_near[axis] + i));
            const RayVec far = hn::Sub(far_plane[axis], hn::Load(d, tile.origin_far[axis] + i));
            entry = hn::Max(entry, hn::Mul(near, hn::Load(d, tile.inv_dir[axis] + i)));
            exit = hn::Min(exit, hn::Mul(far, hn::Load(d, tile.inv_dir_far[axis] + i)));
        }
        bits |= std::uint64_t{bits_of(d, hn::Le(entry, exit))} << i;
        if (i + kRayStep == kMaxTileRays) break;
    }
    return bits & wanted;
}

/// A child that waits, where the first ray enters it, its box in its node, and the rays that are in
/// that node.
struct TileWaiting {
    const float* planes;  // null: the root, which every ray is taken to be in
    std::uint64_t rays;
    BoxChild child;
    float entry;
};

/// Returns the walk of a ray, ready to go on.
HWY_INLINE Walk& walk_of(Tile& tile, std::size_t ray, std::uint64_t& prepared) {
    const std::uint64_t bit = std::uint64_t{1} << ray;
    Walk& walk = started_walk(tile, ray);
    if ((prepared & bit) == 0) prepare_ray(*walk.ray);
    prepared |= bit;
    return walk;
}

/// Walks what is below a child with some rays, each on its own.
template <bool is_ordered>
HWY_INLINE void walk_alone(const BoxTreeView& tree, BoxChild child, std::uint64_t rays, Tile& tile,
                           std::uint64_t& prepared) {
    for (; rays != 0; rays &= rays - 1) {
        const auto ray = hwy::Num0BitsBelowLS1Bit_Nonzero64(rays);
        Walk& walk = walk_of(tile, ray, prepared);
        bool is_ended = false;
        if (child >= kFirstLeaf) {
            is_ended = meet_leaf(tree, child, walk) == kEnded;
        } else if (is_ordered) {
            is_ended = walk_nearest_below(tree, child, walk);
        } else {
            is_ended = walk_any_below(tree, child, walk);
        }
        if (is_ended) {
            tile.active &= ~(std::uint64_t{1} << ray);
            tile.reach[ray] = kNoReach;
        } else if (is_ordered) {
            tile.reach[ray] = walk.reach;
        }
    }
}

template <bool is_ordered>
HWY_INLINE bool walk_tile(const BoxTreeView& tree, Tile& tile) {
    if (tree.is_empty || tile.active == 0) return true;
    const std::uint32_t last =
        63u - static_cast<std::uint32_t>(hwy::Num0BitsAboveMS1Bit_Nonzero64(tile.active));
    const std::uint32_t count = (last / kRayStep + 1) * kRayStep;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!prepare_axis(tile, axis, count)) return false;
    }
    TileBounds bounds;
    bounds.x = make_tile_axis(tile, 0, count);
    bounds.y = make_tile_axis(tile, 1, count);
    bounds.z = make_tile_axis(tile, 2, count);
    bounds.lo = spread(least_of(tile.lo, count));
    FloatVec reach = spread(most_of(tile.reach, count));
    std::uint64_t prepared = 0;  // a bit for each ray whose own floats are
    bool has_units = false;
    TileWaiting stack[kMaxWaiting];
    TileWaiting* top = stack;
    *top++ = {nullptr, tile.active, tree.root, hn::GetLane(bounds.lo)};
    while (top != stack) {
        const TileWaiting current = *--top;
        if (current.entry > hn::GetLane(reach)) continue;
        std::uint64_t rays = current.rays & tile.active;
        if (current.planes != nullptr) rays = rays_in(current.planes, tile, rays);
        if (rays == 0) continue;
        if (current.child >= kFirstLeaf || hwy::PopCount(rays) <= kFewRays) {
            if (hwy::PopCount(rays) > kFewRays && is_bounded(current.child)) {
                if (!has_units) prepare_units(tile, count);
                has_units = true;
                meet_bounded_leaf(tree, current.child, rays, tile);
            } else {
                walk_alone<is_ordered>(tree, current.child, rays, tile, prepared);
            }
            if (tile.active == 0) break;
            reach = spread(most_of(tile.reach, count));
            continue;
        }
        ++tile.node_tests;
        const BoxNode& node = node_at(tree, current.child);
        alignas(32) float entries[kBoxWidth];
        std::uint32_t bits = meet_boxes(node, bounds, reach, entries);
        TileWaiting* const bottom = top;
        while (bits != 0) {
            const auto next = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
            bits &= bits - 1;
            const TileWaiting entered = {&node.planes[0][0][0] + next, rays, node.children[next],
                                         entries[next]};
            TileWaiting* k = top++;
            while (k > bottom && k[-1].entry < entered.entry) {
                *k = k[-1];
                --k;
            }
            *k = entered;
        }
    }
    return true;
}

}  // namespace lray::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
