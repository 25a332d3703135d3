// Noise: its range, its smoothness, that it does not repeat or prefer a direction, and its exact
// values.
#include "base/noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/lattice.h"
#include "base/portable_math.h"
#include "base/random.h"

namespace lray {
namespace {

const NoiseSeed kSeed{KeyedRandom{}.with(7.0)};

double uniform(int i, int dimension) {
    return KeyedRandom{}.with("noise test").with(i).with(dimension).number();
}

DVec3 point(int i, double size = 100.0) {
    return size * (DVec3{uniform(i, 0), uniform(i, 1), uniform(i, 2)} - 0.5);
}

struct Range {
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();
    double sum = 0.0;
    double squares = 0.0;
    int count = 0;

    void add(double x) {
        min = std::min(min, x);
        max = std::max(max, x);
        sum += x;
        squares += x * x;
        ++count;
    }
    double mean() const { return sum / count; }
    double rms() const { return std::sqrt(squares / count); }
};

template <class Function>
Range range_of(Function function) {
    Range range;
    for (int i = 0; i < 200'000; ++i) range.add(function(point(i)));
    return range;
}

TEST(Noise, UsesItsRangeAndNoMore) {
    const Range one = range_of([](DVec3 p) { return noise(p.x * 100.0, kSeed); });
    const Range two = range_of([](DVec3 p) { return noise(DVec2{p}, kSeed); });
    const Range three = range_of([](DVec3 p) { return noise(p, kSeed); });
    for (const Range& range : {one, two, three}) {
        EXPECT_GE(range.min, -1.0);
        EXPECT_LE(range.max, 1.0);
        EXPECT_LT(range.min, -0.75);
        EXPECT_GT(range.max, 0.75);
        EXPECT_NEAR(range.mean(), 0.0, 0.01);
        EXPECT_GT(range.rms(), 0.2);
        EXPECT_LT(range.rms(), 0.4);
    }
}

TEST(Noise, IsZeroAtWholeCoordinates) {
    for (int i = 0; i < 100; ++i) {
        const DVec3 p = glm::floor(point(i, 1e6));
        EXPECT_EQ(noise(p.x, kSeed), 0.0);
        EXPECT_EQ(noise(DVec2{p}, kSeed), 0.0);
        EXPECT_EQ(noise(p, kSeed), 0.0);
    }
}

/// The greatest step of the second derivative across the whole coordinate `at`, by differences.
double second_derivative_step(double at, DVec2 rest) {
    constexpr double kStep = 1e-4;
    const auto f = [&](double x) { return noise(DVec3{x, rest}, kSeed); };
    const auto second = [&](double x) {
        return (f(x + kStep) - 2.0 * f(x) + f(x - kStep)) / (kStep * kStep);
    };
    return std::fabs(second(at + 2.0 * kStep) - second(at - 2.0 * kStep));
}

TEST(Noise, HasTwoContinuousDerivativesAcrossCells) {
    for (int i = 0; i < 200; ++i) {
        const DVec3 p = point(i);
        // The third derivative is below 200, so over four steps of 1e-4 the second moves by less
        // than 0.1; a cubic fade would jump by about 6.
        EXPECT_LT(second_derivative_step(std::floor(p.x), {p.y, p.z}), 0.2) << i;
    }
}

TEST(Noise, ChangesLittleOverASmallStep) {
    for (const double size : {1.0, 1e3, 1e6, 2e9}) {
        const double step = std::max(1e-9, size * 1e-15);
        for (int i = 0; i < 2000; ++i) {
            const DVec3 p = point(i, size);
            EXPECT_NEAR(noise(p, kSeed), noise(p + DVec3{step}, kSeed), 10.0 * step) << i;
            EXPECT_NEAR(noise(DVec2{p}, kSeed), noise(DVec2{p} + step, kSeed), 10.0 * step) << i;
            EXPECT_NEAR(noise(p.x, kSeed), noise(p.x + step, kSeed), 10.0 * step) << i;
        }
    }
}

double correlation(DVec3 offset, double size) {
    double product = 0.0;
    double squares = 0.0;
    for (int i = 0; i < 20'000; ++i) {
        const DVec3 p = point(i, size);
        const double a = noise(p, kSeed);
        product += a * noise(p + offset, kSeed);
        squares += a * a;
    }
    return product / squares;
}

TEST(Noise, DoesNotRepeat) {
    for (const double period : {1.0, 2.0, 256.0, 4096.0, 0x1p31, 0x1p32}) {
        for (int axis = 0; axis < 3; ++axis) {
            DVec3 offset{0.0};
            offset[axis] = period;
            const double limit = period == 1.0 ? 0.3 : 0.05;  // neighbours share corners
            EXPECT_LT(std::fabs(correlation(offset, 1000.0)), limit) << period << " " << axis;
        }
    }
    EXPECT_LT(std::fabs(correlation(DVec3{5000.0}, 1000.0)), 0.05);
}

TEST(Noise, SeedsGiveUnrelatedNoises) {
    double product = 0.0;
    double squares = 0.0;
    const NoiseSeed other{KeyedRandom{}.with(8.0)};
    for (int i = 0; i < 20'000; ++i) {
        const double a = noise(point(i), kSeed);
        product += a * noise(point(i), other);
        squares += a * a;
    }
    EXPECT_LT(std::fabs(product / squares), 0.05);
}

TEST(Noise, PrefersNoDirectionInThePlane) {
    // The mean square of the derivative along 16 directions.
    Range over_directions;
    for (int d = 0; d < 16; ++d) {
        const DVec2 direction = unit_circle_point(d / 16.0);
        double squares = 0.0;
        for (int i = 0; i < 20'000; ++i) {
            const DVec2 p{point(i)};
            const double slope = (noise(p + 1e-4 * direction, kSeed) - noise(p, kSeed)) / 1e-4;
            squares += slope * slope;
        }
        over_directions.add(std::sqrt(squares / 20'000));
    }
    EXPECT_LT(over_directions.max / over_directions.min, 1.1);
}

TEST(Noise, StaysWithinItsRangeForAnyFinitePoint) {
    for (const double x : {1e9, -1e9, 0x1p52 + 0.5, -0x1p53, 1e17, 1e300, -1.7e308, 5e-324}) {
        for (const double value :
             {noise(x, kSeed), noise(DVec2{x, 0.3}, kSeed), noise(DVec3{0.3, x, -x}, kSeed),
              fbm(x, {}, kSeed), fbm(DVec2{x, 0.3}, {}, kSeed)}) {
            if (std::fabs(x) < 1e300) {
                EXPECT_TRUE(value >= -1.0 && value <= 1.0) << x;
            } else {
                EXPECT_TRUE(std::isnan(value) || std::fabs(value) <= 1.0) << x;  // overflow
            }
        }
        const double distance = worley(DVec3{x, 0.3, -x}, kSeed);
        EXPECT_TRUE(distance >= 0.0 && distance <= std::sqrt(3.0)) << x;
    }
    EXPECT_NE(noise(-1e9 - 0.25, kSeed), noise(1e9 + 0.25, kSeed));
}

TEST(Fbm, UsesItsRangeAndNoMore) {
    const Range two = range_of([](DVec3 p) { return fbm(DVec2{p}, {}, kSeed); });
    const Range ridges = range_of([](DVec3 p) { return ridged(DVec2{p}, {}, kSeed); });
    for (const Range& range : {two, ridges}) {
        EXPECT_GE(range.min, -1.0);
        EXPECT_LE(range.max, 1.0);
    }
    EXPECT_LT(two.min, -0.5);
    EXPECT_GT(two.max, 0.5);
    EXPECT_NEAR(two.mean(), 0.0, 0.01);
    EXPECT_LT(ridges.min, -0.6);
    EXPECT_GT(ridges.max, 0.7);
}

TEST(Fbm, WholeCoordinatesAreNothingSpecial) {
    Range range;
    for (int i = 0; i < 2000; ++i) range.add(fbm(glm::floor(point(i)), {}, kSeed));
    EXPECT_GT(range.rms(), 0.1);
}

TEST(Fbm, FinerOctavesAddDetailByGain) {
    const auto roughness = [](double gain) {
        double squares = 0.0;
        for (int i = 0; i < 20'000; ++i) {
            const DVec2 p{point(i)};
            const Octaves octaves{8, 2.0, gain};
            const double step = fbm(p + 1e-3, octaves, kSeed) - fbm(p, octaves, kSeed);
            squares += step * step;
        }
        return squares;
    };
    EXPECT_LT(2.0 * roughness(0.2), roughness(0.5));
    EXPECT_LT(2.0 * roughness(0.5), roughness(0.9));
}

TEST(Fbm, AllOctavesAreFinite) {
    const Octaves most{Octaves::kMaxCount, 2.0, 0.5};
    for (int i = 0; i < 1000; ++i) {
        EXPECT_LE(std::fabs(fbm(point(i), most, kSeed)), 1.0);
        EXPECT_LE(std::fabs(ridged(point(i), most, kSeed)), 1.0);
    }
}

TEST(Ridged, CrestsAreSharp) {
    // Along a line the slope jumps from rising to falling at a crest, as |x| does.
    constexpr double kStep = 1e-5;
    const Octaves one{1, 2.0, 0.5};
    int crests = 0;
    for (int i = 0; i < 400'000; ++i) {
        const double x = i * 1e-4;
        const auto f = [&](double at) { return ridged(DVec2{at, 0.37}, one, kSeed); };
        const double before = (f(x) - f(x - kStep)) / kStep;
        const double behind = (f(x + kStep) - f(x)) / kStep;
        if (before - behind > 1.0) ++crests;
    }
    EXPECT_GT(crests, 3);
}

/// The nearest feature point by looking at every cell within four.
double worley_by_search(DVec3 p, int dimensions) {
    double nearest = 1e300;
    const auto reach = [&](int axis) { return axis < dimensions ? 4 : 0; };
    const DVec3 cell = glm::floor(p);
    for (int k = -reach(2); k <= reach(2); ++k) {
        for (int j = -reach(1); j <= reach(1); ++j) {
            for (int i = -reach(0); i <= reach(0); ++i) {
                const auto index = [](double c) {
                    return static_cast<std::uint64_t>(static_cast<std::int64_t>(c));
                };
                const DVec3 other = cell + DVec3{i, j, k};
                const std::uint64_t hash =
                    lattice_hash(kSeed.bits, index(other.x), dimensions > 1 ? index(other.y) : 0,
                                 dimensions > 2 ? index(other.z) : 0);
                DVec3 to =
                    other + DVec3{first_third(hash), second_third(hash), last_third(hash)} - p;
                for (int axis = dimensions; axis < 3; ++axis) to[axis] = 0.0;
                nearest = std::min(nearest, glm::dot(to, to));
            }
        }
    }
    return std::sqrt(nearest);
}

TEST(Worley, IsTheNearestOfAllFeaturePoints) {
    int far_count = 0;  // those that need the second ring of cells
    for (int i = 0; i < 20'000; ++i) {
        const DVec3 p = point(i);
        EXPECT_NEAR(worley(p.x, kSeed), worley_by_search(p, 1), 1e-13) << i;
        EXPECT_NEAR(worley(DVec2{p}, kSeed), worley_by_search(p, 2), 1e-13) << i;
        if (i < 2000) {
            EXPECT_NEAR(worley(p, kSeed), worley_by_search(p, 3), 1e-13) << i;
        }
        if (worley(DVec2{p}, kSeed) > 1.0) ++far_count;
    }
    EXPECT_GT(far_count, 10);
}

// To the bit, as worked out in Python from the definitions, so that pictures made today are made
// tomorrow.
TEST(Noise, ValuesAreFixed) {
    const DVec3 p{0.3, -12.7, 1e6 + 0.4};
    EXPECT_EQ(noise(p.x, kSeed), -0.5982407335390313);
    EXPECT_EQ(noise(DVec2{p}, kSeed), 0.16648001918819863);
    EXPECT_EQ(noise(p, kSeed), -0.02462650188930902);
    EXPECT_EQ(fbm(p.x, {}, kSeed), 0.1529531825474644);
    EXPECT_EQ(fbm(DVec2{p}, {}, kSeed), 0.14480406511509003);
    EXPECT_EQ(fbm(p, {}, kSeed), -0.008538831948198095);
    EXPECT_EQ(ridged(p.x, {}, kSeed), 0.21223964167264775);
    EXPECT_EQ(ridged(DVec2{p}, {}, kSeed), -0.2345995306538171);
    EXPECT_EQ(ridged(p, {}, kSeed), 0.6905241358282328);
    EXPECT_EQ(worley(p.x, kSeed), 0.2183974266052246);
    EXPECT_EQ(worley(DVec2{p}, kSeed), 0.5159680745975954);
    EXPECT_EQ(worley(p, kSeed), 0.6356922364052107);
}

}  // namespace
}  // namespace lray
