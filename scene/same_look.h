// Whether it matters which of two surfaces in one place is seen.
#pragma once

#include "scene/world.h"

namespace lray::scene {

/// True if both are visible and opaque, and of materials that look different. Of two instances of
/// one prototype: if something in it has their materials.
bool shows_a_difference(const World& world, PrimitiveId a, PrimitiveId b);

}  // namespace lray::scene
