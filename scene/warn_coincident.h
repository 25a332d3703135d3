// Warns of surfaces in the same place (W1206).
#pragma once

#include "base/diagnostics.h"
#include "scene/scene.h"
#include "scene/world.h"

namespace lray::scene {

/// Warns of visible, opaque primitives of different looks that are equal in the world, to the bit,
/// or have faces in one plane (coplanar_faces.h): of the first few pairs, with the number of the
/// others. Of each kind only the first primitives are compared.
void warn_coincident(const Scene& scene, const World& world, Diagnostics& diagnostics);

}  // namespace lray::scene
