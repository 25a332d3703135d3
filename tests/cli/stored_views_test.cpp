#include "cli/stored_views.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "base/angle.h"
#include "tests/support/current_directory.h"
#include "tests/support/temp_directory.h"

namespace lray::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kOwnLine =
    "// Views stored with Shift and F1 to F9 in the viewer of lray, which writes this file anew\n";

class StoredViewsTest : public testing::Test {
 protected:
    StoredViews read(std::string* problem = nullptr) const {
        std::string told;
        FileAccess files;
        StoredViews views = read_views("room.views.lrs", files, told);
        if (problem == nullptr) {
            EXPECT_EQ(told, "");
        } else {
            *problem = told;
        }
        return views;
    }
    std::string problem_of_reading() const {
        std::string problem;
        EXPECT_TRUE(read(&problem).empty());
        return problem;
    }
    static std::string write(const StoredViews& views) {
        return write_views("room.views.lrs", views);
    }
    void put(std::string_view text) const { directory_.write("room.views.lrs", text); }
    std::string text() const { return directory_.read("room.views.lrs"); }

    test::TempDirectory directory_;
    test::CurrentDirectory current_{directory_.path()};
};

scene::Camera camera_at(double x) {
    scene::Camera camera;
    camera.position = {x, 0.1, 1.0 / 3.0};
    return camera;
}

TEST(ViewsPath, StandsBesideTheScene) {
    EXPECT_EQ(views_path("a/room.lrs"), "a/room.views.lrs");
    EXPECT_EQ(views_path("room"), "room.views.lrs");
    EXPECT_EQ(views_path("room.txt"), "room.txt.views.lrs");
    EXPECT_EQ(views_path("a/.lrs"), "a/.lrs.views.lrs");
    EXPECT_EQ(views_path("-"), "");
}

TEST_F(StoredViewsTest, MissingFileHasNoneAndIsNoProblem) {
    EXPECT_TRUE(read().empty());
    EXPECT_TRUE(directory_.names().empty());
}

TEST_F(StoredViewsTest, AreReadBackToTheBit) {
    scene::Camera all = camera_at(-0.0);
    all.name = "of the scene";
    all.up = {0.0, 0.1 + 0.2, 1e-17};
    all.fov = radians(33.3);
    all.projection = scene::Projection::panorama;
    all.height = 7.0 / 9.0;
    all.aperture = 0.05;
    all.focus = 2.7;
    all.resolution = scene::Resolution{640, 360};
    all.samples = 9;
    all.background = Color{0.1f, 0.2f, 0.3f};
    ASSERT_EQ(write({{1, camera_at(1.0)}, {9, all}}), "");
    EXPECT_TRUE(text().starts_with(std::string(kOwnLine) + "camera \"view 1\" { position: [1, "));
    const StoredViews views = read();
    ASSERT_EQ(views.size(), 2u);
    const scene::Camera& read_back = views.at(9);
    EXPECT_EQ(read_back.name, "view 9");
    const auto is_same = [](const auto& a, const auto& b) {
        return std::memcmp(&a, &b, sizeof(a)) == 0;
    };
    EXPECT_TRUE(is_same(read_back.position, all.position));
    EXPECT_TRUE(is_same(read_back.look_at, all.look_at));
    EXPECT_TRUE(is_same(read_back.up, all.up));
    EXPECT_TRUE(is_same(read_back.fov, all.fov));
    EXPECT_TRUE(is_same(read_back.height, all.height));
    EXPECT_TRUE(is_same(read_back.aperture, all.aperture));
    EXPECT_EQ(read_back.projection, all.projection);
    EXPECT_EQ(read_back.focus, all.focus);
    EXPECT_EQ(read_back.resolution, all.resolution);
    EXPECT_EQ(read_back.samples, all.samples);
    EXPECT_EQ(read_back.background, all.background);
    EXPECT_EQ(views.at(1).position, camera_at(1.0).position);
}

