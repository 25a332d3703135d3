// What one ray does at a leaf, for the processor that HWY_TARGET names. Included once for each.

#if defined(LRAY_BVH_SIMD_LEAF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LRAY_BVH_SIMD_LEAF_INL_H
#undef LRAY_BVH_SIMD_LEAF_INL_H
#else
#define LRAY_BVH_SIMD_LEAF_INL_H
#endif

#include <hwy/highway.h>

#include "bvh/simd/blocks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lray::bvh::HWY_NAMESPACE {

/// Tells the walk's calls of what the ray may meet in a leaf. Returns true if one ended the walk.
HWY_NOINLINE bool meet_leaf(const BoxTreeView& tree, BoxChild leaf, const ShearRay& shear_ray,
                          Walk& walk) {
    const std::uint32_t count = (leaf >> kBoxCountShift & (kMaxLeafCount - 1)) + 1;
    const std::uint32_t first = leaf & kMaxLeafFirst;
    const auto kind = static_cast<BoxChildKind>(leaf >> kBoxKindShift);
    if (kind == BoxChildKind::triangles) {
        for (std::uint32_t i = first; i < first + count; ++i) {
            const TriangleBlock& block = tree.triangles[i];
            BlockFinds finds;
            std::uint32_t bits = meet_triangles(block, shear_ray, walk, finds);
            while (bits != 0) {
                const auto lane = static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
                bits &= bits - 1;
                const TriangleFind find = {finds.area_a[lane], finds.area_b[lane],
                                           finds.area_c[lane], finds.entry[lane], finds.exit[lane]};
                if (walk.calls->meet_triangle(walk, block, lane, find)) return true;
            }
        }
        return false;
    }
    if (kind == BoxChildKind::spheres) {
        for (std::uint32_t i = first; i < first + count; ++i) {
            const SphereBlock& block = tree.spheres[i];
            std::uint32_t bits = meet_spheres(block, walk);
            while (bits != 0) {
                const auto lane = static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
                bits &= bits - 1;
                if (walk.calls->meet_sphere(walk, block.ids[lane])) return true;
            }
        }
        return false;
    }
    return walk.calls->meet_listed(walk, tree.list + first, count);
}

}  // namespace lray::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
