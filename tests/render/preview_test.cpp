#include "render/preview.h"

#include <gtest/gtest.h>

namespace lray::render {
namespace {

TEST(FirstSquare, IsTheUsualOneWithoutMeasurements) {
    EXPECT_EQ(first_square(0.0, 1'000'000), kUsualSquare);
}

TEST(FirstSquare, MakesTheFirstStepQuickEnough) {
    for (double seconds_per_ray = 1e-10; seconds_per_ray < 1.0; seconds_per_ray *= 1.7) {
        constexpr std::uint64_t kPixels = 1280 * 720;
        const std::uint32_t square = first_square(seconds_per_ray, kPixels);
        const auto seconds_of = [&](double side) {
            return seconds_per_ray * static_cast<double>(kPixels) / (side * side);
        };
        if (square < kLargestSquare) {
            EXPECT_LE(seconds_of(square), kFirstStepSeconds);
        }
        if (square > 1) {
            EXPECT_GT(seconds_of(square / 2.0), kFirstStepSeconds);
        }
        EXPECT_EQ(square & (square - 1), 0u);
    }
}

TEST(MiddlesOfSquares, LieInTheSquaresThatThePartCutsOff) {
    const std::vector<FilmPlace> middles = middles_of_squares({8, 16, 18, 21}, 8);
    ASSERT_EQ(middles.size(), 2u);
    EXPECT_EQ(middles[0].x, 12u);
    EXPECT_EQ(middles[0].y, 18u);  // of rows 16 to 21
    EXPECT_EQ(middles[1].x, 17u);  // of columns 16 to 18
}

TEST(MiddlesOfSquares, OfSinglePixelsAreThePixels) {
    const std::vector<FilmPlace> middles = middles_of_squares({3, 4, 5, 6}, 1);
    ASSERT_EQ(middles.size(), 4u);
    EXPECT_EQ(middles[3].x, 4u);
    EXPECT_EQ(middles[3].y, 5u);
}

}  // namespace
}  // namespace lray::render
