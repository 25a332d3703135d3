// grammar.md is true: its scenes load, its mistakes are told as it says, its tables and
// productions are those of the parser. With LRAY_BLESS=grammar the tables are written anew.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "parser/blocks/schema.h"
#include "parser/load.h"
#include "tests/parser/grammar_tables.h"
#include "tests/support/temp_directory.h"

namespace lray::parser {
namespace {

const std::string kGrammar = std::string(LRAY_SOURCE_DIR) + "/grammar.md";

/// A fenced piece of a document.
struct Snippet {
    std::string language{};  // "lrs", "lrs-error", ...
    std::string codes{};     // what stands behind the language: "E0401"
    std::string text{};
    unsigned line = 0;  // of the fence
};

std::vector<Snippet> snippets_of(const std::string& document) {
    std::vector<Snippet> snippets;
    std::istringstream lines(document);
    std::string line;
    bool is_inside = false;
    for (unsigned number = 1; std::getline(lines, line); ++number) {
        if (line.starts_with("```")) {
            is_inside = !is_inside;
            if (!is_inside) continue;
            const std::string info = line.substr(3);
            const std::size_t space = info.find(' ');
            snippets.push_back({info.substr(0, space),
                                space == info.npos ? std::string{} : info.substr(space + 1),
                                {},
                                number});
        } else if (is_inside) {
            snippets.back().text += line + "\n";
        }
    }
    return snippets;
}

/// The name of the file that a snippet is, if its first line is a comment that says so:
/// `// materials.lrs`, `# pyramid.obj`.
std::string file_name(const Snippet& snippet) {
    std::smatch match;
    const std::regex name("^(//|#) ([a-z_/]+\\.(lrs|nff|obj))\n");
    return std::regex_search(snippet.text, match, name) ? match[2].str() : std::string{};
}

/// Loads a snippet beside the files of a document.
class Loaded {
 public:
    Loaded(const std::string& text, const std::vector<Snippet>& files) {
        for (const Snippet& file : files) {
            if (!file_name(file).empty()) directory_.write(file_name(file), file.text);
        }
        FileAccess access;
        access.set_library(LRAY_SOURCE_DIR "/parser/std");
        const std::string path = directory_.write("snippet.lrs", text);
        has_scene_ = parser::load(path, {}, access, sources_, diagnostics_).scene.has_value();
    }

    bool has_scene() const { return has_scene_; }

    /// "E0401 2:10 message", one a line, without the warnings of a scene that is not complete.
    std::string told() const {
        std::string text;
        for (const Diagnostic* diagnostic : diagnostics_.sorted()) {
            if (is_incomplete_scene(*diagnostic)) continue;
            const Position at = sources_.position(diagnostic->span);
            text += fmt::format("{} {}:{} {}\n", code_info(diagnostic->code).id, at.line, at.column,
                                diagnostic->message);
        }
        return text;
    }

    std::string codes() const {
        std::string text;
        for (const Diagnostic* diagnostic : diagnostics_.sorted()) {
            if (is_incomplete_scene(*diagnostic)) continue;
            text += fmt::format("{}{}", text.empty() ? "" : " ", code_info(diagnostic->code).id);
        }
        return text;
    }

 private:
    static bool is_incomplete_scene(const Diagnostic& diagnostic) {
        return diagnostic.code == Code::W1501 || diagnostic.code == Code::W1503;
    }

