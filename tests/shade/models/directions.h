// Directions and materials that tests of reflection run through.
#pragma once

#include <array>
#include <cmath>

#include "base/vec.h"
#include "scene/material.h"
#include "tests/support/random.h"

namespace lray::test {

inline constexpr std::array kModels = {
    scene::ReflectionModel::lambert, scene::ReflectionModel::phong,
    scene::ReflectionModel::blinn_phong, scene::ReflectionModel::cook_torrance,
    scene::ReflectionModel::ward};

/// A unit direction `degrees` from +z, turned by `turn` degrees about it.
inline Vec3 direction(double degrees, double turn = 0.0) {
    constexpr double kDegree = 3.14159265358979323846 / 180.0;
    const double sine = std::sin(degrees * kDegree);
    return {sine * std::cos(turn * kDegree), sine * std::sin(turn * kDegree),
            std::cos(degrees * kDegree)};
}

/// Uniform on the hemisphere about +z.
inline Vec3 hemisphere_direction(Random& random) {
    const double z = random.uniform();
    const double angle = random.uniform(0.0, 6.283185307179586);
    const double sine = std::sqrt(1.0 - z * z);
    return {sine * std::cos(angle), sine * std::sin(angle), z};
}

}  // namespace lray::test
