// The test of one ray against eight triangles, for the processor that HWY_TARGET names. Included
// once for each.
// The arithmetic is that of kernels/triangle.h, operation by operation, so that it has the same
// bits.

#if defined(LRAY_BVH_SIMD_TRIANGLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LRAY_BVH_SIMD_TRIANGLES_INL_H
#undef LRAY_BVH_SIMD_TRIANGLES_INL_H
#else
#define LRAY_BVH_SIMD_TRIANGLES_INL_H
#endif

#include <hwy/highway.h>

#include "bvh/simd/slabs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lray::bvh::HWY_NAMESPACE {

/// A ray, for triangles.
struct ShearRay {
    FloatVec origin_x;  // along the axes kx, ky, kz
    FloatVec origin_y;
    FloatVec origin_z;
    FloatVec shear_x;
    FloatVec shear_y;
    std::size_t x_offset;  // of the coordinates along kx from the first of a corner, in floats
    std::size_t y_offset;
    std::size_t z_offset;
};

HWY_INLINE ShearRay make_shear_ray(const Walk& walk) {
    const Floats d;
    const FloatRay& ray = *opaque(walk.ray);
    ShearRay result;
    result.origin_x = hn::Set(d, ray.origin_float[ray.axes[0]]);
    result.origin_y = hn::Set(d, ray.origin_float[ray.axes[1]]);
    result.origin_z = hn::Set(d, ray.origin_float[ray.axes[2]]);
    result.shear_x = hn::Set(d, ray.shear_x);
    result.shear_y = hn::Set(d, ray.shear_y);
    result.x_offset = std::size_t{ray.axes[0]} * kBoxWidth;
    result.y_offset = std::size_t{ray.axes[1]} * kBoxWidth;
    result.z_offset = std::size_t{ray.axes[2]} * kBoxWidth;
    return result;
}

struct ShearedCorner {
    FloatVec x;
    FloatVec y;
};

/// `x`, `y`, `z`: the coordinates of corners along the axes of the ray.
HWY_INLINE ShearedCorner shear(const float* x, const float* y, const float* z,
                               const ShearRay& ray) {
    const Floats d;
    const FloatVec along = hn::Sub(hn::Load(d, z), ray.origin_z);
    return {hn::Sub(hn::Sub(hn::Load(d, x), ray.origin_x), hn::Mul(ray.shear_x, along)),
            hn::Sub(hn::Sub(hn::Load(d, y), ray.origin_y), hn::Mul(ray.shear_y, along))};
}

HWY_INLINE FloatVec area_of(const ShearedCorner& p, const ShearedCorner& q) {
    return hn::Sub(hn::Mul(p.x, q.y), hn::Mul(p.y, q.x));
}

HWY_INLINE FloatVec least_corner(const TriangleBlock& block, std::size_t axis, std::size_t lane) {
    const Floats d;
    return hn::Min(hn::Min(hn::Load(d, block.corners[0][axis] + lane),
                           hn::Load(d, block.corners[1][axis] + lane)),
                   hn::Load(d, block.corners[2][axis] + lane));
}

HWY_INLINE FloatVec most_corner(const TriangleBlock& block, std::size_t axis, std::size_t lane) {
    const Floats d;
    return hn::Max(hn::Max(hn::Load(d, block.corners[0][axis] + lane),
                           hn::Load(d, block.corners[1][axis] + lane)),
                   hn::Load(d, block.corners[2][axis] + lane));
}

