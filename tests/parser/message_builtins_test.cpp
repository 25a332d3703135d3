// Functions that tell the user something.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/parser/builtin_caller.h"

namespace lray::test {
namespace {

using ::testing::ElementsAre;

class MessageFunctions : public ::testing::Test, public BuiltinCaller {};

TEST_F(MessageFunctions, PrintPutsASpaceBetweenValues) {
    EXPECT_EQ(says("print", {string("x ="), number(0.5), numbers({1, 2})}), "true");
    EXPECT_EQ(says("print", {}), "true");
    EXPECT_THAT(printed, ElementsAre("x = 0.5 [1, 2]", ""));
}

TEST_F(MessageFunctions, PrintedLinesAreCut) {
    const std::string long_text(10'000, 'x');
    EXPECT_EQ(says("print", {string(long_text), string(long_text)}), "true");
    ASSERT_EQ(printed.size(), 1u);
    EXPECT_EQ(printed[0].size(), 16384u);
    EXPECT_TRUE(printed[0].ends_with("x..."));
}

TEST_F(MessageFunctions, WarnWarnsAtTheCall) {
    EXPECT_EQ(says("warn", {string("too many trees")}), "W1106 1 too many trees");
    EXPECT_EQ(diagnostics.warning_count(), 1u);
    EXPECT_EQ(call("warn", {number(3)}).boolean, true);
}

TEST_F(MessageFunctions, ErrorFailsAtTheCall) {
    EXPECT_EQ(says("error", {string("no such style")}), "E0508 1 no such style");
    EXPECT_EQ(says("error", {string(std::string(5000, 'x'))}).size(),
              std::string("E0508 1 ").size() + 1024);
}

TEST_F(MessageFunctions, AssertFailsAtItsCondition) {
    EXPECT_EQ(says("assert", {boolean(true), string("never said")}), "true");
    EXPECT_EQ(says("assert", {boolean(false), string("at least 3 steps")}),
              "E0507 10 at least 3 steps");
    EXPECT_EQ(says("assert", {boolean(false)}), "E0507 10 this does not hold");
    EXPECT_EQ(says("assert", {number(1)}),
              "E0301 10 `condition` of `assert` needs true or false, this is a number");
}

TEST_F(MessageFunctions, OnlyTheseHaveEffects) {
    std::vector<std::string> names;
    for (const parser::Builtin& builtin : parser::builtins()) {
        if (builtin.has_effects) names.emplace_back(builtin.name);
    }
    EXPECT_THAT(names, ElementsAre("print", "warn"));
}

TEST_F(MessageFunctions, OnlyTheseAreCalledWithoutUsingTheirValue) {
    std::vector<std::string> names;
    for (const parser::Builtin& builtin : parser::builtins()) {
        if (builtin.is_statement) names.emplace_back(builtin.name);
    }
    EXPECT_THAT(names, ElementsAre("print", "warn", "error", "assert"));
}

}  // namespace
}  // namespace lray::test
