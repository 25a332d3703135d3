// Warns of cameras that have nothing in view (W1205).
#pragma once

#include <optional>

#include "base/diagnostics.h"
#include "scene/scene.h"
#include "scene/world.h"

namespace lray::scene {

/// Warns of the scene's first camera if the bounds of all that is visible are outside of its view.
/// Silent where something else may show: an environment, a blurred lens, or another frame of an
/// animation. `resolution` takes the place of the camera's own.
void warn_view(const Scene& scene, const World& world, std::optional<Resolution> resolution,
               Diagnostics& diagnostics);

}  // namespace lray::scene
