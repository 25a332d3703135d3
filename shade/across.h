// A frame around a direction.
#pragma once

#include <cmath>

#include "base/vec.h"

namespace lray::shade {

/// Two unit vectors at right angles to a unit one and to each other.
struct Across {
    DVec3 x{};
    DVec3 y{};
};

/// Source: Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
inline Across across(DVec3 z) {
    const double sign = std::copysign(1.0, z.z);
    const double a = -1.0 / (sign + z.z);
    const double b = z.x * z.y * a;
    return {{1.0 + sign * z.x * z.x * a, sign * b, -sign * z.x}, {b, sign + z.y * z.y * a, -z.y}};
}

}  // namespace lray::shade
