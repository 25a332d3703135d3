// How a camera moves through the world: pure functions from one camera to the next. Where it may
// end up is bounded, so that no sequence of moves makes a view without a direction.
#pragma once

#include <numbers>

#include "base/bounds.h"
#include "base/vec.h"
#include "scene/camera.h"

namespace lray::gui {

/// The steepest view up or down: 89 degrees. Straight along `up`, the picture would spin.
inline constexpr double kSteepestPitch = 89.0 / 180.0 * std::numbers::pi;

/// Limits of the distance from a camera to what it looks at, and of a view's height: their squares
/// fit into a float.
inline constexpr double kLeastDistance = 1e-12;
inline constexpr double kGreatestDistance = 1e12;

/// Returns the camera after a step of (right, up, forward) in its own directions, world units.
/// What it looks at moves with it. Forward, an orthographic view narrows instead, as nothing would
/// be seen to change otherwise: a step of its height leaves 1/e of it.
scene::Camera moved(const scene::Camera& camera, DVec3 step);

/// Returns the camera turned on the spot, in radians: to the left around `up`, and upwards.
/// A pitch beyond kSteepestPitch ends there.
scene::Camera turned(const scene::Camera& camera, double yaw, double pitch);

/// Returns the camera after the same turn of its view around what it looks at: the camera itself
/// goes to the right of that, and below it.
scene::Camera orbited(const scene::Camera& camera, double yaw, double pitch);

/// Returns the camera moved aside so that what lies at the distance of look_at, in the middle of
/// the picture, follows a mouse that goes so many pixels to the right and down.
/// Space: pixels of a picture of that resolution. A perspective or orthographic view follows
/// exactly, and so in all of the plane through look_at.
scene::Camera panned(const scene::Camera& camera, DVec2 pixels, scene::Resolution resolution);

/// Returns the camera at `factor` times its distance to what it looks at; the height of an
/// orthographic view grows likewise. Shape: factor > 0, asserted.
scene::Camera dollied(const scene::Camera& camera, double factor);

/// Returns how many world units a second a camera flies: a quarter of the diagonal of the scene, or
/// the distance to what it looks at where the scene has no finite size. Of an orthographic camera
/// half of what it sees: to be asked again for each move.
double base_speed(const Bounds& bounds, const scene::Camera& camera);

}  // namespace lray::gui