/// Of the lanes of `bits` returns those in whose triangle's box the ray is somewhere between `lo`
/// and `reach`.
HWY_INLINE std::uint32_t meet_triangle_boxes(const TriangleBlock& block, const Walk& walk,
                                             std::uint32_t bits, TriangleFinds& finds) {
    const Floats d;
    const FloatRay& ray = *walk.ray;
    std::uint32_t met = 0;
    for (std::uint32_t i = 0; i < kBoxWidth; i += kStep) {
        FloatVec entry = hn::Zero(d);
        FloatVec exit = hn::Zero(d);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const FloatVec least = least_corner(block, axis, i);
            const FloatVec most = most_corner(block, axis, i);
            const FloatVec inv_dir = hn::Set(d, ray.inv_dir[axis]);
            const FloatVec near = hn::IfNegativeThenElse(inv_dir, most, least);
            const FloatVec far = hn::IfNegativeThenElse(inv_dir, least, most);
            const FloatVec near_t =
                hn::Mul(hn::Sub(near, hn::Set(d, ray.origin_near[axis])), inv_dir);
            const FloatVec far_t = hn::Mul(hn::Sub(far, hn::Set(d, ray.origin_far[axis])),
                                           hn::Set(d, ray.inv_dir_far[axis]));
            entry = axis == 0 ? near_t : hn::Max(entry, near_t);
            exit = axis == 0 ? far_t : hn::Min(exit, far_t);
        }
        hn::Store(entry, d, finds.entry + i);
        hn::Store(exit, d, finds.exit + i);
        const auto is_met = hn::And(hn::Le(entry, hn::Min(exit, hn::Set(d, walk.reach))),
                                    hn::Ge(exit, hn::Set(d, walk.lo)));
        met |= bits_of(d, is_met) << i;
    }
    return met & bits;
}

using Doubles = hn::CappedTag<double, 4>;
using DoubleVec = hn::Vec<Doubles>;
inline constexpr std::uint32_t kDoubleStep = static_cast<std::uint32_t>(hn::MaxLanes(Doubles()));

struct Vec3Doubles {
    DoubleVec x;
    DoubleVec y;
    DoubleVec z;
};

HWY_INLINE Vec3Doubles operator-(const Vec3Doubles& a, const Vec3Doubles& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

HWY_INLINE DoubleVec dot(const Vec3Doubles& a, const Vec3Doubles& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

HWY_INLINE Vec3Doubles cross(const Vec3Doubles& a, const Vec3Doubles& b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(b.y, a.z)),
            hn::Sub(hn::Mul(a.z, b.x), hn::Mul(b.z, a.x)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(b.x, a.y))};
}

HWY_INLINE Vec3Doubles fill(const double* values) {
    const Doubles d;
    return {hn::Set(d, values[0]), hn::Set(d, values[1]), hn::Set(d, values[2])};
}

HWY_INLINE DoubleVec load_wide(const float* from) {
    const Doubles d;
    return hn::PromoteTo(d, hn::Load(hn::Rebind<float, Doubles>(), from));
}

HWY_INLINE Vec3Doubles corner_at(const TriangleBlock& block, std::size_t corner, std::size_t lane) {
    const auto& planes = block.corners[corner];
    return {load_wide(planes[0] + lane), load_wide(planes[1] + lane), load_wide(planes[2] + lane)};
}

