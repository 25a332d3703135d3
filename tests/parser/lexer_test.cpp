// Text to tokens: numbers, strings, colours, comments, line ends, encodings.
#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <string_view>

#include "image/srgb.h"
#include "tests/parser/evaluate.h"
#include "tests/parser/loaded.h"

namespace lray::test {
namespace {

TEST(LexNumbers, DecimalFormsHaveTheirValues) {
    EXPECT_EQ(number_of("12"), 12.0);
    EXPECT_EQ(number_of("0.5"), 0.5);
    EXPECT_EQ(number_of(".5"), 0.5);
    EXPECT_EQ(number_of("1."), 1.0);
    EXPECT_EQ(number_of("1e-3"), 1e-3);
    EXPECT_EQ(number_of("1E+3"), 1e3);
    EXPECT_EQ(number_of("1.5e2"), 150.0);
    EXPECT_EQ(number_of("007"), 7.0);
    EXPECT_EQ(number_of("0.1"), 0.1);
    EXPECT_EQ(number_of("1.7976931348623157e308"), 1.7976931348623157e308);
    EXPECT_EQ(number_of("1e-400"), 0.0);
}

TEST(LexNumbers, SeparatorsAndHexDigitsAreRead) {
    EXPECT_EQ(number_of("1_000_000"), 1e6);
    EXPECT_EQ(number_of("1_0.2_5"), 10.25);
    EXPECT_EQ(number_of("0xff"), 255.0);
    EXPECT_EQ(number_of("0XFF_FF"), 65535.0);
}

TEST(LexNumbers, UnitsMultiply) {
    EXPECT_EQ(number_of("90deg"), 90.0);
    EXPECT_EQ(number_of("0.5turn"), 180.0);
    EXPECT_DOUBLE_EQ(number_of("1rad"), 180.0 / std::numbers::pi);
    EXPECT_EQ(number_of("2m"), 2.0);
    EXPECT_DOUBLE_EQ(number_of("30cm"), 0.3);
    EXPECT_DOUBLE_EQ(number_of("5mm"), 0.005);
    EXPECT_EQ(number_of("2km"), 2000.0);
    EXPECT_EQ(number_of("1e2cm"), 1.0);
}

TEST(LexNumbers, TheExponentNeedsADigit) {
    EXPECT_EQ(codes_of("let x = 2e"), "E0007");
    EXPECT_EQ(codes_of("let x = 2e-"), "E0008");
    EXPECT_EQ(codes_of("let x = 1e999"), "E0008");
    EXPECT_EQ(codes_of("let x = 1_"), "E0007");
    EXPECT_EQ(codes_of("let x = 0x"), "E0008");
    EXPECT_EQ(codes_of("let x = 1.2.3"), "E0008");
}

TEST(LexStrings, EscapesAreResolved) {
    EXPECT_EQ(string_of(R"("a\nb\tc\"d\\e")"), "a\nb\tc\"d\\e");
    EXPECT_EQ(string_of(R"("\u{41}\u{e9}\u{20AC}\u{1F600}")"),
              "A\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
    EXPECT_EQ(string_of("\"\""), "");
    EXPECT_EQ(string_of("\"\xC3\xA9 // no comment /* nor this */\""),
              "\xC3\xA9 // no comment /* nor this */");
}

TEST(LexStrings, BadEscapesAreReportedOneByOne) {
    EXPECT_EQ(codes_of(R"(info { a: "\q\u{D800}\u{}\u{1234567}\u12" })"),
              "E0009 E0009 E0009 E0009 E0009");
}

TEST(LexColours, DigitsAreSrgb) {
    const auto linear = [](int byte) {
        return static_cast<float>(image::srgb_decode(byte / 255.0));
    };
    EXPECT_EQ(color_of("#ff8000"), Color(1.0f, linear(0x80), 0.0f));
    EXPECT_EQ(color_of("#F80"), Color(1.0f, linear(0x88), 0.0f));
    EXPECT_EQ(color_of("#0a0B0c80"), Color(linear(10), linear(11), linear(12)));
    EXPECT_DOUBLE_EQ(number_of("#0a0B0c80.a"), 128.0 / 255.0);
    EXPECT_EQ(number_of("#fff.a"), 1.0);
}

TEST(LexColours, OtherCountsOfDigitsAreMalformed) {
    EXPECT_EQ(codes_of("let c = #f"), "E0010");
    EXPECT_EQ(codes_of("let c = #ffff"), "E0010");
    EXPECT_EQ(codes_of("let c = #fffffffff"), "E0010");
}

TEST(LexComments, CommentsNestAndEndWithTheLine) {
    EXPECT_EQ(number_of("1 // + 1\n"), 1.0);
    EXPECT_EQ(number_of("1 /* + /* 2 */ + 3 */ + 4"), 5.0);
    EXPECT_EQ(number_of("/**/7"), 7.0);
    EXPECT_EQ(codes_of("/// doc\nsphere { } // end"), "");
    EXPECT_EQ(codes_of("/* a /* b */"), "E0011");
}

TEST(LexLines, EveryKindOfLineEndCounts) {
    for (const std::string_view end : {"\n", "\r\n", "\r"}) {
        std::string scene = "let a = 1@let b = 2@sphere {@radius: a@center: [b, 0, 0]@}@spere { }@";
        for (std::size_t at = 0; (at = scene.find('@', at)) != scene.npos;)
            scene.replace(at, 1, end);
        EXPECT_EQ(load_text(scene).text(), "E0201 7:1 unknown name `spere`\n");
    }
}

TEST(LexLines, AMarkAtTheBeginIsNoCharacter) {
    EXPECT_EQ(load_text("\xEF\xBB\xBFspere { }").text(), "E0201 1:1 unknown name `spere`\n");
}

TEST(LexLines, ColumnsCountCharacters) {
    EXPECT_EQ(load_text("\tinfo { a: \"\xC3\xA9\xE2\x82\xAC\", b: c }").text(),
              "E0201 1:21 unknown name `c`\n");
}

TEST(LexEncodings, WhatIsNotUtf8IsToldOnce) {
    EXPECT_EQ(load_text("// \xE9\n// \xE9\nsphere { }").codes(), "E0002");
    EXPECT_EQ(load_text("info { a: \"\xC0\xAF\" }").codes(), "E0002");
    EXPECT_EQ(load_text(std::string_view("sphere { }\0 spere { }", 21)).text(),
              "E0003 1:11 this is not a text file: it contains a NUL byte\n");
    EXPECT_EQ(load_text(std::string_view("\xFF\xFEs\0p\0", 6)).codes(), "E0003");
    EXPECT_EQ(load_text(std::string_view("\xFE\xFF\0s\0p", 6)).codes(), "E0003");
}

TEST(LexEncodings, AnEmptyFileIsAnEmptyScene) {
    for (const std::string_view text : {"", " ", "\n", "\r", "//", "/**/", "\xEF\xBB\xBF", ",;,"}) {
        EXPECT_EQ(load_text(text).codes(), "W1503") << '"' << text << '"';
    }
}

TEST(LexNames, LettersBeyondAsciiAreReportedOnce) {
    EXPECT_EQ(codes_of("let b\xC3\xA4ll = 1\nsphere { radius: b\xC3\xA4ll }"), "E0004 E0004");
    EXPECT_EQ(codes_of("sph\xD0\xB5re { }"), "E0004");
}

TEST(LexNames, NamesAreCaseSensitiveAndMayStartWithAnUnderscore) {
    EXPECT_EQ(number_of("_a1 + A1 + a1", "let _a1 = 1\nlet A1 = 10\nlet a1 = 100"), 111.0);
}

}  // namespace
}  // namespace lray::test
