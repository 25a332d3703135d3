#include "base/angle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lray {
namespace {

TEST(Angle, QuarterTurnsAreExact) {
    for (int turns = -3; turns <= 3; ++turns) {
        const double full = 360.0 * turns;
        EXPECT_EQ(sin_degrees(full), 0.0);
        EXPECT_EQ(sin_degrees(full + 90.0), 1.0);
        EXPECT_EQ(sin_degrees(full + 180.0), 0.0);
        EXPECT_EQ(sin_degrees(full + 270.0), -1.0);
        EXPECT_EQ(cos_degrees(full), 1.0);
        EXPECT_EQ(cos_degrees(full + 90.0), 0.0);
        EXPECT_EQ(cos_degrees(full + 180.0), -1.0);
        EXPECT_EQ(cos_degrees(full + 270.0), 0.0);
    }
}

TEST(Angle, HalvesAreExact) {
    EXPECT_EQ(sin_degrees(30.0), 0.5);
    EXPECT_EQ(sin_degrees(150.0), 0.5);
    EXPECT_EQ(sin_degrees(210.0), -0.5);
    EXPECT_EQ(sin_degrees(-30.0), -0.5);
    EXPECT_EQ(cos_degrees(60.0), 0.5);
    EXPECT_EQ(cos_degrees(120.0), -0.5);
    EXPECT_EQ(cos_degrees(240.0), -0.5);
    EXPECT_EQ(cos_degrees(300.0), 0.5);
}

TEST(Angle, SineAndCosineAgreeWithLongDouble) {
    const long double degree = 3.141592653589793238462643383279502884L / 180.0L;
    for (int i = -7200; i <= 7200; ++i) {
        const double angle = 0.1 * i;
        const long double exact = static_cast<long double>(angle) * degree;
        EXPECT_NEAR(sin_degrees(angle), static_cast<double>(std::sin(exact)), 4e-16) << angle;
        EXPECT_NEAR(cos_degrees(angle), static_cast<double>(std::cos(exact)), 4e-16) << angle;
    }
}

TEST(Angle, SineIsOddAndCosineEvenToTheBit) {
    for (double angle = 0.0; angle < 800.0; angle += 0.37) {
        EXPECT_EQ(sin_degrees(-angle), -sin_degrees(angle)) << angle;
        EXPECT_EQ(cos_degrees(-angle), cos_degrees(angle)) << angle;
    }
}

TEST(Angle, NoNumberForWhatIsNoAngle) {
    EXPECT_TRUE(std::isnan(sin_degrees(std::numeric_limits<double>::infinity())));
    EXPECT_TRUE(std::isnan(cos_degrees(std::numeric_limits<double>::quiet_NaN())));
}

TEST(Angle, DegreesAndRadiansAreInverse) {
    EXPECT_DOUBLE_EQ(radians(180.0), 3.14159265358979323846);
    EXPECT_DOUBLE_EQ(degrees(radians(37.5)), 37.5);
}

}  // namespace
}  // namespace lray
