// What the rays of a tile do at a leaf of spheres or of framed primitives, for the processor that
// HWY_TARGET names: one primitive after the other against vectors of rays. Included once for each.
// The tests are those of bounds-inl.h.

#if defined(LRAY_BVH_SIMD_TILE_LEAF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LRAY_BVH_SIMD_TILE_LEAF_INL_H
#undef LRAY_BVH_SIMD_TILE_LEAF_INL_H
#else
#define LRAY_BVH_SIMD_TILE_LEAF_INL_H
#endif

#include <hwy/highway.h>

#include "bvh/simd/ray_walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lray::bvh::HWY_NAMESPACE {

using RayFloats = hn::CappedTag<float, kTileStep>;
using RayVec = hn::Vec<RayFloats>;
inline constexpr std::uint32_t kRayStep = static_cast<std::uint32_t>(hn::MaxLanes(RayFloats()));
inline constexpr std::uint64_t kStepBits = (std::uint64_t{1} << kRayStep) - 1;

/// Returns the walk of a ray, whose floats may not be prepared.
HWY_INLINE Walk& started_walk(Tile& tile, std::size_t ray) {
    if (tile.walks[ray] == nullptr) {
        tile.walks[ray] = tile.start(tile, static_cast<std::uint32_t>(ray));
    }
    return *tile.walks[ray];
}

/// Works out unit directions; of rays that are too slow or fast for float, what is not a number.
HWY_INLINE void prepare_units(Tile& tile, std::uint32_t count) {
    const RayFloats d;
    for (std::uint32_t i = 0; i < count; i += kRayStep) {
        const RayVec dir[3] = {hn::Load(d, tile.dir[0] + i), hn::Load(d, tile.dir[1] + i),
                               hn::Load(d, tile.dir[2] + i)};
        const RayVec length = hn::Sqrt(dot(d, dir, dir));
        const auto is_usual = hn::And(hn::Gt(length, hn::Set(d, kLeastSpeedAside)),
                                      hn::Lt(length, hn::Set(d, kMostSpeedAside)));
        const RayVec t_per_length =
            hn::IfThenElse(is_usual, hn::Div(hn::Set(d, 1.0f), length), hn::NaN(d));
        hn::Store(t_per_length, d, tile.t_per_length + i);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            hn::Store(hn::Mul(dir[axis], t_per_length), d, tile.unit_dir[axis] + i);
        }
    }
}

/// Of a tile, from ray i on. Their origins are floats: they have no error.
HWY_INLINE BoundRay<RayFloats> bound_rays_of(const Tile& tile, std::uint32_t i) {
    const RayFloats d;
    BoundRay<RayFloats> result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        result.origin[axis] = hn::Load(d, tile.origin[axis] + i);
        result.dir[axis] = hn::Load(d, tile.dir[axis] + i);
        result.unit_dir[axis] = hn::Load(d, tile.unit_dir[axis] + i);
    }
    result.t_per_length = hn::Load(d, tile.t_per_length + i);
    result.origin_error = hn::Zero(d);
    result.lo = hn::Load(d, tile.lo + i);
    result.reach = hn::Load(d, tile.reach + i);
    return result;
}

/// The same sphere for all rays.
HWY_INLINE BallBound<RayFloats> ball_of(const SphereBlock& block, std::uint32_t lane) {
    const RayFloats d;
    return {{hn::Set(d, block.center[0][lane]), hn::Set(d, block.center[1][lane]),
             hn::Set(d, block.center[2][lane])},
            hn::Set(d, block.radius[lane])};
}

/// Of the rays returns those that may meet what is bounded.
template <class Bound>
HWY_INLINE std::uint64_t rays_at(const Bound& bound, const Tile& tile, std::uint64_t rays) {
    std::uint64_t met = 0;
    for (std::uint32_t i = 0; i < kMaxTileRays; i += kRayStep) {
        if ((rays >> i & kStepBits) == 0) continue;
        const auto is_missed = misses(RayFloats(), bound, bound_rays_of(tile, i));
        met |= std::uint64_t{~bits_of(RayFloats(), is_missed) & kStepBits} << i;
    }
    return met & rays;
}

/// True of leaves whose primitives are bounded: the bounds of one are tested with many rays at
/// once.
HWY_INLINE bool is_bounded(BoxChild leaf) {
    const auto kind = static_cast<BoxChildKind>(leaf >> kBoxKindShift);
    return kind == BoxChildKind::spheres || kind == BoxChildKind::framed;
}

/// Tests the bound of a primitive with the rays, and calls meet(walk) for those that may meet it.
template <class Bound, class Meet>
HWY_INLINE void meet_with_tile(const Bound& bound, std::uint64_t rays, Tile& tile, Meet meet) {
    rays &= tile.active;
    tile.primitive_tests += hwy::PopCount(rays);
    for (std::uint64_t met = rays_at(bound, tile, rays); met != 0; met &= met - 1) {
        const auto ray = hwy::Num0BitsBelowLS1Bit_Nonzero64(met);
        Walk& walk = started_walk(tile, ray);
        if (meet(walk) == Met::end) {
            tile.active &= ~(std::uint64_t{1} << ray);
            tile.reach[ray] = kNoReach;
        } else {
            tile.reach[ray] = walk.reach;
        }
    }
}

HWY_NOINLINE void meet_bounded_leaf(const BoxTreeView& tree, BoxChild leaf, std::uint64_t rays,
                                    Tile& tile) {
    const std::uint32_t first = leaf & kMaxLeafFirst;
    const std::uint32_t end = first + (leaf >> kBoxCountShift & (kMaxLeafCount - 1)) + 1;
    if (static_cast<BoxChildKind>(leaf >> kBoxKindShift) == BoxChildKind::framed) {
        for (std::uint32_t i = first; i < end; ++i) {
            const RoundBound& bound = tree.framed[i];
            meet_with_tile(bound, rays, tile,
                           [&](Walk& walk) { return walk.calls->meet_framed(walk, bound.id); });
        }
        return;
    }
    for (std::uint32_t i = first; i < end; ++i) {
        const SphereBlock& block = tree.spheres[i];
        for (std::uint32_t lane = 0; lane < kBoxWidth && block.ids[lane] != kNoLane; ++lane) {
            meet_with_tile(ball_of(block, lane), rays, tile,
                           [&](Walk& walk) { return walk.calls->meet_sphere(walk, block, lane); });
        }
    }
}

}  // namespace lray::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
