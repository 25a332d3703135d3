// Wireframes of bounding volumes.
#pragma once

#include <array>

#include "gui/overlay.h"
#include "gui/project.h"

namespace lray::gui {

/// A box or an ellipsoid: its middle, and from there the ways to three sides or along three axes.
struct Volume {
    DVec3 center{0.0};
    std::array<DVec3, 3> half_axes{};
};

/// Adds the twelve edges.
void add_wireframe_box(Overlay& overlay, const Volume& volume, Rgba color,
                       const Projector& projector);

/// Adds the three ellipses through two axes each.
void add_wireframe_ellipsoid(Overlay& overlay, const Volume& volume, Rgba color,
                             const Projector& projector);

}  // namespace lray::gui
