// A camera for scenes that have none.
#pragma once

#include "base/bounds.h"
#include "scene/camera.h"

namespace lray::render {

/// Returns a perspective camera of 45 degrees that sees all of `bounds`, from the front, a little
/// to the right and from above. Where there is nothing to see it looks at the cube [-1, 1]^3.
scene::Camera fit_camera(const Bounds& bounds, scene::Resolution resolution);

}  // namespace lray::render
