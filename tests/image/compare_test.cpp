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

}  // namespace
}  // namespace lray::image
