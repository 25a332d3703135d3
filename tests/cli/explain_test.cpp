#include "cli/explain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "cli/explain_topics.h"
#include "cli/option_table.h"
#include "parser/blocks/schema.h"
#include "parser/builtins/builtins.h"

namespace lray::cli {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string explained(std::string_view word, ExitCode expected = ExitCode::done) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    EXPECT_EQ(explain(word), expected) << word;
    const std::string out = testing::internal::GetCapturedStdout();
    const std::string err = testing::internal::GetCapturedStderr();
    EXPECT_EQ(expected == ExitCode::done ? err : out, "");
    return expected == ExitCode::done ? out : err;
}

TEST(Explain, EveryWordOfTheListIsExplainedInLinesOfATerminal) {
    const std::string list = explained("topics");
    for (const std::string_view word : explained_words()) {
        EXPECT_THAT(list, HasSubstr(std::string(word)));
        const std::string text = explained(word);
        EXPECT_GT(text.size(), 20u) << word;
        EXPECT_TRUE(text.ends_with('\n')) << word;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            EXPECT_LE(line.size(), 120u) << word << ": " << line;
        }
    }
}

TEST(Explain, BlockShowsTypeDefaultAndMeaningOfEachProperty) {
    for (const parser::BlockSchema& block : parser::block_schemas()) {
        const std::string text = explained(block.name);
        EXPECT_THAT(text, StartsWith(std::string(block.name) + " { ... }: "));
        for (const parser::PropertySchema& property : block.properties) {
            EXPECT_THAT(text, HasSubstr("  " + std::string(property.name) + " "));
            EXPECT_THAT(text, HasSubstr(std::string(property.doc)));
            EXPECT_THAT(text, HasSubstr(std::string(property.default_text)));
        }
        EXPECT_EQ(text.find("rotate_y") != text.npos, block.is_placeable) << block.name;
    }
    EXPECT_THAT(explained("sphere"),
                HasSubstr("  radius         the radius\n"
                          "                 number, greater than 0; default 1\n"));
    EXPECT_THAT(explained("triangle"), HasSubstr("point; required\n"));
    EXPECT_THAT(explained("box"), HasSubstr("Either `center`, `size`, or `min`, `max`.\n"));
    EXPECT_THAT(explained("camera"), HasSubstr("one of \"perspective\", \"orthographic\""));
    EXPECT_THAT(explained("material"), HasSubstr("number, 0 to 10000; default 32\n"));
}

TEST(Explain, FunctionShowsItsParameters) {
    for (const parser::Builtin& builtin : parser::builtins()) {
        const std::string text = explained(builtin.name);
        EXPECT_THAT(text, HasSubstr(std::string(builtin.name) + "("));
        EXPECT_THAT(text, HasSubstr(std::string(builtin.doc)));
    }
    EXPECT_EQ(explained("rotation"),
              "rotation(axis, angle, about): turns about an axis through a point\n\n"
              "  axis           3 numbers\n"
              "  angle          number\n"
              "  about          3 numbers; may be left out\n");
}

TEST(Explain, LimitsAreThoseOfTheOptionsWithTheirDefaults) {
    const std::string text = explained("limits");
    const Options defaults;
    std::size_t count = 0;
    for (const OptionGroup& group : option_groups()) {
        for (const OptionSpec& spec : group.options) {
            const bool is_limit = std::string_view(spec.name).starts_with("max-") &&
                                  spec.name != std::string("max-errors");
            ASSERT_EQ(spec.value_of != nullptr, is_limit) << spec.name;
            if (!is_limit) continue;
            ++count;
            EXPECT_THAT(text,
                        testing::ContainsRegex(spelled(spec.name) + " +" +
                                               std::to_string(spec.value_of(defaults)) + " "));
        }
    }
    EXPECT_EQ(count, 19u);
}

TEST(Explain, WarningByItsNameSaysHowToSilenceIt) {
    EXPECT_EQ(explained("scale-after-translate"), explained("w1301"));
    EXPECT_THAT(explained("W1301"), HasSubstr("`-A scale-after-translate`"));
    EXPECT_THAT(explained("warnings"), HasSubstr("  W1301  scale-after-translate\n"));
    EXPECT_THAT(explained("codes"), HasSubstr("  E0401  unknown property\n"));
}

TEST(Explain, UnknownWordIsAUsageErrorWithTheNearest) {
    EXPECT_EQ(explained("spheer", ExitCode::usage),
              "lray: there is nothing to explain called `spheer`\n  did you mean `sphere`?\n");
    EXPECT_EQ(explained("quantum", ExitCode::usage),
              "lray: there is nothing to explain called `quantum`\n"
              "  `lray --explain topics` lists what there is\n");
}

TEST(ExplainTopics, AreSorted) {
    for (std::size_t i = 1; i < topics().size(); ++i) {
        EXPECT_LT(topics()[i - 1].name, topics()[i].name);
    }
}

}  // namespace
}  // namespace lray::cli