TEST_F(StoredViewsTest, AreReplacedByWhatIsWrittenNext) {
    ASSERT_EQ(write({{1, camera_at(1.0)}, {2, camera_at(2.0)}}), "");
    ASSERT_EQ(write({{3, camera_at(3.0)}}), "");
    EXPECT_EQ(read().size(), 1u);
    ASSERT_EQ(write({}), "");
    EXPECT_EQ(text(), kOwnLine);
    EXPECT_TRUE(read().empty());
    ASSERT_EQ(write({{3, camera_at(3.0)}}), "");
    EXPECT_EQ(directory_.names(), std::vector<std::string>{"room.views.lrs"});
}

TEST_F(StoredViewsTest, EditedByHandAreStillViews) {
    put("camera \"view 2\" {\n  position: [1.50, 2, 3]\n  fov: 30deg\n}\n");
    EXPECT_EQ(read().at(2).position, (DVec3{1.5, 2.0, 3.0}));
    EXPECT_EQ(write({{1, camera_at(1.0)}}), "");
}

TEST_F(StoredViewsTest, OtherCamerasArePassedOver) {
    put("camera \"view 1\" { }\ncamera \"view 1\" { fov: 3 }\ncamera \"view 10\" { }\n"
        "camera \"view 01\" { }\ncamera \"view 0\" { }\ncamera { }\nsphere { }\n");
    const StoredViews views = read();
    ASSERT_EQ(views.size(), 1u);
    EXPECT_EQ(views.at(1).fov, scene::Camera{}.fov);
}

TEST_F(StoredViewsTest, FileWithAnythingElseIsNotOverwritten) {
    const std::string own = std::string(kOwnLine) + "camera \"view 1\" { }\n";
    for (const std::string& other :
         {own + "// note\n", "// note\n" + own, own + "sphere { }\n", own + "camera \"mine\" { }\n",
          own + "camera \"view 1\" { }\n", own + "camera \"view 2\" { fov: 2 * 15 }\n",
          std::string("camera { "), std::string("let a = 1"), std::string("\x00\xff", 2),
          own + "camera \"view 2\" { fov: \"wide\" }\n", std::string("render { samples: 2 }"),
          std::string("include \"room.lrs\"")}) {
        put(other);
        EXPECT_EQ(write({{1, camera_at(1.0)}}),
                  "`room.views.lrs` is left as it is: it holds more than stored views; move or "
                  "rename it to store views")
            << other;
        EXPECT_EQ(text(), other);
    }
    put("");
    EXPECT_EQ(write({{1, camera_at(1.0)}}), "");
}

TEST_F(StoredViewsTest, MistakesAreTold) {
    put("camera \"view 1\" {\n  fov: wide\n}\n");
    EXPECT_EQ(
        problem_of_reading(),
        "the views in `room.views.lrs` are not read: room.views.lrs:2:8: unknown name `wide`");
    put("\x1b[31m");
    EXPECT_THAT(problem_of_reading(), HasSubstr("room.views.lrs:1:1: "));
    EXPECT_THAT(problem_of_reading(), testing::Not(HasSubstr("\x1b")));
}

TEST_F(StoredViewsTest, DirectoryIsNoFile) {
    fs::create_directory("room.views.lrs");
    EXPECT_EQ(problem_of_reading(), "the views in `room.views.lrs` are not read: it is not a file");
    EXPECT_THAT(write({}), HasSubstr("is left as it is: it is not a file"));
}

TEST_F(StoredViewsTest, PipeIsNotWaitedFor) {
    ASSERT_EQ(mkfifo("room.views.lrs", 0600), 0);
    EXPECT_THAT(problem_of_reading(), HasSubstr("it is not a file"));
    EXPECT_THAT(write({}), HasSubstr("it is not a file"));
}

