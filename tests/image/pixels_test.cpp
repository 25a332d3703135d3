#include "image/pixels.h"

#include <gtest/gtest.h>

#include <limits>

#include "image/srgb.h"

namespace lray::image {
namespace {

TEST(Pixels, MeanOfLightIsThatOfItsValuesWhateverIsSaid) {
    Image light(2, 1);
    light.at(0, 0) = {1000.0f, 0.5f, 0.0f};
    light.at(1, 0) = {0.0f, 0.25f, 3.0f};
    for (const bool is_srgb : {true, false}) {
        EXPECT_EQ(mean_color(Pixels(light), is_srgb), (Color{500.0f, 0.375f, 1.5f}));
    }
    const Pixels coded = CodedImage{1, 1, {51, 102, 204}};
    EXPECT_EQ(mean_color(coded, false), (Color{0.2f, 0.4f, 0.8f}));
    EXPECT_EQ(mean_color(coded, true).r, srgb_decode_8(51));
    EXPECT_EQ(width_of(Pixels(light)), 2u);
    EXPECT_EQ(height_of(Pixels(light)), 1u);
}

TEST(Pixels, WhatIsNoLightIsMendedAndPixelsCounted) {
    constexpr float kInf = std::numeric_limits<float>::infinity();
    Image light(5, 1);
    light.at(0, 0) = {-1.0f, std::numeric_limits<float>::quiet_NaN(), 2.0f};
    light.at(1, 0) = {kInf, -kInf, 1e10f};
    light.at(2, 0) = {0.0f, kMostPictureLight, 1e-40f};
    light.at(3, 0) = {-0.0f, 0.0f, 0.0f};
    EXPECT_EQ(mend_light(light), 2u);
    EXPECT_EQ(light.at(0, 0), (Color{0.0f, 0.0f, 2.0f}));
    EXPECT_EQ(light.at(1, 0), (Color{kMostPictureLight, 0.0f, kMostPictureLight}));
    EXPECT_EQ(light.at(2, 0), (Color{0.0f, kMostPictureLight, 1e-40f}));
    EXPECT_EQ(mend_light(light), 0u);
}

}  // namespace
}  // namespace lray::image
