// Warns of nodes that a transform mirrors (W1303).
#pragma once

#include "base/diagnostics.h"
#include "scene/scene.h"

namespace lray::scene {

/// Warns of each node under the root whose own transform reverses orientation.
void warn_mirrored(const Scene& scene, Diagnostics& diagnostics);

}  // namespace lray::scene
