// The scenes that users learn from, examples/ and the library: nothing is to be said about them,
// they are in the canonical style, and what is imported brings its names and nothing else.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/support/process.h"
#include "tests/support/temp_directory.h"

namespace lray {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> scenes_below(const fs::path& directory) {
    std::vector<std::string> scenes;
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(LRAY_SOURCE_DIR) / directory)) {
        if (entry.path().extension() == ".lrs") scenes.push_back(entry.path().string());
    }
    std::sort(scenes.begin(), scenes.end());
    EXPECT_GE(scenes.size(), 3u) << directory;
    return scenes;
}

std::vector<std::string> all_scenes() {
    std::vector<std::string> scenes = scenes_below("examples");
    for (std::string& scene : scenes_below("parser/std")) scenes.push_back(std::move(scene));
    return scenes;
}

TEST(Examples, NothingIsToBeSaidAboutThem) {
    for (const std::string& scene : all_scenes()) {
        const auto result = test::run_process({LRAY_BINARY, "--check", scene});
        EXPECT_EQ(result.exit_code, 0) << scene;
        EXPECT_EQ(result.err, "") << scene;
    }
}

TEST(Examples, AreInTheCanonicalStyle) {
    std::vector<std::string> command = {LRAY_BINARY, "--fmt", "--check"};
    for (const std::string& scene : all_scenes()) command.push_back(scene);
    const auto result = test::run_process(command);
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
}

TEST(Library, ImportPlacesNothing) {
    const test::TempDirectory directory;
    for (const fs::path scene : scenes_below("parser/std")) {
        directory.write("a.lrs",
                        fmt::format("import \"std:{}\" as lib\n", scene.filename().string()));
        const auto result =
            test::run_process({LRAY_BINARY, "--check", "a.lrs"}, {}, directory.path());
        EXPECT_EQ(result.exit_code, 0) << scene << result.err;
        EXPECT_THAT(result.err, testing::HasSubstr("the scene is empty")) << scene;
    }
}

TEST(Library, GivesWhatItsFilesSay) {
    const test::TempDirectory directory;
    directory.write("a.lrs", R"(import "std:materials.lrs" as mat
import "std:lights.lrs" as lights
import "std:colors.lrs" as palette
camera { position: [0, 2, 6] }
lights.sky { elevation: 10 }
lights.three_point { target: [0, 1, 0], distance: 3, rotate_y: 30 }
lights.ring_light { count: 4, translate: [0, 0, 5] }
lights.candle_light { translate: [1, 0, 0] }
sphere { material: mat.gold { roughness: 0.4 } }
sphere { center: [2, 0, 0], material: mat.glass(tint: #b8ffd0, ior: 1.6) }
sphere { center: [4, 0, 0], material: mat.cloth(palette.cycle(palette.autumn, 5)) }
assert(palette.cycle(palette.autumn, 5) == palette.autumn[0])
assert(palette.along([black, white], 0.5) == gray(0.5))
assert(palette.along([red, black, white], 1) == white)
assert(palette.along([teal], 0.3) == teal)
assert(palette.lighten(black, 0.25) == gray(0.25))
assert(palette.darken(white, 0.25) == gray(0.75))
)");
    const auto result = test::run_process({LRAY_BINARY, "--check", "a.lrs"}, {}, directory.path());
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
}

// Its light would come from below.
TEST(Library, SunBelowTheHorizonIsAnError) {
    const test::TempDirectory directory;
    directory.write("a.lrs", "import \"std:lights.lrs\" as lights\nlights.sky { elevation: -5 }\n");
    const auto result = test::run_process({LRAY_BINARY, "--check", "a.lrs"}, {}, directory.path());
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, testing::HasSubstr("the sun must be above the horizon"));
}

}  // namespace
}  // namespace lray
