#include "base/warning_levels.h"

#include <gtest/gtest.h>

#include <set>

#include "base/diagnostics.h"

namespace lray {
namespace {

Span at(std::uint32_t offset) {
    return {offset, 0, 1};
}

TEST(WarningLevels, NamesAreUniqueWordsOfTheTitles) {
    std::set<std::string> names;
    for (const CodeInfo& info : code_infos()) {
        if (!is_warning(info)) continue;
        const std::string name = slug(info);
        EXPECT_TRUE(names.insert(name).second) << name;
        EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), name.npos);
        EXPECT_FALSE(name.starts_with('-') || name.ends_with('-')) << name;
        EXPECT_FALSE(name == "all" || name == "warnings" || find_code(name)) << name;
    }
    EXPECT_EQ(slug(code_info(Code::W1301)), "scale-after-translate");
    EXPECT_EQ(slug(code_info(Code::W1404)), "ior-below-1");
}

TEST(WarningLevels, CodeOrNameAndTheLastOneCounts) {
    WarningLevels levels;
    EXPECT_EQ(levels[Code::W1301], WarningLevel::warn);
    EXPECT_EQ(levels.set("W1301", WarningLevel::deny), std::nullopt);
    EXPECT_EQ(levels[Code::W1301], WarningLevel::deny);
    EXPECT_EQ(levels.set("scale-after-translate", WarningLevel::allow), std::nullopt);
    EXPECT_EQ(levels[Code::W1301], WarningLevel::allow);
    EXPECT_EQ(levels.set("w1301", WarningLevel::warn), std::nullopt);
    EXPECT_EQ(levels[Code::W1301], WarningLevel::warn);
    EXPECT_EQ(levels[Code::W1302], WarningLevel::warn);
}

TEST(WarningLevels, AllOfThemAndDenyingLeavesTheSilentSilent) {
    WarningLevels levels;
    ASSERT_EQ(levels.set("W1501", WarningLevel::allow), std::nullopt);
    ASSERT_EQ(levels.set("warnings", WarningLevel::deny), std::nullopt);
    EXPECT_EQ(levels[Code::W1501], WarningLevel::allow);
    EXPECT_EQ(levels[Code::W1503], WarningLevel::deny);
    ASSERT_EQ(levels.set("all", WarningLevel::allow), std::nullopt);
    EXPECT_EQ(levels[Code::W1503], WarningLevel::allow);
    ASSERT_EQ(levels.set("all", WarningLevel::warn), std::nullopt);
    EXPECT_EQ(levels[Code::W1501], WarningLevel::warn);
}

TEST(WarningLevels, UnknownNamesAndErrorsAreRefused) {
    WarningLevels levels;
    EXPECT_EQ(levels.set("scale-after-translat", WarningLevel::warn),
              "takes the code or the name of a warning, not `scale-after-translat`; did you mean "
              "`scale-after-translate`?");
    EXPECT_EQ(levels.set("nonsense", WarningLevel::warn),
              "takes the code or the name of a warning, not `nonsense`; `lray --explain warnings` "
              "lists them");
    EXPECT_EQ(levels.set("E0401", WarningLevel::allow), "takes warnings; E0401 is an error");
}

TEST(Diagnostics, SilentWarningsAreNeitherKeptNorCounted) {
    WarningLevels levels;
    ASSERT_FALSE(levels.set("W1301", WarningLevel::allow));
    ASSERT_FALSE(levels.set("W1302", WarningLevel::deny));
    Diagnostics diagnostics(levels);
    diagnostics.warning(Code::W1301, at(0), "silent").with_hint("unheard");
    diagnostics.warning(Code::W1302, at(1), "denied");
    diagnostics.warning(Code::W1302, at(1), "denied");
    diagnostics.warning(Code::W1404, at(2), "told");
    EXPECT_EQ(diagnostics.warning_count(), 2u);
    EXPECT_EQ(diagnostics.denied_count(), 1u);
    EXPECT_EQ(diagnostics.sorted().size(), 2u);
    EXPECT_FALSE(diagnostics.has_errors());
}

}  // namespace
}  // namespace lray
