// Highway includes this file once for each processor that it knows.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bvh/simd/walk.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "bvh/simd/tile_walk-inl.h"
#include "bvh/simd/walk.h"

HWY_BEFORE_NAMESPACE();
namespace lray::bvh::HWY_NAMESPACE {

/// A child that waits, and where the ray enters it.
struct Waiting {
    BoxChild child;
    float entry;
};

HWY_INLINE void sort_last(Waiting* HWY_RESTRICT begin, Waiting* HWY_RESTRICT end) {
    for (Waiting* i = begin + 1; i < end; ++i) {
        const Waiting moved = *i;
        Waiting* k = i;
        while (k > begin && k[-1].entry < moved.entry) {
            *k = k[-1];
            --k;
        }
        *k = moved;
    }
}

template <bool is_ordered>
HWY_INLINE bool walk_tree(const BoxTreeView& tree, Walk& walk) {
    const Floats d;
    if (tree.is_empty) return false;
    const SlabRay slab_ray = make_slab_ray(walk);
    const ShearRay shear_ray = make_shear_ray(walk.ray);
    FloatVec reach = hn::Set(d, walk.reach);
    Waiting stack[kMaxWaiting];
    Waiting* top = stack;
    BoxChild current = tree.root;
    std::uint64_t node_tests = 0;
    bool is_ended = false;
    for (;;) {
        while (current < kMaxBoxNodes) {
            ++node_tests;
            const BoxNode& node = tree.nodes[current];
            alignas(32) float entries[kBoxWidth];
            std::uint32_t bits = meet_boxes(node, slab_ray, reach, entries);
            if (bits == 0) goto pop;
            const auto first = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
            bits &= bits - 1;
            current = node.children[first];
            if (bits == 0) continue;
            const auto second = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
            bits &= bits - 1;
            const Waiting one = {current, entries[first]};
            const Waiting two = {node.children[second], entries[second]};
            if (bits == 0) {
                const bool is_one_nearer = one.entry <= two.entry;
                *top++ = is_one_nearer ? two : one;
                current = is_one_nearer ? one.child : two.child;
                continue;
            }
            Waiting* const bottom = top;
            *top++ = one;
            *top++ = two;
            do {
                const auto next = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
                bits &= bits - 1;
                *top++ = {node.children[next], entries[next]};
            } while (bits != 0);
            if (is_ordered) sort_last(bottom, top);
            current = (--top)->child;
        }
        if (meet_leaf(tree, current, shear_ray, walk)) {
            is_ended = true;
            break;
        }
        if (is_ordered) reach = hn::Set(d, walk.reach);
    pop:
        for (;;) {
            if (top == stack) goto end;
            --top;
            if (!is_ordered || top->entry <= walk.reach) break;
        }
        current = top->child;
    }
end:
    walk.node_tests += node_tests;
    return is_ended;
}

bool walk_nearest(const BoxTreeView& tree, Walk& walk) {
    return walk_tree<true>(tree, walk);
}

bool walk_any(const BoxTreeView& tree, Walk& walk) {
    return walk_tree<false>(tree, walk);
}

void walk_nearest_tile(const BoxTreeView& tree, Tile& tile) {
    walk_tile<true>(tree, tile);
}

void walk_any_tile(const BoxTreeView& tree, Tile& tile) {
    walk_tile<false>(tree, tile);
}

Walks walks() {
    return {walk_nearest, walk_any, walk_nearest_tile, walk_any_tile, hwy::TargetName(HWY_TARGET)};
}

}  // namespace lray::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace lray::bvh {

HWY_EXPORT(walks);

std::int64_t simd_targets() {
    return hwy::SupportedTargets() & HWY_TARGETS;
}

Walks simd_walks() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    return HWY_DYNAMIC_DISPATCH(walks)();
}

}  // namespace lray::bvh

#endif
