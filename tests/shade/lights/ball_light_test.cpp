// Point and spot lights against their formula, and balls against what a ball of light gives.
#include "shade/lights/ball_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/angle.h"
#include "shade/transport/shadow.h"
#include "tests/shade/chi_square.h"
#include "tests/shade/lights/light_means.h"

namespace lray::shade {
namespace {

constexpr double kPi = std::numbers::pi;

BallLight ball_at(DVec3 position, double radius,
                  scene::Falloff falloff = scene::Falloff::quadratic) {
    return BallLight::of(scene::PointLight{position, falloff, radius, 1}, Color{1.0f}, 500.0, true);
}

scene::SpotLight spot_of(double degrees, double softness) {
    scene::SpotLight spot;
    spot.angle = radians(degrees);
    spot.softness = softness;
    return spot;
}

TEST(BallLight, PointIsTheFormulaOfItsDistance) {
    test::Random random(1);
    for (int i = 0; i < 10'000; ++i) {
        const double d = std::exp(random.uniform(-8.0, 12.0));
        const DVec3 point = 100.0 * test::sphere_direction(random);
        const DVec3 wi = test::sphere_direction(random);
        const Color color{1.0f, 0.5f, 0.25f};
        for (const auto& [falloff, exact] :
             {std::pair{scene::Falloff::quadratic, 500.0 / (4.0 * kPi * d * d)},
              std::pair{scene::Falloff::linear, 500.0 / (4.0 * kPi * d)},
              std::pair{scene::Falloff::none, 500.0 / (4.0 * kPi)}}) {
            const auto light = BallLight::of(scene::PointLight{point + d * wi, falloff, 0.0, 1},
                                             color, 500.0, true);
            const auto sample = light.sample(point, {0.3, 0.7});
            ASSERT_TRUE(sample);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(sample->irradiance[c] / (exact * double{color[c]}), 1.0,
                            1.5e-7 + 5e-14 / d);
                EXPECT_NEAR(sample->wi[c], wi[c], 1e-7 + 5e-14 / d);
            }
            EXPECT_EQ(sample->pdf, 0.0f);
            EXPECT_FLOAT_EQ(sample->distance, static_cast<float>(d));
        }
    }
}

TEST(BallLight, OnThePointItselfThereIsNoDirection) {
    EXPECT_FALSE(ball_at({1.0, 2.0, 3.0}, 0.0).sample({1.0, 2.0, 3.0}, {0.5, 0.5}));
    EXPECT_FALSE(ball_at({1.0, 2.0, 3.0}, 0.5).sample({1.0, 2.0, 3.0}, {0.5, 0.5}));
}

TEST(BallLight, BallGivesAFacingSurfaceWhatAPointGives) {
    for (const double d : {1.0001, 1.1, 2.0, 10.0, 1e3, 1e6, 1e9}) {
        const BallLight light = ball_at({0.0, 0.0, d}, 1.0);
        const auto sampler = [&](DVec2 u) { return light.sample(DVec3{0.0}, u); };
        const double exact = 500.0 / (4.0 * kPi * d * d);
        EXPECT_NEAR(test::irradiance(sampler, {0.0, 0.0, 1.0}) / exact, 1.0, 2e-5) << d;
    }
}

TEST(BallLight, OtherFalloffsKeepTheStrengthOfTheMiddle) {
    const BallLight light = ball_at({0.0, 0.0, 2.0}, 1.0, scene::Falloff::linear);
    for (const DVec2 u : {DVec2{0.0, 0.0}, DVec2{0.4, 0.1}, DVec2{0.99, 0.6}}) {
        const auto sample = light.sample(DVec3{0.0}, u);
        EXPECT_NEAR(sample->irradiance.r, 500.0 / (4.0 * kPi * 2.0), 1e-5);
        EXPECT_EQ(sample->pdf, 0.0f);
        EXPECT_EQ(light.pdf(DVec3{0.0}, sample->wi), 0.0f);
    }
}

TEST(BallLight, InsideOfItLightComesFromAllAround) {
    const BallLight light = ball_at({0.0, 0.0, 0.0}, 2.0);
    const double radiance = static_cast<double>(light.radiance().g);
    EXPECT_NEAR(radiance, 500.0 / (4.0 * kPi * 4.0), 1e-5);
    for (const DVec3 point : {DVec3{0.1, 0.0, 0.0}, DVec3{0.0, 1.99, 0.0}}) {
        const auto sampler = [&](DVec2 u) { return light.sample(point, u); };
        for (const DVec3 normal : {DVec3{1.0, 0.0, 0.0}, DVec3{0.0, -0.6, 0.8}}) {
            EXPECT_NEAR(test::irradiance(sampler, normal) / radiance, 1.0, 1e-4);
        }
        EXPECT_NEAR(light.pdf(point, {0.6f, 0.0f, 0.8f}), 1.0 / (4.0 * kPi), 1e-7);
    }
}

TEST(BallLight, DirectionsAreUniformInTheConeThatItFills) {
    for (const double d : {1.02, 1.5, 4.0}) {
        const BallLight light = ball_at({0.0, 0.0, d}, 1.0);
        const auto sampler = [&](double, DVec2 u) -> std::optional<Vec3> {
            const auto sample = light.sample(DVec3{0.0}, u);
            EXPECT_EQ(sample->pdf, light.pdf(DVec3{0.0}, {0.0f, 0.0f, 1.0f}));
            return sample->wi;
        };
        const auto density = [&](Vec3 wi) {
            return static_cast<double>(light.pdf(DVec3{0.0}, wi));
        };
        const double rim = std::sqrt(1.0 - 1.0 / (d * d));
        EXPECT_GT(test::chi_square_probability(sampler, density, 2, {rim, 1.0}), 1e-3) << d;
    }
}

TEST(BallLight, ShadowRaysEndInFrontOfWhereItIsSeen) {
    test::Random random(3);
    for (int i = 0; i < 20'000; ++i) {
        const double radius = std::exp(random.uniform(-6.0, 3.0));
        const double d = radius * (1.0 + std::exp(random.uniform(-7.0, 7.0)));
        const DVec3 origin(Vec3(10.0 * test::sphere_direction(random)));
        const BallLight light = ball_at(origin + d * test::sphere_direction(random), radius);
        const auto sample = light.sample(origin, {random.uniform(0.0, 0.99), random.uniform()});
        ASSERT_TRUE(sample);
        const Ray ray{Vec3(origin), sample->wi};
        const auto seen = light.hit(ray, {});
        ASSERT_TRUE(seen) << d << " " << radius;
        EXPECT_LT(shadow_interval(ray, sample->distance).hi, *seen);
        EXPECT_NEAR(sample->distance, *seen, 0.001f * *seen);
    }
}

TEST(BallLight, IsSeenFromOutsideAndInsideWithinTheIntervalAlone) {
    const BallLight light = ball_at({0.0, 0.0, 5.0}, 1.0);
    const Ray ray{{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
    EXPECT_EQ(light.hit(ray, {}), 4.0f);
    EXPECT_EQ(light.hit(ray, {4.0f, kInfinity}), 6.0f);
    EXPECT_EQ(light.hit(ray, {0.0f, 4.0f}), std::nullopt);
    EXPECT_EQ(light.hit(ray, {6.0f, kInfinity}), std::nullopt);
    EXPECT_EQ(light.hit({{0.0f, 0.0f, 4.5f}, {0.0f, 0.0f, 1.0f}}, {}), 6.0f - 4.5f);
    EXPECT_EQ(light.hit({{0.0f, 0.0f, 7.0f}, {0.0f, 0.0f, 1.0f}}, {}), std::nullopt);
    EXPECT_EQ(light.hit({{1.5f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}}, {}), std::nullopt);
}

TEST(BallLight, SpotFadesBetweenTheInnerConeAndTheRim) {
    const auto light = BallLight::of(spot_of(40.0, 0.5), Color{1.0f}, 500.0);
    const auto share = [&](double degrees) {
        const double angle = radians(degrees);
        return light.cone_share({std::sin(angle), 0.0, -std::cos(angle)});
    };
    EXPECT_EQ(share(0.0), 1.0);
    EXPECT_EQ(share(9.99), 1.0);
    EXPECT_NEAR(share(12.5), 0.84375, 1e-5);
    EXPECT_NEAR(share(15.0), 0.5, 1e-5);
    EXPECT_NEAR(share(17.5), 0.15625, 1e-5);
    EXPECT_EQ(share(20.01), 0.0);
    EXPECT_EQ(share(180.0), 0.0);
}

TEST(BallLight, SoftnessReachesFromNoneToTheAxis) {
    const auto hard = BallLight::of(spot_of(60.0, 0.0), Color{1.0f}, 500.0);
    const auto soft = BallLight::of(spot_of(60.0, 1.0), Color{1.0f}, 500.0);
    const auto at = [](double degrees) {
        return DVec3{std::sin(radians(degrees)), 0.0, -std::cos(radians(degrees))};
    };
    EXPECT_EQ(hard.cone_share(at(29.999)), 1.0);
    EXPECT_EQ(hard.cone_share(at(30.001)), 0.0);
    EXPECT_NEAR(soft.cone_share(at(15.0)), 0.5, 1e-6);
    EXPECT_EQ(soft.cone_share(at(0.0)), 1.0);
    const auto half = BallLight::of(spot_of(180.0, 0.0), Color{1.0f}, 500.0);
    EXPECT_EQ(half.cone_share(at(89.99)), 1.0);
    EXPECT_EQ(half.cone_share(at(90.01)), 0.0);
}

TEST(BallLight, SpotIsAPointLightInItsCone) {
    const auto light = BallLight::of(spot_of(60.0, 0.2), Color{1.0f}, 500.0);
    const auto below = light.sample({0.0, 0.0, -2.0}, {0.5, 0.5});
    ASSERT_TRUE(below);
    EXPECT_NEAR(below->irradiance.r, 500.0 / (4.0 * kPi * 4.0), 1e-6);
    EXPECT_EQ(below->wi, (Vec3{0.0f, 0.0f, 1.0f}));
    EXPECT_FALSE(light.sample({0.0, 0.0, 2.0}, {0.5, 0.5}));
    EXPECT_FALSE(light.sample({5.0, 0.0, -2.0}, {0.5, 0.5}));
}

TEST(BallLight, ExtremeNumbersStayFinite) {
    for (const double d : {1e-300, 1e-30, 1e-10, 1.0, 1e10, 1e18}) {
        for (const double radius : {0.0, 1e-200, 1e-20, 1e-3, 1.0, 1e18}) {
            for (const double intensity : {1e-300, 1.0, 1e300}) {
                const auto light = BallLight::of(scene::PointLight{{0.0, d, 0.0}, {}, radius, 1},
                                                 Color{1e30f}, intensity, true);
                const auto s = light.sample(DVec3{0.0}, {0.9, 0.1});
                const Color radiance = radius > 0.0 ? light.radiance() : Color{0.0f};
                EXPECT_TRUE(std::isfinite(radiance.r)) << radius;
                EXPECT_TRUE(std::isfinite(light.pdf(DVec3{0.0}, {0.0f, 1.0f, 0.0f})));
                if (!s) continue;
                EXPECT_TRUE(std::isfinite(s->irradiance.r) && s->irradiance.r >= 0.0f);
                EXPECT_TRUE(std::isfinite(s->pdf) && s->pdf >= 0.0f);
                EXPECT_TRUE(std::isfinite(s->distance) && s->distance >= 0.0f);
                EXPECT_NEAR(glm::length(s->wi), 1.0f, 3e-7f) << d << " " << radius;
            }
        }
    }
}

}  // namespace
}  // namespace lray::shade
