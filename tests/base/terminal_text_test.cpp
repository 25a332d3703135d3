#include "base/terminal_text.h"

#include <gtest/gtest.h>

#include <string>

namespace lray {
namespace {

using namespace std::string_literals;

TEST(EscapeForTerminal, OrdinaryTextStays) {
    EXPECT_EQ(escape_for_terminal("radius: 1 \\ \"x\""), "radius: 1 \\ \"x\"");
    EXPECT_EQ(escape_for_terminal("K\xc3\xa4se \xe2\x82\xac \xf0\x9f\x98\x80"),
              "K\xc3\xa4se \xe2\x82\xac \xf0\x9f\x98\x80");
}

TEST(EscapeForTerminal, ControlsAreWrittenOut) {
    EXPECT_EQ(escape_for_terminal("\x1b[31m"), "\\u{1b}[31m");
    EXPECT_EQ(escape_for_terminal("a\0b\x7f\r\n\t"s), "a\\u{0}b\\u{7f}\\u{d}\\n\\t");
    EXPECT_EQ(escape_for_terminal("\xc2\x9b"), "\\u{9b}");  // the one-character CSI
}

TEST(EscapeForTerminal, WhatReordersOrHidesIsWrittenOut) {
    EXPECT_EQ(escape_for_terminal("\xe2\x80\xae"), "\\u{202e}");  // right-to-left override
    EXPECT_EQ(escape_for_terminal("\xe2\x81\xa6"), "\\u{2066}");  // isolate
    EXPECT_EQ(escape_for_terminal("\xe2\x80\x8b"), "\\u{200b}");  // zero-width space
    EXPECT_EQ(escape_for_terminal("\xef\xbb\xbf"), "\\u{feff}");
}

TEST(EscapeForTerminal, InvalidUtf8IsWrittenByteByByte) {
    EXPECT_EQ(escape_for_terminal("\xff"), "\\xff");
    EXPECT_EQ(escape_for_terminal("\xc3"), "\\xc3");                             // cut off
    EXPECT_EQ(escape_for_terminal("\xc0\x80"), "\\xc0\\x80");                    // overlong
    EXPECT_EQ(escape_for_terminal("\xe0\x80\x80"), "\\xe0\\x80\\x80");           // overlong
    EXPECT_EQ(escape_for_terminal("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // surrogate
    EXPECT_EQ(escape_for_terminal("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // too large
    EXPECT_EQ(escape_for_terminal("\xe2\x82z"), "\\xe2\\x82z");
}

TEST(EscapeForTerminal, LongTextIsCutBetweenCharacters) {
    EXPECT_EQ(escape_for_terminal("abc", 3), "abc");
    EXPECT_EQ(escape_for_terminal("abcd", 3), "abc...");
    EXPECT_EQ(escape_for_terminal("ab\xc3\xa4z", 3), "ab\xc3\xa4...");
}

TEST(FirstGlyph, WidthIsThatOfTheTerminal) {
    EXPECT_EQ(first_glyph("a").width, 1u);
    EXPECT_EQ(first_glyph("\xcc\x81").width, 0u);          // combining acute
    EXPECT_EQ(first_glyph("\xe4\xb8\xad").width, 2u);      // a Chinese character
    EXPECT_EQ(first_glyph("\xf0\x9f\x98\x80").width, 2u);  // an emoji
    EXPECT_EQ(first_glyph("\xc3\xa4").width, 1u);
    EXPECT_EQ(first_glyph("\x1b").width, 6u);
    EXPECT_EQ(first_glyph("\xff").width, 4u);
}

}  // namespace
}  // namespace lray