    test::TempDirectory directory_;
    Sources sources_;
    Diagnostics diagnostics_;
    bool has_scene_ = false;
};

std::string place_of(const Snippet& snippet) {
    return fmt::format("grammar.md:{}\n{}", snippet.line, snippet.text);
}

TEST(Grammar, EverySnippetLoadsWithoutAWord) {
    const std::vector<Snippet> snippets = snippets_of(test::read_bytes(kGrammar));
    std::size_t count = 0;
    for (const Snippet& snippet : snippets) {
        if (snippet.language != "lrs") continue;
        ++count;
        const Loaded loaded(snippet.text, snippets);
        EXPECT_TRUE(loaded.has_scene()) << place_of(snippet);
        EXPECT_EQ(loaded.told(), "") << place_of(snippet);
    }
    EXPECT_GT(count, 20u) << "are the snippets still found?";
}

TEST(Grammar, EveryMistakeGivesTheCodeItNames) {
    const std::vector<Snippet> snippets = snippets_of(test::read_bytes(kGrammar));
    std::size_t count = 0;
    for (const Snippet& snippet : snippets) {
        if (snippet.language != "lrs-error") continue;
        ++count;
        ASSERT_NE(snippet.codes, "") << place_of(snippet);
        const Loaded loaded(snippet.text, snippets);
        EXPECT_EQ(loaded.codes(), snippet.codes) << place_of(snippet) << loaded.told();
        EXPECT_EQ(loaded.has_scene(), snippet.codes.front() == 'W') << place_of(snippet);
    }
    EXPECT_GT(count, 20u) << "are the snippets still found?";
}

TEST(Grammar, FencesNameALanguageThatIsTested) {
    for (const Snippet& snippet : snippets_of(test::read_bytes(kGrammar))) {
        const bool is_known = snippet.language == "lrs" || snippet.language == "lrs-error" ||
                              snippet.language == "ebnf" || snippet.language == "nff" ||
                              snippet.language == "obj" || snippet.language == "text";
        EXPECT_TRUE(is_known) << place_of(snippet);
    }
}

TEST(Grammar, TablesAreThoseOfTheParser) {
    std::string document = test::read_bytes(kGrammar);
    const char* const bless = std::getenv("LRAY_BLESS");
    const bool is_blessing = bless != nullptr && std::string_view(bless) == "grammar";
    for (const GeneratedText& generated : generated_texts()) {
        const std::string written = text_between_marks(document, generated.name);
        ASSERT_TRUE(document.find(fmt::format("<!-- end {} -->", generated.name)) !=
                    std::string::npos)
            << "grammar.md needs these lines:\n<!-- begin " << generated.name << " -->\n"
            << generated.text << "<!-- end " << generated.name << " -->";
        if (is_blessing) {
            document = with_text_between_marks(document, generated);
        } else {
            EXPECT_EQ(written, generated.text)
                << "paste this, or run `./dev bless grammar`:\n<!-- begin " << generated.name
                << " -->\n"
                << generated.text << "<!-- end " << generated.name << " -->";
        }
    }
    if (is_blessing) std::ofstream(kGrammar, std::ios::binary) << document;
}

TEST(Grammar, EveryBlockHasItsHeadingAndItsWords) {
    const std::string document = test::read_bytes(kGrammar);
    for (const BlockSchema& block : block_schemas()) {
        const std::string heading = fmt::format("\n### `{}`\n\n{}\n", block.name, block.doc);
        EXPECT_NE(document.find(heading), std::string::npos) << "there is no" << heading;
    }
}

TEST(Grammar, ProductionsAreThoseAboveTheParserFunctions) {
    std::string ebnf;
    for (const Snippet& snippet : snippets_of(test::read_bytes(kGrammar))) {
        if (snippet.language == "ebnf") ebnf += snippet.text;
    }
    std::map<std::string, std::string> written;
    for (const auto& [name, body] : productions_of(ebnf)) {
        EXPECT_TRUE(written.emplace(name, body).second) << name << " is defined twice";
    }
    std::size_t count = 0;
    for (const std::string file :
         {"parser_definitions.cpp", "parser_expr.cpp", "parser_functions.cpp", "parser_items.cpp",
          "parser_primary.cpp", "parser_statements.cpp"}) {
        const std::string source =
            test::read_bytes(std::string(LRAY_SOURCE_DIR) + "/parser/syntax/" + file);
        for (const auto& [name, body] : productions_of(production_comments(source))) {
            EXPECT_EQ(written[name], body) << name << " of parser/syntax/" << file;
            ++count;
        }
    }
    EXPECT_GE(count, 36u) << "are the productions still found?";
}

TEST(Grammar, EveryNameInAProductionIsDefined) {
    std::string ebnf;
    for (const Snippet& snippet : snippets_of(test::read_bytes(kGrammar))) {
        if (snippet.language == "ebnf") ebnf += snippet.text;
    }
    const Productions productions = productions_of(ebnf);
    ASSERT_FALSE(productions.empty());
    for (const auto& [name, body] : productions) {
        const std::string without_text = std::regex_replace(body, std::regex("\"[^\"]*\""), "");
        const std::regex word("[a-z_]+");
        for (auto at = std::sregex_iterator(without_text.begin(), without_text.end(), word);
             at != std::sregex_iterator(); ++at) {
            const bool is_defined =
                std::any_of(productions.begin(), productions.end(),
                            [&](const auto& production) { return production.first == at->str(); });
            EXPECT_TRUE(is_defined) << at->str() << " in " << name << " = " << body;
        }
    }
}

TEST(Grammar, WhatIsNotThereYetIsToldSo) {
    const std::string list = text_between_marks(test::read_bytes(kGrammar), "not yet");
    const std::regex name("`([a-z_]+)`");
    std::size_t count = 0;
    for (auto at = std::sregex_iterator(list.begin(), list.end(), name);
         at != std::sregex_iterator(); ++at) {
        EXPECT_TRUE(is_not_yet_available((*at)[1].str())) << (*at)[1];
        ++count;
    }
    EXPECT_GE(count, 4u);
}

}  // namespace
}  // namespace lray::parser
