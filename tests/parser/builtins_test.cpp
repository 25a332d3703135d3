// The built-in functions: each against values known from elsewhere.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "image/srgb.h"
#include "parser/builtins/builtins.h"
#include "tests/parser/evaluate.h"
#include "tests/parser/loaded.h"

namespace lray::test {
namespace {

struct NumberCase {
    const char* expression;
    double value;
};

const std::vector<NumberCase> kNumbers = {
    {"abs(-3)", 3.0},
    {"sign(-3) * 100 + sign(0) * 10 + sign(5)", -99.0},
    {"min(2, 3)", 2.0},
    {"max(2, 3)", 3.0},
    {"clamp(5, 0, 1)", 1.0},
    {"clamp(-5, 0, 1)", 0.0},
    {"clamp(lo: 0, hi: 1, x: 0.5)", 0.5},
    {"lerp(10, 20, 0.25)", 12.5},
    {"smoothstep(0, 2, 1)", 0.5},
    {"smoothstep(0, 2, 3)", 1.0},
    {"smoothstep(0, 1, 0.25)", 0.15625},
    {"floor(-1.5)", -2.0},
    {"ceil(-1.5)", -1.0},
    {"round(2.5)", 3.0},
    {"round(-2.5)", -3.0},
    {"trunc(-1.7)", -1.0},
    {"frac(-1.25)", 0.75},
    {"sqrt(2)", std::numbers::sqrt2},
    {"exp(1)", std::numbers::e},
    {"log(exp(2))", 2.0},
    {"log2(8)", 3.0},
    {"log10(1000)", 3.0},
    {"hypot(3, 4)", 5.0},
    {"sin(30)", 0.5},
    {"sin(180)", 0.0},
    {"cos(60)", 0.5},
    {"cos(90)", 0.0},
    {"tan(45)", 1.0},
    {"asin(1)", 90.0},
    {"acos(0.5)", 60.0},
    {"atan(1)", 45.0},
    {"atan2(1, -1)", 135.0},
    {"radians(180)", std::numbers::pi},
    {"degrees(pi)", 180.0},
    {"length([3, 4])", 5.0},
    {"length([1, 2, 2])", 3.0},
    {"length([1e300, 0, 0])", 1e300},
    {"distance([1, 1], [4, 5])", 5.0},
    {"dot([1, 2, 3], [4, 5, 6])", 32.0},
    {"angle_between([1, 0], [0, 2])", 90.0},
    {"angle_between([1, 0, 0], [-1, 0, 0])", 180.0},
    {"rgb(0.25, 0.5, 0.75).g", 0.5},
    {"gray(0.25).b", 0.25},
    {"mix(black, white, 0.25).r", 0.25},
    {"mix(0, [1, 0.5, 0], 0.5).g", 0.25},
};

struct VectorCase {
    const char* expression;
    DVec3 value;
};

const std::vector<VectorCase> kVectors = {
    {"abs([-1, 2, -3])", {1, 2, 3}},
    {"min([1, 5, 3], 2)", {1, 2, 2}},
    {"max([1, 5, 3], [2, 2, 2])", {2, 5, 3}},
    {"clamp([-1, 0.5, 3], 0, [1, 1, 2])", {0, 0.5, 2}},
    {"lerp([0, 0, 0], [2, 4, 6], 0.5)", {1, 2, 3}},
    {"floor([1.5, -1.5, 2])", {1, -2, 2}},
    {"sqrt([4, 9, 16])", {2, 3, 4}},
    {"normalize([0, 3, 4])", {0, 0.6, 0.8}},
    {"cross([1, 0, 0], [0, 1, 0])", {0, 0, 1}},
    {"reflect([1, -1, 0], [0, 1, 0])", {1, 1, 0}},
    {"apply(translation([1, 2, 3]), [1, 1, 1])", {2, 3, 4}},
    {"apply(rotation_z(90), [1, 0, 0])", {0, 1, 0}},
    {"apply(rotation_x(90), [0, 1, 0])", {0, 0, 1}},
    {"apply(rotation_y(90), [0, 0, 1])", {1, 0, 0}},
    {"apply(rotation([0, 0, 2], 90), [1, 0, 0])", {0, 1, 0}},
    {"apply(rotation([0, 0, 1], 180, about: [1, 0, 0]), [0, 0, 0])", {2, 0, 0}},
    {"apply(scaling(3), [1, 2, 3])", {3, 6, 9}},
    {"apply(scaling([1, 2, 3]), [1, 1, 1])", {1, 2, 3}},
    {"apply(inverse(translation([1, 2, 3])), [1, 2, 3])", {0, 0, 0}},
    {"apply(matrix([[0, -1, 0, 5], [1, 0, 0, 6], [0, 0, 1, 7]]), [1, 0, 0])", {5, 7, 7}},
};

TEST(Builtins, NumbersAreAsExpected) {
    for (const NumberCase& test : kNumbers) {
        EXPECT_NEAR(number_of(test.expression) / (1.0 + std::fabs(test.value)),
                    test.value / (1.0 + std::fabs(test.value)), 1e-15)
            << test.expression;
    }
}

TEST(Builtins, VectorsAreAsExpected) {
    for (const VectorCase& test : kVectors) {
        const DVec3 value = vec3_of(test.expression);
        EXPECT_LT(glm::length(value - test.value), 1e-15) << test.expression;
    }
}

TEST(Builtins, DegreesAreExactAtRightAngles) {
    EXPECT_EQ(number_of("cos(90)"), 0.0);
    EXPECT_EQ(number_of("sin(360)"), 0.0);
    EXPECT_EQ(number_of("sin(90)"), 1.0);
}

TEST(Builtins, EveryFunctionIsTested) {
    std::string all;
    for (const NumberCase& test : kNumbers) all += std::string(" ") + test.expression;
    for (const VectorCase& test : kVectors) all += std::string(" ") + test.expression;
    all += " srgb( hsv( hsl(";  // below
    // In random_builtins_test.cpp:
    all += " noise( fbm( ridged( worley( rand( rand_range( rand_int( rand_on_sphere( rand_in_disk(";
    all += " gauss( shuffle( pick(";
    for (const parser::Builtin& builtin : parser::builtins()) {
        const std::string call = std::string(builtin.name) + "(";
        const std::size_t at = all.find(call);
        const bool is_tested = all.find(" " + call) != all.npos || all.find("(" + call) != all.npos;
        EXPECT_TRUE(at != all.npos && is_tested) << builtin.name;
        EXPECT_FALSE(builtin.doc.empty()) << builtin.name;
    }
}

TEST(ColourFunctions, DisplayColoursBecomeLinear) {
    const auto linear = [](double encoded) {
        return static_cast<float>(image::srgb_decode(encoded));
    };
    EXPECT_EQ(color_of("srgb(0.25, 0.5, 1)"), Color(linear(0.25), linear(0.5), 1.0f));
    EXPECT_EQ(color_of("rgb(0.25, 0.5, 1)"), Color(0.25f, 0.5f, 1.0f));
    EXPECT_EQ(color_of("hsv(0, 1, 1)"), Color(1.0f, 0.0f, 0.0f));
    EXPECT_EQ(color_of("hsv(120, 1, 1)"), Color(0.0f, 1.0f, 0.0f));
    EXPECT_EQ(color_of("hsv(-120, 1, 1)"), Color(0.0f, 0.0f, 1.0f));
    EXPECT_EQ(color_of("hsv(60, 1, 0.5)"), Color(linear(0.5), linear(0.5), 0.0f));
    EXPECT_EQ(color_of("hsv(30, 1, 1)"), Color(1.0f, linear(0.5), 0.0f));
    EXPECT_EQ(color_of("hsl(0, 1, 0.5)"), Color(1.0f, 0.0f, 0.0f));
    EXPECT_EQ(color_of("hsl(240, 1, 0.75)"), Color(linear(0.5), linear(0.5), 1.0f));
    EXPECT_EQ(color_of("hsl(77, 0, 0.5)"), Color(linear(0.5)));
}

TEST(ColourNames, AreThoseOfCss) {
    EXPECT_EQ(color_of("crimson"), color_of("#dc143c"));
    EXPECT_EQ(color_of("rebeccapurple"), color_of("#663399"));
    EXPECT_EQ(color_of("gray"), color_of("#808080"));
    EXPECT_EQ(color_of("colors.white"), Color(1.0f));
}

}  // namespace
}  // namespace lray::test
