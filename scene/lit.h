// Whether a scene has light: without any it is painted flat, one colour for each object.
#pragma once

#include "base/diagnostics.h"
#include "scene/scene.h"
#include "scene/world.h"

namespace lray::scene {

/// True if a light or an environment is placed, or if light is followed along paths and something
/// may give it off.
bool is_lit(const Scene& scene, const World& world);

/// Warns of a scene without light (W1502); one without a shape is told otherwise.
void warn_unlit(const Scene& scene, const World& world, Diagnostics& diagnostics);

}  // namespace lray::scene
