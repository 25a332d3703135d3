// A ray made ready, and its test against the eight boxes of a node, for the processor that
// HWY_TARGET names. Included once for each: no include guard of the usual kind. The arithmetic is
// that of prepared_ray.h and slab.h, operation by operation, so that it has the same bits.

#if defined(LRAY_BVH_SIMD_SLABS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LRAY_BVH_SIMD_SLABS_INL_H
#undef LRAY_BVH_SIMD_SLABS_INL_H
#else
#define LRAY_BVH_SIMD_SLABS_INL_H
#endif

#include <hwy/highway.h>

#include "bvh/simd/walk.h"

HWY_BEFORE_NAMESPACE();
namespace lray::bvh::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kBoxWidth>;
using Words = hn::RebindToUnsigned<Floats>;
using FloatVec = hn::Vec<Floats>;
using FloatMask = hn::Mask<Floats>;

/// Eight lanes are gone through in steps of so many: processors without wide vectors take two.
inline constexpr std::uint32_t kStep = static_cast<std::uint32_t>(hn::MaxLanes(Floats()));

HWY_INLINE const BoxNode& node_at(const BoxTreeView& tree, BoxChild node) {
    return *reinterpret_cast<const BoxNode*>(reinterpret_cast<const char*>(tree.nodes) +
                                             std::size_t{node} * kNodeUnitBytes);
}

/// A bit for each of at most 16 lanes.
template <class D>
HWY_INLINE std::uint32_t bits_of(D d, hn::Mask<D> mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, mask, bits);
    return hn::MaxLanes(d) > 8 ? bits[0] | static_cast<std::uint32_t>(bits[1]) << 8 : bits[0];
}

/// Returns which lanes of a step hold a primitive, a bit each, and counts them as tested.
HWY_INLINE std::uint32_t lanes_there(const std::uint32_t* ids, Walk& walk) {
    const Words w;
    const auto is_there = hn::Ne(hn::Load(w, ids), hn::Set(w, kNoLane));
    const std::uint32_t there = bits_of(Floats(), hn::RebindMask(Floats(), is_there));
    walk.primitive_tests += hwy::PopCount(there);
    return there;
}

/// The greater of two floats, by their bits as whole numbers, which takes a fourth of the time of
/// floats. Of negative ones it is any: a walk asks for what is greater than `lo`.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V greater_by_bits(D d, V a, V b) {
    const hn::RebindToSigned<D> whole;
    return hn::BitCast(d, hn::Max(hn::BitCast(whole, a), hn::BitCast(whole, b)));
}

/// Likewise the lesser; where either is negative, one that is, or -0.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V lesser_by_bits(D d, V a, V b) {
    const hn::RebindToSigned<D> whole;
    return hn::BitCast(d, hn::Min(hn::BitCast(whole, a), hn::BitCast(whole, b)));
}

/// What prepare_floats() of prepared_ray.h works out for slabs, of as many axes or rays as `D` has
/// lanes.
template <class D>
struct Slabs {
    hn::Vec<D> origin_near;
    hn::Vec<D> origin_far;
    hn::Vec<D> inv_dir;
    hn::Vec<D> inv_dir_far;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE Slabs<D> make_slabs(D d, V origin, V dir) {
    const auto speed = greater_by_bits(d, hn::Abs(dir), hn::Set(d, kLeastSpeed));
    const auto inverse = hn::Div(hn::Set(d, 1.0f), hn::CopySignToAbs(speed, dir));
    const auto slack =
        hn::Add(hn::Mul(hn::Abs(origin), hn::Set(d, kOriginSlack)), hn::Set(d, kLeastOriginSlack));
    const auto ahead = hn::CopySign(slack, dir);
    return {hn::Add(origin, ahead), hn::Sub(origin, ahead), inverse,
            hn::Mul(inverse, hn::Set(d, kExitFactor))};
}

/// Which axes a ray takes for x, y and z: [is z the fastest][is y faster than x].
inline constexpr std::uint32_t kAxes[2][2][4] = {{{1, 2, 0, 0}, {2, 0, 1, 0}},
                                                 {{0, 1, 2, 0}, {0, 1, 2, 0}}};

/// prepare_floats() of prepared_ray.h, without branches: rays after each other may run anywhere.
HWY_INLINE void prepare_ray(FloatRay& ray) {
    const hn::CappedTag<float, 4> d;
    const hn::RebindToUnsigned<decltype(d)> w;
    alignas(16) float speed[4];
    for (std::size_t i = 0; i < 4; i += hn::MaxLanes(d)) {
        const auto dir = hn::Load(d, ray.dir_float + i);
        const auto slabs = make_slabs(d, hn::Load(d, ray.origin_float + i), dir);
        hn::Store(slabs.origin_near, d, ray.origin_near + i);
        hn::Store(slabs.origin_far, d, ray.origin_far + i);
        hn::Store(slabs.inv_dir, d, ray.inv_dir + i);
        hn::Store(slabs.inv_dir_far, d, ray.inv_dir_far + i);
        hn::Store(hn::ShiftRight<31>(hn::BitCast(w, dir)), w, ray.near_side + i);
        hn::Store(hn::Abs(dir), d, speed + i);
    }
    const bool is_y_faster = !(speed[0] > speed[1]);
    const float x_or_y = speed[0] > speed[1] ? speed[0] : speed[1];
    const std::uint32_t* const axes = kAxes[x_or_y > speed[2] ? 0 : 1][is_y_faster ? 1 : 0];
    hwy::CopyBytes<sizeof(ray.axes)>(axes, ray.axes);
    const float fastest = ray.dir_float[axes[2]];
    ray.shear_x = ray.dir_float[axes[0]] / fastest;
    ray.shear_y = ray.dir_float[axes[1]] / fastest;
}

/// Returns a value that compilers know nothing about. Otherwise they would put pointers together
/// from their parts, and save over a call what is better read again after it.
template <class T>
HWY_INLINE T opaque(T value) {
#if HWY_COMPILER_GCC || HWY_COMPILER_CLANG
    asm volatile("" : "+r"(value));
#endif
    return value;
}

/// Where the planes that a ray passes first and last of each axis lie in the first node of a tree.
struct SlabPlanes {
    const char* near[3];
    const char* far[3];
};

HWY_INLINE SlabPlanes make_slab_planes(const FloatRay& ray, const BoxNode* nodes) {
    constexpr std::size_t kSideBytes = kBoxWidth * sizeof(float);
    SlabPlanes result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t near = (2 * axis + ray.near_side[axis]) * kSideBytes;
        result.near[axis] = opaque(reinterpret_cast<const char*>(nodes) + near);
        result.far[axis] = opaque(reinterpret_cast<const char*>(nodes) + (near ^ kSideBytes));
    }
    return result;
}

