// From the world into the picture: where a camera shows a point or a segment. What CameraRays does,
// the other way round.
#pragma once

#include <optional>

#include "base/vec.h"
#include "render/camera_rays.h"
#include "scene/camera.h"

namespace lray::gui {

/// Positions in the full picture, as CameraRays takes them.
struct PixelSegment {
    DVec2 from{0.0};
    DVec2 to{0.0};
};

/// Perspective and orthographic cameras, without their lens. A panorama shows segments as curves:
/// nothing is projected.
class Projector {
 public:
    Projector(const scene::Camera& camera, scene::Resolution resolution);

    /// Returns where a point is in the picture, which may be outside of it; empty for points that
    /// are not before the camera.
    std::optional<DVec2> point(DVec3 point) const;

    /// Returns the part of a segment that is before the camera and in the picture or not far from
    /// it: within its size around it. Empty if there is none.
    std::optional<PixelSegment> segment(DVec3 from, DVec3 to) const;

 private:
    /// In the directions of the camera: right, up, forward.
    DVec3 camera_from_world(DVec3 point) const;
    DVec2 pixel_of(DVec3 point_camera) const;

    render::CameraFrame frame_{};
    DVec3 position_{};
    DVec2 center_pixel_{};
    double pixels_per_unit_ = 1.0;  // at distance 1, if perspective
    scene::Projection projection_ = scene::Projection::perspective;
};

}  // namespace lray::gui
