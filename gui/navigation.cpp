#include "gui/navigation.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"
#include "render/camera_rays.h"

namespace lray::gui {

namespace {

using scene::Camera;
using scene::Projection;

/// Rays begin at positions in float: a camera closer to what it looks at than a float can tell
/// apart sees nothing more, and its direction would wear off as it moves.
constexpr double kLeastRelativeDistance = 0x1p-24;

/// One move changes the height of an orthographic view by this much at most, as an exponent.
constexpr double kGreatestZoom = 1.0;

double largest_component(DVec3 v) {
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

/// Nothing overflows or vanishes on the way.
double length(DVec3 v) {
    const double largest = largest_component(v);
    if (!(largest > 0.0)) return 0.0;
    const DVec3 scaled = v / largest;
    return largest * std::sqrt(dot(scaled, scaled));
}

render::CameraFrame frame_of(const Camera& camera) {
    return render::camera_frame(camera.position, camera.look_at, camera.up);
}

double distance_of(const Camera& camera) {
    return length(camera.look_at - camera.position);
}

/// A limit that is left behind already is no reason to jump: it holds for moves that go on.
double limited(double value, double least, double greatest, double before) {
    return std::clamp(value, std::min(least, before), std::max(greatest, before));
}

double least_distance(DVec3 at) {
    return std::max(kLeastDistance, kLeastRelativeDistance * largest_component(at));
}

/// The same camera somewhere else; `forward` is that of the camera, in case it is too close to
/// what it looks at for the numbers there.
Camera shifted(const Camera& camera, DVec3 way, DVec3 forward) {
    Camera result = camera;
    result.position += way;
    result.look_at += way;
    if (!(largest_component(result.position) <= kGreatestDistance) &&
        !(largest_component(result.position) <= largest_component(camera.position))) {
        return camera;
    }
    const double least = least_distance(result.position);
    if (distance_of(result) < least) result.look_at = result.position + least * forward;
    return result;
}

/// The direction of a view after a turn.
DVec3 turned_forward(const Camera& camera, double yaw, double pitch) {
    const render::CameraFrame frame = frame_of(camera);
    // The frame that the camera has when it looks horizontally: across its right side is `up`.
    const double up_length = length(camera.up);
    const DVec3 up = up_length > 0.0 ? camera.up / up_length : frame.up;
    const DVec3 ahead = cross(up, frame.right);
    const double before = std::atan2(dot(frame.forward, up), dot(frame.forward, ahead));
    const double after = std::clamp(before + pitch, -kSteepestPitch, kSteepestPitch);
    const DVec3 heading = std::cos(yaw) * ahead - std::sin(yaw) * frame.right;
    const DVec3 forward = std::cos(after) * heading + std::sin(after) * up;
    return forward / length(forward);
}

/// World units that a pixel is wide at the distance of what the camera looks at.
double pixel_size(const Camera& camera, scene::Resolution resolution) {
    const double rows = std::max(resolution.height, 1u);
    switch (camera.projection) {
        case Projection::perspective:
            // The tangent of CameraRays, for the same plane.
            return 2.0 * static_cast<double>(std::tan(static_cast<float>(camera.fov) / 2.0f)) *
                   distance_of(camera) / rows;
        case Projection::orthographic:
            return camera.height / rows;
        case Projection::panorama:
            return std::numbers::pi * distance_of(camera) / rows;
    }
    LRAY_ASSERT(false);
}

}  // namespace

Camera moved(const Camera& camera, DVec3 step) {
    const render::CameraFrame frame = frame_of(camera);
    const bool is_zoom = camera.projection == Projection::orthographic;
    const DVec3 aside = step.x * frame.right + step.y * frame.up;
    Camera result =
        shifted(camera, is_zoom ? aside : aside + step.z * frame.forward, frame.forward);
    if (is_zoom && step.z != 0.0) {
        const double exponent = std::clamp(step.z / camera.height, -kGreatestZoom, kGreatestZoom);
        result.height = limited(camera.height * std::exp(-exponent), kLeastDistance,
                                kGreatestDistance, camera.height);
    }
    return result;
}

Camera turned(const Camera& camera, double yaw, double pitch) {
    if (yaw == 0.0 && pitch == 0.0) return camera;
    const double distance = std::max(distance_of(camera), least_distance(camera.position));
    Camera result = camera;
    result.look_at = camera.position + distance * turned_forward(camera, yaw, pitch);
    return result;
}

Camera orbited(const Camera& camera, double yaw, double pitch) {
    if (yaw == 0.0 && pitch == 0.0) return camera;
    const double distance = std::max(distance_of(camera), least_distance(camera.look_at));
    Camera result = camera;
    result.position = camera.look_at - distance * turned_forward(camera, yaw, pitch);
    return result;
}

Camera panned(const Camera& camera, DVec2 pixels, scene::Resolution resolution) {
    const render::CameraFrame frame = frame_of(camera);
    const double size = pixel_size(camera, resolution);
    const DVec3 way = (-pixels.x * size) * frame.right + (pixels.y * size) * frame.up;
    return shifted(camera, way, frame.forward);
}

Camera dollied(const Camera& camera, double factor) {
    LRAY_ASSERT(factor > 0.0);
    if (factor == 1.0) return camera;
    const double before = distance_of(camera);
    const double after =
        limited(before * factor, least_distance(camera.look_at), kGreatestDistance, before);
    Camera result = camera;
    result.position = camera.look_at - after * frame_of(camera).forward;
    if (camera.projection == Projection::orthographic) {
        result.height =
            limited(camera.height * factor, kLeastDistance, kGreatestDistance, camera.height);
    }
    return result;
}

double base_speed(const Bounds& bounds, const Camera& camera) {
    if (camera.projection == Projection::orthographic) return 0.5 * camera.height;
    if (!bounds.is_empty()) {
        const double diagonal = length(DVec3(bounds.max) - DVec3(bounds.min));
        if (diagonal > 0.0 && std::isfinite(diagonal)) return 0.25 * diagonal;
    }
    return distance_of(camera);
}

}  // namespace lray::gui
