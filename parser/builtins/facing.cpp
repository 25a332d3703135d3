#include "parser/builtins/facing.h"

#include <cmath>

#include "base/angle.h"

namespace lray::parser {

std::optional<Transform> facing(DVec3 direction) {
    const bool is_finite =
        std::isfinite(direction.x) && std::isfinite(direction.y) && std::isfinite(direction.z);
    if (!is_finite || direction == DVec3{0.0}) return std::nullopt;
    // Made of a pitch and a heading, so that it counts as the rotation it is.
    const bool is_upright = direction.x == 0.0 && direction.z == 0.0;
    const double heading = is_upright ? 0.0 : degrees(std::atan2(-direction.x, -direction.z));
    const double pitch = degrees(std::atan2(direction.y, std::hypot(direction.x, direction.z)));
    return Transform::rotation_x(pitch).then(Transform::rotation_y(heading));
}

}  // namespace lray::parser
