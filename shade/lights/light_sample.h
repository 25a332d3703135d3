// Light that arrives at a point, and what is seen of a light.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numbers>

#include "base/numerics.h"
#include "base/vec.h"

namespace lray::shade {

/// Light that arrives at a point from one direction.
struct LightSample {
    Vec3 wi{};                   // unit, towards the light
    float distance = kInfinity;  // to the light: what is nearer casts a shadow
    Color irradiance{0.0f};      // E / pi of a surface that faces wi; the mean over all u is
                                 // the light's, so samples are added up and divided by number
    float pdf = 0.0f;            // per solid angle; 0: the light has no extent, or is not visible
                                 // itself, and is met by no ray that was not sent to it
};

/// What a ray in some direction sees of a light itself.
struct LightHit {
    float t = kInfinity;  // infinite for an environment
    Color radiance{0.0f};
    std::uint32_t light = 0;
};

/// No light is stronger at a point, and no density greater: what is made of them stays finite.
inline constexpr double kMostLight = 1e30;

/// Returns a finite float, of a number that is not negative or NaN.
inline float finite_float(double x) {
    return static_cast<float>(std::min(x, kMostLight));
}

/// Returns colour times strength, finite.
inline Color light_color(Color color, double strength) {
    return glm::min(color * finite_float(strength), Color{static_cast<float>(kMostLight)});
}

/// Returns a distance as a finite float.
inline float finite_distance(double distance) {
    return static_cast<float>(std::min(distance, 1e37));
}

}  // namespace lray::shade
