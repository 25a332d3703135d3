// The functions made of IEEE operations, against those of the C library.
#include "base/portable_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace lray {
namespace {

TEST(PortableMath, CircleIsThatOfSineAndCosine) {
    for (int i = 0; i <= 100'000; ++i) {
        const double turns = i / 100'000.0;
        const DVec2 point = unit_circle_point(turns);
        EXPECT_NEAR(point.x, std::cos(2.0 * std::numbers::pi * turns), 1.2e-15) << turns;
        EXPECT_NEAR(point.y, std::sin(2.0 * std::numbers::pi * turns), 1.2e-15) << turns;
        EXPECT_NEAR(glm::dot(point, point), 1.0, 5e-16) << turns;
    }
}

TEST(PortableMath, CircleIsExactAtQuarters) {
    EXPECT_EQ(unit_circle_point(0.0), (DVec2{1, 0}));
    EXPECT_EQ(unit_circle_point(0.25), (DVec2{0, 1}));
    EXPECT_EQ(unit_circle_point(0.5), (DVec2{-1, 0}));
    EXPECT_EQ(unit_circle_point(0.75), (DVec2{0, -1}));
    EXPECT_EQ(unit_circle_point(1.0), (DVec2{1, 0}));
}

TEST(PortableMath, TurnsAreThoseOfTheArctangent) {
    for (int i = 0; i < 200'000; ++i) {
        const double turns = i / 200'000.0;
        for (const double length : {1.0, 1e-200, 1e200}) {
            EXPECT_NEAR(turns_of(length * unit_circle_point(turns)), turns, 6e-16) << turns;
        }
        const double angle = std::atan2(i - 7e4, 1e5) / (2.0 * std::numbers::pi);
        EXPECT_NEAR(turns_of({1e5, i - 7e4}), angle < 0.0 ? 1.0 + angle : angle, 6e-16) << i;
    }
}

TEST(PortableMath, TurnsAreExactAtQuarters) {
    EXPECT_EQ(turns_of({2, 0}), 0.0);
    EXPECT_EQ(turns_of({2, -0.0}), 0.0);
    EXPECT_EQ(turns_of({0, 3}), 0.25);
    EXPECT_EQ(turns_of({-1, 0}), 0.5);
    EXPECT_EQ(turns_of({0, -1}), 0.75);
    EXPECT_EQ(turns_of({0, 0}), 0.0);
}

TEST(PortableMath, LogarithmIsThatOfTheLibrary) {
    EXPECT_EQ(natural_logarithm(1.0), 0.0);
    for (double x = 0x1p-53; x < 1e18; x *= 1.0009) {
        const double expected = std::log(x);
        EXPECT_NEAR(natural_logarithm(x), expected, 4e-16 * (1.0 + std::fabs(expected))) << x;
    }
    EXPECT_NEAR(natural_logarithm(std::numeric_limits<double>::max()), 709.782712893384, 1e-12);
}

TEST(PortableMath, ExponentialIsThatOfTheLibrary) {
    for (int i = -70'000; i <= 70'000; ++i) {
        const double x = i / 100.0 + i * 1e-9;
        EXPECT_NEAR(exponential(x) / std::exp(x), 1.0, 1e-15) << x;
    }
    for (const double x : {1e-300, 1e-17, 1e-9, 0.3465735, 0.3465736, -1e-9}) {
        EXPECT_NEAR(exponential(x) / std::exp(x), 1.0, 1e-15) << x;
    }
    EXPECT_EQ(exponential(0.0), 1.0);
    EXPECT_EQ(exponential(-0.0), 1.0);
}

}  // namespace
}  // namespace lray
