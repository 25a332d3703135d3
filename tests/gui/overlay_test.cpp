#include "gui/overlay.h"

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace lray::gui {
namespace {

TEST(ShownText, AsciiAndLatin1StayAsTheyAre) {
    EXPECT_EQ(shown_text("a ~ Z"), "a ~ Z");
    EXPECT_EQ(shown_text("caf\u00e9 \u00d7 2\u00b0"), "caf\xe9 \xd7 2\xb0");
    EXPECT_EQ(shown_text(""), "");
}

TEST(ShownText, WhatFontsLackLooksAlikeOrIsAQuestionMark) {
    EXPECT_EQ(shown_text("\u2500\u2502\u256d\u253c\u2570\u2550"), "-|+++=");
    EXPECT_EQ(shown_text("a\u2026 \u2018b\u2019 \u2013 \u201cc\u201d \u2192"),
              "a... 'b' - \"c\" ->");
    EXPECT_EQ(shown_text("\u4e2d\U0001f600\u0301"), "???");
}

TEST(ShownText, ControlsAndBrokenSequencesDoNotGetThrough) {
    EXPECT_EQ(shown_text("a\tb\nc\x1b[1m\x7f"), "a b c [1m ");
    EXPECT_EQ(shown_text("\u0085\u009b\u00a0|"), "   |");
    EXPECT_EQ(shown_text("\xff\xc3"), "??");
    EXPECT_EQ(shown_text(std::string_view("\0x", 2)), " x");
}

TEST(ShownText, OfAnyBytesIsPrintable) {
    constexpr std::uint64_t kSeed = 71;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    for (int i = 0; i < 2000; ++i) {
        std::string bytes;
        for (int k = 0; k < 30; ++k) bytes += static_cast<char>(random.below(256));
        for (const char c : shown_text(bytes)) {
            const auto code = static_cast<unsigned char>(c);
            EXPECT_TRUE((code >= 0x20 && code < 0x7f) || code > 0xa0) << int{code};
        }
    }
}

TEST(CutText, ThreeDotsStandForTheRest) {
    EXPECT_EQ(cut_text("abcdef", 6), "abcdef");
    EXPECT_EQ(cut_text("abcdef", 5), "ab...");
    EXPECT_EQ(cut_text("abcdef", 3), "...");
    EXPECT_EQ(cut_text("abcdef", 2), "..");
    EXPECT_EQ(cut_text("abcdef", 0), "");
}

TEST(ColumnsIn, WholeLettersOnly) {
    const Font font{8, 13, 11};
    EXPECT_EQ(columns_in(80.0, font), 10u);
    EXPECT_EQ(columns_in(79.9, font), 9u);
    EXPECT_EQ(columns_in(7.0, font), 0u);
    EXPECT_EQ(columns_in(-100.0, font), 0u);
}

}  // namespace
}  // namespace lray::gui
