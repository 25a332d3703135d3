#include "render/camera_rays.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/assert.h"

namespace lray::render {

namespace {

/// Dividing by the largest component first keeps the squares from overflowing or vanishing.
DVec3 unit(DVec3 v) {
    const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    const DVec3 scaled = v / largest;
    return scaled / std::sqrt(dot(scaled, scaled));
}

/// The axis along which v is shortest.
DVec3 farthest_axis(DVec3 v) {
    const DVec3 size{std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)};
    if (size.y <= size.x && size.y <= size.z) return {0.0, 1.0, 0.0};
    if (size.z <= size.x) return {0.0, 0.0, 1.0};
    return {1.0, 0.0, 0.0};
}

/// The picture's height at distance 1, or of the view in world units.
double view_height(const scene::Camera& camera) {
    switch (camera.projection) {
        case scene::Projection::perspective:
            return 2.0 * static_cast<double>(std::tan(static_cast<float>(camera.fov) / 2.0f));
        case scene::Projection::orthographic:
            return camera.height;
        case scene::Projection::panorama:
            return std::numbers::pi;  // not looked at: a panorama has angles
    }
    LRAY_ASSERT(false);
}

struct SineCosine {
    double sine = 0.0;
    double cosine = 1.0;
};

/// Of an angle within a quarter turn of 0, from the tangent of its half.
SineCosine sine_cosine(double angle) {
    const double t = static_cast<double>(std::tan(static_cast<float>(0.5 * angle)));
    return {2.0 * t / (1.0 + t * t), (1.0 - t * t) / (1.0 + t * t)};
}

}  // namespace

CameraFrame camera_frame(DVec3 position, DVec3 look_at, DVec3 up) {
    CameraFrame frame;
    frame.forward = unit(look_at - position);
    DVec3 right = cross(frame.forward, unit(up));
    // Also when `up` is 0 and `right` not a number.
    if (!(dot(right, right) > 0.0)) right = cross(frame.forward, farthest_axis(frame.forward));
    frame.right = unit(right);
    frame.up = cross(frame.right, frame.forward);
    return frame;
}

CameraRays::CameraRays(const scene::Camera& camera, scene::Resolution resolution)
    : frame_(camera_frame(camera.position, camera.look_at, camera.up)),
      position_(camera.position),
      center_pixel_(0.5 * resolution.width, 0.5 * resolution.height),
      pixel_size_(view_height(camera) / resolution.height),
      projection_(camera.projection) {}

DVec3 CameraRays::panorama_direction(DVec2 position_pixel) const {
    const double turn = position_pixel.x / (2.0 * center_pixel_.x) - 0.5;  // of a whole turn
    const double rise = 0.5 - position_pixel.y / (2.0 * center_pixel_.y);  // of half a turn
    const SineCosine half = sine_cosine(std::numbers::pi * turn);
    const SineCosine pitch = sine_cosine(std::numbers::pi * rise);
    const double heading_sine = 2.0 * half.sine * half.cosine;
    const double heading_cosine = half.cosine * half.cosine - half.sine * half.sine;
    return unit(pitch.cosine * (heading_sine * frame_.right + heading_cosine * frame_.forward) +
                pitch.sine * frame_.up);
}

Ray CameraRays::through(DVec2 position_pixel) const {
    const double x = (position_pixel.x - center_pixel_.x) * pixel_size_;
    const double y = (center_pixel_.y - position_pixel.y) * pixel_size_;  // rows go down
    const DVec3 offset = x * frame_.right + y * frame_.up;
    switch (projection_) {
        case scene::Projection::perspective:
            return {Vec3(position_), Vec3(unit(frame_.forward + offset))};
        case scene::Projection::orthographic:
            return {Vec3(position_ + offset), Vec3(frame_.forward)};
        case scene::Projection::panorama:
            return {Vec3(position_), Vec3(panorama_direction(position_pixel))};
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::render
