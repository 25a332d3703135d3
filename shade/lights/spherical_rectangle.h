// A rectangle as it is seen from a point, and directions to it that are uniform by solid angle.
#pragma once

#include "base/vec.h"

namespace lray::shade {

/// Space: the point is the origin, the sides of the rectangle run along x and y, and it lies in the
/// plane z = -height. Angles are floats: the solid angle is off by 2e-7 of it.
/// Source: Urena, Fajardo, King 2013, "An Area-Preserving Parametrization for Spherical
/// Rectangles".
struct SphericalRectangle {
    /// Shape: low < high, height > 0.
    static SphericalRectangle of(DVec2 low, DVec2 high, double height);

    /// Returns the x and y of a point of the rectangle.
    DVec2 point(DVec2 u) const;

    DVec2 low{0.0};
    DVec2 high{0.0};
    double height = 1.0;
    double solid_angle = 0.0;
    double angle = 0.0;      // k of the source
    double side_low = 0.0;   // b0
    double side_high = 0.0;  // b1
};

}  // namespace lray::shade
