// The program itself: when samples end, and how light comes to the file.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "image/srgb.h"
#include "image/tone_map.h"
#include "tests/cli/lray_test.h"
#include "tests/support/json.h"

namespace lray {
namespace {

constexpr const char* kBall =
    "camera { position: [0, 0, 5] }\nrender { resolution: [64, 48], background: 0.25 }\n"
    "point_light { position: [2, 5, 5] }\nsphere { material { diffuse: 0.8 } }\n";

/// Nothing but background: its light is known whatever shows it.
std::string background(const std::string& settings) {
    return "camera { position: [0, 0, 5], look_at: [0, 0, 9] }\nrender { resolution: [8, 8], " +
           settings + " }\npoint_light { position: [2, 5, 5] }\nsphere { }\n";
}

class Display : public LrayTest {
 protected:
    /// Renders the scene into a.ppm; returns what --stats=json tells.
    test::Json rendered(std::vector<std::string> options) {
        std::vector<std::string> arguments{"scene.lrs", "-o", "a.ppm", "--stats=json", "--quiet"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const auto result = run(arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return test::read_json(result.err);
    }

    /// The code of the first pixel of a background, by `full`, and by flat painting.
    int code(const std::string& settings, const std::string& shading) {
        directory_.write("scene.lrs", background(settings));
        const auto result =
            run({"scene.lrs", "-o", "a.ppm", "--quiet", "--shading", shading, "-A", "all"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        const std::string bytes = directory_.read("a.ppm");
        return static_cast<unsigned char>(bytes[bytes.size() - 1]);
    }
};

int srgb_code(double linear) {
    return image::srgb_encode_8(static_cast<float>(linear));
}

TEST_F(Display, ExposureToneMapAndGammaAreThoseOfTheScene) {
    EXPECT_EQ(code("background: 0.25", "full"), srgb_code(0.25));
    EXPECT_EQ(code("background: 0.25, exposure: 1", "full"), srgb_code(0.5));
    EXPECT_EQ(code("background: 0.25, exposure: -1.5", "full"), srgb_code(0.25 * std::exp2(-1.5)));
    EXPECT_EQ(code("background: 3, tonemap: \"reinhard\"", "full"), srgb_code(0.75));
    EXPECT_EQ(code("background: 0.5, exposure: 1, tonemap: \"aces\"", "full"),
              srgb_code(2.54 / 3.16));
    EXPECT_EQ(code("background: 0.2, gamma: \"linear\"", "full"), 51);
}

TEST_F(Display, WhatIsNotLightHasNoExposure) {
    EXPECT_EQ(code("background: 0.25, exposure: 1, tonemap: \"aces\"", "flat"), srgb_code(0.25));
    EXPECT_EQ(code("background: 0.2, exposure: 1, gamma: \"linear\"", "flat"), 51);
}

TEST_F(Display, LinearPngSaysSo) {
    directory_.write("scene.lrs", background("background: 0.2, gamma: \"linear\""));
    ASSERT_EQ(run({"-n", "1", "scene.lrs", "-o", "a.png", "--quiet"}).exit_code, 0);
    EXPECT_EQ(directory_.read("a.png").find("sRGB"), std::string::npos);
    EXPECT_NE(directory_.read("a.png").find("gAMA"), std::string::npos);
}

TEST_F(Display, SamplersGiveDifferentPicturesOfTheSameThing) {
    directory_.write("scene.lrs", kBall);
    rendered({"-ps", "16"});
    const std::string usual = directory_.read("a.ppm");
    rendered({"-ps", "16", "--sampler", "sobol"});
    EXPECT_TRUE(directory_.read("a.ppm") == usual);
    rendered({"-ps", "16", "--sampler", "random"});
    EXPECT_FALSE(directory_.read("a.ppm") == usual);
    std::string scene = kBall;
    scene.replace(scene.find("render { "), 9, "render { sampler: \"random\", ");
    directory_.write("scene.lrs", scene);
    const std::string random = directory_.read("a.ppm");
    rendered({"-ps", "16"});
    EXPECT_TRUE(directory_.read("a.ppm") == random);
}

TEST_F(Display, ALensBlursWhatIsOutOfFocus) {
    const auto shades = [&](const std::string& camera) {
        directory_.write("scene.lrs", "camera { position: [0, 0, 5], " + camera +
                                          " }\nrender { resolution: [64, 48], samples: 64 }\n"
                                          "point_light { position: [2, 5, 5] }\n"
                                          "rectangle { size: [1, 1], normal: [0, 0, 1] }\n");
        rendered({"--shading", "flat"});
        const image::Image image = picture("a.ppm");
        return std::count_if(image.pixels.begin(), image.pixels.end(),
                             [](const Color& pixel) { return pixel.r > 0.0f && pixel.r < 0.79f; });
    };
    const auto sharp = shades("aperture: 0");
    EXPECT_NEAR(static_cast<double>(shades("aperture: 0.5")), static_cast<double>(sharp), 8.0);
    EXPECT_NEAR(static_cast<double>(shades("aperture: 0.5, focus: 5")), static_cast<double>(sharp),
                8.0);
    EXPECT_GT(shades("aperture: 0.5, focus: 3"), 2 * sharp);
    EXPECT_GT(shades("aperture: 0.5, focus: [0, 0, -4]"), 2 * sharp);
}

TEST_F(Display, NoiseSpendsSamplesWhereTheyAreNeededAndACropIsTheSame) {
    directory_.write("scene.lrs", kBall);
    const test::Json stats = rendered({"--noise", "0.02"});
    const double mean = stats["picture"]["samples_per_pixel"].number;
    EXPECT_GT(mean, 32.0);
    EXPECT_LT(mean, 512.0);
    EXPECT_EQ(stats["picture"]["samples_taken"].number, mean * 64 * 48);
    const image::Image whole = picture("a.ppm");
    rendered({"--noise", "0.02", "--crop", "11,5,40,31", "--threads", "2"});
    const image::Image crop = picture("a.ppm");
    for (std::uint32_t y = 0; y < crop.height; ++y) {
        for (std::uint32_t x = 0; x < crop.width; ++x) {
            ASSERT_EQ(crop.at(x, y), whole.at(x + 11, y + 5)) << x << ", " << y;
        }
    }
    EXPECT_EQ(rendered({"--noise", "0.02", "-ps", "8"})["picture"]["samples_taken"].number,
              8.0 * 64 * 48);
}

TEST_F(Display, TimeEndsOnWholePasses) {
    directory_.write("scene.lrs", kBall);
    const test::Json stats = rendered({"--time", "300ms"});
    const double passes = stats["picture"]["samples_per_pixel"].number;
    EXPECT_EQ(passes, std::floor(passes));
    EXPECT_GT(passes, 1.0);
    const std::string timed = directory_.read("a.ppm");
    rendered({"-ps", std::to_string(static_cast<int>(passes))});
    EXPECT_TRUE(directory_.read("a.ppm") == timed) << "as many samples by hand";
    EXPECT_EQ(rendered({"--time", "1h", "-ps", "4"})["picture"]["samples_taken"].number,
              4.0 * 64 * 48)
        << "the first limit reached ends it";
}

TEST_F(Display, ASceneWithoutLightIsPaintedFlatAndSaysSo) {
    directory_.write("scene.lrs", "camera { position: [0, 0, 5] }\nsphere { }\n");
    const auto warns = [&](std::vector<std::string> options) {
        std::vector<std::string> arguments{"scene.lrs", "--size", "8x6", "--quiet"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const auto result = run(arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return result.err.find("warning[W1502]") != std::string::npos;
    };
    EXPECT_TRUE(warns({"-o", "a.ppm"}));
    EXPECT_TRUE(warns({"-n", "2", "-o", "a.ppm"}));
    EXPECT_TRUE(warns({"--check"}));
    EXPECT_FALSE(warns({"-n", "1", "-o", "a.ppm"}));
    EXPECT_FALSE(warns({"--shading", "flat", "-o", "a.ppm"}));
    EXPECT_FALSE(warns({"--shading", "full", "-o", "a.ppm"}));
    EXPECT_FALSE(warns({"-A", "W1502", "-o", "a.ppm"}));
}

}  // namespace
}  // namespace lray
