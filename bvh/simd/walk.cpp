// Highway includes this file once for each processor that it knows.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bvh/simd/walk.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "bvh/simd/tile_walk-inl.h"
#include "bvh/simd/walk.h"

HWY_BEFORE_NAMESPACE();
namespace lray::bvh::HWY_NAMESPACE {

bool walk_nearest(const BoxTreeView& tree, Walk& walk) {
    if (tree.is_empty) return false;
    prepare_ray(*walk.ray);
    return walk_nearest_below(tree, tree.root, walk);
}

bool walk_any(const BoxTreeView& tree, Walk& walk) {
    if (tree.is_empty) return false;
    prepare_ray(*walk.ray);
    return walk_any_below(tree, tree.root, walk);
}

bool walk_nearest_tile(const BoxTreeView& tree, Tile& tile) {
    return walk_tile<true>(tree, tile);
}

bool walk_any_tile(const BoxTreeView& tree, Tile& tile) {
    return walk_tile<false>(tree, tile);
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