TEST_F(StoredViewsTest, UnreadableFileStays) {
    if (geteuid() == 0) GTEST_SKIP() << "root reads everything";
    put("camera \"view 1\" { }\n");
    ASSERT_EQ(chmod("room.views.lrs", 0200), 0);
    EXPECT_THAT(problem_of_reading(), HasSubstr("ermission denied"));
    EXPECT_THAT(write({}), HasSubstr("ermission denied"));
}

TEST_F(StoredViewsTest, DirectoryThatTakesNoFilesIsTold) {
    if (geteuid() == 0) GTEST_SKIP() << "root writes everywhere";
    ASSERT_EQ(chmod(directory_.path().c_str(), 0500), 0);
    EXPECT_THAT(write({}), HasSubstr("cannot write `room.views.lrs`"));
    ASSERT_EQ(chmod(directory_.path().c_str(), 0700), 0);
}

TEST_F(StoredViewsTest, HugeFileIsNotRead) {
    put("camera \"view 1\" { }\n");
    fs::resize_file("room.views.lrs", std::uintmax_t{1} << 40);
    EXPECT_THAT(problem_of_reading(), HasSubstr("it has more than 1048576 bytes"));
    EXPECT_THAT(write({}), HasSubstr("it has more than 1048576 bytes"));
}

TEST_F(StoredViewsTest, EndlessLoopEnds) {
    put("var i = 0\nwhile true { i = i + 1 }\n");
    EXPECT_THAT(problem_of_reading(), HasSubstr("steps"));
}

TEST_F(StoredViewsTest, LinksThatLeadAwayAreNotFollowed) {
    const test::TempDirectory elsewhere;
    const std::string secret = elsewhere.write("secret.lrs", "camera \"view 1\" { }\n");
    fs::create_symlink(secret, "room.views.lrs");
    EXPECT_THAT(problem_of_reading(), HasSubstr("it leads to another directory"));
    EXPECT_THAT(write({}), HasSubstr("it leads to another directory"));
    EXPECT_EQ(elsewhere.read("secret.lrs"), "camera \"view 1\" { }\n");
    for (const fs::path& target :
         {fs::path(elsewhere.path("new.lrs")), fs::path("not_there.lrs")}) {
        fs::remove("room.views.lrs");
        fs::create_symlink(target, "room.views.lrs");
        EXPECT_NE(write({}), "");
        EXPECT_FALSE(fs::exists(target));
    }
    fs::remove("room.views.lrs");
    directory_.write("kept.lrs", "");
    fs::create_symlink("kept.lrs", "room.views.lrs");
    EXPECT_EQ(write({{1, camera_at(1.0)}}), "");
    EXPECT_TRUE(fs::is_symlink("room.views.lrs"));
    EXPECT_EQ(read().size(), 1u);
}

TEST_F(StoredViewsTest, FilesOutsideAreNotReadThroughThem) {
    const test::TempDirectory elsewhere;
    const std::string secret = elsewhere.write("secret.lrs", "camera \"view 1\" { }\n");
    put("include \"" + secret + "\"\n");
    EXPECT_THAT(problem_of_reading(), HasSubstr("room.views.lrs:1:9: "));
    directory_.write("more.lrs", "camera \"view 4\" { }\n");
    put("include \"more.lrs\"\n");
    EXPECT_EQ(read().count(4), 1u);
}

TEST_F(StoredViewsTest, NamesThatMeanSomethingElseToScenesAreLeftAlone) {
    directory_.write("std:a.views.lrs", "mine");
    directory_.write("b\\c.views.lrs", "mine");
    EXPECT_THAT(write_views("std:a.views.lrs", {}), HasSubstr("is left as it is"));
    EXPECT_THAT(write_views("b\\c.views.lrs", {}), HasSubstr("is left as it is"));
    EXPECT_EQ(directory_.read("std:a.views.lrs"), "mine");
    EXPECT_EQ(directory_.read("b\\c.views.lrs"), "mine");
}

}  // namespace
}  // namespace lray::cli
