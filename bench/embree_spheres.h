// Spheres as a geometry that Embree asks its user to intersect.
#pragma once

#include <embree3/rtcore.h>

#include <span>

#include "scene/world.h"

namespace lray::bench {

/// Adds spheres, which must outlive the scene, as Embree's tutorial `user_geometry` does: in float,
/// with a centre and a radius looked up for each test.
void add_spheres(RTCDevice device, RTCScene scene, std::span<const scene::Sphere> spheres);

}  // namespace lray::bench
