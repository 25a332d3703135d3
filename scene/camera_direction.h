// Whether a view knows which way is up.
#pragma once

#include "base/vec.h"

namespace lray::scene {

/// True if a view in a direction is along its `up`, as far as doubles can tell.
/// Shape: neither is zero.
bool is_along_up(DVec3 direction, DVec3 up);

}  // namespace lray::scene
