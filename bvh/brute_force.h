// The accelerator that is none: every ray against every primitive. The measure of all others.
#pragma once

#include <memory>

#include "bvh/accel.h"

namespace lray::bvh {

std::unique_ptr<Accel> make_brute_force(const scene::World& world);

}  // namespace lray::bvh
