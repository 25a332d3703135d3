#include "gui/wireframe.h"

#include <cstddef>

#include "base/portable_math.h"

namespace lray::gui {

namespace {

constexpr std::size_t kCircleSegments = 48;

/// The corners of a circle; the last is the first again.
constexpr auto kCircle = [] {
    std::array<DVec2, kCircleSegments + 1> points{};
    for (std::size_t i = 0; i <= kCircleSegments; ++i) {
        points[i] =
            unit_circle_point(static_cast<double>(i % kCircleSegments) / double{kCircleSegments});
    }
    return points;
}();

void add_segment(Overlay& overlay, DVec3 from, DVec3 to, Rgba color, const Projector& projector) {
    const auto segment = projector.segment(from, to);
    if (segment) overlay.add_line(segment->from, segment->to, color);
}

}  // namespace

void add_wireframe_box(Overlay& overlay, const Volume& volume, Rgba color,
                       const Projector& projector) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const DVec3 along = volume.half_axes[axis];
        const DVec3 across = volume.half_axes[(axis + 1) % 3];
        const DVec3 third = volume.half_axes[(axis + 2) % 3];
        for (const double side : {-1.0, 1.0}) {
            for (const double other : {-1.0, 1.0}) {
                const DVec3 middle = volume.center + side * across + other * third;
                add_segment(overlay, middle - along, middle + along, color, projector);
            }
        }
    }
}

void add_wireframe_ellipsoid(Overlay& overlay, const Volume& volume, Rgba color,
                             const Projector& projector) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const DVec3 a = volume.half_axes[axis];
        const DVec3 b = volume.half_axes[(axis + 1) % 3];
        const auto at = [&](DVec2 p) { return volume.center + p.x * a + p.y * b; };
        for (std::size_t i = 0; i < kCircleSegments; ++i) {
            add_segment(overlay, at(kCircle[i]), at(kCircle[i + 1]), color, projector);
        }
    }
}

}  // namespace lray::gui