/// plane_hit() of kernels/triangle.h, operation by operation. Of the lanes of `bits` returns those
/// whose plane is met in front of `lo` and, if it is not grazed, by `reach`.
HWY_INLINE std::uint32_t meet_triangle_planes(const TriangleBlock& block, const Walk& walk,
                                              std::uint32_t bits, TriangleFinds& finds) {
    const Doubles d;
    const hn::Rebind<float, Doubles> narrow;
    const Vec3Doubles origin = fill(walk.origin);
    const Vec3Doubles dir = fill(walk.dir);
    std::uint32_t met = 0;
    finds.grazing = 0;
    for (std::uint32_t i = 0; i < kBoxWidth; i += kDoubleStep) {
        if ((bits >> i & ((1u << kDoubleStep) - 1)) == 0) continue;
        const Vec3Doubles a = corner_at(block, 0, i);
        const Vec3Doubles normal = cross(corner_at(block, 1, i) - a, corner_at(block, 2, i) - a);
        const DoubleVec slope = dot(normal, dir);
        const DoubleVec plane_t = hn::Div(dot(normal, a - origin), slope);
        const auto entry = hn::Load(narrow, finds.entry + i);
        const DoubleVec least = hn::PromoteTo(d, hn::Mul(entry, hn::Set(narrow, kEntryFactor)));
        const DoubleVec most = load_wide(finds.exit + i);
        const DoubleVec in_box =
            hn::IfThenElse(hn::Lt(plane_t, least), least, hn::Min(plane_t, most));
        const auto t = hn::DemoteTo(narrow, in_box);
        const DoubleVec limit =
            hn::Mul(hn::Mul(hn::Set(d, kGrazing), dot(normal, normal)), dot(dir, dir));
        const std::uint32_t steep = bits_of(d, hn::Ge(hn::Mul(slope, slope), limit));
        const std::uint32_t sloped = bits_of(d, hn::Ne(slope, hn::Zero(d)));
        const std::uint32_t ahead = bits_of(narrow, hn::Gt(t, hn::Set(narrow, walk.lo)));
        const std::uint32_t near = bits_of(narrow, hn::Le(t, hn::Set(narrow, walk.reach)));
        met |= (sloped & ahead & (near | ~steep)) << i;
        finds.grazing |= (~steep & ((1u << kDoubleStep) - 1)) << i;
        hn::Store(t, narrow, finds.t + i);
        hn::Store(hn::DemoteTo(narrow, normal.x), narrow, finds.normal[0] + i);
        hn::Store(hn::DemoteTo(narrow, normal.y), narrow, finds.normal[1] + i);
        hn::Store(hn::DemoteTo(narrow, normal.z), narrow, finds.normal[2] + i);
    }
    return bits & met;
}

/// Returns which triangles of a block the ray may meet between `lo` and `reach`, a bit each: those
/// whose areas have no two signs (and maybe such as have one that is not a number), in whose box it
/// is, and whose plane it meets there.
HWY_INLINE std::uint32_t meet_triangles(const TriangleBlock& block, Walk& walk,
                                        TriangleFinds& finds) {
    const Floats d;
    const ShearRay ray = make_shear_ray(walk);
    const FloatVec zero = hn::Zero(d);
    const float* const x = &block.corners[0][0][0] + ray.x_offset;
    const float* const y = &block.corners[0][0][0] + ray.y_offset;
    const float* const z = &block.corners[0][0][0] + ray.z_offset;
    constexpr std::size_t kCorner = 3 * kBoxWidth;  // from one to the next
    std::uint32_t bits = 0;
    for (std::uint32_t i = 0; i < kBoxWidth; i += kStep) {
        const ShearedCorner a = shear(x + i, y + i, z + i, ray);
        const ShearedCorner b = shear(x + kCorner + i, y + kCorner + i, z + kCorner + i, ray);
        const ShearedCorner c =
            shear(x + 2 * kCorner + i, y + 2 * kCorner + i, z + 2 * kCorner + i, ray);
        const FloatVec area_a = area_of(c, b);
        const FloatVec area_b = area_of(a, c);
        const FloatVec area_c = area_of(b, a);
        const FloatVec least = hn::Min(hn::Min(area_a, area_b), area_c);
        const FloatVec most = hn::Max(hn::Max(area_a, area_b), area_c);
        const auto has_two_signs = hn::And(hn::Lt(least, zero), hn::Gt(most, zero));
        const std::uint32_t there = lanes_there(block.ids + i, walk);
        bits |= (there & ~bits_of(d, has_two_signs)) << i;
        hn::Store(area_a, d, finds.area_a + i);
        hn::Store(area_b, d, finds.area_b + i);
        hn::Store(area_c, d, finds.area_c + i);
    }
    if (bits != 0) bits = meet_triangle_boxes(block, walk, bits, finds);
    return bits == 0 ? 0 : meet_triangle_planes(block, walk, bits, finds);
}

}  // namespace lray::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
