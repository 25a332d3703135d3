#include "render/fit_camera.h"

#include <algorithm>
#include <cmath>

#include "render/camera_rays.h"

namespace lray::render {

namespace {

constexpr DVec3 kTowardsCamera{0.4, 0.5, 1.0};
constexpr double kMargin = 1.1;  // how much farther than needed: a rim around the picture

}  // namespace

scene::Camera fit_camera(const Bounds& bounds, scene::Resolution resolution) {
    const bool is_empty = bounds.is_empty();
    const DVec3 low = is_empty ? DVec3(-1.0) : DVec3(bounds.min);
    const DVec3 high = is_empty ? DVec3(1.0) : DVec3(bounds.max);
    const DVec3 half = 0.5 * (high - low);

    scene::Camera camera;
    camera.look_at = low + half;
    const CameraFrame frame = camera_frame(kTowardsCamera, DVec3(0.0), camera.up);
    const double tan_up = static_cast<double>(std::tan(static_cast<float>(camera.fov) / 2.0f));
    const double tan_right = tan_up * resolution.width / resolution.height;

    // A corner at (x, y) in the picture's directions and `depth` beyond the centre is seen from a
    // distance d if |x| <= tan_right (d + depth) and |y| <= tan_up (d + depth).
    double distance = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const DVec3 offset{(corner & 1) != 0 ? half.x : -half.x,
                           (corner & 2) != 0 ? half.y : -half.y,
                           (corner & 4) != 0 ? half.z : -half.z};
        const double needed = std::max(std::fabs(dot(offset, frame.right)) / tan_right,
                                       std::fabs(dot(offset, frame.up)) / tan_up);
        distance = std::max(distance, needed - dot(offset, frame.forward));
    }
    if (!(distance > 0.0)) distance = 1.0;  // a single point
    camera.position = camera.look_at - kMargin * distance * frame.forward;
    return camera;
}

}  // namespace lray::render
