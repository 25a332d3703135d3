#include "render/camera_rays.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/assert.h"
#include "base/portable_math.h"

namespace lray::render {

namespace {

/// Dividing by the largest component first keeps the squares from overflowing or vanishing.
DVec3 unit(DVec3 v) {
    const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    const DVec3 scaled = v / largest;
    return scaled / std::sqrt(dot(scaled, scaled));
}

/// Likewise, of what is neither short nor long.
DVec3 unit_of_usual(DVec3 v) {
    return v * (1.0 / std::sqrt(dot(v, v)));
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
            return std::numbers::pi;  // of the sphere of radius 1, from below to above
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

double focus_distance(const scene::Camera& camera) {
    if (camera.focus) return *camera.focus;
    const DVec3 way = camera.look_at - camera.position;
    const double largest = std::max({std::fabs(way.x), std::fabs(way.y), std::fabs(way.z)});
    return largest * std::sqrt(dot(way / largest, way / largest));
}

}  // namespace

DVec2 disk_point(DVec2 pair) {
    const double a = 2.0 * pair.x - 1.0;
    const double b = 2.0 * pair.y - 1.0;
    if (a == 0.0 && b == 0.0) return {0.0, 0.0};
    // In the quarter around +X or -X the radius is |a|, and the angle an eighth of a turn at most.
    const bool is_across = std::fabs(a) > std::fabs(b);
    const double radius = is_across ? a : b;
    const double slope = is_across ? b / a : a / b;
    const DVec2 point = unit_circle_point(std::fabs(slope) / 8.0);
    const double far = radius * point.x;
    const double aside = radius * (slope < 0.0 ? -point.y : point.y);
    return is_across ? DVec2{far, aside} : DVec2{aside, far};
}

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
      lens_radius_(camera.projection == scene::Projection::panorama ? 0.0 : 0.5 * camera.aperture),
      focus_(focus_distance(camera)),
      projection_(camera.projection) {}

DVec3 CameraRays::offset(DVec2 position_pixel) const {
    const double x = (position_pixel.x - center_pixel_.x) * pixel_size_;
    const double y = (center_pixel_.y - position_pixel.y) * pixel_size_;  // rows go down
    return x * frame_.right + y * frame_.up;
}

/// The direction from a point of the lens to where the way from its middle meets the plane of
/// focus. Whichever is multiplied or divided by the distance shrinks: nothing overflows.
DVec3 CameraRays::towards_focus(DVec3 way, DVec3 lens_point) const {
    return focus_ >= 1.0 ? unit(way - lens_point / focus_) : unit(way * focus_ - lens_point);
}

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

Ray CameraRays::through(DVec2 position_pixel, DVec2 lens) const {
    if (projection_ == scene::Projection::panorama) {
        return {Vec3(position_), Vec3(panorama_direction(position_pixel))};
    }
    const bool is_perspective = projection_ == scene::Projection::perspective;
    const DVec3 aside = offset(position_pixel);
    const DVec3 origin = is_perspective ? position_ : position_ + aside;
    const DVec3 way = is_perspective ? frame_.forward + aside : frame_.forward;
    if (!has_lens()) return {Vec3(origin), Vec3(is_perspective ? unit_of_usual(way) : way)};
    const DVec2 point = lens_radius_ * disk_point(lens);
    const DVec3 lens_point = point.x * frame_.right + point.y * frame_.up;
    return {Vec3(origin + lens_point), Vec3(towards_focus(way, lens_point))};
}

shade::RayCone CameraRays::cone(DVec2 position_pixel) const {
    switch (projection_) {
        case scene::Projection::perspective: {
            // A pixel lies in the plane at distance 1; the ray takes this much longer to get there.
            const DVec3 way = frame_.forward + offset(position_pixel);
            return {0.0f, static_cast<float>(pixel_size_ / std::sqrt(dot(way, way)))};
        }
        case scene::Projection::orthographic:
            return {static_cast<float>(pixel_size_), 0.0f};
        case scene::Projection::panorama:
            return {0.0f, static_cast<float>(pixel_size_)};
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::render
