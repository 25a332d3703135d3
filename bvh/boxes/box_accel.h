// The fast hierarchy behind the interface of all.
#pragma once

#include <memory>

#include "bvh/accel.h"
#include "bvh/simd/walk.h"

namespace lray::bvh {

/// Builds the trees of a world and its prototypes, walked as `walks` do.
std::unique_ptr<Accel> make_box_accel(const scene::World& world, BuildQuality quality,
                                      const Walks& walks);

}  // namespace lray::bvh
