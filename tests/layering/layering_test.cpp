// The folders of this tree against the table of docs/architecture.md, and the rules themselves on
// snippets that break them.
#include "tests/layering/layering.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace lray::layering {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

const fs::path kTop = LRAY_SOURCE_DIR;

std::string read_text(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    EXPECT_TRUE(file && !text.str().empty()) << path;
    return text.str();
}

/// Paths of all C++ files, relative to the top. Hidden folders and build trees are not ours.
std::vector<std::string> source_files() {
    std::vector<std::string> paths;
    for (auto entry = fs::recursive_directory_iterator(kTop); entry != fs::end(entry); ++entry) {
        const std::string name = entry->path().filename().string();
        const bool is_foreign = name.starts_with('.') ||
                                fs::exists(entry->path() / "CMakeCache.txt") ||
                                (entry.depth() == 0 && name.starts_with("build"));
        if (entry->is_directory() && is_foreign) entry.disable_recursion_pending();
        const std::string extension = entry->path().extension().string();
        if (entry->is_regular_file() && (extension == ".h" || extension == ".cpp")) {
            paths.push_back(entry->path().lexically_relative(kTop).generic_string());
        }
    }
    std::ranges::sort(paths);
    return paths;
}

FolderTable project_table() {
    const auto table = read_folder_table(read_text(kTop / "docs" / "architecture.md"));
    EXPECT_TRUE(table.has_value());
    return table.value_or(FolderTable{});
}

/// A small table for the rules: low < bvh < high, and tests above all.
const FolderTable& small_table() {
    static const FolderTable kTable = read_folder_table(
                                          "| folder | lives here | may include |\n"
                                          "|---|---|---|\n"
                                          "| `base/` | a thing \\| two | – |\n"
                                          "| `bvh/` | more | base |\n"
                                          "| `high/` | most | base bvh |\n"
                                          "| `tests/` | checks | all |\n")
                                          .value();
    return kTable;
}

TEST(Layering, EveryFileKeepsTheRules) {
    const FolderTable table = project_table();
    const std::vector<std::string> paths = source_files();
    // A walk that finds nothing would pass everything.
    ASSERT_THAT(paths, testing::IsSupersetOf({"base/vec.h", "tests/layering/layering.cpp"}));
    std::vector<std::string> broken;
    for (const std::string& path : paths) {
        const std::string text = read_text(kTop / path);
        const std::vector<std::string> here = broken_rules(path, text, table);
        broken.insert(broken.end(), here.begin(), here.end());
    }
    EXPECT_THAT(broken, IsEmpty());
}

TEST(Layering, EveryRowOfTheTableIsAFolder) {
    for (const std::string& folder : project_table().folders) {
        // bench/ is built on demand and gui/ may be left out of a build, but both are in the tree.
        EXPECT_TRUE(fs::is_directory(kTop / folder)) << folder;
    }
}

TEST(Layering, FoldersIncludeOnlyRowsAboveTheirOwn) {
    const FolderTable table = project_table();
    std::set<std::string> above;
    for (const std::string& folder : table.folders) {
        const std::set<std::string>& may_include = table.may_include.at(folder);
        const bool is_top = may_include.size() == table.folders.size();
        if (!is_top) {
            EXPECT_TRUE(std::ranges::includes(above, may_include)) << folder;
        }
        above.insert(folder);
    }
}

TEST(FolderTable, RowsAreReadInOrder) {
    EXPECT_THAT(small_table().folders, ElementsAre("base", "bvh", "high", "tests"));
    EXPECT_THAT(small_table().may_include.at("base"), IsEmpty());
    EXPECT_THAT(small_table().may_include.at("high"), ElementsAre("base", "bvh"));
    EXPECT_THAT(small_table().may_include.at("tests"), ElementsAre("base", "bvh", "high", "tests"));
}

TEST(FolderTable, BadTablesAreRefused) {
    EXPECT_FALSE(read_folder_table("no table here\n"));
    EXPECT_FALSE(read_folder_table("| `base/` | a | bse |\n"));
    EXPECT_FALSE(read_folder_table("| `base/` | a | |\n"));
    EXPECT_FALSE(read_folder_table("| `base/` | a | – |\n| `base/` | b | – |\n"));
}

