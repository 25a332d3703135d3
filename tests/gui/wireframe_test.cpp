#include "gui/wireframe.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lray::gui {
namespace {

constexpr scene::Resolution kResolution{200, 200};
constexpr Rgba kColor{0.1f, 0.2f, 0.3f, 0.4f};

/// Looks at the origin along -z; a unit is 50 pixels.
Projector projector() {
    scene::Camera camera;
    camera.projection = scene::Projection::orthographic;
    camera.height = 4.0;
    return {camera, kResolution};
}

constexpr Volume kUnit{DVec3(0.0),
                       {DVec3(1.0, 0.0, 0.0), DVec3(0.0, 1.0, 0.0), DVec3(0.0, 0.0, 1.0)}};

TEST(WireframeBox, HasTwelveEdgesOnItsOutline) {
    Overlay overlay;
    add_wireframe_box(overlay, kUnit, kColor, projector());
    ASSERT_EQ(overlay.lines.size(), 12u);
    int point_count = 0;
    double total = 0.0;
    for (const OverlayLine& line : overlay.lines) {
        EXPECT_EQ(line.color, kColor);
        for (const DVec2 end : {line.from, line.to}) {
            EXPECT_NEAR(std::fabs(end.x - 100.0), 50.0, 1e-9);
            EXPECT_NEAR(std::fabs(end.y - 100.0), 50.0, 1e-9);
        }
        const DVec2 way = line.to - line.from;
        const double size = std::sqrt(dot(way, way));
        if (size < 1e-9) ++point_count;  // along the view
        total += size;
    }
    EXPECT_EQ(point_count, 4);
    EXPECT_NEAR(total, 8 * 100.0, 1e-9);
}

TEST(WireframeEllipsoid, HasThreeClosedEllipses) {
    Overlay overlay;
    Volume volume = kUnit;
    volume.half_axes[1] *= 0.5;
    add_wireframe_ellipsoid(overlay, volume, kColor, projector());
    ASSERT_EQ(overlay.lines.size(), 3u * 48u);
    for (std::size_t circle = 0; circle < 3; ++circle) {
        for (std::size_t i = 0; i < 48; ++i) {
            EXPECT_EQ(overlay.lines[48 * circle + i].to,
                      overlay.lines[48 * circle + (i + 1) % 48].from);
        }
    }
    // The first is through the x and y axes, and seen from the front.
    for (std::size_t i = 0; i < 48; ++i) {
        const DVec2 offset = (overlay.lines[i].from - DVec2(100.0)) / DVec2(50.0, 25.0);
        EXPECT_NEAR(dot(offset, offset), 1.0, 1e-12);
    }
}

TEST(Wireframe, BehindTheCameraIsNothing) {
    Overlay overlay;
    Volume volume = kUnit;
    volume.center.z = 100.0;
    add_wireframe_box(overlay, volume, kColor, projector());
    add_wireframe_ellipsoid(overlay, volume, kColor, projector());
    EXPECT_TRUE(overlay.lines.empty());
}

}  // namespace
}  // namespace lray::gui