/// A ray, for slabs, in registers.
struct SlabRay {
    FloatVec origin_near[3];
    FloatVec origin_far[3];
    FloatVec inv_dir[3];
    FloatVec inv_dir_far[3];
    FloatVec lo;
};

HWY_INLINE SlabRay make_slab_ray(const Walk& walk) {
    const Floats d;
    const FloatRay& ray = *opaque(walk.ray);
    SlabRay result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        result.origin_near[axis] = hn::Set(d, ray.origin_near[axis]);
        result.origin_far[axis] = hn::Set(d, ray.origin_far[axis]);
        result.inv_dir[axis] = hn::Set(d, ray.inv_dir[axis]);
        result.inv_dir_far[axis] = hn::Set(d, ray.inv_dir_far[axis]);
    }
    result.lo = hn::Set(d, walk.lo);
    return result;
}

HWY_INLINE FloatVec near_of(std::size_t axis, const SlabPlanes& planes, const SlabRay& ray,
                            std::size_t offset) {
    const auto* const plane = reinterpret_cast<const float*>(planes.near[axis] + offset);
    return hn::Mul(hn::Sub(hn::Load(Floats(), plane), ray.origin_near[axis]), ray.inv_dir[axis]);
}

HWY_INLINE FloatVec far_of(std::size_t axis, const SlabPlanes& planes, const SlabRay& ray,
                           std::size_t offset) {
    const auto* const plane = reinterpret_cast<const float*>(planes.far[axis] + offset);
    return hn::Mul(hn::Sub(hn::Load(Floats(), plane), ray.origin_far[axis]), ray.inv_dir_far[axis]);
}

/// Where a ray enters children of a node, and which of them it is in between `lo` and `reach`.
struct BoxesMet {
    FloatVec entry;
    FloatMask is_met;
};

/// Of the children from `lane` on: a step of them. A box that is left at -0 may be met or not: no
/// hit in it counts.
HWY_INLINE BoxesMet meet_step(BoxChild node, std::uint32_t lane, const SlabPlanes& planes,
                              const SlabRay& ray, FloatVec reach) {
    const std::size_t at = std::size_t{node} * kNodeUnitBytes + lane * sizeof(float);
    const Floats d;
    const FloatVec entry_x = near_of(0, planes, ray, at);
    const FloatVec entry_y = near_of(1, planes, ray, at);
    const FloatVec entry_z = near_of(2, planes, ray, at);
    const FloatVec exit_x = far_of(0, planes, ray, at);
    const FloatVec exit_y = far_of(1, planes, ray, at);
    const FloatVec exit_z = far_of(2, planes, ray, at);
    const FloatVec entry = greater_by_bits(d, greater_by_bits(d, entry_x, entry_y),
                                           greater_by_bits(d, entry_z, ray.lo));
    const FloatVec exit =
        lesser_by_bits(d, lesser_by_bits(d, exit_x, exit_y), lesser_by_bits(d, exit_z, reach));
    return {entry, hn::Le(entry, exit)};
}

/// Of all children: a bit for each that is met, and the entries as the bits of floats.
HWY_INLINE std::uint32_t meet_boxes(BoxChild node, const SlabPlanes& planes, const SlabRay& ray,
                                    FloatVec reach, std::uint32_t* HWY_RESTRICT entries) {
    const Words w;
    std::uint32_t bits = 0;
    for (std::uint32_t i = 0; i < kBoxWidth; i += kStep) {
        const BoxesMet step = meet_step(node, i, planes, ray, reach);
        hn::Store(hn::BitCast(w, step.entry), w, entries + i);
        bits |= bits_of(Floats(), step.is_met) << i;
    }
    return bits;
}

}  // namespace lray::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
