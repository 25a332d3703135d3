// The built-in functions: each against values known from elsewhere.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "image/srgb.h"
#include "parser/builtins/builtins.h"
#include "tests/parser/builtin_caller.h"
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
    {"lerp(0.4, 0.1, 1)", 0.1},
    {"lerp(10, 20, 2)", 30},
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
    {"mix(0, [1, 0.5, 0], 0.5).y", 0.25},
    {"mix(2, 4, 0.25)", 2.5},
    {"mix(black, 1, 0.25).g", 0.25},
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
    {"apply(similarity([[0, -2, 0, 1], [2, 0, 0, 0], [0, 0, 2, 0]], 2), [1, 0, 3])", {1, 2, 6}},
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
    for (const char* file : {"builtins", "list_builtins", "string_builtins", "message_builtins",
                             "geometry_builtins", "animation_builtins", "random_builtins"}) {
        all += read_bytes(fmt::format("{}/tests/parser/{}_test.cpp", LRAY_SOURCE_DIR, file));
    }
    for (const parser::Builtin& builtin : parser::builtins()) {
        const bool is_in_scene = all.find(fmt::format("\"{}(", builtin.name)) != all.npos;
        const bool is_called = all.find(fmt::format("(\"{}\", {{", builtin.name)) != all.npos;
        const bool is_inside = all.find(fmt::format("({}(", builtin.name)) != all.npos;
        EXPECT_TRUE(is_in_scene || is_called || is_inside) << builtin.name;
        EXPECT_FALSE(builtin.doc.empty()) << builtin.name;
    }
}

TEST(Builtins, AreFoundByTheirNames) {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < parser::builtins().size(); ++i) {
        const std::string_view name = parser::builtins()[i].name;
        EXPECT_EQ(parser::find_builtin(name), i) << name;
        EXPECT_TRUE(names.insert(name).second) << name << " is there twice";
    }
    for (const char* name : {"", "a", "ab", "absx", "zzz", "ABS"}) {
        EXPECT_EQ(parser::find_builtin(name), std::nullopt) << name;
    }
}

TEST(Builtins, TheShortWayIsTheSameFunction) {
    BuiltinCaller caller;
    std::size_t count = 0;
    for (const parser::Builtin& builtin : parser::builtins()) {
        if (builtin.of_number == nullptr) continue;
        ++count;
        EXPECT_EQ(builtin.parameter_count(), 1u) << builtin.name;
        for (const double x : {-1.0, -0.25, 0.0, 0.5, 1.0, 3.75, 1e300}) {
            const double direct = builtin.of_number(x);
            const parser::Value result = caller.call(builtin.name, {parser::Value::of(x)});
            EXPECT_EQ(result.is(parser::ValueKind::number), std::isfinite(direct));
            if (!std::isfinite(direct)) continue;
            EXPECT_EQ(result.number, direct) << builtin.name << " " << x;
        }
    }
    EXPECT_EQ(count, 20u);
}

TEST(Builtins, HugeNumbersAreNeverPatchedOver) {
    BuiltinCaller caller;
    const auto number = [](double x) { return parser::Value::of(x); };
    EXPECT_EQ(caller.says("exp", {number(1000)}), "E0503 1 `exp(1000)` has no finite value");
    EXPECT_EQ(caller.says("hypot", {number(1.7e308), number(1.7e308)}),
              "E0503 1 `hypot(1.7e+308, 1.7e+308)` has no finite value");
    EXPECT_EQ(caller.says("smoothstep", {number(-1.7e308), number(1.7e308), number(0)}), "0.5");
    EXPECT_EQ(caller.says("rgb", {number(1e308), number(0), number(0)}), "rgb(1e+308, 0, 0)");
    EXPECT_EQ(caller.says("cross",
                          {caller.numbers({1e308, 1e308, 1}), caller.numbers({1, 1e308, 1e308})}),
              "E0503 1 `cross(..., ...)` has no finite value");
    EXPECT_EQ(caller.says("sqrt", {caller.numbers({4, -1})}),
              "E0503 1 `sqrt(...)` has no real value");
    EXPECT_EQ(caller.says("abs", {caller.numbers({})}), "[]");
    EXPECT_EQ(caller.says("min", {caller.numbers({1, 2}), caller.numbers({})}),
              "E0302 1 these have 2 and 0 elements");
}

