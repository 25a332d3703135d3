#include "base/sampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace lray {
namespace {

/// Point `index` by its definition: of the primitive polynomial x + 1 with m_1 = 1 come the
/// direction numbers m_k = 2 m_(k-1) xor m_(k-1), and v_k = m_k 2^(32-k).
/// Source: Bratley, Fox 1988, "Algorithm 659", sec. 2.
std::uint32_t sobol_second_by_definition(std::uint32_t index) {
    std::uint64_t m = 1;
    std::uint32_t result = 0;
    for (int k = 1; k <= 32; ++k) {
        if (((index >> (k - 1)) & 1u) != 0) result ^= static_cast<std::uint32_t>(m << (32 - k));
        m = (2 * m) ^ m;
    }
    return result;
}

TEST(Sobol, SecondDimensionIsThatOfItsDirectionNumbers) {
    for (std::uint32_t index = 0; index < 70'000; ++index) {
        ASSERT_EQ(reverse_bits(sobol_second_reversed(index)), sobol_second_by_definition(index))
            << index;
    }
    KeyedRandom keys;
    for (std::uint64_t i = 0; i < 10'000; ++i) {
        const auto index = static_cast<std::uint32_t>(keys.with_bits(i).bits());
        ASSERT_EQ(reverse_bits(sobol_second_reversed(index)), sobol_second_by_definition(index))
            << index;
    }
}

TEST(Sobol, FirstPointsAreTheKnownOnes) {
    constexpr std::array<double, 8> kSecond{0.0, 0.5, 0.75, 0.25, 0.625, 0.125, 0.375, 0.875};
    for (std::uint32_t i = 0; i < kSecond.size(); ++i) {
        EXPECT_EQ(static_cast<double>(reverse_bits(sobol_second_reversed(i))) * 0x1p-32, kSecond[i])
            << i;
    }
}

TEST(ReverseBits, EveryBitGoesToItsMirror) {
    for (int bit = 0; bit < 32; ++bit) {
        EXPECT_EQ(reverse_bits(std::uint32_t{1} << bit), std::uint32_t{1} << (31 - bit));
    }
    EXPECT_EQ(reverse_bits(0x12345678u), 0x1e6a2c48u);
}

TEST(OwenScramble, ABitDependsOnTheHigherOnesAlone) {
    KeyedRandom keys;
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const std::uint64_t bits = keys.with_bits(i).bits();
        const auto x = static_cast<std::uint32_t>(bits);
        const auto seed = static_cast<std::uint32_t>(bits >> 32);
        for (int bit = 0; bit < 32; ++bit) {
            const std::uint32_t changed = x ^ (std::uint32_t{1} << bit);
            const std::uint32_t difference = owen_scramble(x, seed) ^ owen_scramble(changed, seed);
            ASSERT_EQ(difference >> bit, 1u) << "that bit changes, and none above it";
        }
    }
}

// Each bit that is flipped or not is a coin of its own for each value of the bits above it: over
// many seeds half of the coins show heads, and two coins agree as often as not.
TEST(OwenScramble, FlipsAreFairAndIndependentOverSeeds) {
    constexpr std::uint32_t kSeeds = 4096;
    constexpr double kBound = 5.0 * 0.5 * 64.0;  // five standard deviations of 4096 coins
    KeyedRandom keys;
    const auto flip = [](std::uint32_t x, int bit, std::uint32_t seed) {
        return ((owen_scramble(x, seed) ^ x) >> bit) & 1u;
    };
    for (const int bit : {31, 30, 28, 24, 20}) {
        const std::uint32_t other = std::uint32_t{1} << 31;
        double heads = 0.0;
        double agreements = 0.0;
        for (std::uint32_t i = 0; i < kSeeds; ++i) {
            const auto seed = static_cast<std::uint32_t>(keys.with_bits(i).bits());
            heads += flip(0, bit, seed);
            agreements += flip(0, bit, seed) == flip(other, bit, seed) ? 1.0 : 0.0;
        }
        EXPECT_NEAR(heads, kSeeds / 2.0, kBound) << bit;
        if (bit != 31) {  // no bit is above the highest: it has one coin
            EXPECT_NEAR(agreements, kSeeds / 2.0, kBound) << bit;
        }
    }
}

using Numbers = std::pair<std::uint32_t, std::uint32_t>;

Numbers as_numbers(DVec2 pair) {
    return {static_cast<std::uint32_t>(pair.x * 0x1p32),
            static_cast<std::uint32_t>(pair.y * 0x1p32)};
}

