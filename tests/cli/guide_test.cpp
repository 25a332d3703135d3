// docs/guide.md is true: each of its scenes is short, warns of nothing, and gives the picture that
// stands above it. LRAY_BLESS=guide makes the pictures anew: `./dev bless guide`.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <span>

#include "image/read.h"
#include "tests/support/process.h"
#include "tests/support/temp_directory.h"

namespace lray {
namespace {

const std::string kDocs = LRAY_SOURCE_DIR "/docs/";

struct Lesson {
    std::string title{};    // "1. A ball"
    std::string picture{};  // from docs/: "images/guide_ball.png"
    std::string scene{};
};

/// The parts of the guide that have a picture and a scene.
std::vector<Lesson> lessons() {
    const std::string guide = test::read_bytes(kDocs + "guide.md");
    const std::regex lesson(
        "\n## (\\d+\\. [^\n]+)\n\n!\\[[^\\]]+\\]\\(([a-z_/]+\\.png)\\)\n\n```lrs\n([^`]*)```\n");
    std::vector<Lesson> found;
    for (auto at = std::sregex_iterator(guide.begin(), guide.end(), lesson);
         at != std::sregex_iterator(); ++at) {
        found.push_back({(*at)[1], (*at)[2], (*at)[3]});
    }
    return found;
}

TEST(Guide, HasTenLessonsOfFifteenLinesAtMost) {
    const std::vector<Lesson> all = lessons();
    ASSERT_EQ(all.size(), 10u);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_TRUE(all[i].title.starts_with(std::to_string(i + 1) + ". ")) << all[i].title;
        EXPECT_LE(std::ranges::count(all[i].scene, '\n'), 15) << all[i].title;
    }
}

class GuidePicture : public testing::TestWithParam<std::size_t> {};

// Pixels, not bytes: a PNG may be packed differently by another zlib.
TEST_P(GuidePicture, IsThatOfItsScene) {
    const std::vector<Lesson> all = lessons();
    ASSERT_LT(GetParam(), all.size());
    const Lesson& lesson = all[GetParam()];
    const auto result = test::run_process({LRAY_BINARY, "-ps", "16", "-i", "-", "-o", "-",
                                           "--format", "png", "--size", "240x180", "--quiet"},
                                          lesson.scene);
    EXPECT_EQ(result.exit_code, 0) << lesson.title;
    EXPECT_EQ(result.err, "") << lesson.title;
    const char* const bless = std::getenv("LRAY_BLESS");
    if (bless != nullptr && std::string_view(bless) == "guide") {
        std::ofstream(kDocs + lesson.picture, std::ios::binary) << result.out;
        return;
    }
    std::string error;
    const std::string shown = test::read_bytes(kDocs + lesson.picture);
    const auto expected = image::read_image(std::as_bytes(std::span(shown)), {}, error);
    const auto actual = image::read_image(std::as_bytes(std::span(result.out)), {}, error);
    ASSERT_TRUE(expected && actual) << lesson.picture << ": " << error;
    ASSERT_EQ(actual->width, expected->width) << lesson.picture;
    ASSERT_EQ(actual->height, expected->height) << lesson.picture;
    std::size_t different = 0;
    for (std::uint32_t y = 0; y < actual->height; ++y) {
        for (std::uint32_t x = 0; x < actual->width; ++x) {
            if (!(actual->at(x, y) == expected->at(x, y))) ++different;
        }
    }
    EXPECT_EQ(different, 0u) << lesson.picture
                             << " is another picture; if the scene is right: ./dev bless guide";
}

INSTANTIATE_TEST_SUITE_P(Guide, GuidePicture, testing::Range(std::size_t{0}, std::size_t{10}));

}  // namespace
}  // namespace lray
