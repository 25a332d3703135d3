// Functions of lists: what they return, how they are kept within their limits.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "tests/parser/builtin_caller.h"

namespace lray::test {
namespace {

using parser::Value;
using parser::ValueKind;

class ListFunctions : public ::testing::Test, public BuiltinCaller {
 protected:
    Value add_ = function([](auto v) { return Value::of(v[0].number + v[1].number); });
    Value negate_ = function([](auto v) { return Value::of(-v[0].number); });
    Value poison_ = function([](auto) { return Value::poison(); });
    const Value empty_ = numbers({});
};

TEST_F(ListFunctions, RangesExcludeTheirEnd) {
    EXPECT_EQ(says("range", {number(4)}), "[0, 1, 2, 3]");
    EXPECT_EQ(says("range", {number(2.5)}), "[0, 1, 2]");
    EXPECT_EQ(says("range", {number(2), number(5)}), "[2, 3, 4]");
    EXPECT_EQ(says("range", {number(0), number(1), number(0.25)}), "[0, 0.25, 0.5, 0.75]");
    EXPECT_EQ(says("range", {number(5), number(2), number(-1)}), "[5, 4, 3]");
    EXPECT_EQ(says("range", {number(0)}), "[]");
    EXPECT_EQ(says("range", {number(-3)}), "[]");
    EXPECT_EQ(says("range", {number(5), number(2)}), "[]");
}

TEST_F(ListFunctions, RangesAreStartPlusMultiplesOfTheStep) {
    for (const double step : {0.1, 0.3, 1.0 / 3.0, 1e-3, 0.7}) {
        for (int n = 1; n < 60; ++n) {
            const double end = n * step;
            const Value range = call("range", {number(0), number(end), number(step)});
            ASSERT_TRUE(range.is(ValueKind::numbers));
            for (std::uint32_t i = 0; i < range.count; ++i) {
                EXPECT_EQ(range.numbers[i], i * step);
                EXPECT_LT(range.numbers[i], end);
            }
            EXPECT_GE(range.count * step, end) << "the next one is outside";
        }
    }
}

TEST_F(ListFunctions, HostileRangesEnd) {
    EXPECT_EQ(says("range", {number(0), number(1), number(0)}),
              "E0304 30 a range with a step of 0 never ends");
    EXPECT_EQ(says("range", {number(1e308)}),
              "E0514 1 this list would have 1e+308 elements, more than the limit of 1000 "
              "(`--max-list-size`)");
    EXPECT_EQ(says("range", {number(-1e308), number(1e308), number(1e308)}), "[-1e+308, 0]");
    EXPECT_EQ(says("range", {number(-1e308), number(1e308), number(-1)}), "[]");
    const double tiny = std::numeric_limits<double>::denorm_min();
    EXPECT_EQ(says("range", {number(0), number(tiny), number(tiny)}), "[0]");
    EXPECT_TRUE(says("range", {number(0), number(1), number(tiny)}).starts_with("E0514"));
    EXPECT_TRUE(says("range", {number(1e300), number(1e300 * (1 + 1e-15)), number(1)})
                    .starts_with("E0514"));
}

TEST_F(ListFunctions, ListsAreAsLongAsTheirLimitAllows) {
    for (const double size : {999.0, 1000.0, 1001.0}) {
        const bool fits = size <= 1000.0;
        EXPECT_EQ(call("range", {number(size)}).is_list(), fits) << size;
        EXPECT_EQ(call("linspace", {number(0), number(1), number(size)}).is_list(), fits) << size;
    }
    const Value half = call("range", {number(500)});
    EXPECT_EQ(call("concat", {half, half}).count, 1000u);
    EXPECT_EQ(says("concat", {half, half, numbers({1})}),
              "E0514 1 this list would have 1001 elements, more than the limit of 1000 "
              "(`--max-list-size`)");
    EXPECT_TRUE(says("flatten", {list({half, half, numbers({1})})}).starts_with("E0514"));
}

TEST_F(ListFunctions, MemoryIsTakenBeforeItIsUsed) {
    budget.max_list_size = std::numeric_limits<std::uint64_t>::max();
    EXPECT_TRUE(says("range", {number(5e9)}).starts_with("E0514")) << "no list has 2^32 elements";
    EXPECT_TRUE(says("range", {number(4e9)}).starts_with("E0516"));
    EXPECT_TRUE(call("range", {number(3)}).is(ValueKind::poison));
    EXPECT_EQ(diagnostics.error_count(), 1u) << "spent, nothing more is said";
}

TEST_F(ListFunctions, StepsAreTakenForEachElement) {
    budget.steps = 100;
    EXPECT_EQ(call("range", {number(60)}).count, 60u);
    EXPECT_EQ(budget.steps, 40u);
    EXPECT_TRUE(says("range", {number(60)}).starts_with("E0512"));
}

TEST_F(ListFunctions, LinspaceIncludesBothEnds) {
    EXPECT_EQ(says("linspace", {number(0), number(1), number(5)}), "[0, 0.25, 0.5, 0.75, 1]");
    EXPECT_EQ(says("linspace", {number(3), number(-3), number(2)}), "[3, -3]");
    EXPECT_EQ(says("linspace", {number(-1e308), number(1e308), number(3)}), "[-1e+308, 0, 1e+308]");
    const Value tenths = call("linspace", {number(0.1), number(0.7), number(7)});
    EXPECT_EQ(tenths.numbers[0], 0.1);
    EXPECT_EQ(tenths.numbers[6], 0.7);
    EXPECT_EQ(says("linspace", {number(0), number(1), number(1)}),
              "E0304 30 `linspace` makes 2 numbers at least, this is 1");
    EXPECT_EQ(says("linspace", {number(0), number(1), number(2.5)}),
              "E0308 30 `count` of `linspace` needs a whole number, this is 2.5");
}

TEST_F(ListFunctions, LenCountsElementsCharactersAndFields) {
    EXPECT_EQ(says("len", {numbers({1, 2, 3})}), "3");
    EXPECT_EQ(says("len", {empty_}), "0");
    EXPECT_EQ(says("len", {list({numbers({1, 2}), numbers({3, 4}), numbers({5, 6})})}), "3");
    EXPECT_EQ(says("len", {string("h\xc3\xa9llo \xf0\x9f\x98\x80")}), "7");
    EXPECT_EQ(says("len", {number(3)}),
              "E0301 10 `len` needs a list, a string or a record, this is a number");
}

TEST_F(ListFunctions, ListsAreJoinedAndFlattenedAndReversed) {
    const Value rows = list({numbers({1, 2}), numbers({3, 4})});
    EXPECT_EQ(says("concat", {numbers({1}), empty_, numbers({2, 3})}), "[1, 2, 3]");
    EXPECT_EQ(call("concat", {numbers({1}), numbers({2})}).kind, ValueKind::numbers);
    EXPECT_EQ(says("concat", {numbers({1}), list({boolean(true)})}), "[1, true]");
    EXPECT_EQ(says("flatten", {rows}), "[1, 2, 3, 4]");
    EXPECT_EQ(says("flatten", {list({rows, number(5), list({list({rows})})})}),
              "[[1, 2], [3, 4], 5, [[[1, 2], [3, 4]]]]");
    EXPECT_EQ(says("flatten", {empty_}), "[]");
    EXPECT_EQ(says("reverse", {numbers({1, 2, 3})}), "[3, 2, 1]");
    EXPECT_EQ(says("reverse", {rows}), "[[3, 4], [1, 2]]");
    EXPECT_EQ(call("reverse", {rows}).kind, ValueKind::rows);
}

TEST_F(ListFunctions, SumAddsNumbersAndVectors) {
    EXPECT_EQ(says("sum", {numbers({1, 2, 3.5})}), "6.5");
    EXPECT_EQ(says("sum", {list({numbers({1, 2}), numbers({3, 4})})}), "[4, 6]");
    EXPECT_EQ(says("sum", {empty_}), "0");
    EXPECT_EQ(says("sum", {numbers({1e308, 1e308})}), "E0503 1 `sum(...)` has no finite value");
    EXPECT_EQ(says("sum", {list({string("a")})}),
              "E0301 10 `sum` needs a list of numbers, or of vectors of one size");
}

TEST_F(ListFunctions, LeastAndGreatestOfAList) {
    EXPECT_EQ(says("min", {numbers({3, -1, 2})}), "-1");
    EXPECT_EQ(says("max", {numbers({3, -1, 2})}), "3");
    EXPECT_EQ(says("max", {numbers({3, -1}), number(0)}), "[3, 0]");
    EXPECT_EQ(says("min", {empty_}), "E0505 10 `min` needs a list with elements, this has none");
    EXPECT_EQ(says("max", {list({string("a")})}),
              "E0301 10 `a` of `max` needs a number or a vector, this is a list of 1 element");
}

TEST_F(ListFunctions, SlicesKeepTheirPacking) {
    const Value xs = numbers({10, 20, 30, 40});
    EXPECT_EQ(says("slice", {xs, number(1), number(3)}), "[20, 30]");
    EXPECT_EQ(says("slice", {xs, number(2)}), "[30, 40]");
    EXPECT_EQ(says("slice", {xs, number(4)}), "[]");
    EXPECT_EQ(call("slice", {xs, number(4)}).kind, empty_.kind);
    const Value rows = list({numbers({1, 2}), numbers({3, 4}), numbers({5, 6})});
    EXPECT_EQ(says("slice", {rows, number(1)}), "[[3, 4], [5, 6]]");
    EXPECT_EQ(says("slice", {list({number(1), string("b"), number(3)}), number(2)}), "[3]");
    EXPECT_EQ(says("slice", {xs, number(-1)}),
              "E0504 20 a slice begins and ends between 0 and 4, this is -1");
    EXPECT_EQ(says("slice", {xs, number(0), number(1e308)}),
              "E0504 30 a slice begins and ends between 0 and 4, this is 1e+308");
    EXPECT_EQ(says("slice", {xs, number(3), number(1)}),
              "E0504 30 this slice ends at 1, before it begins at 3");
}

TEST_F(ListFunctions, ZipPairsElements) {
    EXPECT_EQ(says("zip", {numbers({1, 2}), list({string("a"), string("b")})}),
              "[[1, \"a\"], [2, \"b\"]]");
    EXPECT_EQ(call("zip", {numbers({1, 2}), numbers({3, 4}), numbers({5, 6})}).kind,
              ValueKind::rows);
    EXPECT_EQ(says("zip", {empty_, empty_}), "[]");
    EXPECT_EQ(says("zip", {numbers({1, 2}), numbers({1, 2, 3})}),
              "E0302 1 these have 2 and 3 elements");
}

TEST_F(ListFunctions, ElementsAreFound) {
    const Value mixed = list({number(1), string("b"), numbers({1, 2})});
    EXPECT_EQ(says("contains", {mixed, string("b")}), "true");
    EXPECT_EQ(says("contains", {mixed, numbers({1, 2})}), "true");
    EXPECT_EQ(says("contains", {mixed, boolean(true)}), "false");
    EXPECT_EQ(says("index_of", {mixed, numbers({1, 2})}), "2");
    EXPECT_EQ(says("index_of", {numbers({5, 7, 7}), number(7)}), "1");
    EXPECT_EQ(says("index_of", {numbers({5, 7}), string("7")}), "-1");
}

TEST_F(ListFunctions, MapFilterAndReduceCallTheirFunction) {
    const Value xs = numbers({1, 2, 3});
    const Value is_odd = function([](auto v) { return Value::of(v[0].number != 2.0); });
    EXPECT_EQ(says("map", {xs, negate_}), "[-1, -2, -3]");
    EXPECT_EQ(call("map", {xs, negate_}).kind, ValueKind::numbers);
    EXPECT_EQ(says("map", {empty_, negate_}), "[]");
    EXPECT_EQ(says("filter", {xs, is_odd}), "[1, 3]");
    EXPECT_EQ(says("reduce", {xs, add_}), "6");
    EXPECT_EQ(says("reduce", {xs, add_, number(10)}), "16");
    EXPECT_EQ(says("reduce", {empty_, add_, number(10)}), "10");
    EXPECT_EQ(says("reduce", {empty_, add_}),
              "E0505 10 `reduce` needs a list with elements, this has none");
    EXPECT_EQ(says("filter", {xs, negate_}),
              "E0301 20 `filter` needs a function that returns true or false, this returned a "
              "number");
    EXPECT_EQ(says("map", {xs, number(1)}),
              "E0301 20 `f` of `map` needs a function, this is a number");
}

TEST_F(ListFunctions, PoisonFromAFunctionIsSilent) {
    for (const char* name : {"map", "filter", "reduce", "sort"}) {
        EXPECT_TRUE(call(name, {numbers({1, 2}), poison_}).is(ValueKind::poison)) << name;
    }
    EXPECT_EQ(diagnostics.error_count(), 0u);
}

TEST_F(ListFunctions, SortIsStableAndTakesAKey) {
    EXPECT_EQ(says("sort", {numbers({3, 1, 2})}), "[1, 2, 3]");
    EXPECT_EQ(says("sort", {list({string("pear"), string("Apple"), string("fig")})}),
              "[\"Apple\", \"fig\", \"pear\"]");
    const Value first = function([](auto v) { return Value::of(v[0].numbers[0]); });
    const Value rows = list({numbers({2, 1}), numbers({1, 2}), numbers({2, 3}), numbers({1, 4})});
    EXPECT_EQ(says("sort", {rows, first}), "[[1, 2], [1, 4], [2, 1], [2, 3]]");
    EXPECT_EQ(says("sort", {empty_}), "[]");
    EXPECT_EQ(says("sort", {list({number(1), string("a")})}),
              "E0301 10 only numbers, or only strings, have an order; here are others");
    EXPECT_EQ(says("sort", {rows, function([](auto v) { return v[0]; })}),
              "E0301 20 only numbers, or only strings, have an order; this key returns others");
}

TEST_F(ListFunctions, ListsNestSoDeepAndNoDeeper) {
    for (const std::size_t depth : {199u, 200u, 201u}) {
        const Value inner = nested(depth - 1);
        const std::string told = says("map", {numbers({1}), function([&](auto) { return inner; })});
        EXPECT_EQ(told.starts_with('['), depth <= 200) << depth;
        if (depth <= 200) continue;
        EXPECT_EQ(told, "E0514 1 lists are nested more than 200 deep");
    }
    EXPECT_EQ(nested(3).depth(), 3);
    EXPECT_EQ(nested(1000).depth(), 255) << "never around to 0";
}

}  // namespace
}  // namespace lray::test
