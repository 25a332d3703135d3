#include "base/json_writer.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "tests/support/json.h"

namespace lray {
namespace {

std::string written(std::string_view text) {
    JsonWriter json;
    json.string(text);
    return json.take();
}

TEST(JsonWriter, NestsWithCommasBetween) {
    JsonWriter json;
    json.begin_object().member("a", 1).key("b").begin_array();
    json.number(2).begin_object().end_object().begin_array().end_array().null().string("x");
    json.end_array().member("c", "y").end_object();
    EXPECT_EQ(json.take(), R"({"a":1,"b":[2,{},[],null,"x"],"c":"y"})");
}

TEST(JsonWriter, DecimalsReadBackAsTheSameAndNanIsNull) {
    for (const double value : {0.0, 0.1, -2.5, 1e300, 5e-324, 1.0 / 3.0, 12345678.0}) {
        JsonWriter json;
        json.decimal(value);
        EXPECT_EQ(test::read_json(json.take()).number, value);
    }
    JsonWriter json;
    json.begin_array().decimal(0.5).decimal(std::numeric_limits<double>::quiet_NaN());
    json.decimal(std::numeric_limits<double>::infinity()).end_array();
    EXPECT_EQ(json.take(), "[0.5,null,null]");
}

TEST(JsonWriter, StringsEscapeWhatJsonAndTerminalsMustNotSee) {
    EXPECT_EQ(written("a\"b\\c/d"), R"("a\"b\\c/d")");
    EXPECT_EQ(written("\n\r\t\b"), R"("\n\r\t\u0008")");
    EXPECT_EQ(written(std::string_view("\0\x1b[31m\x7f", 7)), R"("\u0000\u001b[31m\u007f")");
    EXPECT_EQ(written("\xc2\x9b\xe2\x80\xa8"), R"("\u009b\u2028")");
    EXPECT_EQ(written("\xc3\xa4\xf0\x9f\x98\x80"), "\"\xc3\xa4\xf0\x9f\x98\x80\"");
}

TEST(JsonWriter, WhatIsNotUtf8IsReplacedByteByByte) {
    const std::string r = "\xef\xbf\xbd";
    EXPECT_EQ(written("a\xff"
                      "b"),
              "\"a" + r + "b\"");
    EXPECT_EQ(written("\xe2\x82"), "\"" + r + r + "\"") << "cut off";
    EXPECT_EQ(written("\xed\xa0\x80"), "\"" + r + r + r + "\"") << "a surrogate";
    EXPECT_EQ(written("\xc0\x80"), "\"" + r + r + "\"") << "overlong";
}

TEST(JsonWriter, EveryByteComesThroughAReader) {
    for (int byte = 0; byte < 256; ++byte) {
        const std::string text = {'<', static_cast<char>(byte), '>'};
        const test::Json read = test::read_json(written(text));
        EXPECT_EQ(read.string, byte < 0x80 ? text : "<\xef\xbf\xbd>") << byte;
    }
}

TEST(JsonWriterDeathTest, KeysAndValuesOutOfTurnAreOurBug) {
    EXPECT_DEATH(JsonWriter().begin_object().number(1), "has_key");
    EXPECT_DEATH(JsonWriter().begin_array().key("a"), "closer");
    EXPECT_DEATH(JsonWriter().begin_object().end_array(), "closer");
    EXPECT_DEATH(JsonWriter().begin_object().take(), "empty");
}

TEST(JsonReader, RefusesWhatIsNoJson) {
    for (const char* text :
         {"", "{", "[1,]", "{\"a\":1,}", "{\"a\":1,\"a\":2}", "\"\n\"", "01", "1 2", "\"\\x\"",
          "tru", "'a'", "{a:1}", "\"\xff\"", "\"\\ud800\"", "+1", "1."}) {
        EXPECT_THROW(test::read_json(text), std::runtime_error) << text;
    }
    EXPECT_EQ(test::read_json(" [1, -2.5e1, true, null] ")[1].number, -25.0);
}

}  // namespace
}  // namespace lray