/// True if each elementary interval of area 2^-log2_count holds exactly one of the points.
bool is_net(const std::vector<Numbers>& points, int log2_count) {
    for (int columns = 0; columns <= log2_count; ++columns) {
        const int rows = log2_count - columns;
        std::vector<bool> is_taken(points.size());
        for (const auto& [x, y] : points) {
            const std::uint64_t column = (std::uint64_t{x} << columns) >> 32;
            const std::uint64_t row = (std::uint64_t{y} << rows) >> 32;
            const std::uint64_t cell = row << columns | column;
            if (is_taken[cell]) return false;
            is_taken[cell] = true;
        }
    }
    return true;
}

TEST(PixelSample, EveryAlignedPowerOfTwoIsANet) {
    for (std::uint32_t pixel = 0; pixel < 8; ++pixel) {
        for (int log2_count = 0; log2_count <= 10; ++log2_count) {
            const std::uint32_t count = std::uint32_t{1} << log2_count;
            for (const std::uint32_t block : {0u, 1u, 5u}) {
                std::vector<Numbers> points;
                for (std::uint32_t i = block * count; i < (block + 1) * count; ++i) {
                    const auto sample = PixelSample::of(SamplerKind::sobol, 3, pixel, 7, i);
                    points.push_back(as_numbers(sample.pair(11 + pixel)));
                }
                ASSERT_TRUE(is_net(points, log2_count))
                    << pixel << ": " << count << " of " << block;
            }
        }
    }
}

TEST(PixelSample, PartsOfADecisionMakeOneNet) {
    std::vector<Numbers> points;
    for (std::uint32_t index = 0; index < 16; ++index) {
        const auto sample = PixelSample::of(SamplerKind::sobol, 1, 2, 3, index);
        for (std::uint32_t part = 0; part < 4; ++part) {
            points.push_back(as_numbers(sample.pair(5, part, 4)));
        }
    }
    EXPECT_TRUE(is_net(points, 6));
}

TEST(PixelSample, RandomNumbersMakeNoNet) {
    std::vector<Numbers> points;
    for (std::uint32_t i = 0; i < 64; ++i) {
        points.push_back(as_numbers(PixelSample::of(SamplerKind::random, 3, 1, 7, i).pair(0)));
    }
    EXPECT_FALSE(is_net(points, 6)) << "or the test of nets cannot fail";
}

constexpr std::array kKinds{SamplerKind::sobol, SamplerKind::random};
constexpr std::size_t kCells = 16;

/// The sum of (found - expected)^2 / expected.
double chi_square(const std::vector<std::uint32_t>& found, double expected) {
    double sum = 0.0;
    for (const std::uint32_t count : found)
        sum += (count - expected) * (count - expected) / expected;
    return sum;
}

/// Five standard deviations above the mean of a chi-square with so many degrees of freedom.
double chi_square_bound(double freedom) {
    return freedom + 5.0 * std::sqrt(2.0 * freedom);
}

// What one sample sees over many pixels: nothing is spread on purpose there.
TEST(PixelSample, OneSampleIsUniformOverPixels) {
    for (const SamplerKind kind : kKinds) {
        for (const std::uint32_t index : {0u, 1u, 6u, 32767u}) {
            std::vector<std::uint32_t> found(kCells * kCells);
            for (std::uint32_t pixel = 0; pixel < 65'536; ++pixel) {
                const auto sample = PixelSample::of(kind, 0, pixel % 256, pixel / 256, index);
                const DVec2 pair = sample.pair(0);
                ++found[static_cast<std::size_t>(pair.y * kCells) * kCells +
                        static_cast<std::size_t>(pair.x * kCells)];
            }
            EXPECT_LT(chi_square(found, 256.0), chi_square_bound(255.0)) << index;
        }
    }
}

template <class Pair>
void expect_uniform(const Pair& pair) {
    std::vector<std::uint32_t> found(kCells * kCells);
    for (std::uint32_t i = 0; i < 65'536; ++i) {
        const DVec2 at = pair(i);
        ++found[static_cast<std::size_t>(at.y * kCells) * kCells +
                static_cast<std::size_t>(at.x * kCells)];
    }
    EXPECT_LT(chi_square(found, 256.0), chi_square_bound(255.0));
    EXPECT_GT(chi_square(found, 256.0), 150.0) << "too even to be random";
}

