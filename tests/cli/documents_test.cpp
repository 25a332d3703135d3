// README.md and docs/diagnostics.md are true: their scenes, their messages, their options.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "cli/options.h"
#include "tests/support/process.h"
#include "tests/support/temp_directory.h"

namespace lray {
namespace {

const std::string kTop = LRAY_SOURCE_DIR;

struct Fence {
    std::string info{};  // "lrs room.lrs"
    std::string text{};
};

std::vector<Fence> fences_of(const std::string& document) {
    std::vector<Fence> fences;
    std::istringstream lines(document);
    std::string line;
    bool is_inside = false;
    while (std::getline(lines, line)) {
        if (line.starts_with("```")) {
            is_inside = !is_inside;
            if (is_inside) fences.push_back({line.substr(3), {}});
        } else if (is_inside) {
            fences.back().text += line + "\n";
        }
    }
    return fences;
}

/// All `-x` and `--word` of a text.
std::set<std::string> option_names(const std::string& text) {
    std::set<std::string> names;
    const std::regex name("(^|[\\s`|(,])(--?[A-Za-z][a-z-]*)");
    for (auto at = std::sregex_iterator(text.begin(), text.end(), name);
         at != std::sregex_iterator(); ++at) {
        names.insert((*at)[2]);
    }
    return names;
}

TEST(Readme, ListsTheOptionsOfHelpAndNoOthers) {
    const std::string readme = test::read_bytes(kTop + "/README.md");
    const std::size_t begin = readme.find("## Options");
    const std::size_t end = readme.find("\n## ", begin + 1);
    ASSERT_NE(begin, readme.npos);
    std::set<std::string> listed;
    std::istringstream lines(readme.substr(begin, end - begin));
    std::string line;
    while (std::getline(lines, line)) {
        if (!line.starts_with("| `-")) continue;
        const std::regex bar("[^\\\\]\\|");  // the end of the first column
        std::smatch match;
        ASSERT_TRUE(std::regex_search(line.cbegin() + 1, line.cend(), match, bar));
        listed.merge(option_names(line.substr(0, static_cast<std::size_t>(match.position()) + 2)));
    }
    std::string help;
    std::istringstream help_lines(cli::help_text());
    while (std::getline(help_lines, line)) {
        if (line.starts_with("  -")) help += line.substr(0, 26) + "\n";  // the names' column
    }
    EXPECT_THAT(listed, testing::ContainerEq(option_names(help)));
    EXPECT_GT(listed.size(), 20u);
}

TEST(Readme, FirstSceneRendersAndItsMisspellingIsToldAsShown) {
    std::string scene;
    std::string message;
    for (const Fence& fence : fences_of(test::read_bytes(kTop + "/README.md"))) {
        if (fence.text.starts_with("// first.lrs\n")) scene = fence.text;
        if (fence.text.starts_with("first.lrs:")) message = fence.text;
    }
    ASSERT_NE(scene, "");
    ASSERT_NE(message, "");
    const test::TempDirectory directory;
    directory.write("first.lrs", scene);
    const std::vector<std::string> command = {LRAY_BINARY, "-n", "1",        "-i",
                                              "first.lrs", "-o", "first.png"};
    const auto right = test::run_process(command, {}, directory.path());
    EXPECT_EQ(right.exit_code, 0);
    EXPECT_EQ(right.err, "");

    // The message shows the line as it was written wrongly, and which one it is.
    std::smatch match;
    ASSERT_TRUE(std::regex_search(message, match, std::regex("\n(\\d+) \\| (.*)\n")));
    std::istringstream lines(scene);
    std::string wrong;
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        wrong += (number == std::stoi(match[1]) ? match[2].str() : line) + "\n";
    }
    directory.write("first.lrs", wrong);
    const auto told = test::run_process(command, {}, directory.path());
    EXPECT_EQ(told.exit_code, 1);
    EXPECT_EQ(told.err, message);
}

TEST(Readme, NamesThePackagesThatAreInstalled) {
    const std::string readme = test::read_bytes(kTop + "/README.md");
    const std::string dev = test::read_bytes(kTop + "/dev");
    for (const std::string need : {"build", "test"}) {
        std::smatch match;
        ASSERT_TRUE(std::regex_search(dev, match, std::regex(need + "\\) echo ([^;]*) ;;")));
        std::istringstream packages(match[1]);
        std::string package;
        while (packages >> package) EXPECT_THAT(readme, testing::HasSubstr(package));
    }
}

TEST(DiagnosticsDocument, MessagesAreAsShown) {
    const std::vector<Fence> fences = fences_of(test::read_bytes(kTop + "/docs/diagnostics.md"));
    const test::TempDirectory directory;
    std::map<std::string, std::string> shown;
    std::set<std::string> scenes;
    for (const Fence& fence : fences) {
        const std::size_t space = fence.info.find(' ');
        ASSERT_NE(space, fence.info.npos) << "which file is this?\n" << fence.text;
        const std::string name = fence.info.substr(space + 1);
        if (fence.info.starts_with("text ")) {
            shown[name] = fence.text;
        } else {
            directory.write(name, fence.text);
            scenes.insert(name);
        }
    }
    EXPECT_GE(shown.size(), 3u);
    for (const std::string& scene : scenes) {
        const auto result =
            test::run_process({LRAY_BINARY, "--check", scene}, {}, directory.path());
        EXPECT_EQ(result.err, shown[scene]) << scene;
    }
}

TEST(Documents, ScenesAreFormatted) {
    std::size_t count = 0;
    for (const std::string document :
         {"README.md", "grammar.md", "docs/guide.md", "docs/viewer.md"}) {
        for (const Fence& fence : fences_of(test::read_bytes(kTop + "/" + document))) {
            if (fence.info != "lrs") continue;  // some show that other layouts are read, too
            ++count;
            const auto formatted = test::run_process({LRAY_BINARY, "--fmt", "-"}, fence.text);
            EXPECT_EQ(formatted.exit_code, 0) << formatted.err;
            EXPECT_EQ(formatted.out, fence.text) << document;
        }
    }
    EXPECT_GT(count, 20u);
}

/// The line of --stats about tests, of an example rendered by level 2.
std::string tests_line(const std::string& example, const std::string& size,
                       const std::string& accel) {
    const auto result = test::run_process(
        {LRAY_BINARY, "-n", "2", "-ps", "1", "-i", kTop + "/examples/" + example + ".lrs", "--size",
         size, "-o", "-", "--stats", "--quiet", "--accel", accel, "--shading", "flat"});
    std::smatch match;
    const bool is_found = std::regex_search(result.err, match, std::regex("tests        [^\n]*"));
    EXPECT_TRUE(is_found) << result.err;
    return match[0];
}

// The table of tests per ray is what --stats says, and so are the lines that are shown of it.
TEST(HierarchiesDocument, TestsPerRayAreThoseOfTheProgram) {
    const std::string document = test::read_bytes(kTop + "/docs/hierarchies.md");
    const std::regex row("\n\\| `(none|spheres|boxes)` \\| ([0-9.]+) \\| ([0-9.]+) \\|");
    std::set<std::string> rows;
    for (auto at = std::sregex_iterator(document.begin(), document.end(), row);
         at != std::sregex_iterator(); ++at) {
        const std::string accel = (*at)[1];
        rows.insert(accel);
        EXPECT_EQ(tests_line("sphereflake", "160x120", accel),
                  "tests        " + (*at)[2].str() + " nodes, " + (*at)[3].str() +
                      " primitives, 0.00 instances per ray");
    }
    EXPECT_EQ(rows.size(), 3u);
    const std::regex shown("\nhierarchy    (none|spheres|boxes)[^\n]*\n(tests[^\n]*)");
    std::set<std::string> hierarchies;
    for (auto at = std::sregex_iterator(document.begin(), document.end(), shown);
         at != std::sregex_iterator(); ++at) {
        const std::string accel = (*at)[1];
        hierarchies.insert(accel);
        EXPECT_EQ(tests_line("forest", "96x54", accel), (*at)[2]);
    }
    EXPECT_EQ(hierarchies.size(), 3u);
}

/// Files that a document links to, without those of the web.
std::vector<std::string> links_of(const std::string& document) {
    std::vector<std::string> links;
    const std::regex link("\\]\\(([^)#]+)[^)]*\\)");
    for (auto at = std::sregex_iterator(document.begin(), document.end(), link);
         at != std::sregex_iterator(); ++at) {
        const std::string target = (*at)[1];
        if (!target.starts_with("http")) links.push_back(target);
    }
    return links;
}

TEST(Documents, LinkToFilesThatAreThere) {
    for (const std::string document :
         {"README.md", "grammar.md", "docs/diagnostics.md", "docs/formats.md", "docs/guide.md",
          "docs/hierarchies.md", "docs/architecture.md", "docs/viewer.md"}) {
        const std::filesystem::path path = std::filesystem::path(kTop) / document;
        for (const std::string& link : links_of(test::read_bytes(path.string()))) {
            EXPECT_TRUE(std::filesystem::exists(path.parent_path() / link))
                << document << " links to " << link;
        }
    }
}

}  // namespace
}  // namespace lray
