#include "shade/lights/sun_light.h"

#include <numbers>

#include "base/portable_math.h"
#include "shade/lights/cone.h"

namespace lray::shade {

SunLight SunLight::of(const scene::DirectionalLight& light, Color color, double intensity) {
    SunLight sun;
    sun.towards = -light.direction;
    // 1 - cos x = 2 sin^2 (x/2), of half the diameter.
    const double sine = unit_circle_point(0.25 * light.angle / (2.0 * std::numbers::pi)).y;
    sun.height = 2.0 * sine * sine;
    // The mean cosine to the middle is 1 - height / 2.
    sun.irradiance = light_color(color, intensity / (1.0 - 0.5 * sun.height));
    return sun;
}

LightSample SunLight::sample(DVec2 u) const {
    const DVec3 wi = height > 0.0 ? cone_direction_about(towards, height, u) : towards;
    return {Vec3(wi), kInfinity, irradiance, 0.0f};
}

}  // namespace lray::shade
