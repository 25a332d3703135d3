#include <gtest/gtest.h>

#include <cmath>

#include "base/noise.h"
#include "scene/vein_profiles.h"
#include "shade/textures/marble.h"
#include "shade/textures/noise.h"
#include "shade/textures/wood.h"
#include "tests/shade/textures/worlds.h"

namespace lray::shade {
namespace {

TEST(NoiseTexture, PointIsThatOfTheLanguagesFbm) {
    scene::NoiseTexture texture;
    texture.octaves = 4;
    texture.lacunarity = 2.5;
    texture.gain = 0.6;
    texture.seed = 7.0;
    const Noise noise(texture);
    test::Random random(6);
    for (int trial = 0; trial < 100; ++trial) {
        const DVec3 p = test::point_in_box(random, 50.0);
        const double expected = fbm(p, {4, 2.5, 0.6}, NoiseSeed(KeyedRandom{}.with(7.0)));
        EXPECT_EQ(test::color_of(noise, p, {}).r, static_cast<float>(0.5 + 0.5 * expected));
    }
}

TEST(Fbm, WidthOfZeroChangesNothingAndOfACellLeavesNothing) {
    const NoiseSeed seed(KeyedRandom{});
    test::Random random(7);
    for (int trial = 0; trial < 100; ++trial) {
        const DVec3 p = test::point_in_box(random, 50.0);
        EXPECT_EQ(fbm(p, {}, seed, 0.0), fbm(p, {}, seed));
        EXPECT_EQ(fbm(p, {}, seed, 1.0), 0.0);
        // Two octaves stay, and keep their share of the sum.
        const double weights = 1.0 + 0.5 + 0.25 + 0.125 + 0.0625;
        EXPECT_NEAR(fbm(p, {}, seed, 0.25), fbm(p, {2, 2.0, 0.5}, seed) * 1.5 / weights, 1e-14);
    }
}

TEST(FractalNoise, SpreadGrowsWithTheWidthToThatOfTheWholeNoise) {
    const FractalNoise noise({}, 0.0);
    double last = 0.0;
    EXPECT_EQ(noise.at(DVec3{0.3}, 0.0).spread, 0.0);
    for (double width = 0.001; width < 2.0; width *= 1.5) {
        const double spread = noise.at(DVec3{0.3}, width).spread;
        EXPECT_GE(spread, last * (1.0 - 1e-12)) << width;
        last = spread;
    }
    test::Random random(8);
    double squares = 0.0;
    constexpr int kCount = 20000;
    for (int i = 0; i < kCount; ++i) {
        const double value = noise.at(test::point_in_box(random, 500.0), 0.0).mean;
        squares += value * value;
    }
    const double whole = noise.at(DVec3{0.3}, 5.0).spread;
    EXPECT_NEAR(whole * whole / 12.0, squares / kCount, 0.05 * squares / kCount);
}

/// From afar all of a texture is about its average, wherever it is looked up.
template <class Pattern>
void expect_average_from_afar(const Pattern& pattern, Color average) {
    test::Random random(9);
    for (int trial = 0; trial < 100; ++trial) {
        const DVec3 p = test::point_in_box(random, 50.0);
        for (const Footprint& footprint :
             {Footprint{{40.0, 0.0, 40.0}, 0.0}, Footprint{DVec3{0.0}, 40.0}}) {
            const Color color = test::color_of(pattern, p, footprint);
            for (int channel = 0; channel < 3; ++channel) {
                EXPECT_NEAR(color[channel], average[channel], 0.02f);
            }
        }
    }
}

TEST(NoiseTextures, FromAfarAreTheirAverage) {
    scene::NoiseTexture noise;
    noise.stops = {{0.0, Color{0.0f}}, {0.6, Color{0.0f}}, {1.0, Color{2.0f, 1.0f, 0.0f}}};
    expect_average_from_afar(Noise(noise), scene::average_color(noise, {}));
    const scene::MarbleTexture marble;
    expect_average_from_afar(Marble(marble), scene::average_color(marble, {}));
    const scene::WoodTexture wood;
    expect_average_from_afar(Wood(wood), scene::average_color(wood, {}));
}

/// How far lookups are from the mean of the points of their footprint, on average.
struct Errors {
    double of_footprint = 0.0;
    double of_point = 0.0;  // when the footprint is not regarded
};

template <class Pattern>
Errors errors_of(const Pattern& pattern, double width) {
    constexpr int kTrials = 200;
    constexpr int kSteps = 12;
    test::Random random(10);
    Errors errors;
    for (int trial = 0; trial < kTrials; ++trial) {
        const DVec3 p = test::point_in_box(random, 3.0);
        const DVec3 extent{width, width, 0.0};
        const auto red = [&](DVec3 at, const Footprint& footprint) {
            return static_cast<double>(test::color_of(pattern, at, footprint).r);
        };
        double mean = 0.0;
        for (int i = 0; i < kSteps; ++i) {
            for (int j = 0; j < kSteps; ++j) {
                const DVec3 part{(i + 0.5) / kSteps - 0.5, (j + 0.5) / kSteps - 0.5, 0.0};
                mean += red(p + part * extent, {}) / (kSteps * kSteps);
            }
        }
        errors.of_footprint += std::fabs(red(p, {extent, 0.0}) - mean) / kTrials;
        errors.of_point += std::fabs(red(p, {}) - mean) / kTrials;
    }
    return errors;
}

TEST(NoiseTextures, FootprintIsAboutTheMeanOfItsPoints) {
    const Marble marble(scene::MarbleTexture{});
    const Wood wood(scene::WoodTexture{});
    const Noise noise(scene::NoiseTexture{});
    for (const double size : {0.1, 0.5, 2.0}) {
        for (const Errors& errors :
             {errors_of(marble, size), errors_of(wood, 0.1 * size), errors_of(noise, size)}) {
            EXPECT_LT(errors.of_footprint, 0.08) << size;
            if (size > 1.0) {
                EXPECT_LT(errors.of_footprint, 0.5 * errors.of_point);
            }
        }
    }
}

TEST(Marble, WithoutTurbulenceVeinsLieASizeApart) {
    scene::MarbleTexture texture;
    texture.turbulence = 0.0;
    texture.size = 2.0;
    texture.axis = scene::Axis::z;
    const Marble marble(texture);
    EXPECT_EQ(test::color_of(marble, {5.0, -3.0, 0.0}, {}), texture.b);
    EXPECT_EQ(test::color_of(marble, {5.0, -3.0, -4.0}, {}), texture.b);
    EXPECT_EQ(test::color_of(marble, {5.0, -3.0, 3.0}, {}), texture.a);
}

TEST(Wood, WithoutTurbulenceRingsAreRoundAndASizeWide) {
    scene::WoodTexture texture;
    texture.turbulence = 0.0;
    texture.axis = scene::Axis::x;
    texture.size = 0.5;
    const Wood wood(texture);
    const Color color = test::color_of(wood, {7.0, 0.8, 0.0}, {});
    EXPECT_EQ(test::color_of(wood, {-2.0, 0.0, -0.8}, {}), color);
    EXPECT_EQ(test::color_of(wood, {0.0, 0.0, 0.0}, {}), texture.a);
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(test::color_of(wood, {0.0, 0.0, 1.3}, {})[channel], color[channel], 1e-6f);
        EXPECT_NEAR(test::color_of(wood, {0.0, 0.0, 0.5 * 1.85}, {})[channel], texture.b[channel],
                    1e-6f);
    }
}

template <class Profile>
void expect_integral_of_values(Profile profile) {
    double sum = 0.0;
    constexpr int kSteps = 1000;
    for (int i = 0; i < kSteps; ++i) {
        sum += profile.value((i + 0.5) / kSteps) / kSteps;
        EXPECT_NEAR(profile.integral((i + 1.0) / kSteps), sum, 1e-5);
    }
    EXPECT_EQ(profile.integral(0.0), 0.0);
}

TEST(VeinProfiles, IntegralsAreThoseOfTheValues) {
    expect_integral_of_values(scene::MarbleProfile{});
    expect_integral_of_values(scene::WoodProfile{});
}

}  // namespace
}  // namespace lray::shade
