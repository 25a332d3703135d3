#include "shade/textures/checker.h"

#include <gtest/gtest.h>

#include "shade/textures/square_wave.h"
#include "shade/textures/stripes.h"
#include "tests/shade/textures/worlds.h"

namespace lray::shade {
namespace {

const Color kA{0.9f, 0.5f, 0.1f};
const Color kB{0.1f, 0.2f, 0.4f};

Color at_point(const Checker& checker, DVec3 p) {
    return test::color_of(checker, p, {});
}

TEST(Checker, ColoursAlternateFromTheFirstCubeOnAlsoBelowZero) {
    const Checker checker({kA, kB, 0.5});
    for (int i = -4; i < 4; ++i) {
        for (int j = -2; j < 2; ++j) {
            for (int k = -2; k < 2; ++k) {
                const DVec3 middle = 0.5 * DVec3{i + 0.5, j + 0.5, k + 0.5};
                const bool is_even = ((i + j + k) & 1) == 0;
                EXPECT_EQ(at_point(checker, middle), is_even ? kA : kB) << i << j << k;
            }
        }
    }
}

TEST(Checker, FaceOnABorderOfCubesIsInOneOfThem) {
    const Checker checker({kA, kB, 2.0});
    for (const double border : {0.0, 2.0, -4.0}) {
        const Color color = at_point(checker, {1.0, border, 1.0});
        for (const double error : {-1e-3, -1e-6, 1e-6, 1e-3}) {
            EXPECT_EQ(at_point(checker, {1.0, border + error, 1.0}), color) << border << error;
        }
    }
}

TEST(Checker, FloorOnABorderKeepsItsColoursUnderAFootprintThatLiesInIt) {
    const scene::World world = test::world_with(scene::CheckerTexture{kA, kB, 1.0});
    const TextureSet textures(world);
    const DVec3 up{0.0, 1.0, 0.0};
    const scene::TextureId id(std::size_t{0});
    const Color near = textures.color(id, test::point_at({0.5, 0.0, 0.5}, 0.2, up));
    EXPECT_EQ(near, textures.color(id, test::point_at({0.5, 0.0, 0.5})));
    EXPECT_EQ(near, textures.color(id, test::point_at({0.5, 0.0, 0.5}, 0.2)));  // plane unknown
}

TEST(Checker, FootprintIsTheMeanOfItsPoints) {
    const Checker checker({kA, kB, 0.7});
    test::Random random(1);
    for (const double width : {0.05, 0.3, 0.7, 1.1, 2.3}) {
        for (int trial = 0; trial < 8; ++trial) {
            const DVec3 p = test::point_in_box(random, 3.0);
            const DVec3 extent{width, 0.0, 0.5 * width};
            constexpr int kSteps = 300;
            DVec3 sum{0.0};
            for (int i = 0; i < kSteps; ++i) {
                for (int k = 0; k < kSteps; ++k) {
                    const DVec3 part{(i + 0.5) / kSteps - 0.5, 0.0, (k + 0.5) / kSteps - 0.5};
                    sum += DVec3{at_point(checker, p + part * extent)};
                }
            }
            const Color mean = test::color_of(checker, p, {extent, 0.0});
            for (int channel = 0; channel < 3; ++channel) {
                EXPECT_NEAR(static_cast<double>(mean[channel]), sum[channel] / (kSteps * kSteps),
                            0.01)
                    << width;
            }
        }
    }
}

TEST(Checker, FarAwayIsTheMiddleOfItsColours) {
    const Checker checker({kA, kB, 1.0});
    const Color middle = 0.5f * (kA + kB);
    test::Random random(2);
    for (int trial = 0; trial < 100; ++trial) {
        const DVec3 p = test::point_in_box(random, 1e4);
        for (const Footprint& footprint :
             {Footprint{{2e3, 0.0, 2e3}, 0.0}, Footprint{DVec3{0.0}, 1.0},
              Footprint{{1e300, 0.0, 1e300}, 0.0}}) {
            const Color color = test::color_of(checker, p, footprint);
            for (int channel = 0; channel < 3; ++channel) {
                EXPECT_NEAR(color[channel], middle[channel], 1e-3f);
            }
        }
    }
}

TEST(Stripes, AlternateAlongTheirAxisAlone) {
    const Stripes stripes({kA, kB, 0.25, scene::Axis::z});
    test::Random random(3);
    for (int i = -5; i < 5; ++i) {
        const DVec3 p{random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0), 0.25 * (i + 0.5)};
        EXPECT_EQ(test::color_of(stripes, p, {}), (i & 1) == 0 ? kA : kB) << i;
    }
}

TEST(Stripes, AcrossTheirAxisNothingIsAveraged) {
    const Stripes stripes({kA, kB, 1.0, scene::Axis::x});
    EXPECT_EQ(test::color_of(stripes, {0.5, 0.0, 0.0}, {{0.0, 50.0, 50.0}, 0.0}), kA);
    EXPECT_NE(test::color_of(stripes, {0.5, 0.0, 0.0}, {{1.5, 0.0, 0.0}, 0.0}), kA);
}

TEST(SquareWave, MeanOfOneEdgeIsTheShareOnEachSide) {
    EXPECT_EQ(mean_square_wave(0.5, 0.0), 1.0);
    EXPECT_EQ(mean_square_wave(0.5, 1.0), 1.0);  // up to both edges and not beyond
    EXPECT_EQ(mean_square_wave(1.0, 0.5), 0.0);
    EXPECT_EQ(mean_square_wave(0.0, 1e-300), 0.0);
    EXPECT_DOUBLE_EQ(mean_square_wave(0.75, 1.0), 0.5);
    EXPECT_DOUBLE_EQ(mean_square_wave(1.25, 1.0), -0.5);
    EXPECT_NEAR(mean_square_wave(0.5, 2.0), 0.0, 1e-15);         // a whole period
    EXPECT_NEAR(mean_square_wave(0.5, 3.0), -1.0 / 3.0, 1e-15);  // two parts of -1, one of 1
    EXPECT_EQ(mean_square_wave(0.5, std::numeric_limits<double>::quiet_NaN()), 1.0);
    EXPECT_EQ(mean_square_wave(0.5, std::numeric_limits<double>::infinity()), 0.0);
}

}  // namespace
}  // namespace lray::shade
