// Turning an object towards something.
#pragma once

#include <optional>

#include "base/transform.h"

namespace lray::parser {

/// Returns the rotation that turns -Z to the direction, and Y up as far as it can; straight up or
/// down, the object's X axis stays where it is. Empty for no direction: 0 or not finite.
std::optional<Transform> facing(DVec3 direction);

}  // namespace lray::parser
