#include "shade/textures/color_stops.h"

#include <gtest/gtest.h>

#include <limits>

#include "shade/textures/gradient.h"
#include "shade/textures/ramp.h"
#include "tests/shade/textures/worlds.h"

namespace lray::shade {
namespace {

using scene::ColorStop;

const std::vector<ColorStop> kStops{{0.25, Color{0.0f}},
                                    {0.5, Color{1.0f, 0.5f, 0.0f}},
                                    {0.5, Color{0.0f, 0.0f, 2.0f}},
                                    {1.0, Color{0.0f, 1.0f, 0.0f}}};

void expect_near(DVec3 a, DVec3 b, double tolerance) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance);
}

template <class Function>
DVec3 mean_of(Function function, double from, double to) {
    constexpr int kSteps = 20000;
    DVec3 sum{0.0};
    for (int i = 0; i < kSteps; ++i) sum += function(from + (to - from) * (i + 0.5) / kSteps);
    return sum / static_cast<double>(kSteps);
}

TEST(ColorStops, BlendsBetweenStopsAndStaysBeyondThem) {
    const ColorStops stops(kStops);
    EXPECT_EQ(stops.value(-1e300), DVec3(0.0));
    EXPECT_EQ(stops.value(0.25), DVec3(0.0));
    EXPECT_EQ(stops.value(0.375), DVec3(0.5, 0.25, 0.0));
    EXPECT_EQ(stops.value(0.75), DVec3(0.0, 0.5, 1.0));
    EXPECT_EQ(stops.value(1.0), DVec3(0.0, 1.0, 0.0));
    EXPECT_EQ(stops.value(1e300), DVec3(0.0, 1.0, 0.0));
}

TEST(ColorStops, HardEdgeBelongsToWhatIsBehindIt) {
    const ColorStops stops(kStops);
    EXPECT_EQ(stops.value(0.5), DVec3(0.0, 0.0, 2.0));
    expect_near(stops.value(0.5 - 1e-12), {1.0, 0.5, 0.0}, 1e-9);
}

TEST(ColorStops, OneStopIsEverywhere) {
    const std::vector<ColorStop> one{{3.0, Color{0.5f}}};
    const ColorStops stops(one);
    for (const double at : {-5.0, 3.0, 9.0}) {
        EXPECT_EQ(stops.value(at), DVec3(0.5));
        EXPECT_EQ(stops.mean(at, 2.0), DVec3(0.5));
    }
}

TEST(ColorStops, MeanIsThatOfValues) {
    const ColorStops stops(kStops);
    test::Random random(4);
    for (int trial = 0; trial < 30; ++trial) {
        const double at = random.uniform(-0.5, 1.5);
        const double width = random.uniform(0.01, 2.0);
        const auto value = [&](double x) { return stops.value(x); };
        expect_near(stops.mean(at, width), mean_of(value, at - 0.5 * width, at + 0.5 * width),
                    1e-3);
    }
}

TEST(ColorStops, NoNumberIsTooLarge) {
    constexpr double kMax = std::numeric_limits<double>::max();
    const std::vector<ColorStop> far{{-kMax, Color{0.0f}}, {kMax, Color{1.0f}}};
    const ColorStops stops(far);
    for (const double at : {0.0, 1e300, -1e300, std::numeric_limits<double>::quiet_NaN()}) {
        for (const double width : {0.0, 1.0, 1e300}) {
            const DVec3 color = stops.mean(at, width);
            EXPECT_TRUE(color.x >= 0.0 && color.x <= 1.0) << at << ' ' << width;
        }
    }
}

TEST(Gradient, ComesAgainInEachUnit) {
    const Gradient gradient({scene::Axis::y, kStops});
    for (const double unit : {0.0, 1.0, -1.0, -3.0, 1024.0}) {
        EXPECT_EQ(test::color_of(gradient, {9.0, unit + 0.375, 9.0}, {}), Color(0.5f, 0.25f, 0.0f))
            << unit;
        EXPECT_EQ(test::color_of(gradient, {9.0, unit + 0.125, 9.0}, {}), Color(0.0f)) << unit;
    }
}

TEST(Gradient, FaceOnABorderOfUnitsHasOneColour) {
    const Gradient gradient({scene::Axis::x, {{0.0, Color{0.25f}}, {1.0, Color{1.0f}}}});
    for (const double border : {-2.0, 0.0, 1.0}) {
        for (const double error : {-1e-6, 0.0, 1e-6}) {
            EXPECT_NEAR(test::color_of(gradient, {border + error, 0.0, 0.0}, {}).r, 0.25f, 1e-5f);
        }
    }
}

TEST(Gradient, FootprintIsTheMeanOfItsPoints) {
    const Gradient gradient({scene::Axis::x, kStops});
    test::Random random(5);
    for (int trial = 0; trial < 30; ++trial) {
        const double at = random.uniform(-2.0, 2.0);
        const double width = random.uniform(0.01, 3.0);
        const auto value = [&](double x) {
            return DVec3{test::color_of(gradient, {x, 0.0, 0.0}, {})};
        };
        expect_near(DVec3{test::color_of(gradient, {at, 0.0, 0.0}, {{width, 0.0, 0.0}, 0.0})},
                    mean_of(value, at - 0.5 * width, at + 0.5 * width), 0.01);
    }
}

TEST(Ramp, DoesNotComeAgain) {
    const Ramp ramp({scene::Axis::z, {{-4.0, Color{0.0f}}, {4.0, Color{1.0f}}}});
    EXPECT_EQ(test::color_of(ramp, {0.0, 0.0, -5.0}, {}), Color(0.0f));
    EXPECT_EQ(test::color_of(ramp, {0.0, 0.0, -4.0}, {}), Color(0.0f));
    EXPECT_EQ(test::color_of(ramp, {0.0, 0.0, 2.0}, {}), Color(0.75f));
    EXPECT_EQ(test::color_of(ramp, {0.0, 0.0, 1e30}, {}), Color(1.0f));
    EXPECT_EQ(test::color_of(ramp, {0.0, 0.0, 4.0}, {{0.0, 0.0, 8.0}, 0.0}), Color(0.875f));
}

}  // namespace
}  // namespace lray::shade
