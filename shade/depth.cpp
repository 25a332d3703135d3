#include "shade/depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lray::shade {

double depth_unit(DVec3 position, DVec3 look_at) {
    const DVec3 way = look_at - position;
    // Kept finite and above 0, so that t / unit is a number wherever the camera is.
    return std::clamp(std::sqrt(dot(way, way)), std::numeric_limits<double>::min(),
                      std::numeric_limits<double>::max());
}

Color depth(const bvh::Hit& hit, double unit) {
    if (hit.is_none()) return Color{0.0f};
    const double far = static_cast<double>(hit.t) / unit;
    return Color{static_cast<float>(1.0 / (1.0 + far * far * far))};
}

}  // namespace lray::shade
