// Functions of strings, and values as text.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <string>

#include "tests/parser/builtin_caller.h"

namespace lray::test {
namespace {

using parser::Value;
using parser::ValueKind;

class StringFunctions : public ::testing::Test, public BuiltinCaller {};

TEST_F(StringFunctions, ValuesReadAsTheyAreWritten) {
    EXPECT_EQ(says("str", {number(0.1), string(" m, "), boolean(true)}), "\"0.1 m, true\"");
    EXPECT_EQ(says("str", {}), "\"\"");
    EXPECT_EQ(says("str", {numbers({1, 2.5})}), "\"[1, 2.5]\"");
    EXPECT_EQ(says("str", {list({numbers({1, 2}), numbers({3, 4})})}), "\"[[1, 2], [3, 4]]\"");
    EXPECT_EQ(says("str", {list({string("a\"b\n"), boolean(false)})}),
              "\"[\"a\\\"b\\n\", false]\"");
    EXPECT_EQ(says("str", {color(1, 0.5, 0)}), "\"rgb(1, 0.5, 0)\"");
    EXPECT_EQ(says("str", {call("translation", {numbers({1, 2, 3})})}),
              "\"matrix([[1, 0, 0, 1], [0, 1, 0, 2], [0, 0, 1, 3]])\"");
    EXPECT_EQ(says("str", {node(scene::NodeId(0))}), "\"a group\"");
    const parser::FunctionValue sine{nullptr, *parser::find_builtin("sin")};
    EXPECT_EQ(says("str", {Value::of_function(&sine, 1)}), "\"fn sin\"");
    const std::array fields = {parser::RecordField{intern("a"), number(1)},
                               parser::RecordField{intern("b"), string("x")}};
    EXPECT_EQ(says("str", {Value::of_record(fields, 1)}), "\"record { a: 1, b: \"x\" }\"");
    EXPECT_EQ(says("str", {Value::of_record({}, 1)}), "\"record { }\"");
}

TEST_F(StringFunctions, NumbersReadBackAreTheSame) {
    for (const double x : {0.1, 1.0 / 3.0, 1e21, 1e-300, 123456789.0, 5e-324}) {
        const std::string text(call("str", {number(x)}).string());
        EXPECT_EQ(std::strtod(text.c_str(), nullptr), x) << text;
    }
}

TEST_F(StringFunctions, TextIsCutBetweenCharacters) {
    const std::string e_acute = "\xc3\xa9";
    const Value text = string(e_acute + e_acute + e_acute + e_acute);  // 8 bytes
    EXPECT_EQ(value_text(text, symbols(), 8), e_acute + e_acute + e_acute + e_acute);
    EXPECT_EQ(value_text(text, symbols(), 7), e_acute + e_acute + "...");
    EXPECT_EQ(value_text(text, symbols(), 6), e_acute + "...");
    EXPECT_EQ(value_text(text, symbols(), 3), "...");
    EXPECT_EQ(value_text(call("range", {number(100)}), symbols(), 12), "[0, 1, 2,...");
}

TEST_F(StringFunctions, SharedListsAreNotWrittenOutForEver) {
    Value value = boolean(true);
    for (int i = 0; i < 100; ++i) value = list({value, value});
    EXPECT_EQ(value_text(value, symbols(), 1000).size(), 1000u);
    EXPECT_TRUE(says("str", {value}).starts_with("E0516")) << "2^100 words";
}

TEST_F(StringFunctions, StringsTakeTheirMemoryFromTheBudget) {
    const Value text = string("0123456789");
    for (const std::uint64_t bytes : {29u, 30u, 31u}) {
        budget.steps = budget.max_steps;
        budget.value_bytes = bytes;
        budget.is_spent = false;
        const std::string told = says("str", {text, text, text});
        EXPECT_EQ(told.starts_with('"'), bytes >= 30) << told;
        EXPECT_EQ(told.starts_with("E0516"), bytes < 30);
    }
}

TEST_F(StringFunctions, TheLeftmostStringSaysWhereItWasWritten) {
    const Value left = string("a", 3);
    const Value right = string("b", 4);
    EXPECT_EQ(call("str", {number(1), left, right}).source, 3);
    EXPECT_EQ(call("str", {number(1)}).source, 0) << "that of the call";
    EXPECT_EQ(call("join", {list({right, left}), left}).source, 4);
    EXPECT_EQ(call("format", {left, right}).source, kNoSource) << "a value too many";
    EXPECT_EQ(call("format", {string("{}", 5), right}).source, 5);
    EXPECT_EQ(call("upper", {right}).source, 4);
    EXPECT_EQ(call("split", {right, string("x")}).elements[0].source, 4);
}

TEST_F(StringFunctions, FormatPutsValuesInTheirPlaces) {
    EXPECT_EQ(says("format", {string("x = {}, {:.2}"), numbers({1, 2}), number(1.0 / 3.0)}),
              "\"x = [1, 2], 0.33\"");
    EXPECT_EQ(says("format", {string("{:.0} {:.17}"), number(2.5), number(1)}),
              "\"2 1.00000000000000000\"");
    EXPECT_EQ(says("format", {string("{{}} {}"), string("{}")}), "\"{} {}\"");
    EXPECT_EQ(says("format", {string("")}), "\"\"");
    EXPECT_EQ(says("format", {string("{:.2}"), number(-1e308)}).size(), 1 + 309 + 3 + 2u);
}

TEST_F(StringFunctions, FormatSaysWhatIsWrong) {
    EXPECT_EQ(says("format", {string("a {} {}"), number(1)}),
              "E0305 1 this text has more places `{}` than the 1 value that follows");
    EXPECT_EQ(says("format", {string("a {}")}),
              "E0305 1 this text has more places `{}` than the 0 values that follow");
    EXPECT_EQ(says("format", {string("a {}"), number(1), number(2)}),
              "E0306 30 this text has 1 place `{}`, but 2 values follow");
    EXPECT_EQ(says("format", {string("{:.2}"), string("a")}),
              "E0301 20 `{:.2}` is for a number, this is a string");
    for (const char* wrong :
         {"{x}", "{:.}", "{:2}", "{:.18}", "{:.999999999999}", "{", "}", "{:."}) {
        const std::string told = says("format", {string(wrong), number(1)});
        EXPECT_TRUE(told.starts_with("E0312 10 `")) << wrong << ": " << told;
    }
    EXPECT_EQ(says("format", {string("a {name} b"), number(1)}),
              "E0312 10 `{name}` in this text is no place for a value");
}

TEST_F(StringFunctions, LettersOfAsciiChange) {
    EXPECT_EQ(says("upper", {string("az AZ 09 \xc3\xa9")}), "\"AZ AZ 09 \xc3\xa9\"");
    EXPECT_EQ(says("lower", {string("az AZ 09 \xc3\xa9")}), "\"az az 09 \xc3\xa9\"");
    EXPECT_EQ(says("upper", {number(1)}),
              "E0301 10 `text` of `upper` needs a string, this is a number");
}

TEST_F(StringFunctions, SplitAndJoinUndoEachOther) {
    EXPECT_EQ(says("split", {string("a, b,, c"), string(", ")}), "[\"a\", \"b,\", \"c\"]");
    EXPECT_EQ(says("split", {string(",a,"), string(",")}), "[\"\", \"a\", \"\"]");
    EXPECT_EQ(says("split", {string(""), string(",")}), "[\"\"]");
    EXPECT_EQ(says("split", {string("a\xc3\xa9z"), string("")}), "[\"a\", \"\xc3\xa9\", \"z\"]");
    EXPECT_EQ(says("split", {string(""), string("")}), "[]");
    EXPECT_EQ(says("join", {list({string("a"), number(1), string("c")}), string(", ")}),
              "\"a, 1, c\"");
    EXPECT_EQ(says("join", {numbers({1, 2})}), "\"12\"");
    EXPECT_EQ(says("join", {numbers({}), string(", ")}), "\"\"");
}

}  // namespace
}  // namespace lray::test
