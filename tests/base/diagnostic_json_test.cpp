#include "base/diagnostic_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "tests/base/machine_diagnostics.h"
#include "tests/support/json.h"

namespace lray {
namespace {

std::vector<test::Json> lines_of(const std::string& text) {
    std::vector<test::Json> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(test::read_json(line));
    return lines;
}

TEST(DiagnosticJson, ALineHasAllThereIsToSay) {
    const test::RichDiagnostics rich;
    const auto lines = lines_of(format_json(rich.diagnostics, rich.sources, 0));
    ASSERT_EQ(lines.size(), 4u);
    const test::Json& warning = lines[0];
    EXPECT_EQ(warning["severity"].string, "warning");
    EXPECT_EQ(warning["code"].string, "W1301");
    EXPECT_EQ(warning["message"].string, "scale after \"move\"\x1b");
    EXPECT_EQ(warning["line"].number, 3);
    EXPECT_TRUE(warning["fix"].is_null());

    const test::Json& error = lines[1];
    EXPECT_EQ(error["severity"].string, "error");
    EXPECT_EQ(error["hint"].string, "did you mean `radius`?");
    EXPECT_EQ(error["file"].string, "my parts/a.lrs");
    EXPECT_EQ(error["line"].number, 2);
    EXPECT_EQ(error["column"].number, 18) << "code points";
    EXPECT_EQ(error["end_line"].number, 2);
    EXPECT_EQ(error["end_column"].number, 24);
    EXPECT_EQ(error["offset"].number, 30) << "bytes";
    EXPECT_EQ(error["length"].number, 6);
    EXPECT_EQ(error["labels"].elements.size(), 2u);
    EXPECT_EQ(error["labels"][0]["message"].string, "of this");
    EXPECT_EQ(error["labels"][0]["column"].number, 9);
    EXPECT_TRUE(error["labels"][1]["file"].is_null());
    EXPECT_EQ(error["notes"][0].string, "a note");
    EXPECT_EQ(error["helps"][0].string, "a help");
    EXPECT_EQ(error["calls"][0]["name"].string, "flake");
    EXPECT_EQ(error["calls"][0]["line"].number, 3);
    EXPECT_TRUE(error["calls"][1]["line"].is_null());
    ASSERT_EQ(error["included_from"].elements.size(), 1u);
    EXPECT_EQ(error["included_from"][0]["file"].string, "main.lrs");
    EXPECT_EQ(error["included_from"][0]["line"].number, 2);
    EXPECT_EQ(error["fix"]["replacement"].string, "radius");
    EXPECT_EQ(error["fix"]["offset"].number, 30);

    const test::Json& often = lines[2];
    EXPECT_EQ(often["count"].number, 3);
    EXPECT_EQ(often["end_line"].number, 3) << "over a line end";
    EXPECT_EQ(often["end_column"].number, 4);
    EXPECT_TRUE(lines[3]["file"].is_null());
    EXPECT_TRUE(lines[3]["line"].is_null());
    EXPECT_TRUE(lines[3]["offset"].is_null());
}

TEST(DiagnosticJson, EveryLineHasTheSameFields) {
    const test::RichDiagnostics rich;
    const auto lines = lines_of(format_json(rich.diagnostics, rich.sources, 0));
    for (const test::Json& line : lines) {
        std::string names;
        for (const auto& [name, value] : line.members) names += name + " ";
        EXPECT_EQ(names,
                  "calls code column count end_column end_line file fix helps hint included_from "
                  "labels length line message notes offset severity ");
    }
}

TEST(DiagnosticJson, NothingSaidIsNoLineAndMostAreAsManyAsAskedFor) {
    EXPECT_EQ(format_json({}, {}, 0), "");
    const test::RichDiagnostics rich;
    EXPECT_EQ(lines_of(format_json(rich.diagnostics, rich.sources, 1)).size(), 2u);
}

TEST(DiagnosticJson, PlaceInATextThatIsGoneHasNoLine) {
    test::RichDiagnostics rich;
    rich.sources.release_text(rich.part);
    const auto lines = lines_of(format_json(rich.diagnostics, rich.sources, 0));
    EXPECT_EQ(lines[1]["file"].string, "my parts/a.lrs");
    EXPECT_TRUE(lines[1]["line"].is_null());
    EXPECT_EQ(lines[1]["offset"].number, 30);
}

}  // namespace
}  // namespace lray
