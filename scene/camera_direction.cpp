#include "scene/camera_direction.h"

#include <algorithm>
#include <cmath>

#include "base/numerics.h"

namespace lray::scene {

bool is_along_up(DVec3 direction, DVec3 up) {
    const auto scaled = [](DVec3 v) {
        return v / std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    };
    // Parallel as far as doubles can tell: the cross product is its own rounding error.
    const double sine_bound = 2.0 * gamma<double>(3);
    const DVec3 f = scaled(direction);
    const DVec3 u = scaled(up);
    return glm::length(cross(f, u)) <= sine_bound * glm::length(f) * glm::length(u);
}

}  // namespace lray::scene
