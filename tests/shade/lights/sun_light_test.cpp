// Suns: the same light everywhere, however wide.
#include "shade/lights/sun_light.h"

#include <gtest/gtest.h>

#include "base/angle.h"
#include "tests/shade/chi_square.h"
#include "tests/shade/lights/light_means.h"

namespace lray::shade {
namespace {

SunLight sun_of(double degrees) {
    return SunLight::of(scene::DirectionalLight{{0.0, 0.0, -1.0}, radians(degrees), 1}, Color{1.0f},
                        0.75);
}

TEST(SunLight, WithoutExtentItIsOneDirection) {
    const LightSample sample = sun_of(0.0).sample({0.3, 0.9});
    EXPECT_EQ(sample.wi, (Vec3{0.0f, 0.0f, 1.0f}));
    EXPECT_EQ(sample.irradiance, Color{0.75f});
    EXPECT_EQ(sample.distance, kInfinity);
    EXPECT_EQ(sample.pdf, 0.0f);
}

TEST(SunLight, FacingSurfaceGetsItsIntensityHoweverWideItIs) {
    for (const double degrees : {1e-6, 0.5, 10.0, 90.0, 180.0}) {
        const SunLight sun = sun_of(degrees);
        const auto sampler = [&](DVec2 u) { return std::optional(sun.sample(u)); };
        EXPECT_NEAR(test::irradiance(sampler, {0.0, 0.0, 1.0}), 0.75, 1e-5) << degrees;
    }
}

TEST(SunLight, DirectionsAreUniformInItsDisk) {
    for (const double degrees : {5.0, 180.0}) {
        const SunLight sun = sun_of(degrees);
        const double rim = std::cos(radians(0.5 * degrees));
        const auto sampler = [&](double, DVec2 u) -> std::optional<Vec3> {
            return sun.sample(u).wi;
        };
        const auto density = [&](Vec3) { return 1.0 / (2.0 * 3.14159265358979 * (1.0 - rim)); };
        EXPECT_GT(test::chi_square_probability(sampler, density, 1, {rim, 1.0}), 1e-3) << degrees;
    }
}

}  // namespace
}  // namespace lray::shade
