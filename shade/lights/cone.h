// Directions in a cone.
#pragma once

#include <cmath>
#include <numbers>

#include "base/vec.h"
#include "shade/across.h"

namespace lray::shade {

/// Returns a unit direction, uniform by solid angle in the cone about +z that reaches to where
/// 1 - cos is `height`: 0 the axis alone, 1 the half, 2 the whole sphere.
/// Source: Pharr, Jakob, Humphreys 2023, "Physically Based Rendering", 4th ed., sec. 6.2.4: of
/// narrow cones 1 - cos is what is exact.
inline DVec3 cone_direction(double height, DVec2 u) {
    const double h = height * u.x;
    const double sine = std::sqrt(h * (2.0 - h));
    const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(u.y);
    return {sine * static_cast<double>(std::cos(angle)),
            sine * static_cast<double>(std::sin(angle)), 1.0 - h};
}

inline double cone_solid_angle(double height) {
    return 2.0 * std::numbers::pi * height;
}

/// Likewise about a unit axis.
inline DVec3 cone_direction_about(DVec3 axis, double height, DVec2 u) {
    const DVec3 d = cone_direction(height, u);
    const Across frame = across(axis);
    return d.x * frame.x + d.y * frame.y + d.z * axis;
}

}  // namespace lray::shade
