#include "cli/picture_names.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/current_directory.h"
#include "tests/support/temp_directory.h"

namespace lray::cli {
namespace {

Options of_scene(const std::string& scene_path, const std::string& output_path = {}) {
    Options options;
    options.scene_path = scene_path;
    options.output_path = output_path;
    return options;
}

std::string next(const Options& options) {
    std::string problem;
    const auto name = next_picture_name(options, problem);
    EXPECT_EQ(name.has_value(), problem.empty());
    return name.value_or("none: " + problem);
}

TEST(SceneStem, IsTheNameWithoutItsExtension) {
    EXPECT_EQ(scene_stem("a/room.lrs"), "room");
    EXPECT_EQ(scene_stem("room.v2.lrs"), "room.v2");
    EXPECT_EQ(scene_stem("room"), "room");
    EXPECT_EQ(scene_stem("-"), "scene");
    EXPECT_EQ(scene_stem("a.b/.lrs"), "scene");
    EXPECT_EQ(scene_stem("a.b/room"), "room");
}

TEST(PictureNames, AreTheOutputIfThereIsOne) {
    EXPECT_EQ(next(of_scene("a.lrs", "b/c.ppm")), "b/c.ppm");
    EXPECT_EQ(next(of_scene("a.lrs", "c-####.png")), "c-####.png");
    Options frame = of_scene("a.lrs", "c-####.png");
    frame.frames = FrameRange{7, 7};
    EXPECT_EQ(next(frame), "c-0007.png");
}

TEST(PictureNames, AreTheFirstThatIsFreeHere) {
    const test::TempDirectory directory;
    const test::CurrentDirectory current(directory.path());
    const Options options = of_scene("elsewhere/room.lrs");
    EXPECT_EQ(next(options), "room-001.png");
    directory.write("room-001.png", "");
    std::filesystem::create_symlink("nowhere", "room-002.png");
    directory.write("room-004.png", "");
    EXPECT_EQ(next(options), "room-003.png");
    EXPECT_EQ(next(of_scene("-")), "scene-001.png");
    Options jpeg = options;
    jpeg.format = image::Format::jpg;
    EXPECT_EQ(next(jpeg), "room-001.jpg");
}

TEST(PictureNames, EndAtTheGreatestNumber) {
    const test::TempDirectory directory;
    const test::CurrentDirectory current(directory.path());
    for (int i = 1; i < kMaxPictureNumber; ++i) directory.write(fmt::format("r-{:03}.png", i), "");
    EXPECT_EQ(next(of_scene("r.lrs")), "r-999.png");
    directory.write("r-999.png", "");
    EXPECT_EQ(next(of_scene("r.lrs")),
              "none: all names from `r-001.png` to `r-999.png` are taken; name another with `-o`");
}

}  // namespace
}  // namespace lray::cli
