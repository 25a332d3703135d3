#include "base/suggest_name.h"

#include <gtest/gtest.h>

#include <array>

namespace lray {
namespace {

constexpr std::array<std::string_view, 3> kNames = {"radius", "rad", "center"};

TEST(SuggestName, OneNearNameIsTheFix) {
    Diagnostic diagnostic;
    diagnostic.span = {4, 0, 6};
    EXPECT_TRUE(suggest_name(diagnostic, "radios", kNames));
    EXPECT_EQ(diagnostic.hint, "did you mean `radius`?");
    ASSERT_TRUE(diagnostic.fix);
    EXPECT_EQ(diagnostic.fix->replacement, "radius");
    EXPECT_EQ(diagnostic.fix->span, diagnostic.span);
}

TEST(SuggestName, SeveralNearNamesAreHintsOnlyAndNoneIsNothing) {
    constexpr std::array<std::string_view, 2> kTwins = {"tine", "time"};
    Diagnostic diagnostic;
    diagnostic.span = {4, 0, 4};
    EXPECT_TRUE(suggest_name(diagnostic, "tile", kTwins));
    EXPECT_EQ(diagnostic.hint, "did you mean `tine` or `time`?");
    EXPECT_FALSE(diagnostic.fix);
    Diagnostic other;
    EXPECT_FALSE(suggest_name(other, "zebra", kNames));
    EXPECT_EQ(other.hint, "");
}

TEST(SuggestName, SpanWhoseEndIsNotKnownIsNotReplaced) {
    Diagnostic diagnostic;
    diagnostic.with_fix({0, 0, Span::kMaxLength}, "x").with_fix(Span{}, "x");
    EXPECT_FALSE(diagnostic.fix);
}

}  // namespace
}  // namespace lray