/// CIE 1931 chromaticity of a linear RGB colour.
DVec2 chromaticity(DVec3 c) {
    const double x = 0.4124 * c.x + 0.3576 * c.y + 0.1805 * c.z;
    const double y = 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
    const double z = 0.0193 * c.x + 0.1192 * c.y + 0.9505 * c.z;
    return DVec2{x, y} / (x + y + z);
}

// The Planckian locus. Source: CIE 15:2004 (2856 K is illuminant A); Wyszecki, Stiles 1982,
// "Color Science", table 1(5.4).
TEST(ColourFunctions, GlowingBodiesLieOnThePlanckianLocus) {
    struct Case {
        double kelvin;
        double x, y;
    };
    for (const Case& test : {Case{2856, 0.4476, 0.4074}, Case{5000, 0.3451, 0.3516},
                             Case{6500, 0.3135, 0.3237}, Case{10000, 0.2807, 0.2884}}) {
        const Color color = color_of(fmt::format("kelvin({})", test.kelvin));
        const DVec2 xy = chromaticity(DVec3{color});
        EXPECT_NEAR(xy.x, test.x, 0.003) << test.kelvin;
        EXPECT_NEAR(xy.y, test.y, 0.003) << test.kelvin;
        EXPECT_EQ(std::max({color.x, color.y, color.z}), 1.0f);
    }
}

TEST(ColourFunctions, TemperaturesHaveTheirRange) {
    BuiltinCaller caller;
    for (const double kelvin : {999.0, 1000.0, 40000.0, 40001.0, -1.0, 1e308}) {
        const bool fits = kelvin >= 1000.0 && kelvin <= 40000.0;
        const std::string told = caller.says("kelvin", {parser::Value::of(kelvin)});
        EXPECT_EQ(told.starts_with("rgb("), fits) << told;
        EXPECT_EQ(told.starts_with("E0304 10 `kelvin` takes 1000 to 40000 K, this is "), !fits);
    }
    EXPECT_EQ(color_of("kelvin(1000)").z, 0.0f) << "bluer than RGB is cut off";
    EXPECT_LT(color_of("kelvin(20000)").x, 0.5f);
}

TEST(ColourFunctions, MixTakesWhatFitsTogether) {
    BuiltinCaller caller;
    const auto half = parser::Value::of(0.5);
    const auto red = caller.color(1, 0, 0);
    EXPECT_EQ(caller.says("mix", {red, caller.color(0, 0, 1), half}), "rgb(0.5, 0, 0.5)");
    EXPECT_EQ(caller.says("mix", {caller.numbers({0, 0}), caller.numbers({1, 2}), half}),
              "[0.5, 1]");
    EXPECT_EQ(caller.says("mix", {red, caller.numbers({0, 1, 0}), half}), "rgb(0.5, 0.5, 0)");
    EXPECT_EQ(caller.says("mix", {red, caller.numbers({1, 2}), half}),
              "E0301 1 there is nothing between a colour and a list of 2 numbers");
    EXPECT_EQ(caller.says("mix", {caller.numbers({1, 2, 3}), caller.numbers({1, 2}), half}),
              "E0302 1 these have 3 and 2 elements");
    EXPECT_EQ(caller.says("mix", {caller.string("a"), red, half}),
              "E0301 10 `a` of `mix` needs a number, a vector or a colour, this is a string");
}

TEST(TransformFunctions, LookAtTurnsTowardsItsTarget) {
    EXPECT_LT(
        glm::length(vec3_of("apply(look_at([1, 2, 3], [1, 2, 13]), [0, 0, -1])") - DVec3(1, 2, 4)),
        1e-15);
    EXPECT_LT(
        glm::length(vec3_of("apply(look_at([0, 0, 0], [0, 5, 0]), [0, 0, -1])") - DVec3(0, 1, 0)),
        1e-15);
    EXPECT_EQ(vec3_of("apply(look_at([0, 0, 0], [0, -5, 0]), [1, 0, 0])"), DVec3(1, 0, 0));
    BuiltinCaller caller;
    EXPECT_EQ(caller.says("look_at", {caller.numbers({1, 2, 3}), caller.numbers({1, 2, 3})}),
              "E0503 1 `position` and `target` are the same point, or infinitely far apart");
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
