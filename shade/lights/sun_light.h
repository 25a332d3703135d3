// Light from far away: the same everywhere, from one direction or from a disk of the sky.
#pragma once

#include "scene/light.h"
#include "shade/lights/light_sample.h"

namespace lray::shade {

/// A surface that faces its middle gets the same light however wide it is. It is not in the
/// picture: no ray meets it.
struct SunLight {
    static SunLight of(const scene::DirectionalLight& light, Color color, double intensity);

    LightSample sample(DVec2 u) const;

    DVec3 towards{0.0, 0.0, 1.0};  // its middle
    double height = 0.0;           // 1 - cos of its radius as seen
    Color irradiance{0.0f};
};

}  // namespace lray::shade
