#include "shade/textures/cell.h"

#include <gtest/gtest.h>

#include <limits>

#include "shade/textures/periodic.h"
#include "tests/support/random.h"

namespace lray::shade {
namespace {

TEST(Cell, IndexIsTheGreatestWholeNumberNotAbove) {
    EXPECT_EQ(Cell(2.75).index, 2);
    EXPECT_EQ(Cell(2.75).inside, 0.75);
    EXPECT_EQ(Cell(-2.75).index, -3);
    EXPECT_EQ(Cell(-2.75).inside, 0.25);
    EXPECT_EQ(Cell(-3.0).index, -3);
    EXPECT_EQ(Cell(-3.0).inside, 0.0);
    EXPECT_TRUE(Cell(-3.0).is_odd());
    EXPECT_FALSE(Cell(-2.0).is_odd());
    EXPECT_EQ(Cell(-1e-300).index, -1);
    EXPECT_EQ(Cell(-1e-300).inside, 1.0);  // rounded
}

TEST(Cell, WhatHasNoPlaceInACellIsAtTheBeginningOfTheFirst) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    for (const double x : {0x1p62, -0x1p62, 1e300, kInfinite, -kInfinite,
                           std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_EQ(Cell(x).index, 0) << x;
        EXPECT_EQ(Cell(x).inside, 0.0) << x;
    }
    EXPECT_EQ(Cell(0x1p61).index, std::int64_t{1} << 61);
}

/// t squared in each unit.
struct Squares {
    static double value(double t) { return t * t; }
    static double integral(double t) { return t * t * t / 3.0; }
};

TEST(MeanOfPeriodic, IsTheIntegralOverTheWidth) {
    const Squares squares;
    EXPECT_EQ(mean_of_periodic(squares, 3.5, 0.0), 0.25);
    EXPECT_NEAR(mean_of_periodic(squares, -3.5, 1.0), 1.0 / 3.0, 1e-15);
    EXPECT_NEAR(mean_of_periodic(squares, 7.0, 0.5), (1.0 - 27.0 / 64.0 + 1.0 / 64.0) / 1.5, 1e-15);
    EXPECT_NEAR(mean_of_periodic(squares, 7.25, 1e6), 1.0 / 3.0, 1e-6);
    EXPECT_EQ(mean_of_periodic(squares, 7.25, std::numeric_limits<double>::infinity()), 1.0 / 3.0);
    test::Random random(25);
    for (int trial = 0; trial < 50; ++trial) {
        // Narrow means are all but values, on both sides of where integrals are no longer taken.
        const double x = random.uniform(-5.0, 5.0);
        const double inside = Cell(x).inside;
        if (inside < 0.01 || inside > 0.99) continue;
        EXPECT_NEAR(mean_of_periodic(squares, x, 0x1.1p-20), inside * inside, 1e-9);
    }
}

}  // namespace
}  // namespace lray::shade
