// `lray diff`, run as a program.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "image/image.h"
#include "image/write.h"
#include "tests/cli/lray_test.h"

namespace lray {
namespace {

using namespace std::string_literals;

class Diff : public LrayTest {
 protected:
    /// 3 x 2 pixels, whose bytes are these but for the last.
    void write_ppm(const std::string& name, int last) {
        directory_.write(name,
                         "P6\n3 2\n255\n"s + std::string(17, '\x40') + static_cast<char>(last));
    }
};

TEST_F(Diff, SameFilesAreTheSameToTheBit) {
    write_ppm("a.ppm", 64);
    const auto result = run({"diff", "a.ppm", "a.ppm"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(result.out, "3 x 2 pixels  a.ppm\n3 x 2 pixels  a.ppm\nthe same to the bit\n");
}

TEST_F(Diff, ThresholdDecidesAndTheWorstPixelIsNamed) {
    write_ppm("a.ppm", 64);
    write_ppm("b.ppm", 67);
    const auto beyond = run({"diff", "a.ppm", "b.ppm"});
    EXPECT_EQ(beyond.exit_code, 1);
    EXPECT_EQ(beyond.out,
              "3 x 2 pixels  a.ppm\n3 x 2 pixels  b.ppm\n"
              "largest difference: 3.00 levels of 255, at pixel 2, 1\n"
              "root mean square: 0.7071 levels\n"
              "pixels beyond 1.5 levels: 1 (16.67 %)\ndifferent\n");
    const auto within = run({"diff", "a.ppm", "b.ppm", "--threshold", "3.5"});
    EXPECT_EQ(within.exit_code, 0);
    EXPECT_TRUE(contains(within.out,
                         "pixels beyond 3.5 levels: 0 (0 %)\n"
                         "the same within the threshold\n"))
        << within.out;
}

TEST_F(Diff, PictureOfItIsBlackBlueAndWhite) {
    write_ppm("a.ppm", 64);
    write_ppm("b.ppm", 67);
    ASSERT_EQ(run({"diff", "a.ppm", "b.ppm", "-o", "d.png"}).exit_code, 1);
    const image::Image far = picture("d.png");
    EXPECT_EQ(far.at(0, 0), Color{0.0f});
    EXPECT_EQ(far.at(2, 1), Color{1.0f});
    ASSERT_EQ(run({"diff", "a.ppm", "b.ppm", "-o", "d.png", "--threshold", "10"}).exit_code, 0);
    const image::Image near = picture("d.png");
    EXPECT_EQ(near.at(2, 1).r, 0.0f);
    EXPECT_GT(near.at(2, 1).b, 0.05f);
    // On stdout the words make way for it.
    const auto streamed = run({"diff", "a.ppm", "b.ppm", "-o", "-"});
    EXPECT_TRUE(streamed.out.starts_with("P6\n3 2\n255\n"));
    EXPECT_TRUE(contains(streamed.err, "different\n"));
}

TEST_F(Diff, SizesThatDifferAreSaidSo) {
    write_ppm("a.ppm", 64);
    directory_.write("b.pgm", "P2 1 1 255 3");
    const auto result = run({"diff", "a.ppm", "b.pgm", "-o", "d.png"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(result.out, "3 x 2 pixels  a.ppm\n1 x 1 pixels  b.pgm\ndifferent sizes\n");
}

TEST_F(Diff, WhatCannotBeReadExits2InWords) {
    write_ppm("a.ppm", 64);
    directory_.write("b.png", "text");
    const auto missing = run({"diff", "a.ppm", "c.png"});
    EXPECT_EQ(missing.exit_code, 2);
    EXPECT_TRUE(contains(missing.err, "`c.png`: not found")) << missing.err;
    const auto wrong = run({"diff", "b.png", "a.ppm"});
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_TRUE(contains(wrong.err, "`b.png`: this is not a PNG")) << wrong.err;
    const auto large = run({"diff", "a.ppm", "a.ppm", "--max-output-pixels", "5"});
    EXPECT_EQ(large.exit_code, 3);
    EXPECT_TRUE(contains(large.err, "--max-output-pixels")) << large.err;
    EXPECT_EQ(run({"diff", "a.ppm"}).exit_code, 2);
}

TEST_F(Diff, DoesNotOverwriteWhatItCompares) {
    write_ppm("a.ppm", 64);
    write_ppm("b.ppm", 67);
    const std::string before = directory_.read("b.ppm");
    const auto result = run({"diff", "a.ppm", "b.ppm", "-o", "b.ppm"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(directory_.read("b.ppm"), before);
}

TEST_F(Diff, RendersOfOneSceneInAllFormatsAreOnePicture) {
    directory_.write("scene.lrs", kScene);
    std::vector<std::string> formats = {"ppm", "png", "pfm"};
    if (image::is_built(image::Format::exr)) formats.push_back("exr");
    for (const std::string& format : formats) {
        ASSERT_EQ(run({"scene.lrs", "-ps", "2", "-o", "a." + format, "--quiet"}).exit_code, 0);
        const auto result = run({"diff", "a.ppm", "a." + format, "--threshold", "0.51"});
        EXPECT_EQ(result.exit_code, 0) << format << result.out;
    }
    ASSERT_EQ(
        run({"scene.lrs", "-ps", "2", "-o", "deep.png", "--png-bits", "16", "--quiet"}).exit_code,
        0);
    EXPECT_EQ(run({"diff", "a.pfm", "deep.png", "--threshold", "0.003"}).exit_code, 0);
}

}  // namespace
}  // namespace lray