TEST(LayeringRules, AllowedEdgesPass) {
    EXPECT_THAT(broken_rules("high/a.cpp",
                             "#include \"high/a.h\"\n"
                             "#include \"bvh/build.h\"\n"
                             "#include <vector>\n"
                             "#include <fmt/format.h>\n"
                             "float x = std::fma(a, b, c);  // only kernels are held to it\n",
                             small_table()),
                IsEmpty());
    EXPECT_THAT(broken_rules("base/vec.h", "// Vectors.\n#pragma once\n#include <glm/vec3.hpp>\n",
                             small_table()),
                IsEmpty());
}

TEST(LayeringRules, AnEdgeThatIsNotInTheTableIsBroken) {
    EXPECT_THAT(
        broken_rules("base/a.cpp", "\n  #  include \"bvh/build.h\"  // why\n", small_table()),
        ElementsAre("base/a.cpp:2: base/ may not include bvh/ (docs/architecture.md)"));
    EXPECT_THAT(broken_rules("high/a.cpp", "#include \"tests/b.h\"\n", small_table()),
                ElementsAre("high/a.cpp:1: high/ may not include tests/ (docs/architecture.md)"));
}

TEST(LayeringRules, IncludesAreWrittenFromTheTop) {
    const std::string climbs =
        "high/a.cpp:1: includes are written from the top of the tree, "
        "without ../";
    EXPECT_THAT(broken_rules("high/a.cpp", "#include \"../bvh/build.h\"\n", small_table()),
                ElementsAre(climbs));
    EXPECT_THAT(broken_rules("high/a.cpp", "#include \"bvh/../bvh/build.h\"\n", small_table()),
                ElementsAre(climbs));
    const std::string unplaced =
        "high/a.cpp:1: quotes are for headers of lray, written from the top of the tree";
    EXPECT_THAT(broken_rules("high/a.cpp", "#include \"b.h\"\n", small_table()),
                ElementsAre(unplaced));
    EXPECT_THAT(broken_rules("high/a.cpp", "#include \"png.h\"\n", small_table()),
                ElementsAre(unplaced));
    EXPECT_THAT(broken_rules("high/a.cpp", "#include <bvh/build.h>\n", small_table()),
                ElementsAre("high/a.cpp:1: what is lray's is included in quotes"));
}

TEST(LayeringRules, GlmIsIncludedByVecAlone) {
    for (const char* include : {"#include <glm/vec3.hpp>\n", "#include \"glm/vec3.hpp\"\n"}) {
        EXPECT_THAT(broken_rules("base/ray.cpp", include, small_table()),
                    ElementsAre("base/ray.cpp:1: GLM is included by base/vec.h alone"));
    }
}

TEST(LayeringRules, KernelsUseNoFusedOrApproximateOperations) {
    for (const char* line :
         {"std::fma(a, b, c)", "fmaf (a, b, c)", "__builtin_fma(a, b, c)", "hn::MulAdd(a, b, c)",
          "hn::NegMulAdd(a, b, c)", "MulSub(a, b, c)", "ApproximateReciprocal(a)",
          "ApproximateReciprocalSqrt(a)", "_mm256_fmadd_ps(a, b, c)", "_mm_fnmsub_ss(a, b, c)"}) {
        EXPECT_THAT(
            broken_rules("bvh/a.cpp", line, small_table()),
            ElementsAre(
                "bvh/a.cpp:1: bvh/ uses no fused or approximate operations (docs/style.md, 18)"))
            << line;
    }
    EXPECT_THAT(broken_rules("bvh/a.cpp",
                             "// no std::fma(a, b, c) here\n"
                             "x = a * b + c;  // not MulAdd\n"
                             "alfma(a);\n",
                             small_table()),
                IsEmpty());
}

TEST(LayeringRules, HeadersNeedPragmaOnce) {
    EXPECT_THAT(broken_rules("base/a.h", "// A.\nnamespace lray {}\n", small_table()),
                ElementsAre("base/a.h:1: a header begins with #pragma once"));
    EXPECT_THAT(broken_rules("base/a.cpp", "namespace lray {}\n", small_table()), IsEmpty());
    EXPECT_THAT(broken_rules("base/a-inl.h", "namespace lray {}\n", small_table()), IsEmpty());
}

TEST(LayeringRules, FilesOutsideTheTableAreBroken) {
    EXPECT_THAT(broken_rules("utils/a.cpp", "int x;\n", small_table()),
                ElementsAre("utils/a.cpp:1: its folder is not in docs/architecture.md"));
    EXPECT_THAT(broken_rules("main.cpp", "int x;\n", small_table()),
                ElementsAre("main.cpp:1: its folder is not in docs/architecture.md"));
}

}  // namespace
}  // namespace lray::layering
