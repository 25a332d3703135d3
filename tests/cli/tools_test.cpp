// The program for other programs: diagnostics for machines, dependencies, frames, where files are
// found, and what is installed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "tests/support/json.h"
#include "tests/support/process.h"
#include "tests/support/temp_directory.h"

namespace lray {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kCamera = "camera { position: [0, 0, 5] }\n";
constexpr const char* kRight =
    "camera { position: [0, 0, 5] }\npoint_light { position: [4, 6, 5] }\nsphere { }\n";
constexpr const char* kWarned =  // W1301 W1501
    "sphere { translate: [1, 0, 0], scale: 2 }\npoint_light { position: [4, 6, 5] }\n";

class Tools : public testing::Test {
 protected:
    test::ProcessResult run(std::vector<std::string> arguments, const std::string& program = {}) {
        arguments.insert(arguments.begin(), program.empty() ? LRAY_BINARY : program);
        return test::run_process(arguments, {}, directory_.path());
    }

    test::TempDirectory directory_;
};

TEST_F(Tools, DumpGoesToStandardOutputOrAFileAndRendersTheSame) {
    directory_.write("a.lrs",
                     "include \"b.lrs\"\n"
                     "camera { position: [0, 1, 5 + time] }\n"
                     "animation { frames: 4, fps: 1 }\n"
                     "for i in range(3) { sphere { center: [i, 0, 0], radius: 0.3 } }\n");
    directory_.write("b.lrs", "box { translate: [-2, 0, 0] }\n");
    const auto to_output = run({"--dump", "a.lrs", "--frame", "2"});
    EXPECT_EQ(to_output.exit_code, 0) << to_output.err;
    const auto to_file = run({"--dump", "a.lrs", "--frame", "2", "-o", "dumped.lrs"});
    EXPECT_EQ(to_file.exit_code, 0) << to_file.err;
    EXPECT_EQ(to_file.out, "");
    EXPECT_EQ(directory_.read("dumped.lrs"), to_output.out);
    EXPECT_THAT(to_output.out, Not(HasSubstr("for ")));
    const auto render = [&](const char* scene, const char* picture) {
        return run({"-n", "1", "-i", scene, "--frame", "2", "-o", picture, "--size", "32x24"});
    };
    EXPECT_EQ(render("a.lrs", "a.ppm").exit_code, 0);
    EXPECT_EQ(render("dumped.lrs", "d.ppm").exit_code, 0);
    EXPECT_EQ(directory_.read("a.ppm"), directory_.read("d.ppm"));
}

TEST_F(Tools, DumpOverwritesNothingThatItRead) {
    directory_.write("a.lrs", "include \"b.lrs\"\ncamera { }\n");
    directory_.write("b.lrs", "sphere { }\n");
    for (const char* const file : {"a.lrs", "b.lrs"}) {
        const auto result = run({"--dump", "a.lrs", "-o", file});
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_THAT(result.err, HasSubstr(std::string("`-o ") + file + "` would overwrite"));
        EXPECT_THAT(result.err, HasSubstr("give the output another name"));
    }
    EXPECT_EQ(directory_.read("b.lrs"), "sphere { }\n");
    const auto frames = run({"--dump", "a.lrs", "--frames", "0:3", "-o", "d-##.lrs"});
    EXPECT_EQ(frames.exit_code, 2);
    EXPECT_THAT(frames.err, HasSubstr("`--dump` writes one frame"));
    const auto wrong = run({"--dump", "c.lrs", "-o", "d.lrs"});
    EXPECT_NE(wrong.exit_code, 0);
    EXPECT_FALSE(fs::exists(directory_.path("d.lrs")));
}

TEST_F(Tools, JsonIsALineEachAndNothingElse) {
    directory_.write("a.lrs", "sphere { radios: 1 }\nbox { siz: 1 }\n");
    const auto result = run({"--check", "a.lrs", "--diagnostics=json"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(result.out, "");
    std::istringstream lines(result.err);
    std::vector<test::Json> read;
    for (std::string line; std::getline(lines, line);) read.push_back(test::read_json(line));
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(read[0]["code"].string, "E0401");
    EXPECT_EQ(read[0]["fix"]["replacement"].string, "radius");
    EXPECT_EQ(read[1]["line"].number, 2);
    directory_.write("b.lrs", kRight);
    const auto right = run({"--check", "b.lrs", "--diagnostics=json"});
    EXPECT_EQ(right.exit_code, 0);
    EXPECT_EQ(right.out + right.err, "");
}

TEST_F(Tools, SarifIsOneDocumentAlsoWhenAllIsWell) {
    directory_.write("a.lrs", kWarned);
    const auto result = run(
        {"a.lrs", "-o", "a.ppm", "--size", "8x8", "-n", "1", "-ps", "4", "--diagnostics", "sarif"});
    EXPECT_EQ(result.exit_code, 0);
    const test::Json log = test::read_json(result.err);
    EXPECT_EQ(log["runs"][0]["results"].elements.size(), 2u);
    EXPECT_TRUE(fs::exists(directory_.path("a.ppm")));
    directory_.write("b.lrs", kRight);
    const auto right = run({"--check", "b.lrs", "--diagnostics", "sarif"});
    EXPECT_EQ(right.exit_code, 0);
    EXPECT_TRUE(test::read_json(right.err)["runs"][0]["results"].elements.empty());
}

TEST_F(Tools, MachinesGetAllDiagnosticsUnlessTheyAskForFewer) {
    std::string many;
    for (int i = 0; i < 30; ++i) many += "sphere { radios: 1 }\n";
    directory_.write("a.lrs", many);
    const auto count = [&](std::vector<std::string> options) {
        options.insert(options.begin(), {"--check", "a.lrs"});
        const std::string err = run(options).err;
        std::size_t found = 0;
        for (std::size_t at = 0; (at = err.find("has no property", at)) != err.npos; ++at) ++found;
        return found;
    };
    EXPECT_EQ(count({}), 20u);
    EXPECT_EQ(count({"--diagnostics", "json"}), 30u);
    EXPECT_EQ(count({"--diagnostics", "json", "--max-errors", "7"}), 7u);
    EXPECT_EQ(count({"--max-errors", "0"}), 30u);
}

TEST_F(Tools, WarningsAreToldSilencedAndDeniedByCodeOrName) {
    directory_.write("a.lrs", kWarned);
    const auto check = [&](std::vector<std::string> options) {
        options.insert(options.begin(), {"--check", "a.lrs"});
        return run(options);
    };
    EXPECT_EQ(check({}).out, "a.lrs: no errors, 2 warnings\n");
    const auto silenced = check({"-A", "scale-after-translate"});
    EXPECT_EQ(silenced.out, "a.lrs: no errors, 1 warning\n");
    EXPECT_EQ(silenced.err.find("W1301"), std::string::npos);
    EXPECT_EQ(check({"-A", "all", "--deny", "warnings"}).out, "a.lrs: no errors\n");
    EXPECT_EQ(check({"-A", "all", "-W", "W1301"}).out, "a.lrs: no errors, 1 warning\n");
    const auto denied = check({"--deny", "W1301"});
    EXPECT_EQ(denied.exit_code, 1);
    EXPECT_THAT(denied.err, testing::EndsWith("\n2 warnings, 1 denied by `--deny`\n"));
    EXPECT_EQ(check({"--deny", "W1301", "-W", "W1301"}).exit_code, 0) << "the last one counts";
    EXPECT_EQ(check({"--deny", "W1301", "--diagnostics", "json"}).exit_code, 1);
    EXPECT_EQ(check({"-A", "E0401"}).exit_code, 2);
}

TEST_F(Tools, DependenciesAreTheFilesReadTheSceneFirst) {
    directory_.write(
        "a.lrs", std::string(kCamera) + "include \"parts/b.lrs\"\ninclude \"std:materials.lrs\"\n");
    directory_.write("parts/b.lrs", "mesh { file: \"m.obj\" }\nmesh { file: \"./m.obj\" }\n");
    directory_.write("parts/m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto result = run({"--deps", "a.lrs"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    std::istringstream lines(result.out);
    std::vector<std::string> files;
    for (std::string line; std::getline(lines, line);) files.push_back(line);
    ASSERT_EQ(files.size(), 4u) << result.out;
    EXPECT_EQ(files[0], "a.lrs");
    EXPECT_EQ(files[1], "parts/b.lrs");
    EXPECT_TRUE(fs::exists(files[2])) << files[2];
    EXPECT_THAT(files[2], testing::EndsWith("/std/materials.lrs"));
    EXPECT_EQ(files[3], "parts/m.obj");
    directory_.write("wrong.lrs", "sphere { radios: 1 }\n");
    const auto wrong = run({"--deps", "wrong.lrs"});
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_EQ(wrong.out, "");
}

TEST_F(Tools, FramesAreNumberedPictures) {
    directory_.write("a.lrs", kWarned);
    const auto result = run({"a.lrs", "-o", "out-###.ppm", "--frames", "9:11", "--size", "8x8"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(directory_.names(),
              (std::vector<std::string>{"a.lrs", "out-009.ppm", "out-010.ppm", "out-011.ppm"}));
    EXPECT_THAT(result.err, HasSubstr("frame 1 of 3\nframe 2 of 3\nframe 3 of 3\n"));
    EXPECT_EQ(result.err.find("W1301"), result.err.rfind("W1301")) << "told once";
    const auto one = run({"a.lrs", "-o", "one-##.ppm", "--frame", "5", "--size", "8x8", "--quiet"});
    EXPECT_EQ(one.exit_code, 0) << one.err;
    EXPECT_EQ(directory_.read("one-05.ppm"), directory_.read("out-009.ppm"));
    EXPECT_EQ(run({"--check", "a.lrs", "--frames", "1:2"}).out,
              "a.lrs, frame 1 of 2: no errors, 2 warnings\n"
              "a.lrs, frame 2 of 2: no errors, 2 warnings\n");
}

TEST_F(Tools, FramesEndWithTheFirstThatFails) {
    directory_.write("a.lrs", kRight);
    fs::create_directory(directory_.path("out-2.ppm"));  // no picture can be written there
    const auto result = run({"a.lrs", "-o", "out-#.ppm", "--frames", "1:3", "--size", "8x8"});
    EXPECT_EQ(result.exit_code, 4) << result.err;
    EXPECT_TRUE(fs::exists(directory_.path("out-1.ppm")));
    EXPECT_FALSE(fs::exists(directory_.path("out-3.ppm")));
}

TEST_F(Tools, LrayPathIsSearchedBehindIncludeDirectories) {
    directory_.write("scenes/a.lrs", std::string(kCamera) + "include \"part.lrs\"\n");
    directory_.write("x/part.lrs", "sphere { radius: 1 }\n");
    directory_.write("y/part.lrs", "sphere { radius: 2 }\n");
    const auto deps = [&](std::vector<std::string> options) {
        options.insert(options.begin(), {"--deps", "scenes/a.lrs"});
        return run(options);
    };
    EXPECT_EQ(deps({}).exit_code, 1);
    ASSERT_EQ(setenv("LRAY_PATH", ":nowhere::y:x", 1), 0);
    const auto found = deps({});
    const auto before = deps({"-I", "x"});
    directory_.write("scenes/part.lrs", "sphere { }\n");
    const auto beside = deps({"-I", "x"});
    ASSERT_EQ(unsetenv("LRAY_PATH"), 0);
    EXPECT_EQ(found.out, "scenes/a.lrs\ny/part.lrs\n") << found.err;
    EXPECT_EQ(before.out, "scenes/a.lrs\nx/part.lrs\n") << before.err;
    EXPECT_EQ(beside.out, "scenes/a.lrs\nscenes/part.lrs\n") << beside.err;
}

TEST_F(Tools, InstalledProgramFindsItsLibrary) {
    const std::string prefix = directory_.path("a prefix");
    const auto installed =
        test::run_process({LRAY_CMAKE, "--install", LRAY_BINARY_DIR, "--prefix", prefix});
    ASSERT_EQ(installed.exit_code, 0) << installed.err;
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(prefix)) {
        if (entry.is_regular_file()) {
            files.push_back(entry.path().lexically_relative(prefix).string());
        }
    }
    EXPECT_THAT(files, testing::IsSupersetOf({"bin/lray", "share/lray/std/materials.lrs"}));
    directory_.write("a.lrs", std::string(kCamera) +
                                  "include \"std:materials.lrs\"\nsphere { material: gold }\n");
    const auto result = run({"--deps", "a.lrs"}, prefix + "/bin/lray");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, std::string("a.lrs\n") + prefix + "/share/lray/std/materials.lrs\n");
    fs::create_symlink(prefix + "/bin/lray", directory_.path("linked"));
    EXPECT_EQ(run({"--check", "a.lrs"}, directory_.path("linked")).exit_code, 0);

    fs::remove_all(prefix + "/share");
    const auto lost = run({"--check", "a.lrs"}, prefix + "/bin/lray");
    EXPECT_EQ(lost.exit_code, 1);
    EXPECT_THAT(lost.err, HasSubstr("the library is missing"));
}

}  // namespace
}  // namespace lray
