// The rays of a camera: from a position in the picture to a ray in the world.
#pragma once

#include "base/ray.h"
#include "base/vec.h"
#include "scene/camera.h"
#include "shade/transport/transport_ray.h"

namespace lray::render {

/// The directions of a camera in world space, unit and orthogonal: right x up = -forward.
struct CameraFrame {
    DVec3 right{1.0, 0.0, 0.0};
    DVec3 up{0.0, 1.0, 0.0};
    DVec3 forward{0.0, 0.0, -1.0};
};

/// Returns the frame of a camera at `position` that looks at `look_at`, with `up` upwards in the
/// picture. An `up` along the view gives way to the axis that is farthest from it.
CameraFrame camera_frame(DVec3 position, DVec3 look_at, DVec3 up);

/// The pair that stands for the middle of a lens.
inline constexpr DVec2 kLensCenter{0.5, 0.5};

/// Returns the point of the disk of radius 1 that a pair in [0, 1)^2 stands for; evenly spread
/// pairs give evenly spread points, and kLensCenter gives the centre.
/// Source: Shirley, Chiu 1997, "A Low Distortion Map Between Disk and Square".
DVec2 disk_point(DVec2 pair);

/// A perspective, orthographic or panoramic (equirectangular) camera with a picture before it. The
/// first two have a lens, which is a point if the camera's aperture is 0. Uses only operations that
/// give the same bits on every processor: + - * / sqrt, and of libm the float tangent.
class CameraRays {
 public:
    /// `resolution` is that of the full picture, also when only a crop of it is rendered.
    CameraRays(const scene::Camera& camera, scene::Resolution resolution);

    /// Returns the ray through a position in the full picture: (0, 0) is its top left corner,
    /// (0.5, 0.5) the centre of its first pixel. Pixels are square. It begins at the point of the
    /// lens that `lens` in [0, 1)^2 stands for; all rays through one position meet in the plane of
    /// focus.
    Ray through(DVec2 position_pixel, DVec2 lens = kLensCenter) const;

    /// Returns how wide a pixel around that position is along its ray through the middle of the
    /// lens.
    shade::RayCone cone(DVec2 position_pixel) const;

    bool has_lens() const { return lens_radius_ > 0.0; }

 private:
    /// From the middle of the lens to where the position lies on the plane at distance 1, or from
    /// the middle of the view to it.
    DVec3 offset(DVec2 position_pixel) const;
    DVec3 towards_focus(DVec3 way, DVec3 lens_point) const;
    DVec3 panorama_direction(DVec2 position_pixel) const;

    CameraFrame frame_{};
    DVec3 position_{};
    DVec2 center_pixel_{};
    double pixel_size_ = 1.0;  // at distance 1 (perspective, panorama), or in world units
    double lens_radius_ = 0.0;
    double focus_ = 1.0;  // distance along the view
    scene::Projection projection_ = scene::Projection::perspective;
};

}  // namespace lray::render
