// Whether it matters which of two surfaces in one place is seen.
#pragma once

#include "scene/world.h"

namespace lray::scene {

/// True if both are visible and opaque, and of materials that look different.
bool shows_a_difference(const World& world, PrimitiveId a, PrimitiveId b);

}  // namespace lray::scene
