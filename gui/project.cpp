#include "gui/project.h"

#include <algorithm>
#include <cmath>

namespace lray::gui {

namespace {

/// How near to the camera's plane a segment is shown, over its depth. At this the ends of what
/// remains are outside of any picture, or close to its middle.
constexpr double kNearestDepth = 0x1p-20;

/// The part of a segment that is inside of [low, high] each way. Source: Liang, Barsky 1984, "A New
/// Concept and Method for Line Clipping".
std::optional<PixelSegment> clipped(const PixelSegment& segment, DVec2 low, DVec2 high) {
    const DVec2 way = segment.to - segment.from;
    double begin = 0.0;
    double end = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
        const double at = segment.from[axis];
        if (way[axis] == 0.0) {
            if (!(at >= low[axis] && at <= high[axis])) return {};
            continue;
        }
        const double a = (low[axis] - at) / way[axis];
        const double b = (high[axis] - at) / way[axis];
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
    if (!(begin <= end)) return {};
    // Rounding may leave the part outside by a hair.
    const auto at = [&](double t) { return glm::clamp(segment.from + t * way, low, high); };
    return PixelSegment{begin > 0.0 ? at(begin) : segment.from, end < 1.0 ? at(end) : segment.to};
}

bool is_finite(DVec2 v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}

}  // namespace

Projector::Projector(const scene::Camera& camera, scene::Resolution resolution)
    : frame_(render::camera_frame(camera.position, camera.look_at, camera.up)),
      position_(camera.position),
      center_pixel_(0.5 * resolution.width, 0.5 * resolution.height),
      projection_(camera.projection) {
    const double height =
        projection_ == scene::Projection::orthographic
            ? camera.height
            : 2.0 * static_cast<double>(std::tan(static_cast<float>(camera.fov) / 2.0f));
    pixels_per_unit_ = resolution.height / height;
}

DVec3 Projector::camera_from_world(DVec3 point) const {
    const DVec3 offset = point - position_;
    return {dot(offset, frame_.right), dot(offset, frame_.up), dot(offset, frame_.forward)};
}

DVec2 Projector::pixel_of(DVec3 point_camera) const {
    const double scale = projection_ == scene::Projection::perspective
                             ? pixels_per_unit_ / point_camera.z
                             : pixels_per_unit_;
    return {center_pixel_.x + point_camera.x * scale, center_pixel_.y - point_camera.y * scale};
}

std::optional<DVec2> Projector::point(DVec3 point) const {
    if (projection_ == scene::Projection::panorama) return {};
    const DVec3 point_camera = camera_from_world(point);
    if (!(point_camera.z > 0.0)) return {};
    const DVec2 pixel = pixel_of(point_camera);
    if (!is_finite(pixel)) return {};
    return pixel;
}

std::optional<PixelSegment> Projector::segment(DVec3 from, DVec3 to) const {
    if (projection_ == scene::Projection::panorama) return {};
    DVec3 a = camera_from_world(from);
    DVec3 b = camera_from_world(to);
    const double near = kNearestDepth * std::max(a.z, b.z);
    if (!(near > 0.0)) return {};  // all behind, or not a number
    const auto at_near = [&](DVec3 behind, DVec3 before) {
        const double t = (near - behind.z) / (before.z - behind.z);
        DVec3 point = behind + t * (before - behind);
        point.z = near;
        return point;
    };
    if (a.z < near) a = at_near(a, b);
    if (b.z < near) b = at_near(b, a);
    const PixelSegment whole{pixel_of(a), pixel_of(b)};
    if (!is_finite(whole.from) || !is_finite(whole.to)) return {};
    return clipped(whole, -2.0 * center_pixel_, 4.0 * center_pixel_);
}

}  // namespace lray::gui
