// Warns of cameras and lights that are shut in (W1203, W1204).
#pragma once

#include "base/diagnostics.h"
#include "scene/scene.h"
#include "scene/world.h"

namespace lray::scene {

/// Warns of perspective and panoramic cameras inside closed opaque primitives, and of point and
/// spot lights that cast shadows inside those that cast one. Not meant are rooms and skies: a
/// primitive with other things in it, or with a camera and a light; for cameras also what is
/// textured or shines. In a large world only the first few cameras and lights are looked at.
void warn_enclosed(const Scene& scene, const World& world, Diagnostics& diagnostics);

}  // namespace lray::scene
