// What samples of a light add up to.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "shade/lights/light_sample.h"
#include "tests/support/random.h"

namespace lray::test {

/// Returns E / pi of a surface with that normal, by `side` x `side` samples that are spread evenly:
/// sampler(u) gives an optional LightSample.
template <class Sampler>
double irradiance(const Sampler& sampler, DVec3 normal, int side = 300) {
    double sum = 0.0;
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
            const std::optional<shade::LightSample> s =
                sampler(DVec2{(i + 0.5) / side, (j + 0.5) / side});
            if (!s) continue;
            const double cosine = std::max(dot(DVec3(s->wi), normal), 0.0);
            sum += static_cast<double>(s->irradiance.g) * cosine;
        }
    }
    return sum / (side * side);
}

/// A unit direction, uniform on the sphere.
inline DVec3 sphere_direction(Random& random) {
    const double z = random.uniform(-1.0, 1.0);
    const double angle = random.uniform(0.0, 6.283185307179586);
    const double sine = std::sqrt(1.0 - z * z);
    return {sine * std::cos(angle), sine * std::sin(angle), z};
}

}  // namespace lray::test
