// Parts of one picture, rendered apart and added up: `lray merge`.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cli/lray_test.h"

namespace lray {
namespace {

class Merge : public LrayTest {
 protected:
    Merge() { directory_.write("scene.lrs", kScene); }

    void render_part(const std::string& range, const std::string& film,
                     std::vector<std::string> more = {}) {
        std::vector<std::string> arguments{"scene.lrs", "--samples", range, "-o", film};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto result = run(arguments);
        ASSERT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.err, "");
    }
};

TEST_F(Merge, PartsAreThePictureToTheByte) {
    render_part("0:5", "a.film", {"-ps", "16"});
    render_part("5:9", "b.film", {"-ps", "16", "--threads", "1"});
    render_part("9:16", "c.film", {"-ps", "16", "--accel", "spheres"});
    for (const char* kind : {"png", "pfm", "ppm"}) {
        const std::string merged = std::string("merged.") + kind;
        const std::string whole = std::string("whole.") + kind;
        const auto result = run({"merge", "c.film", "a.film", "b.film", "-o", merged});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.err + result.out, "");
        ASSERT_EQ(run({"scene.lrs", "-ps", "16", "-o", whole}).exit_code, 0);
        EXPECT_TRUE(directory_.read(merged) == directory_.read(whole)) << kind;
    }
}

TEST_F(Merge, FilmsOfPartsMayBeMergedAgain) {
    render_part("0:5", "a.film", {"-ps", "16"});
    render_part("5:9", "b.film", {"-ps", "16"});
    render_part("9:16", "c.film", {"-ps", "16"});
    ASSERT_EQ(run({"merge", "a.film", "c.film", "-o", "ac.film"}).exit_code, 0);
    ASSERT_EQ(run({"merge", "ac.film", "b.film", "-o", "image.png"}).exit_code, 0);
    ASSERT_EQ(run({"scene.lrs", "-ps", "16", "-o", "whole.png"}).exit_code, 0);
    EXPECT_TRUE(directory_.read("image.png") == directory_.read("whole.png"));
}

TEST_F(Merge, WhatIsMissingIsNamed) {
    render_part("4:8", "a.film", {"-ps", "16"});
    const auto result = run({"merge", "a.film", "-o", "image.png"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err,
              "lray: the samples 0:4 and 8:16 are missing\n"
              "  render them with `--samples A:B`, or merge into a film: `-o parts.film`\n");
    EXPECT_EQ(directory_.names(), (std::vector<std::string>{"a.film", "scene.lrs"}));
}

TEST_F(Merge, OverlapIsRefused) {
    render_part("0:8", "a.film");
    render_part("6:10", "b.film");
    const auto result = run({"merge", "a.film", "b.film", "-o", "image.png"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err, "lray: `a.film` and `b.film` both have the samples 6:8\n");
}

TEST_F(Merge, OtherPicturesAreRefused) {
    render_part("0:8", "a.film");
    render_part("8:10", "b.film", {"--size", "65x48"});
    const auto size = run({"merge", "a.film", "b.film", "-o", "image.png"});
    EXPECT_EQ(size.exit_code, 2);
    EXPECT_EQ(size.err,
              "lray: `a.film` and `b.film` are not of one picture: they differ in size: 64x48 and "
              "65x48\n");
    directory_.write("scene.lrs", std::string(kScene) + "sphere { radius: 2 }\n");
    render_part("8:10", "b.film");
    const auto scene = run({"merge", "a.film", "b.film", "-o", "image.png"});
    EXPECT_EQ(scene.exit_code, 2);
    EXPECT_TRUE(contains(scene.err, "they differ in what is in the scene")) << scene.err;
}

TEST_F(Merge, WhatIsNoFilmIsRefused) {
    directory_.write("a.film", "P6 1 1 255 abc");
    const auto wrong = run({"merge", "a.film", "-o", "image.png"});
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_EQ(wrong.err, "lray: `a.film`: this is not a film of this version of lray\n");
    EXPECT_EQ(run({"merge", "none.film", "-o", "image.png"}).err, "lray: `none.film`: not found\n");
    EXPECT_EQ(run({"merge", "a.film"}).exit_code, 2) << "where to?";
    EXPECT_EQ(run({"merge", "-o", "image.png"}).exit_code, 2) << "of what?";
}

TEST_F(Merge, AFilmIsNotOverwrittenByItsSum) {
    render_part("0:8", "a.film");
    const std::string before = directory_.read("a.film");
    EXPECT_EQ(run({"merge", "a.film", "-o", "a.film"}).exit_code, 2);
    EXPECT_TRUE(directory_.read("a.film") == before);
}

TEST_F(Merge, AFilmTakesNoLimitsOfTimeOrNoise) {
    const auto result = run({"scene.lrs", "-o", "a.film", "--noise", "0.1"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_TRUE(contains(result.err, "a film and `--noise` do not go together")) << result.err;
    EXPECT_EQ(run({"diff", "a.png", "b.png", "-o", "c.film"}).exit_code, 2);
}

}  // namespace
}  // namespace lray
