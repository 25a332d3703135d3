// The fast hierarchy behind the interface of all.
#pragma once

#include <memory>

#include "bvh/accel.h"
#include "bvh/simd/walk.h"

namespace lray::bvh {

/// The walks that are fastest on this processor.
Walks fastest_walks();

/// Builds the trees of a world and its prototypes, walked as `walks` do.
std::unique_ptr<Accel> make_box_accel(const scene::World& world, BuildQuality quality,
                                      const Walks& walks);

}  // namespace lray::bvh
