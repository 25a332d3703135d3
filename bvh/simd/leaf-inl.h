// What one ray does at a leaf, for the processor that HWY_TARGET names. Included once for each.

#if defined(LRAY_BVH_SIMD_LEAF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LRAY_BVH_SIMD_LEAF_INL_H
#undef LRAY_BVH_SIMD_LEAF_INL_H
#else
#define LRAY_BVH_SIMD_LEAF_INL_H
#endif

#include <hwy/highway.h>

#include "bvh/simd/bounds-inl.h"
#include "bvh/simd/triangles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lray::bvh::HWY_NAMESPACE {

/// Of a leaf in which the walk was ended.
inline constexpr float kEnded = -1.0f;

/// Of a leaf in which nothing nearer was hit.
inline constexpr float kNoBound = 0x1p127f;

/// A triangle is hit before the ray leaves its box. This is so much farther that what is entered
/// beyond cannot hold a hit that counts: it is no nearer than reach_of() of the t that is hit.
/// It is known long before that t is.
HWY_INLINE float bound_of(float exit) {
    return exit * (1.0f + 4.0f * kSlabSlack) + 0x1p-126f;
}

HWY_INLINE float meet_triangle_leaf(const TriangleBlock* block, const TriangleBlock* end,
                                    Walk& walk) {
    float bound = kNoBound;
    for (; block != end; ++block) {
        TriangleFinds finds;
        std::uint32_t bits = meet_triangles(*block, walk, finds);
        while (bits != 0) {
            const auto lane = static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
            bits &= bits - 1;
            const Met met = walk.calls->meet_triangle(walk, *block, lane, finds);
            if (met == Met::nothing) continue;
            if (met == Met::end) return kEnded;
            const float at_most = bound_of(finds.exit[lane]);
            bound = at_most < bound ? at_most : bound;
        }
    }
    return bound;
}

HWY_INLINE float meet_sphere_leaf(const SphereBlock* block, const SphereBlock* end, Walk& walk) {
    for (; block != end; ++block) {
        std::uint32_t bits = meet_spheres(*block, walk);
        while (bits != 0) {
            const auto lane = static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
            bits &= bits - 1;
            if (walk.calls->meet_sphere(walk, *block, lane) == Met::end) return kEnded;
        }
    }
    return walk.reach;
}

HWY_INLINE float meet_framed_leaf(const RoundBound* bound, const RoundBound* end, Walk& walk) {
    for (; bound != end; ++bound) {
        ++walk.primitive_tests;
        if (misses_bound(*bound, walk)) continue;
        if (walk.calls->meet_framed(walk, bound->id) == Met::end) return kEnded;
    }
    return walk.reach;
}

HWY_NOINLINE float meet_other_leaf(const BoxTreeView& tree, BoxChildKind kind, std::uint32_t first,
                                   std::uint32_t count, Walk& walk) {
    if (kind == BoxChildKind::spheres) {
        const SphereBlock* const block = tree.spheres + first;
        return meet_sphere_leaf(block, block + count, walk);
    }
    if (kind == BoxChildKind::framed) {
        const RoundBound* const bound = tree.framed + first;
        return meet_framed_leaf(bound, bound + count, walk);
    }
    const Met met = walk.calls->meet_instances(walk, tree.instances + first, count);
    return met == Met::end ? kEnded : walk.reach;
}

/// Tells the walk's calls of what the ray may meet in a leaf. Returns kEnded if one ended the walk,
/// otherwise a bound on Walk::reach from above.
HWY_INLINE float meet_leaf(const BoxTreeView& tree, BoxChild leaf, Walk& walk) {
    const std::uint32_t count = (leaf >> kBoxCountShift & (kMaxLeafCount - 1)) + 1;
    const std::uint32_t first = leaf & kMaxLeafFirst;
    const auto kind = static_cast<BoxChildKind>(leaf >> kBoxKindShift);
    if (HWY_UNLIKELY(kind != BoxChildKind::triangles)) {
        return meet_other_leaf(tree, kind, first, count, walk);
    }
    const TriangleBlock* const block = tree.triangles + first;
    return meet_triangle_leaf(block, block + count, walk);
}

}  // namespace lray::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
