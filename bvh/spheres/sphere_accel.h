// Traces through trees of bounding spheres, one for each geometry of the world.
#pragma once

#include <memory>

#include "bvh/accel.h"

namespace lray::bvh {

std::unique_ptr<Accel> make_sphere_accel(const scene::World& world);

}  // namespace lray::bvh
