// Random numbers and noise as the language has them: keys, ranges, distributions, mistakes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "base/noise.h"
#include "base/random.h"
#include "parser/values/operators.h"
#include "tests/parser/call_builtin_of.h"
#include "tests/parser/evaluate.h"

namespace lray::test {
namespace {

using parser::Value;
using parser::ValueKind;

Value text(std::string_view string) {
    return Value::of_string(string, 0);
}

double number(std::string_view function, const std::vector<Value>& arguments) {
    const BuiltinCall call(function, arguments);
    EXPECT_TRUE(call.value.is(ValueKind::number)) << function << call.told();
    return call.value.number;
}

TEST(RandomBuiltins, RandIsThatOfTheDefinition) {
    EXPECT_EQ(number("rand", {Value::of(42.0)}), 0x1.5af16cca03a66p-1);
    EXPECT_EQ(number("rand", {Value::of(42.0), Value::of(1.0), Value::of(2.0)}),
              0x1.f6c9eafe581c8p-2);
    EXPECT_EQ(number("rand", {Value::of(42.0), text("tree"), Value::of(1.0)}),
              0x1.678ca3f8dc726p-2);
    EXPECT_EQ(number("rand", {Value::of(-0.0)}), number("rand", {Value::of(0.0)}));
}

TEST(RandomBuiltins, SceneTextGivesTheSame) {
    EXPECT_EQ(number_of("rand(42)"), 0x1.5af16cca03a66p-1);
    EXPECT_EQ(number_of("rand(\"tree\")"), KeyedRandom{}.with("tree").number());
    EXPECT_EQ(number_of("noise([0.3, 0.4], seed: 7)"),
              noise(DVec2{0.3, 0.4}, NoiseSeed(KeyedRandom{}.with(7.0))));
    EXPECT_EQ(number_of("rand_range(2, 4, 42)"), 2.0 + 2.0 * 0x1.5af16cca03a66p-1);
}

TEST(RandomBuiltins, RandRangeStaysBetweenItsEnds) {
    for (int i = 0; i < 1000; ++i) {
        const double x =
            number("rand_range", {Value::of(-3.0), Value::of(5.0), Value::of(1.0 * i)});
        EXPECT_TRUE(x >= -3.0 && x <= 5.0);
        EXPECT_EQ(number("rand_range", {Value::of(0.1), Value::of(0.1), Value::of(1.0 * i)}), 0.1);
        const double wide =
            number("rand_range", {Value::of(-1.7e308), Value::of(1.7e308), Value::of(1.0 * i)});
        EXPECT_TRUE(std::isfinite(wide));
    }
}

TEST(RandomBuiltins, RandIntIsAFairDie) {
    std::array<int, 6> counts{};
    for (int i = 0; i < 60'000; ++i) {
        const double x = number(
            "rand_int", {Value::of(1.0), Value::of(6.0), Value::of(9.0), Value::of(1.0 * i)});
        ASSERT_TRUE(x >= 1.0 && x <= 6.0 && x == std::floor(x));
        ++counts[static_cast<std::size_t>(x) - 1];
    }
    double chi_square = 0.0;
    for (const int count : counts) chi_square += (count - 10'000.0) * (count - 10'000.0) / 10'000.0;
    EXPECT_LT(chi_square, 20.5);  // 99.9 % of five degrees of freedom
}

TEST(RandomBuiltins, RandIntTakesAnyWholeRange) {
    EXPECT_EQ(number("rand_int", {Value::of(5.0), Value::of(5.0), Value::of(1.0)}), 5.0);
    const double most = 9007199254740992.0;
    for (int i = 0; i < 100; ++i) {
        const double x =
            number("rand_int", {Value::of(0.0), Value::of(most - 1.0), Value::of(1.0 * i)});
        EXPECT_TRUE(x >= 0.0 && x < most && x == std::floor(x));
    }
    EXPECT_EQ(BuiltinCall("rand_int", {Value::of(6.0), Value::of(1.0), Value::of(1.0)}).told(),
              "E0304 10 `hi` of `rand_int` is 1, less than `lo`, 6");
    EXPECT_EQ(BuiltinCall("rand_int", {Value::of(0.0), Value::of(most), Value::of(1.0)}).told(),
              "E0304 10 `rand_int` chooses among at most 2^53 numbers");
    EXPECT_EQ(BuiltinCall("rand_int", {Value::of(-1e300), Value::of(1.0), Value::of(1.0)}).told(),
              "E0304 0 `rand_int` goes to 2^53 and no further, this is -1e+300");
    EXPECT_EQ(BuiltinCall("rand_int", {Value::of(0.5), Value::of(1.0), Value::of(1.0)}).told(),
              "E0308 0 `lo` of `rand_int` needs a whole number, this is 0.5");
}

TEST(RandomBuiltins, KeysAreNumbersOrStrings) {
    EXPECT_EQ(BuiltinCall("rand", {Value::of(true)}).told(),
              "E0301 0 `seed` of `rand` needs a number or a string, this is true");
    EXPECT_EQ(BuiltinCall("rand", {Value::of(1.0), Value::of(2.0), Value::of(false)}).told(),
              "E0301 20 every argument of `rand` needs a number or a string, this is false");
    const BuiltinCall poisoned("rand", {Value::of(1.0), Value::poison()});
    EXPECT_TRUE(poisoned.value.is(ValueKind::poison));
    EXPECT_EQ(poisoned.told(), "");
}

TEST(RandomBuiltins, DirectionsAreUniformOnTheSphere) {
    DVec3 sum{0.0};
    DVec3 squares{0.0};
    constexpr int kCount = 20'000;
    for (int i = 0; i < kCount; ++i) {
        const BuiltinCall call("rand_on_sphere", {Value::of(5.0), Value::of(1.0 * i)});
        ASSERT_TRUE(call.value.is_vector(3));
        const DVec3 p = call.value.vec3();
        EXPECT_NEAR(glm::length(p), 1.0, 1e-15);
        sum += p;
        squares += p * p;
    }
    for (int axis = 0; axis < 3; ++axis) {  // by Archimedes each coordinate is uniform in [-1, 1]
        EXPECT_NEAR(sum[axis] / kCount, 0.0, 0.0165);
        EXPECT_NEAR(squares[axis] / kCount, 1.0 / 3.0, 0.0085);
    }
}

TEST(RandomBuiltins, PointsAreUniformInTheDisk) {
    int inner_count = 0;
    DVec2 sum{0.0};
    constexpr int kCount = 20'000;
    for (int i = 0; i < kCount; ++i) {
        const BuiltinCall call("rand_in_disk", {Value::of(5.0), Value::of(1.0 * i)});
        ASSERT_TRUE(call.value.is_vector(2));
        const DVec2 p{call.value.numbers[0], call.value.numbers[1]};
        EXPECT_LE(glm::length(p), 1.0);
        if (glm::length(p) < 0.5) ++inner_count;
        sum += p;
    }
    EXPECT_NEAR(inner_count / double{kCount}, 0.25, 0.0125);
    EXPECT_NEAR(sum.x / kCount, 0.0, 0.015);
    EXPECT_NEAR(sum.y / kCount, 0.0, 0.015);
}

TEST(RandomBuiltins, GaussIsNormal) {
    std::array<double, 4> moments{};
    int within_one = 0;
    constexpr int kCount = 50'000;
    for (int i = 0; i < kCount; ++i) {
        const double x = number("gauss", {Value::of(11.0), Value::of(1.0 * i)});
        ASSERT_TRUE(std::isfinite(x));
        double power = 1.0;
        for (double& moment : moments) moment += (power *= x) / kCount;
        if (std::fabs(x) < 1.0) ++within_one;
    }
    EXPECT_NEAR(moments[0], 0.0, 0.018);
    EXPECT_NEAR(moments[1], 1.0, 0.026);
    EXPECT_NEAR(moments[2], 0.0, 0.07);
    EXPECT_NEAR(moments[3], 3.0, 0.18);
    EXPECT_NEAR(within_one / double{kCount}, 0.6827, 0.0085);
}

TEST(RandomBuiltins, ShuffleKeepsEveryElement) {
    std::vector<double> numbers(100);
    for (std::size_t i = 0; i < 100; ++i) numbers[i] = static_cast<double>(i);
    const BuiltinCall call("shuffle", {Value::of_numbers(numbers), Value::of(3.0)});
    ASSERT_TRUE(call.value.is(ValueKind::numbers));
    std::vector<double> shuffled(call.value.numbers, call.value.numbers + call.value.count);
    EXPECT_NE(shuffled, numbers);
    std::sort(shuffled.begin(), shuffled.end());
    EXPECT_EQ(shuffled, numbers);
    const BuiltinCall other("shuffle", {Value::of_numbers(numbers), Value::of(4.0)});
    EXPECT_FALSE(std::equal(numbers.begin(), numbers.end(), other.value.numbers));
}

TEST(RandomBuiltins, EveryOrderOfThreeIsAsLikely) {
    const std::vector<double> numbers = {0.0, 1.0, 2.0};
    std::array<int, 27> counts{};
    for (int i = 0; i < 6000; ++i) {
        const BuiltinCall call("shuffle", {Value::of_numbers(numbers), Value::of(1.0 * i)});
        const double* n = call.value.numbers;
        ++counts[static_cast<std::size_t>(9.0 * n[0] + 3.0 * n[1] + n[2])];
    }
    int orders = 0;
    for (const int count : counts) {
        if (count == 0) continue;
        ++orders;
        EXPECT_NEAR(count, 1000, 100);  // three standard errors and a bit
    }
    EXPECT_EQ(orders, 6);
}

TEST(RandomBuiltins, ShuffleTakesEmptyAndMixedLists) {
    EXPECT_EQ(BuiltinCall("shuffle", {Value::of_numbers({}), Value::of(3.0)}).value.count, 0u);
    EXPECT_EQ(string_of("shuffle([\"a\"], 1)[0]"), "a");
    EXPECT_EQ(number_of("shuffle([[1, 2], [1, 3]], 1)[1][0]"), 1.0);
}

TEST(RandomBuiltins, PickChoosesEachElement) {
    const std::vector<double> numbers = {10.0, 20.0, 30.0};
    std::array<int, 3> counts{};
    for (int i = 0; i < 3000; ++i) {
        const double x =
            number("pick", {Value::of_numbers(numbers), Value::of(1.0), Value::of(1.0 * i)});
        ++counts[static_cast<std::size_t>(x / 10.0) - 1];
    }
    for (const int count : counts) EXPECT_NEAR(count, 1000, 100);
    EXPECT_EQ(BuiltinCall("pick", {Value::of_numbers({}), Value::of(1.0)}).told(),
              "E0505 0 `pick` from a list without elements");
}

TEST(NoiseBuiltins, PositionsHaveOneToThreeNumbers) {
    const NoiseSeed zero(KeyedRandom{}.with(0.0));
    EXPECT_EQ(number_of("noise(0.3)"), noise(0.3, zero));
    EXPECT_EQ(number_of("noise([0.3, 1.4, -2.6])"), noise(DVec3{0.3, 1.4, -2.6}, zero));
    EXPECT_EQ(number_of("worley([0.3, 1.4])"), worley(DVec2{0.3, 1.4}, zero));
    EXPECT_EQ(number_of("fbm([0.3, 1.4])"), fbm(DVec2{0.3, 1.4}, {}, zero));
    EXPECT_EQ(number_of("fbm([0.3, 1.4], octaves: 3, gain: 0.7, lacunarity: 1.9)"),
              fbm(DVec2{0.3, 1.4}, {3, 1.9, 0.7}, zero));
    EXPECT_EQ(number_of("ridged([0.3, 1.4], 4, 2, 0.5, \"alps\")"),
              ridged(DVec2{0.3, 1.4}, {4, 2.0, 0.5}, NoiseSeed(KeyedRandom{}.with("alps"))));
}

TEST(NoiseBuiltins, MistakesAreTold) {
    const Value x = Value::of(0.5);
    EXPECT_EQ(BuiltinCall("fbm", {x, Value::of(0.0)}).told(),
              "E0304 10 `octaves` of `fbm` must be from 1 to 32, this is 0");
    EXPECT_EQ(BuiltinCall("ridged", {x, Value::of(33.0)}).told(),
              "E0304 10 `octaves` of `ridged` must be from 1 to 32, this is 33");
    EXPECT_EQ(BuiltinCall("fbm", {x, Value::of(2.5)}).told(),
              "E0308 10 `octaves` of `fbm` needs a whole number, this is 2.5");
    EXPECT_EQ(BuiltinCall("fbm", {x, Value::of(3.0), Value::of(0.0)}).told(),
              "E0304 20 `lacunarity` of `fbm` must be greater than 0, this is 0");
    EXPECT_EQ(BuiltinCall("fbm", {x, Value::of(3.0), Value::of(2.0), Value::of(-1.0)}).told(),
              "E0304 30 `gain` of `fbm` must be 0 or greater, this is -1");
    EXPECT_EQ(BuiltinCall("noise", {text("here")}).told(),
              "E0301 0 `p` of `noise` needs a number or a vector of 2 or 3, this is a string");
    EXPECT_EQ(BuiltinCall("fbm", {Value::of(1.0), Value::of(32.0), Value::of(1e300)}).told(),
              "E0503 1 `fbm` has no value here: its octaves are too many or too far away");
}

}  // namespace
}  // namespace lray::test
