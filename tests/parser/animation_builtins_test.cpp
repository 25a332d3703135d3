// Functions of time.
#include <gtest/gtest.h>

#include "tests/parser/builtin_caller.h"

namespace lray::test {
namespace {

using parser::Value;

class KeyFunctions : public ::testing::Test, public BuiltinCaller {
 protected:
    std::string at(double time, const char* ease = nullptr) {
        std::vector<Value> arguments = {keys_, number(time)};
        if (ease != nullptr) arguments.push_back(string(ease));
        return says("keys", arguments);
    }

    Value keys_ = list({numbers({0, 10}), numbers({2, 20}), numbers({4, 0})});
};

TEST_F(KeyFunctions, ReachTheirValuesAndHoldOutside) {
    for (const char* ease : {"smooth", "linear", "step"}) {
        EXPECT_EQ(at(-1e308, ease), "10");
        EXPECT_EQ(at(0, ease), "10");
        EXPECT_EQ(at(2, ease), "20");
        EXPECT_EQ(at(4, ease), "0");
        EXPECT_EQ(at(1e308, ease), "0");
    }
}

TEST_F(KeyFunctions, GoFromOneToTheNextAsEased) {
    EXPECT_EQ(at(0.5, "linear"), "12.5");
    EXPECT_EQ(at(0.5, "smooth"), "11.5625");  // t = 1/4: t t (3 - 2 t) = 5/32
    EXPECT_EQ(at(0.5), "11.5625") << "smooth unless said otherwise";
    EXPECT_EQ(at(1.99, "step"), "10");
    EXPECT_EQ(at(3, "linear"), "10");
}

TEST_F(KeyFunctions, TakeVectorsAndColours) {
    const Value vectors =
        list({list({number(0), numbers({0, 0, 0})}), list({number(1), numbers({2, 4, 6})})});
    EXPECT_EQ(says("keys", {vectors, number(0.5)}), "[1, 2, 3]");
    const Value colors =
        list({list({number(0), color(0, 0, 0)}), list({number(1), color(1, 0.5, 0)})});
    EXPECT_EQ(says("keys", {colors, number(0.5)}), "rgb(0.5, 0.25, 0)");
    EXPECT_EQ(says("keys", {list({numbers({5, 7})}), number(0)}), "7");
}

TEST_F(KeyFunctions, SayWhatIsWrong) {
    const Value zero = number(0);
    EXPECT_EQ(says("keys", {numbers({}), zero}),
              "E0505 10 `keys` needs a list with elements, this has none");
    EXPECT_EQ(says("keys", {list({numbers({1, 0}), numbers({1, 0})}), zero}),
              "E0304 10 the times of keys must increase: 1 follows 1");
    EXPECT_EQ(says("keys", {numbers({1, 2}), zero}),
              "E0301 10 `keys` needs pairs of a time and a number, vector or colour, like "
              "[[0, 1], [2, 5]]; element 0 is a number");
    EXPECT_TRUE(says("keys", {list({numbers({0, 1, 2})}), zero}).starts_with("E0301 10 "));
    EXPECT_TRUE(says("keys", {list({list({string("a"), number(1)})}), zero}).starts_with("E0301"));
    EXPECT_EQ(at(1, "smoth"), "E0403 30 `ease` of `keys` is \"smooth\", \"linear\" or \"step\"");
    EXPECT_EQ(diagnostics.sorted()[0]->hint, "did you mean `smooth`?");
    EXPECT_EQ(
        says("keys",
             {list({list({number(0), numbers({1, 2})}), list({number(1), numbers({1, 2, 3})})}),
              number(0.5)}),
        "E0302 1 these have 2 and 3 elements");
}

TEST_F(KeyFunctions, TimesFarApartStayFinite) {
    const Value far = list({numbers({-1.7e308, 0}), numbers({1.7e308, 1})});
    EXPECT_EQ(says("keys", {far, number(0), string("linear")}), "0.5");
}

}  // namespace
}  // namespace lray::test
