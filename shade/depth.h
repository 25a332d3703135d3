// How far away surfaces are, as a grey.
#pragma once

#include "base/vec.h"
#include "bvh/hit.h"

namespace lray::shade {

/// Returns the distance that is shown as a half: that of the point a camera looks at. It depends on
/// the camera alone, so that crops and frames have the same scale.
double depth_unit(DVec3 position, DVec3 look_at);

/// Returns 1 / (1 + (t / unit)^3): white at the eye, a half at the unit and steepest there, darker
/// the farther; black if nothing was hit.
Color depth(const bvh::Hit& hit, double unit);

}  // namespace lray::shade
