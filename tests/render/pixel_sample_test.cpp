#include "render/pixel_sample.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace lray::render {
namespace {

TEST(PixelSample, CentreIsTheSameForEverySample) {
    for (const std::uint32_t sample : {0u, 1u, 32767u}) {
        EXPECT_EQ(sample_position(PixelPosition::center, 3, 7, 11, sample), DVec2(7.5, 11.5));
    }
}

TEST(PixelSample, RandomPositionsLieInTheirPixel) {
    for (std::uint32_t sample = 0; sample < 10'000; ++sample) {
        const DVec2 position = sample_position(PixelPosition::random, 5, 640, 1u << 20, sample);
        ASSERT_GE(position.x, 640.0);
        ASSERT_LT(position.x, 641.0);
        ASSERT_GE(position.y, 1048576.0);
        ASSERT_LT(position.y, 1048577.0);
    }
}

TEST(PixelSample, NumbersAreFixed) {
    // Pictures change when these do: they are the promise of `same seed, same bits`.
    const DVec2 first = sample_pair(0, 0, 0, 0, kPositionPair);
    const DVec2 other = sample_pair(42, 799, 599, 15, kPositionPair);
    EXPECT_EQ(first * 0x1p32, DVec2(872319956.0, 4190468195.0));
    EXPECT_EQ(other * 0x1p32, DVec2(1604575123.0, 2086947641.0));
}

TEST(PixelSample, EveryKeyCounts) {
    const auto as_pair = [](DVec2 v) { return std::pair(v.x, v.y); };
    std::set<std::pair<double, double>> seen;
    for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}}) {
        for (const std::uint32_t x : {0u, 1u, 0x7fffffffu}) {
            for (const std::uint32_t y : {0u, 1u, 0x7fffffffu}) {
                for (const std::uint32_t sample : {0u, 1u, 32767u}) {
                    for (const std::uint64_t pair : {0u, 1u}) {
                        seen.insert(as_pair(sample_pair(seed, x, y, sample, pair)));
                    }
                }
            }
        }
    }
    EXPECT_EQ(seen.size(), 3u * 3u * 3u * 3u * 2u);
}

/// The sum of squared deviations of the counts of `cells` equally likely cells.
template <std::size_t cells>
double chi_square(const std::array<int, cells>& counts, int total) {
    const double expected = static_cast<double>(total) / static_cast<double>(cells);
    double sum = 0.0;
    for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
    return sum;
}

/// About the chi-square value that is exceeded once in a million.
/// Source: Wilson, Hilferty 1931, "The Distribution of Chi-Square".
double chi_square_limit(double freedom) {
    const double spread = 2.0 / (9.0 * freedom);
    const double root = 1.0 - spread + 4.75 * std::sqrt(spread);
    return freedom * root * root * root;
}

template <class Position>
void expect_uniform(Position position) {
    constexpr int kSide = 16;
    constexpr int kTotal = 100'000;
    std::array<int, kSide * kSide> counts{};
    for (int i = 0; i < kTotal; ++i) {
        const DVec2 at = position(static_cast<std::uint32_t>(i));
        ++counts[static_cast<std::size_t>(at.x * kSide) * kSide +
                 static_cast<std::size_t>(at.y * kSide)];
    }
    EXPECT_LT(chi_square(counts, kTotal), chi_square_limit(kSide * kSide - 1));
    EXPECT_GT(chi_square(counts, kTotal), 150.0) << "too even to be random";
}

TEST(PixelSample, PositionsAreUniformOverSamplesPixelsAndSeeds) {
    expect_uniform([](std::uint32_t i) { return sample_pair(0, 17, 4, i, 0); });
    expect_uniform([](std::uint32_t i) { return sample_pair(0, i, 4, 0, 0); });
    expect_uniform([](std::uint32_t i) { return sample_pair(0, 17, i, 0, 0); });
    expect_uniform([](std::uint32_t i) { return sample_pair(0, i % 317, i / 317, 2, 0); });
    expect_uniform([](std::uint32_t i) { return sample_pair(i, 17, 4, 0, 0); });
    expect_uniform([](std::uint32_t i) { return sample_pair(0, 17, 4, 0, i); });
}

TEST(PixelSample, NeighboursAreIndependent) {
    // Of a sample and the next one, and of a pixel and the next one, each its first number.
    expect_uniform([](std::uint32_t i) {
        return DVec2{sample_pair(0, 17, 4, i, 0).x, sample_pair(0, 17, 4, i + 1, 0).x};
    });
    expect_uniform([](std::uint32_t i) {
        return DVec2{sample_pair(0, i, 4, 3, 0).y, sample_pair(0, i + 1, 4, 3, 0).y};
    });
    expect_uniform([](std::uint32_t i) {
        return DVec2{sample_pair(i, 9, 4, 3, 0).x, sample_pair(i + 1, 9, 4, 3, 0).y};
    });
}

}  // namespace
}  // namespace lray::render
