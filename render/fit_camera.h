// Cameras that see all of a box: one for scenes that have none, or one that is moved.
#pragma once

#include "base/bounds.h"
#include "scene/camera.h"

namespace lray::render {

/// Returns a perspective camera of 45 degrees that sees all of `bounds`, from the front, a little
/// to the right and from above. Where there is nothing to see it looks at the cube [-1, 1]^3.
scene::Camera fit_camera(const Bounds& bounds, scene::Resolution resolution);

/// Returns the camera with another place: it looks the same way, with the same projection and the
/// same angle of view, at the middle of `bounds`, and sees all of them. A perspective one stands
/// where a rim is left around them; of an orthographic one the height of the view leaves the same
/// rim, and nothing of them is behind it; a panorama is taken from their middle. Sharp is what it
/// looks at. Empty bounds stand for the cube [-1, 1]^3.
scene::Camera framed(const scene::Camera& camera, const Bounds& bounds,
                     scene::Resolution resolution);

}  // namespace lray::render
