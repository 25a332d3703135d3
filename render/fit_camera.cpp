#include "render/fit_camera.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/camera_rays.h"

namespace lray::render {

namespace {

constexpr DVec3 kTowardsCamera{0.4, 0.5, 1.0};
constexpr double kMargin = 1.1;  // how much farther than needed: a rim around the picture

/// A corner of a box, from its middle, in the directions of a camera.
struct Corner {
    double right = 0.0;
    double up = 0.0;
    double depth = 0.0;
};

std::array<Corner, 8> corners_of(DVec3 half, const CameraFrame& frame) {
    std::array<Corner, 8> corners;
    for (unsigned i = 0; i < corners.size(); ++i) {
        const DVec3 offset{(i & 1) != 0 ? half.x : -half.x, (i & 2) != 0 ? half.y : -half.y,
                           (i & 4) != 0 ? half.z : -half.z};
        corners[i] = {std::fabs(dot(offset, frame.right)), std::fabs(dot(offset, frame.up)),
                      dot(offset, frame.forward)};
    }
    return corners;
}

/// A corner at (x, y) in the picture's directions and `depth` beyond the middle is seen from a
/// distance d if |x| <= tan_right (d + depth) and |y| <= tan_up (d + depth).
double perspective_distance(const std::array<Corner, 8>& corners, double fov,
                            scene::Resolution resolution) {
    const double tan_up = static_cast<double>(std::tan(static_cast<float>(fov) / 2.0f));
    const double tan_right = tan_up * resolution.width / resolution.height;
    double distance = 0.0;
    for (const Corner& corner : corners) {
        const double needed = std::max(corner.right / tan_right, corner.up / tan_up);
        distance = std::max(distance, needed - corner.depth);
    }
    return distance;
}

/// The height of a view without a vanishing point.
double orthographic_height(const std::array<Corner, 8>& corners, scene::Resolution resolution) {
    double height = 0.0;
    for (const Corner& corner : corners) {
        const double of_width = corner.right * resolution.height / resolution.width;
        height = std::max(height, 2.0 * std::max(corner.up, of_width));
    }
    return height;
}

double depth_reach(const std::array<Corner, 8>& corners) {
    double reach = 0.0;
    for (const Corner& corner : corners) reach = std::max(reach, corner.depth);
    return reach;
}

/// What a single point is seen from: far enough to be another place in double.
double least_distance(DVec3 point) {
    const double largest = std::max({std::fabs(point.x), std::fabs(point.y), std::fabs(point.z)});
    return std::max(1.0, 0x1p-20 * largest);
}

}  // namespace

scene::Camera framed(const scene::Camera& camera, const Bounds& bounds,
                     scene::Resolution resolution) {
    const bool is_empty = bounds.is_empty();
    const DVec3 low = is_empty ? DVec3(-1.0) : DVec3(bounds.min);
    const DVec3 high = is_empty ? DVec3(1.0) : DVec3(bounds.max);
    const DVec3 half = 0.5 * (high - low);
    const DVec3 middle = low + half;
    const CameraFrame frame = camera_frame(camera.position, camera.look_at, camera.up);
    const std::array<Corner, 8> corners = corners_of(half, frame);

    double distance = 0.0;
    scene::Camera result = camera;
    result.look_at = middle;
    result.focus.reset();
    switch (camera.projection) {
        case scene::Projection::perspective:
            distance = perspective_distance(corners, camera.fov, resolution);
            break;
        case scene::Projection::orthographic:
            distance = depth_reach(corners);
            result.height = kMargin * orthographic_height(corners, resolution);
            if (!(result.height > 0.0)) result.height = 2.0 * least_distance(middle);
            break;
        case scene::Projection::panorama:
            distance = depth_reach(corners);
            break;
    }
    if (!(distance > 0.0)) distance = least_distance(middle);
    const DVec3 way = kMargin * distance * frame.forward;
    if (camera.projection == scene::Projection::panorama) {
        result.position = middle;
        result.look_at = middle + way;
    } else {
        result.position = middle - way;
    }
    return result;
}

scene::Camera fit_camera(const Bounds& bounds, scene::Resolution resolution) {
    scene::Camera camera;
    camera.position = kTowardsCamera;
    return framed(camera, bounds, resolution);
}

}  // namespace lray::render
