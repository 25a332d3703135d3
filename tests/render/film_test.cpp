#include "render/film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/random.h"

namespace lray::render {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

TEST(Film, SingleSampleComesBackExactly) {
    constexpr std::uint64_t kSeed = 5;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    for (int i = 0; i < 10'000; ++i) {
        const auto value = [&] {  // from 2^-9 to the maximum
            return static_cast<float>(std::exp2(random.uniform(-9.0, 15.99)));
        };
        const float r = value();
        const float g = value();
        const Color sample{r, g, -value()};
        Film film(3, 2);
        film.add(2, 1, sample);
        ASSERT_EQ(film.resolve(2, 1), sample);
        ASSERT_EQ(film.resolve(0, 0), Color(0.0f));
    }
}

TEST(Film, CommonConstantsComeBackExactly) {
    for (const float value : {0.0f, 1.0f, 0.8f, 0.1f, 0x1p-9f, 0x1p-32f, 65504.0f}) {
        Film film(1, 1);
        film.add(0, 0, Color{value});
        EXPECT_EQ(film.resolve(0, 0), Color(value)) << value;
        EXPECT_EQ(film.counts().clamped, 0u);
    }
}

TEST(Film, SmallValueIsWithinHalfAStep) {
    for (const float value : {1e-3f, 1.7e-5f, 3e-9f, 1e-12f}) {
        Film film(1, 1);
        film.add(0, 0, Color{value});
        EXPECT_NEAR(film.resolve(0, 0).r, value, 0x1p-33f) << value;
    }
}

TEST(Film, OrderAndSplitDoNotMatter) {
    constexpr std::uint64_t kSeed = 6;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    std::vector<Color> samples(1000);
    for (Color& sample : samples) {
        sample = random.vec3(0.0, 1.0) * static_cast<float>(std::exp2(random.uniform(-20.0, 15.0)));
    }
    Film forward(1, 1);
    Film backward(1, 1);
    for (const Color& sample : samples) forward.add(0, 0, sample);
    std::reverse(samples.begin(), samples.end());
    for (const Color& sample : samples) backward.add(0, 0, sample);
    EXPECT_EQ(forward.resolve(0, 0), backward.resolve(0, 0));

    double sum = 0.0;
    for (const Color& sample : samples) sum += static_cast<double>(sample.r);
    EXPECT_NEAR(static_cast<double>(forward.resolve(0, 0).r), sum / 1000.0, sum * 1e-10);
}

TEST(Film, BrightestSamplesDoNotOverflow) {
    Film film(1, 1);
    for (std::uint32_t i = 0; i < Film::kMaxSamples; ++i) film.add(0, 0, Color{65504.0f});
    EXPECT_EQ(film.resolve(0, 0), Color(65504.0f));
    EXPECT_EQ(film.counts().clamped, 0u);
}

TEST(Film, SamplesOfAllPixelsAreCounted) {
    Film film(3, 2);
    EXPECT_EQ(film.sample_count(), 0u);
    for (int i = 0; i < 5; ++i) film.add(2, 1, Color{1.0f});
    film.add(0, 0, Color{kNan});  // counts, though as black
    EXPECT_EQ(film.sample_count(), 6u);
    Film more(3, 2);
    more.add(2, 1, Color{0.0f});
    film.add_film(more);
    EXPECT_EQ(film.sample_count(), 7u);
    EXPECT_EQ(film.part(2, 0, 1, 2).sample_count(), 6u);
}

TEST(Film, TooBrightIsClampedAndCounted) {
    Film film(1, 1);
    film.add(0, 0, {kInf, 65505.0f, 1.0f});
    EXPECT_EQ(film.resolve(0, 0), Color(65504.0f, 65504.0f, 1.0f));
    EXPECT_EQ(film.counts().clamped, 1u);
    EXPECT_EQ(film.counts().nan, 0u);
    Film dark(1, 1);
    dark.add(0, 0, {-kInf, 0.0f, 0.0f});
    EXPECT_EQ(dark.resolve(0, 0), Color(-65504.0f, 0.0f, 0.0f));
    EXPECT_EQ(dark.counts().clamped, 1u);
}

TEST(Film, NotANumberIsBlackAndCounted) {
    Film film(1, 1);
    film.add(0, 0, {1.0f, kNan, 1.0f});
    film.add(0, 0, Color{1.0f});
    EXPECT_EQ(film.resolve(0, 0), Color(0.5f));
    EXPECT_EQ(film.counts().nan, 1u);
    EXPECT_EQ(film.counts().clamped, 0u);
}

Film film_with_squares(const std::vector<Color>& samples) {
    Film film(1, 1, Film::Keeps::squares);
    for (const Color& sample : samples) film.add(0, 0, sample);
    return film;
}

TEST(Film, StandardErrorIsThatOfTheMean) {
    // Of 1, 2, 3, 4: the variance is 5/3, and that of the mean a quarter of it.
    const Film film = film_with_squares(
        {{1.0f, 0.0f, -1.0f}, {2.0f, 0.0f, -2.0f}, {3.0f, 0.0f, -3.0f}, {4.0f, 0.0f, -4.0f}});
    const float expected = std::sqrt(5.0f / 12.0f);
    EXPECT_NEAR(film.standard_error(0, 0).r, expected, 1e-7f);
    EXPECT_EQ(film.standard_error(0, 0).g, 0.0f);
    EXPECT_EQ(film.standard_error(0, 0).b, film.standard_error(0, 0).r);
}

TEST(Film, StandardErrorOfALittleUnrestInBrightLightIsNotLost) {
    // Doubles would lose it: the squares are 4.3e9, and the variance 2.3e-10.
    std::vector<Color> samples;
    for (int i = 0; i < 32; ++i) samples.emplace_back(65000.0f);
    samples[7] = Color{65000.00390625f};
    const float expected = 0.00390625f * std::sqrt((1.0f / 32.0f - 1.0f / 1024.0f) / 31.0f);
    EXPECT_NEAR(film_with_squares(samples).standard_error(0, 0).r, expected, 1e-6f * expected);
    for (Color& sample : samples) sample = Color{65000.0f};
    EXPECT_EQ(film_with_squares(samples).standard_error(0, 0), Color(0.0f));
}

TEST(Film, StandardErrorDoesNotDependOnTheOrder) {
    constexpr std::uint64_t kSeed = 8;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    std::vector<Color> samples(1000);
    for (Color& sample : samples) {
        sample = random.vec3(-1.0, 1.0) * static_cast<float>(std::exp2(random.uniform(-9.0, 15.0)));
    }
    const Color forward = film_with_squares(samples).standard_error(0, 0);
    std::reverse(samples.begin(), samples.end());
    EXPECT_EQ(film_with_squares(samples).standard_error(0, 0), forward);

    double sum = 0.0;
    double squares = 0.0;
    for (const Color& sample : samples) sum += static_cast<double>(sample.r) / 1000.0;
    for (const Color& sample : samples) {
        const double off = static_cast<double>(sample.r) - sum;
        squares += off * off;
    }
    const double expected = std::sqrt(squares / 999.0 / 1000.0);
    EXPECT_NEAR(static_cast<double>(forward.r), expected, 1e-6 * expected);
}

TEST(Film, SquaresOfTheBrightestSamplesDoNotOverflow) {
    Film film(1, 1, Film::Keeps::squares);
    for (std::uint32_t i = 0; i < Film::kMaxSamples; ++i) {
        film.add(0, 0, {65504.0f, i % 2 == 0 ? 65504.0f : -65504.0f, 0.0f});
    }
    EXPECT_EQ(film.standard_error(0, 0).r, 0.0f);
    const double expected = 65504.0 / std::sqrt(Film::kMaxSamples - 1.0);
    EXPECT_NEAR(static_cast<double>(film.standard_error(0, 0).g), expected, 1e-6 * expected);
}

TEST(FilmDeathTest, OneSampleTooManyIsOurBug) {
    Film film(1, 1);
    for (std::uint32_t i = 0; i < Film::kMaxSamples; ++i) film.add(0, 0, Color{0.0f});
    EXPECT_EXIT(film.add(0, 0, Color{0.0f}), testing::ExitedWithCode(70), "internal error");
}

}  // namespace
}  // namespace lray::render
