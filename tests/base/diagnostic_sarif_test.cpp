// What a SARIF log must have, by the standard (sections of "SARIF Version 2.1.0", OASIS 2020):
//   3.13    a log has `version` "2.1.0" and `runs`
//   3.14    a run has `tool`; 3.18, 3.19: a tool has a `driver`, and it a `name`
//   3.49    a rule has an `id`; 3.49.9..11: its texts are messages with a `text`
//   3.27    a result has a `message`; `ruleIndex` is that of the rule with its `ruleId`; `level` is
//           one of none, note, warning and error; `occurrenceCount` is at least 1
//   3.28    a location's `id` is unique within its result
//   3.30    lines and columns count from 1, and a region does not end before it begins; byteOffset
//           and byteLength are not negative
//   3.4     an artifact location has a `uri` that is a URI reference (RFC 3986)
//   3.55    a fix has `artifactChanges`; 3.56: these have `artifactLocation` and `replacements`;
//           3.57: these have a `deletedRegion`
//   3.44    a stack has `frames`
#include "base/diagnostic_sarif.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "tests/base/machine_diagnostics.h"
#include "tests/support/json.h"

namespace lray {
namespace {

using test::Json;
using test::JsonKind;

void expect_message(const Json& message) {
    ASSERT_TRUE(message.has("text"));
    EXPECT_FALSE(message["text"].string.empty());
}

void expect_region(const Json& region) {
    EXPECT_GE(region["byteOffset"].number, 0);
    EXPECT_GE(region["byteLength"].number, 0);
    if (!region.has("startLine")) return;
    const double start_line = region["startLine"].number;
    const double end_line = region["endLine"].number;
    EXPECT_GE(start_line, 1);
    EXPECT_GE(region["startColumn"].number, 1);
    EXPECT_GE(end_line, start_line);
    if (end_line == start_line) {
        EXPECT_GE(region["endColumn"].number, region["startColumn"].number);
    }
}

void expect_artifact(const Json& location) {
    const std::regex reference("([A-Za-z0-9._~/-]|%[0-9A-F]{2}|^file://)+");
    EXPECT_TRUE(std::regex_match(location["uri"].string, reference)) << location["uri"].string;
}

void expect_physical_location(const Json& location) {
    expect_artifact(location["artifactLocation"]);
    expect_region(location["region"]);
}

void expect_result(const Json& result, const Json& rules) {
    expect_message(result["message"]);
    EXPECT_EQ(rules[static_cast<std::size_t>(result["ruleIndex"].number)]["id"].string,
              result["ruleId"].string);
    EXPECT_TRUE(result["level"].string == "error" || result["level"].string == "warning");
    EXPECT_GE(result["occurrenceCount"].number, 1);
    for (const Json& location : result["locations"].elements) {
        expect_physical_location(location["physicalLocation"]);
    }
    std::set<double> ids;
    if (result.has("relatedLocations")) {
        for (const Json& related : result["relatedLocations"].elements) {
            EXPECT_TRUE(ids.insert(related["id"].number).second);
            expect_message(related["message"]);
            expect_physical_location(related["physicalLocation"]);
        }
    }
    if (result.has("fixes")) {
        for (const Json& fix : result["fixes"].elements) {
            for (const Json& change : fix["artifactChanges"].elements) {
                expect_artifact(change["artifactLocation"]);
                ASSERT_FALSE(change["replacements"].elements.empty());
                expect_region(change["replacements"][0]["deletedRegion"]);
            }
        }
    }
    if (result.has("stacks")) {
        for (const Json& stack : result["stacks"].elements) {
            EXPECT_EQ(stack["frames"].kind, JsonKind::array);
        }
    }
}

/// The run of a log, after a look at all that the standard demands.
Json checked_run(const std::string& text) {
    EXPECT_TRUE(text.ends_with("}\n"));
    const Json log = test::read_json(text);
    EXPECT_EQ(log["version"].string, "2.1.0");
    EXPECT_NE(log["$schema"].string.find("sarif-schema-2.1.0.json"), std::string::npos);
    EXPECT_EQ(log["runs"].elements.size(), 1u);
    const Json run = log["runs"][0];
    EXPECT_EQ(run["columnKind"].string, "unicodeCodePoints");
    const Json& driver = run["tool"]["driver"];
    EXPECT_EQ(driver["name"].string, "lray");
    EXPECT_EQ(driver["version"].string, LRAY_VERSION);
    std::set<std::string> ids;
    for (const Json& rule : driver["rules"].elements) {
        EXPECT_TRUE(ids.insert(rule["id"].string).second);
        for (const char* name : {"shortDescription", "fullDescription", "help"}) {
            expect_message(rule[name]);
        }
    }
    for (const Json& result : run["results"].elements) expect_result(result, driver["rules"]);
    return run;
}

TEST(DiagnosticSarif, AResultHasPlaceRelationsStackAndFix) {
    const test::RichDiagnostics rich;
    const Json run = checked_run(format_sarif(rich.diagnostics, rich.sources, 0));
    ASSERT_EQ(run["results"].elements.size(), 4u);
    EXPECT_EQ(run["tool"]["driver"]["rules"].elements.size(), 4u);
    EXPECT_EQ(run["results"][0]["level"].string, "warning");
    const Json& error = run["results"][1];
    EXPECT_EQ(error["ruleId"].string, "E0401");
    EXPECT_EQ(error["message"]["text"].string,
              "sphere has no property `radios`\ndid you mean `radius`?\nof nothing\nnote: a note\n"
              "help: a help");
    const Json& place = error["locations"][0]["physicalLocation"];
    EXPECT_EQ(place["artifactLocation"]["uri"].string, "my%20parts/a.lrs");
    EXPECT_EQ(place["region"]["startLine"].number, 2);
    EXPECT_EQ(place["region"]["startColumn"].number, 18);
    EXPECT_EQ(place["region"]["endColumn"].number, 24);
    EXPECT_EQ(place["region"]["byteOffset"].number, 30);
    EXPECT_EQ(place["region"]["byteLength"].number, 6);
    ASSERT_EQ(error["relatedLocations"].elements.size(), 2u);
    EXPECT_EQ(error["relatedLocations"][0]["message"]["text"].string, "of this");
    EXPECT_EQ(error["relatedLocations"][1]["message"]["text"].string, "included from here");
    const Json& frames = error["stacks"][0]["frames"];
    ASSERT_EQ(frames.elements.size(), 2u);
    EXPECT_EQ(frames[0]["location"]["message"]["text"].string, "in flake");
    EXPECT_FALSE(frames[1]["location"].has("physicalLocation"));
    const Json& change = error["fixes"][0]["artifactChanges"][0];
    EXPECT_EQ(change["replacements"][0]["insertedContent"]["text"].string, "radius");
    EXPECT_EQ(change["replacements"][0]["deletedRegion"]["byteOffset"].number, 30);
    EXPECT_EQ(run["results"][2]["occurrenceCount"].number, 3);
    EXPECT_TRUE(run["results"][3]["locations"].elements.empty());
    EXPECT_FALSE(run["results"][3].has("fixes"));
}

TEST(DiagnosticSarif, NothingSaidIsALogWithoutResults) {
    const Json run = checked_run(format_sarif({}, {}, 0));
    EXPECT_EQ(run["results"].kind, JsonKind::array);
    EXPECT_TRUE(run["results"].elements.empty());
    EXPECT_TRUE(run["tool"]["driver"]["rules"].elements.empty());
}

TEST(DiagnosticSarif, EveryCodeMakesARule) {
    Sources sources;
    const SourceId id = sources.add("a.lrs", Text(std::string(1000, ' ')));
    Diagnostics diagnostics;
    for (std::size_t i = 0; i < kCodeCount; ++i) {
        diagnostics.error(static_cast<Code>(i), Span::make(id, i, i + 1), "x");
    }
    const Json run = checked_run(format_sarif(diagnostics, sources, 0));
    EXPECT_EQ(run["tool"]["driver"]["rules"].elements.size(), kCodeCount);
    EXPECT_EQ(run["results"].elements.size(), kCodeCount);
}

TEST(DiagnosticSarif, PlaceInATextThatIsGoneHasBytesOnly) {
    test::RichDiagnostics rich;
    rich.sources.release_text(rich.part);
    const Json run = checked_run(format_sarif(rich.diagnostics, rich.sources, 0));
    const Json& region = run["results"][1]["locations"][0]["physicalLocation"]["region"];
    EXPECT_FALSE(region.has("startLine"));
    EXPECT_EQ(region["byteOffset"].number, 30);
}

TEST(UriOf, EncodesAllButUnreservedCharactersAndSlashes) {
    EXPECT_EQ(uri_of("a/b-c_d.e~f"), "a/b-c_d.e~f");
    EXPECT_EQ(uri_of("../my parts/50%.lrs"), "../my%20parts/50%25.lrs");
    EXPECT_EQ(uri_of("/home/me/a b.lrs"), "file:///home/me/a%20b.lrs");
    EXPECT_EQ(uri_of("std:metals.lrs"), "std%3Ametals.lrs");
    EXPECT_EQ(uri_of("\xc3\xa4?#\x1b<"), "%C3%A4%3F%23%1B%3C");
}

}  // namespace
}  // namespace lray
