#include "gui/slider_value.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <cstdlib>

#include "tests/support/random.h"

namespace lray::gui {
namespace {

Slider slider(double least, double greatest, double value, bool is_whole = false) {
    return {
        .name = "s", .value = value, .least = least, .greatest = greatest, .is_whole = is_whole};
}

Slider random_slider(test::Random& random, bool is_whole) {
    const double scale = std::pow(10.0, random.uniform(is_whole ? 1.0 : -9.0, 12.0));
    Slider result = slider(random.uniform(-1.0, 1.0) * scale, 0.0, 0.0, is_whole);
    result.greatest = result.least + random.uniform(0.01, 1.0) * scale;
    if (is_whole) {
        result.least = std::floor(result.least);
        result.greatest = std::ceil(result.greatest);
    }
    result.value = result.least;
    return result;
}

TEST(SliderValue, TextIsExactAndShort) {
    constexpr std::uint64_t kSeed = 73;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    for (int i = 0; i < 5000; ++i) {
        Slider one = random_slider(random, i % 2 == 0);
        const double fraction = random.uniform();
        one.value = value_at(one, fraction);
        EXPECT_GE(one.value, one.least);
        EXPECT_LE(one.value, one.greatest);
        EXPECT_NEAR(fraction_of(one), fraction,
                    one.is_whole ? 0.05 + 1.0 / (one.greatest - one.least) : 0.0051);
        const std::string text = value_text(one);
        EXPECT_EQ(std::strtod(text.c_str(), nullptr), one.value);
        if (one.is_whole) {
            EXPECT_EQ(one.value, std::round(one.value));
        }
        // Digits of the range's position and of its 200 parts.
        const double size = std::max(std::fabs(one.least), std::fabs(one.greatest));
        const double digits = std::log10(size / (one.greatest - one.least)) + 4.0;
        if (one.value != one.least && one.value != one.greatest) {
            EXPECT_LE(static_cast<double>(text.size()), digits + 14.0) << text;
        }
    }
}

TEST(SliderValue, UsualRangesGiveUsualNumbers) {
    EXPECT_EQ(value_at(slider(0.0, 1.0, 0.0), 0.33333), 0.333);
    EXPECT_EQ(value_at(slider(0.0, 10.0, 0.0), 0.33333), 3.33);
    EXPECT_EQ(value_at(slider(-180.0, 180.0, 0.0), 0.7503), 90.0 + 0.0);
    EXPECT_EQ(value_at(slider(1.0, 50.0, 0.0, true), 0.5), 26.0);
    Slider small = slider(0.0, 1.0, 0.1 + 0.2);
    small.value = value_at(small, 0.3);
    EXPECT_EQ(value_text(small), "0.3");
}

TEST(SliderValue, BothEndsAreReached) {
    const Slider odd = slider(0.123456789, 7.654321, 1.0);
    EXPECT_EQ(value_at(odd, 0.0), 0.123456789);
    EXPECT_EQ(value_at(odd, 1.0), 7.654321);
    EXPECT_EQ(value_at(odd, -5.0), 0.123456789);
    EXPECT_EQ(value_at(odd, 5.0), 7.654321);
    const Slider whole = slider(0.5, 3.5, 1.0, true);
    EXPECT_EQ(value_at(whole, 0.0), 1.0);
    EXPECT_EQ(value_at(whole, 1.0), 3.0);
}

TEST(SliderValue, StepsGoThroughTheRangeAndBack) {
    constexpr std::uint64_t kSeed = 79;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    for (int i = 0; i < 500; ++i) {
        Slider one = random_slider(random, i % 2 == 0);
        int up_count = 0;
        while (one.value < one.greatest && up_count < 1000) {
            const double before = one.value;
            one.value = stepped_value(one, 1);
            ASSERT_GT(one.value, before);
            ++up_count;
        }
        EXPECT_EQ(one.value, one.greatest);
        EXPECT_LE(up_count, 160);
        if (!one.is_whole) {
            EXPECT_GE(up_count, 48);
        }
        int down_count = 0;
        while (one.value > one.least && down_count < 1000) {
            one.value = stepped_value(one, -1);
            ++down_count;
        }
        EXPECT_EQ(one.value, one.least);
        EXPECT_NEAR(down_count, up_count, 2);
    }
}

TEST(SliderValue, AStepIsARoundNumber) {
    EXPECT_EQ(stepped_value(slider(0.0, 1.0, 0.5), 1), 0.52);
    EXPECT_EQ(stepped_value(slider(0.0, 10.0, 5.0), -1), 4.8);
    EXPECT_EQ(stepped_value(slider(1.0, 5.0, 3.0, true), 1), 4.0);
    EXPECT_EQ(stepped_value(slider(0.0, 1000.0, 500.0, true), 1), 520.0);
    EXPECT_EQ(stepped_value(slider(0.0, 1.0, 0.99), 1), 1.0);
}

TEST(SliderValue, ExtremeRangesStayFinite) {
    for (Slider one : {slider(-DBL_MAX, DBL_MAX, 0.0), slider(0.0, DBL_MIN, 0.0),
                       slider(0.0, 5e-324, 0.0), slider(3.0, 3.0, 3.0),
                       slider(-DBL_MAX, DBL_MAX, 1.0, true), slider(0.2, 0.8, 0.5, true)}) {
        for (const double fraction : {0.0, 0.3, 0.999, 1.0}) {
            one.value = value_at(one, fraction);
            EXPECT_GE(one.value, one.least);
            EXPECT_LE(one.value, one.greatest);
            EXPECT_GE(fraction_of(one), 0.0);
            EXPECT_LE(fraction_of(one), 1.0);
            for (const int direction : {-1, 1}) {
                const double stepped = stepped_value(one, direction);
                EXPECT_GE(stepped, one.least);
                EXPECT_LE(stepped, one.greatest);
            }
        }
    }
}

TEST(SliderValue, ChoicesAreIndices) {
    Slider one{.name = "s", .value = 9.0, .choices = {"red", "green", "blue"}};
    one = in_order(one);
    EXPECT_EQ(one.value, 2.0);
    EXPECT_EQ(value_text(one), "blue");
    one.value = stepped_value(one, -1);
    EXPECT_EQ(value_text(one), "green");
    one.value = stepped_value(one, -1);
    one.value = stepped_value(one, -1);
    EXPECT_EQ(value_text(one), "red");
    EXPECT_EQ(value_at(one, 0.6), 1.0);
    EXPECT_EQ(value_at(one, 1.0), 2.0);
}

TEST(SliderValue, RangesAreBroughtInOrder) {
    const Slider upside_down = in_order(slider(5.0, 1.0, 3.0));
    EXPECT_EQ(upside_down.value, 5.0);
    EXPECT_EQ(upside_down.greatest, 5.0);
    EXPECT_EQ(in_order(slider(0.0, 1.0, std::nan(""))).value, 0.0);
    const Slider endless = in_order(slider(-HUGE_VAL, HUGE_VAL, 3.0));
    EXPECT_TRUE(std::isfinite(endless.least) && std::isfinite(endless.greatest));
}

TEST(SliderValue, NoNegativeZero) {
    EXPECT_EQ(value_text(slider(-1.0, 1.0, -0.0)), "0");
    Slider one = slider(-1.0, 1.0, 0.0);
    one.value = value_at(one, 0.49999);
    EXPECT_EQ(value_text(one), "0");
}

}  // namespace
}  // namespace lray::gui
