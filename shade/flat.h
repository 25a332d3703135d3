// Flat painting: one colour per object, no light.
#pragma once

#include "base/vec.h"
#include "bvh/hit.h"
#include "scene/world.h"

namespace lray::shade {

/// Returns the diffuse colour (of a texture its average) of the object that was hit, or the
/// background if none was.
Color flat(const scene::World& world, const bvh::Hit& hit, Color background);

}  // namespace lray::shade
