// Walking a tree with one ray, for the processor that HWY_TARGET names. Included once for each.

#if defined(LRAY_BVH_SIMD_RAY_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LRAY_BVH_SIMD_RAY_WALK_INL_H
#undef LRAY_BVH_SIMD_RAY_WALK_INL_H
#else
#define LRAY_BVH_SIMD_RAY_WALK_INL_H
#endif

#include <hwy/highway.h>

#include "bvh/simd/leaf-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lray::bvh::HWY_NAMESPACE {

/// A child that waits: where the ray enters it in the upper half, as the bits of a float that is
/// not negative, which are in its order; the BoxChild in the lower.
using Waiting = std::uint64_t;

HWY_INLINE Waiting make_waiting(const BoxNode& node, const std::uint32_t* entries,
                                std::size_t lane) {
    return static_cast<Waiting>(entries[lane]) << 32 | node.children[lane];
}

HWY_INLINE BoxChild child_of(Waiting waiting) {
    return static_cast<BoxChild>(waiting);
}

HWY_INLINE std::uint32_t bits_of_float(float value) {
    std::uint32_t bits;
    hwy::CopyBytes<sizeof(bits)>(&value, &bits);
    return bits;
}

/// Puts the last of the waiting before it where it belongs: the farthest first.
HWY_INLINE void sink_last(Waiting* bottom, Waiting* last) {
    const Waiting moved = *last;
    while (last > bottom && last[-1] < moved) {
        *last = last[-1];
        --last;
    }
    *last = moved;
}

/// Puts all but the nearest of the children that were met to those that wait, and returns it.
HWY_INLINE BoxChild choose_child(const BoxNode& node, std::uint32_t bits,
                                 const std::uint32_t* HWY_RESTRICT entries,
                                 Waiting* HWY_RESTRICT& top) {
    const Waiting one = make_waiting(node, entries, hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
    bits &= bits - 1;
    const Waiting two = make_waiting(node, entries, hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
    bits &= bits - 1;
    if (bits == 0) {
        const bool is_one_nearer = one < two;
        *top++ = is_one_nearer ? two : one;
        return child_of(is_one_nearer ? one : two);
    }
    Waiting* const bottom = top;
    *top++ = one < two ? two : one;
    *top++ = one < two ? one : two;
    do {
        *top = make_waiting(node, entries, hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
        bits &= bits - 1;
        sink_last(bottom, top);
        ++top;
    } while (bits != 0);
    return child_of(*--top);
}

/// Walks what is below a child with a ray that is prepared, entering the nearest first. Returns
/// true if a call ended the walk.
HWY_NOINLINE bool walk_nearest_below(const BoxTreeView& tree, BoxChild root, Walk& walk) {
    const Floats d;
    const SlabPlanes planes = make_slab_planes(*walk.ray, tree.nodes);
    FloatVec reach = hn::Set(d, walk.reach);
    Waiting stack[kMaxWaiting];
    Waiting* top = stack;
    BoxChild current = root;
    std::uint64_t node_tests = 0;
    bool is_ended = false;
    for (;;) {
        const SlabRay slab_ray = make_slab_ray(walk);
        bool is_empty = false;
        while (current < kFirstLeaf) {
            ++node_tests;
            const BoxNode& node = node_at(tree, current);
            alignas(32) std::uint32_t entries[kBoxWidth];
            const std::uint32_t bits = meet_boxes(current, planes, slab_ray, reach, entries);
            is_empty = bits == 0;
            if (is_empty) break;
            if ((bits & (bits - 1)) == 0) {
                current = node.children[hwy::Num0BitsBelowLS1Bit_Nonzero32(bits)];
            } else {
                current = choose_child(node, bits, entries, top);
            }
        }
        if (!is_empty) {
            const float reach_before = walk.reach;
            const float bound = meet_leaf(tree, current, walk);
            if (bound == kEnded) {
                is_ended = true;
                break;
            }
            // The nodes to come need not wait for the exact one.
            reach = hn::Set(d, bound < reach_before ? bound : reach_before);
        }
        const Waiting beyond = (static_cast<Waiting>(bits_of_float(walk.reach)) + 1) << 32;
        do {
            if (top == stack) goto end;
            --top;
        } while (*top >= beyond);
        current = child_of(*top);
    }
end:
    walk.node_tests += node_tests;
    return is_ended;
}

/// Returns which children of a node the ray is in, a bit each, and writes these to `met` in the
/// order of the lanes, without a branch.
HWY_INLINE std::uint32_t list_met(BoxChild node, const BoxChild* children, const SlabPlanes& planes,
                                  const SlabRay& ray, FloatVec reach, BoxChild* HWY_RESTRICT met) {
    const Words w;
    std::uint32_t bits = 0;
    for (std::uint32_t i = 0; i < kBoxWidth; i += kStep) {
        const FloatMask is_met = meet_step(node, i, planes, ray, reach).is_met;
        const auto listed = hn::Compress(hn::Load(w, children + i), hn::RebindMask(w, is_met));
        hn::StoreU(listed, w, met + hwy::PopCount(bits));
        bits |= bits_of(Floats(), is_met) << i;
    }
    return bits;
}

/// Likewise, in no particular order.
HWY_NOINLINE bool walk_any_below(const BoxTreeView& tree, BoxChild root, Walk& walk) {
    const SlabPlanes planes = make_slab_planes(*walk.ray, tree.nodes);
    const FloatVec reach = hn::Set(Floats(), walk.reach);
    BoxChild stack[kMaxWaiting + kBoxWidth];
    BoxChild* top = stack;
    BoxChild current = root;
    std::uint64_t node_tests = 0;
    bool is_ended = false;
    for (;;) {
        const SlabRay slab_ray = make_slab_ray(walk);
        bool is_empty = false;
        while (current < kFirstLeaf) {
            ++node_tests;
            const BoxNode& node = node_at(tree, current);
            const std::uint32_t bits =
                list_met(current, node.children, planes, slab_ray, reach, top);
            is_empty = bits == 0;
            if (is_empty) break;
            // The last of them is next: known sooner from its lane than from the list.
            current = node.children[31 ^ hwy::Num0BitsAboveMS1Bit_Nonzero32(bits)];
            top += hwy::PopCount(bits) - 1;
        }
        if (!is_empty && meet_leaf(tree, current, walk) == kEnded) {
            is_ended = true;
            break;
        }
        if (top == stack) break;
        current = *--top;
    }
    walk.node_tests += node_tests;
    return is_ended;
}

}  // namespace lray::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
