#include "base/numerics.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace lray {
namespace {

constexpr float kLargest = std::numeric_limits<float>::max();
constexpr float kLeast = std::numeric_limits<float>::denorm_min();

void expect_same_bits(float a, float b, float x) {
    EXPECT_EQ(std::bit_cast<std::uint32_t>(a), std::bit_cast<std::uint32_t>(b)) << x;
}

TEST(Numerics, NextUpAndDownAgreeWithTheLibrary) {
    constexpr std::uint32_t kSeed = 1;
    std::mt19937 random(kSeed);
    for (int i = 0; i < 100'000; ++i) {
        const float x = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        if (std::isnan(x)) continue;
        expect_same_bits(next_up(x), std::nextafter(x, kInfinity), x);
        expect_same_bits(next_down(x), std::nextafter(x, -kInfinity), x);
    }
}

TEST(Numerics, NextUpAndDownAtTheEndsOfTheRange) {
    EXPECT_EQ(next_up(0.0f), kLeast);
    EXPECT_EQ(next_up(-0.0f), kLeast);
    EXPECT_EQ(next_down(0.0f), -kLeast);
    EXPECT_EQ(next_up(-kLeast), 0.0f);
    EXPECT_EQ(next_up(kLargest), kInfinity);
    EXPECT_EQ(next_up(kInfinity), kInfinity);
    EXPECT_EQ(next_up(-kInfinity), -kLargest);
    EXPECT_EQ(next_down(-kInfinity), -kInfinity);
    EXPECT_TRUE(std::isnan(next_up(std::numeric_limits<float>::quiet_NaN())));
}

TEST(Numerics, RoundUpAndDownEncloseTightly) {
    constexpr std::uint64_t kSeed = 2;
    std::mt19937_64 random(kSeed);
    std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
    std::uniform_int_distribution<int> exponent(-160, 130);
    for (int i = 0; i < 100'000; ++i) {
        const double x = std::ldexp(mantissa(random), exponent(random));
        const float up = round_up(x);
        const float down = round_down(x);
        ASSERT_GE(static_cast<double>(up), x);
        ASSERT_LE(static_cast<double>(down), x);
        ASSERT_TRUE(down == up || next_up(down) == up) << x;
    }
}

TEST(Numerics, RoundingKeepsWhatAFloatCanHold) {
    for (const float x : {0.0f, 1.0f, -0.1f, kLargest, -kLeast, kInfinity}) {
        EXPECT_EQ(round_up(static_cast<double>(x)), x);
        EXPECT_EQ(round_down(static_cast<double>(x)), x);
    }
    EXPECT_EQ(round_up(1e300), kInfinity);
    EXPECT_EQ(round_down(1e300), kLargest);
    EXPECT_EQ(round_up(-1e300), -kLargest);
    EXPECT_EQ(round_down(-1e300), -kInfinity);
}

TEST(Numerics, GammaBoundsTheErrorOfAProduct) {
    EXPECT_GT(gamma<float>(3), 3.0f * kUnitRoundoff<float>);
    EXPECT_LT(gamma<float>(3), 3.001f * kUnitRoundoff<float>);
}

}  // namespace
}  // namespace lray
