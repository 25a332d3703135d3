// Directions in a cone, and a frame about its axis.
#pragma once

#include <cmath>
#include <numbers>

#include "base/vec.h"

namespace lray::shade {

/// Two unit vectors at right angles to a unit one and to each other.
struct Across {
    DVec3 x{};
    DVec3 y{};
};

/// Source: Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
inline Across across(DVec3 z) {
    const double sign = std::copysign(1.0, z.z);
    const double a = -1.0 / (sign + z.z);
    const double b = z.x * z.y * a;
    return {{1.0 + sign * z.x * z.x * a, sign * b, -sign * z.x}, {b, sign + z.y * z.y * a, -z.y}};
}

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
