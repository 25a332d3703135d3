// Keyed random numbers: the numbers that the language promises, and that they look random.
#include "base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace lray {
namespace {

// Worked out with Python's integers from the definition in words.
TEST(KeyedRandom, NumbersAreThoseOfTheDefinition) {
    EXPECT_EQ(KeyedRandom{}.with(0.0).bits(), 0xe220a8397b1dcdafu);
    EXPECT_EQ(KeyedRandom{}.with(1.0).bits(), 0x88d7c35bbbf3eded);
    EXPECT_EQ(KeyedRandom{}.with(42.0).number(), 0x1.5af16cca03a66p-1);
    EXPECT_EQ(KeyedRandom{}.with(42.0).with(0.0).number(), 0x1.d3be6d79d93ccp-2);
    EXPECT_EQ(KeyedRandom{}.with(42.0).with(1.0).with(2.0).number(), 0x1.f6c9eafe581c8p-2);
    EXPECT_EQ(KeyedRandom{}.with(0.1).number(), 0x1.f047c9da5f625p-1);
    EXPECT_EQ(KeyedRandom{}.with("tree").bits(), 0xd2628b79920afe06u);
    EXPECT_EQ(KeyedRandom{}.with("").bits(), 0xc3817c016ba4ff30u);
    EXPECT_EQ(KeyedRandom{}.with(42.0).with("tree").with(1.0).number(), 0x1.678ca3f8dc726p-2);
}

TEST(KeyedRandom, NegativeZeroIsZero) {
    EXPECT_EQ(KeyedRandom{}.with(-0.0).bits(), KeyedRandom{}.with(0.0).bits());
}

TEST(KeyedRandom, OrderOfKeysMatters) {
    EXPECT_NE(KeyedRandom{}.with(1.0).with(2.0).bits(), KeyedRandom{}.with(2.0).with(1.0).bits());
    EXPECT_NE(KeyedRandom{}.with(1.0).bits(), KeyedRandom{}.with(1.0).with(0.0).bits());
}

TEST(KeyedRandom, NumbersStayBelowOne) {
    // The greatest 64 bits are made by some key; the number is cut down, not rounded up.
    EXPECT_EQ(static_cast<double>((~std::uint64_t{0}) >> 11) * 0x1p-53, 1.0 - 0x1p-53);
}

struct Moments {
    double mean = 0.0;
    double variance = 0.0;
    double chi_square = 0.0;  // of 64 equal bins: 63 degrees of freedom
};

template <class Sample>
Moments moments_of(int count, Sample sample) {
    std::array<int, 64> bins{};
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < count; ++i) {
        const double x = sample(i);
        EXPECT_TRUE(x >= 0.0 && x < 1.0) << x;
        sum += x;
        squares += x * x;
        ++bins[std::min<std::size_t>(static_cast<std::size_t>(x * 64.0), 63)];
    }
    Moments moments;
    moments.mean = sum / count;
    moments.variance = squares / count - moments.mean * moments.mean;
    const double expected = count / 64.0;
    for (const int bin : bins) moments.chi_square += (bin - expected) * (bin - expected) / expected;
    return moments;
}

// The 0.1 % and 99.9 % points of chi-square with 63 degrees of freedom are 32.5 and 103.4; the
// standard error of the mean of 2^16 numbers is 0.0011. The numbers are fixed, so the tests are.
void expect_uniform(const Moments& moments) {
    EXPECT_NEAR(moments.mean, 0.5, 0.0035);
    EXPECT_NEAR(moments.variance, 1.0 / 12.0, 0.0012);
    EXPECT_GT(moments.chi_square, 32.5);
    EXPECT_LT(moments.chi_square, 103.4);
}

TEST(KeyedRandom, CountersGiveUniformNumbers) {
    expect_uniform(moments_of(1 << 16, [](int i) { return KeyedRandom{}.with(i).number(); }));
    expect_uniform(
        moments_of(1 << 16, [](int i) { return KeyedRandom{}.with(42.0).with(i).number(); }));
    expect_uniform(
        moments_of(1 << 16, [](int i) { return KeyedRandom{}.with(i).with(42.0).number(); }));
    expect_uniform(moments_of(1 << 16, [](int i) {
        return KeyedRandom{}.with(7.0).with(i % 256).with(i / 256).number();
    }));
}

TEST(KeyedRandom, IntegerKeysGiveUniformNumbers) {
    expect_uniform(moments_of(1 << 16, [](int i) {
        return KeyedRandom{}.with_bits(static_cast<std::uint64_t>(i)).number();
    }));
}

TEST(KeyedRandom, NeighborsAreNotCorrelated) {
    constexpr int kCount = 1 << 16;
    double sum = 0.0;
    for (int i = 0; i < kCount; ++i) {
        const auto at = [](int k) { return KeyedRandom{}.with(3.0).with(k).number() - 0.5; };
        sum += at(i) * at(i + 1);
    }
    EXPECT_NEAR(sum / kCount / (1.0 / 12.0), 0.0, 4.0 / 256.0);  // four standard errors
}

TEST(MixBits, EachBitChangesHalfOfTheResult) {
    constexpr int kCount = 1000;
    for (int bit = 0; bit < 64; ++bit) {
        int changed = 0;
        for (int i = 0; i < kCount; ++i) {
            const std::uint64_t x = static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15u;
            changed += std::popcount(mix_bits(x) ^ mix_bits(x ^ (std::uint64_t{1} << bit)));
        }
        EXPECT_NEAR(changed / double{kCount}, 32.0, 1.0) << bit;
    }
}

}  // namespace
}  // namespace lray
