// The rays of a camera: from a position in the picture to a ray in the world.
#pragma once

#include "base/ray.h"
#include "base/vec.h"
#include "scene/camera.h"

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

/// A pinhole, orthographic or panoramic (equirectangular) camera with a picture before it. Uses
/// only operations that give the same bits on every processor: + - * / sqrt, and of libm the float
/// tangent.
class CameraRays {
 public:
    /// `resolution` is that of the full picture, also when only a crop of it is rendered.
    CameraRays(const scene::Camera& camera, scene::Resolution resolution);

    /// Returns the ray through a position in the full picture: (0, 0) is its top left corner,
    /// (0.5, 0.5) the centre of its first pixel. Pixels are square.
    Ray through(DVec2 position_pixel) const;

 private:
    DVec3 panorama_direction(DVec2 position_pixel) const;

    CameraFrame frame_{};
    DVec3 position_{};
    DVec2 center_pixel_{};
    double pixel_size_ = 1.0;  // on the plane at distance 1 (perspective), or in world units
    scene::Projection projection_ = scene::Projection::perspective;
};

}  // namespace lray::render
