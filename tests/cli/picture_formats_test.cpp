// The program itself: options of formats, and pictures in floats in a scene.
#include <gtest/gtest.h>

#include <string>

#include "image/write.h"
#include "tests/cli/lray_test.h"

namespace lray {
namespace {

using PictureFormats = LrayTest;
using namespace std::string_literals;

/// A PFM of one pixel.
std::string light_of(float r, float g, float b) {
    std::string file = "PF\n1 1\n-1.0\n";
    for (const float value : {r, g, b}) {
        file.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    return file;
}

TEST_F(PictureFormats, PngOf16BitsSaysSoAndQualityMakesJpegsSmaller) {
    directory_.write("scene.lrs", kScene);
    ASSERT_EQ(run({"scene.lrs", "-o", "a.png", "--png-bits", "16", "--quiet"}).exit_code, 0);
    EXPECT_EQ(directory_.read("a.png")[24], 16);
    ASSERT_EQ(run({"scene.lrs", "-o", "a.jpg", "--quiet"}).exit_code, 0);
    ASSERT_EQ(run({"scene.lrs", "-o", "b.jpg", "--jpeg-quality", "10", "--quiet"}).exit_code, 0);
    EXPECT_LT(directory_.read("b.jpg").size(), directory_.read("a.jpg").size());
    const auto ignored = run({"scene.lrs", "-o", "c.jpg", "--png-bits", "16"});
    EXPECT_EQ(ignored.exit_code, 0);
    EXPECT_TRUE(contains(ignored.err, "`--png-bits` is ignored: the picture is jpg, not png"))
        << ignored.err;
}

TEST_F(PictureFormats, LightOfAPictureArrivesAsItIsWhateverSrgbSays) {
    directory_.write("sky.pfm", light_of(40.0f, 0.5f, 0.125f));
    for (const std::string srgb : {"true", "false"}) {
        directory_.write("scene.lrs",
                         "render { resolution: [2, 2] }\ncamera { position: [0, 0, 5] }\n"
                         "plane { normal: [0, 0, 1], material { diffuse: 0, specular: 0, emission: "
                         "image { file: \"sky.pfm\", srgb: " +
                             srgb +
                             " } } }\n"
                             "point_light { position: [0, 0, 2], intensity: 0 }\n");
        const auto result = run({"scene.lrs", "-o", "a.pfm", "-A", "all", "--quiet"});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(picture("a.pfm").at(1, 1), (Color{40.0f, 0.5f, 0.125f}));
    }
}

TEST_F(PictureFormats, SkyInFloatsLightsBeyondWhite) {
    directory_.write("sky.pfm", light_of(8.0f, 4.0f, 2.0f));
    directory_.write("scene.lrs",
                     "render { resolution: [4, 4] }\ncamera { position: [0, 0, 5], look_at: [0, 0, "
                     "9] }\nenvironment { image: \"sky.pfm\" }\nsphere { }\n");
    const auto result = run({"scene.lrs", "-o", "a.pfm", "-A", "all", "--quiet"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(picture("a.pfm").at(2, 2), (Color{8.0f, 4.0f, 2.0f}));
}

TEST_F(PictureFormats, HeightsInFloatsMayBeNegativeButNotNan) {
    directory_.write("pits.pfm", "Pf\n2 2\n-1\n"s + std::string("\0\0\x80\xbf\0\0\x80\xbf"
                                                                "\0\0\x80\xbf\0\0\x80\xbf",
                                                                16));
    directory_.write("scene.lrs",
                     "camera { position: [0, 5, 5] }\n"
                     "heightfield { image: \"pits.pfm\" }\n");
    const auto result = run({"--check", "scene.lrs"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    directory_.write("pits.pfm", "Pf\n2 2\n-1\n"s + std::string(16, '\xff'));
    const auto wrong = run({"--check", "scene.lrs"});
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_TRUE(contains(wrong.err, "the height of pixel 0, 0 is not finite")) << wrong.err;
}

TEST_F(PictureFormats, ExrHoldsTheBitsOfPfmAndTheInfoOfTheScene) {
    if (!image::is_built(image::Format::exr)) GTEST_SKIP() << "built without OpenEXR";
    directory_.write("scene.lrs", "info { title: \"A ball\" }\n"s + kScene);
    ASSERT_EQ(run({"scene.lrs", "-ps", "3", "-o", "a.pfm", "--quiet"}).exit_code, 0);
    ASSERT_EQ(run({"scene.lrs", "-ps", "3", "-o", "a.exr", "--quiet"}).exit_code, 0);
    const auto result = run({"diff", "a.pfm", "a.exr"});
    EXPECT_TRUE(contains(result.out, "the same to the bit")) << result.out;
    EXPECT_TRUE(contains(directory_.read("a.exr"), "A ball"));
    const std::string first = directory_.read("a.exr");
    ASSERT_EQ(run({"scene.lrs", "-ps", "3", "-o", "a.exr", "--quiet"}).exit_code, 0);
    EXPECT_EQ(directory_.read("a.exr"), first);
}

}  // namespace
}  // namespace lray
