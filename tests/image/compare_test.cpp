#include "image/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/image/pictures.h"

namespace lray::image {
namespace {

TEST(Compare, EqualPicturesDoNotDiffer) {
    const Image image = test::random_image(8, 8, 1);
    const auto difference = compare(image, image, 0.0f);
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->max, 0.0f);
    EXPECT_EQ(difference->rms, 0.0);
    EXPECT_EQ(difference->share_beyond, 0.0);
}

TEST(Compare, OneChannelOfOnePixelByLevels) {
    Image a(2, 2);
    Image b(2, 2);
    a.at(1, 0).g = srgb_decode_8(100);
    b.at(1, 0).g = srgb_decode_8(106);
    const auto difference = compare(a, b, 5.5f);
    ASSERT_TRUE(difference);
    EXPECT_NEAR(difference->max, 6.0f, 1e-3f);
    EXPECT_NEAR(difference->rms, 6.0 / std::sqrt(12.0), 1e-3);
    EXPECT_EQ(difference->share_beyond, 0.25);
    EXPECT_EQ(compare(a, b, 6.5f)->share_beyond, 0.0);
}

TEST(Compare, NotANumberDiffersFromEverythingElse) {
    Image a(1, 1);
    Image b(1, 1);
    a.at(0, 0).b = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(compare(a, b, 1.0f)->max, 255.0f);
    EXPECT_EQ(compare(a, a, 1.0f)->max, 0.0f);
}

TEST(Compare, OtherSizeIsNoComparison) {
    EXPECT_FALSE(compare(Image(2, 3), Image(3, 2), 1.0f));
}

TEST(Compare, TellsWhereTheWorstPixelIsAndHowManyAreBeyond) {
    Image a(4, 3);
    Image b(4, 3);
    b.at(1, 1).r = srgb_decode_8(3);
    b.at(2, 2).b = srgb_decode_8(9);
    b.at(3, 2).b = srgb_decode_8(9);
    const auto difference = compare(a, b, 1.5f);
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->worst_x, 2u);
    EXPECT_EQ(difference->worst_y, 2u);
    EXPECT_EQ(difference->beyond_count, 3u);
    EXPECT_FALSE(difference->is_none);
    EXPECT_TRUE(compare(a, a, 1.5f)->is_none);
}

TEST(Compare, LightBeyondWhiteDiffersInBitsAlone) {
    Image a(1, 1);
    Image b(1, 1);
    a.at(0, 0) = Color{2.0f};
    b.at(0, 0) = Color{3.0f};
    const auto difference = compare(a, b, 0.0f);
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->max, 0.0f);
    EXPECT_FALSE(difference->is_none);
}

TEST(DifferencePicture, BlackBlueRedAndWhite) {
    Image a(5, 1);
    Image b(5, 1);
    b.at(1, 0).g = srgb_decode_8(1);
    b.at(2, 0).g = srgb_decode_8(2);
    b.at(3, 0).g = srgb_decode_8(20);
    b.at(4, 0).g = srgb_decode_8(200);
    const Image picture = difference_picture(a, b, 4.0f);
    EXPECT_EQ(picture.at(0, 0), Color{0.0f});
    EXPECT_EQ(picture.at(1, 0).r, 0.0f);
    EXPECT_GT(picture.at(1, 0).b, 0.03f);
    EXPECT_GT(picture.at(2, 0).b, picture.at(1, 0).b);
    EXPECT_EQ(picture.at(3, 0).r, 1.0f);
    EXPECT_NEAR(srgb_encode(picture.at(3, 0).g), 0.1f, 0.001f);
    EXPECT_EQ(picture.at(4, 0), Color{1.0f});
}

}  // namespace
}  // namespace lray::image