TEST(PixelSample, SeedsDecisionsAndNeighboursAreIndependent) {
    for (const SamplerKind kind : kKinds) {
        const auto of = [&](std::uint64_t seed, std::uint32_t x, std::uint32_t index) {
            return PixelSample::of(kind, seed, x, 4, index);
        };
        expect_uniform([&](std::uint32_t i) { return of(i, 17, 0).pair(0); });
        expect_uniform([&](std::uint32_t i) { return of(0, 17, 0).pair(i); });
        expect_uniform([&](std::uint32_t i) {
            return DVec2{of(i, 17, 0).pair(0).x, of(i + 1, 17, 0).pair(0).y};
        });
        expect_uniform([&](std::uint32_t i) {
            return DVec2{of(0, i, 3).pair(0).y, of(0, i + 1, 3).pair(0).y};
        });
        // The same sample of other numbers of samples, as of pixels that have not the same.
        expect_uniform([&](std::uint32_t i) {
            return DVec2{of(0, i, 3).pair(0).x, of(0, i, 4).pair(1).x};
        });
    }
}

TEST(PixelSample, RandomIsUniformInOnePixelAndSobolMoreEvenThanThat) {
    for (const SamplerKind kind : kKinds) {
        std::vector<std::uint32_t> found(kCells * kCells);
        for (std::uint32_t index = 0; index < 20'000; ++index) {
            const DVec2 pair = PixelSample::of(kind, 9, 100, 200, index).pair(1);
            ++found[static_cast<std::size_t>(pair.y * kCells) * kCells +
                    static_cast<std::size_t>(pair.x * kCells)];
        }
        const double evenness = chi_square(found, 20'000.0 / 256.0);
        EXPECT_LT(evenness, chi_square_bound(255.0));
        if (kind == SamplerKind::sobol) {
            EXPECT_LT(evenness, 25.0);
        }
    }
}

TEST(PixelSample, DecisionsAreIndependentOfEachOther) {
    for (const SamplerKind kind : kKinds) {
        for (const auto& [first, second] : {std::pair<std::uint64_t, std::uint64_t>{0, 1},
                                            {1, 2},
                                            {0, std::uint64_t{1} << 63},
                                            {7, std::uint64_t{7} << 32}}) {
            std::vector<std::uint32_t> found(kCells * kCells);
            for (std::uint32_t pixel = 0; pixel < 1024; ++pixel) {
                for (std::uint32_t index = 0; index < 64; ++index) {
                    const auto sample = PixelSample::of(kind, 4, pixel, 0, index);
                    const double a = sample.pair(first).y;
                    const double b = sample.pair(second).x;
                    ++found[static_cast<std::size_t>(a * kCells) * kCells +
                            static_cast<std::size_t>(b * kCells)];
                }
            }
            EXPECT_LT(chi_square(found, 256.0), chi_square_bound(255.0)) << first << second;
        }
    }
}

TEST(PixelSample, EveryKeyCounts) {
    for (const SamplerKind kind : kKinds) {
        std::set<Numbers> seen;
        std::size_t count = 0;
        for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}}) {
            for (const std::uint32_t x : {0u, 1u, 0x7fffffffu}) {
                for (const std::uint32_t y : {0u, 1u, 0x7fffffffu}) {
                    for (const std::uint32_t index : {0u, 1u, 32767u}) {
                        for (const std::uint64_t decision : {0u, 1u}) {
                            const auto sample = PixelSample::of(kind, seed, x, y, index);
                            seen.insert(as_numbers(sample.pair(decision)));
                            ++count;
                        }
                    }
                }
            }
        }
        EXPECT_EQ(seen.size(), count);
    }
}

TEST(PixelSample, NumbersAreFixed) {
    // Pictures change when these do: they are the promise of `same seed, same bits`.
    const auto numbers = [](SamplerKind kind, std::uint64_t seed, std::uint32_t x, std::uint32_t y,
                            std::uint32_t index, std::uint64_t decision) {
        return as_numbers(PixelSample::of(kind, seed, x, y, index).pair(decision));
    };
    EXPECT_EQ(numbers(SamplerKind::sobol, 0, 0, 0, 0, 0), Numbers(1655553208u, 1173947427u));
    EXPECT_EQ(numbers(SamplerKind::sobol, 42, 799, 599, 15, 1), Numbers(3328817214u, 124437833u));
    EXPECT_EQ(numbers(SamplerKind::random, 0, 0, 0, 0, 0), Numbers(425174880u, 1310806392u));
    EXPECT_EQ(numbers(SamplerKind::random, 42, 799, 599, 15, 1), Numbers(1593630020u, 2841532799u));
}

}  // namespace
}  // namespace lray
