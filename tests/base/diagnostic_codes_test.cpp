#include "base/diagnostic_codes.h"

#include <gtest/gtest.h>

#include <string>

namespace lray {
namespace {

TEST(DiagnosticCodes, EveryCodeHasAWholeEntry) {
    ASSERT_EQ(code_infos().size(), kCodeCount);
    for (std::size_t i = 0; i < kCodeCount; ++i) {
        const CodeInfo& info = code_info(static_cast<Code>(i));
        EXPECT_EQ(static_cast<std::size_t>(info.code), i);
        EXPECT_FALSE(info.title.empty()) << info.id;
        EXPECT_FALSE(info.explanation.empty()) << info.id;
        EXPECT_FALSE(info.wrong.empty()) << info.id;
        EXPECT_FALSE(info.right.empty()) << info.id;
        EXPECT_NE(info.wrong, info.right) << info.id;
    }
}

TEST(DiagnosticCodes, IdsAreALetterAndFourDigitsSortedAndUnique) {
    std::string previous;
    for (const CodeInfo& info : code_infos()) {
        const std::string id(info.id);
        ASSERT_EQ(id.size(), 5u);
        EXPECT_TRUE(id[0] == 'E' || id[0] == 'W') << id;
        EXPECT_EQ(id.find_first_not_of("0123456789", 1), std::string::npos) << id;
        EXPECT_LT(previous, id);
        previous = id;
    }
}

TEST(DiagnosticCodes, TitlesArePhrasesAndExplanationsSentences) {
    for (const CodeInfo& info : code_infos()) {
        EXPECT_NE(info.title.back(), '.') << info.id;
        EXPECT_FALSE(info.title.front() >= 'A' && info.title.front() <= 'Z' &&
                     !info.title.starts_with("UTF"))
            << info.id;
        EXPECT_EQ(info.explanation.back(), '.') << info.id;
        EXPECT_EQ(info.explanation.find("  "), std::string_view::npos) << info.id;
    }
}

TEST(DiagnosticCodes, FindIgnoresCaseAndRefusesTheUnknown) {
    for (const CodeInfo& info : code_infos()) EXPECT_EQ(find_code(info.id), info.code);
    EXPECT_EQ(find_code("e0401"), Code::E0401);
    EXPECT_EQ(find_code("w1603"), Code::W1603);
    EXPECT_EQ(find_code("E9999"), std::nullopt);
    EXPECT_EQ(find_code("E040"), std::nullopt);
    EXPECT_EQ(find_code(""), std::nullopt);
}

TEST(DiagnosticCodes, LimitsAreThoseOfExitCodeThree) {
    std::string limits;
    for (const CodeInfo& info : code_infos()) {
        if (is_limit(info.code)) limits += std::string(info.id) + " ";
    }
    EXPECT_EQ(limits, "E0115 E0511 E0512 E0513 E0514 E0515 E0516 E0517 ");
}

}  // namespace
}  // namespace lray
