#include "shade/textures/image_lookup.h"

#include <gtest/gtest.h>

#include <cmath>

#include "image/srgb.h"
#include "tests/shade/textures/worlds.h"

namespace lray::shade {
namespace {

using scene::ImageFilter;
using scene::ImageWrap;

/// A picture with its chain and lookup.
struct Lookup {
    image::CodedImage picture;
    MipChain chain;
    ImageLookup lookup;

    Lookup(image::CodedImage pixels, ImageWrap wrap, ImageFilter filter, bool is_srgb = true)
        : picture(std::move(pixels)),
          chain(picture, is_srgb),
          lookup({scene::PictureId{}, wrap, filter, is_srgb}, chain) {}
    Lookup(const Lookup&) = delete;
    Lookup& operator=(const Lookup&) = delete;

    Color at(double x, double y, double extent = 0.0) const {
        return test::color_of(lookup, {x, y, 0.0}, {{extent, extent, 0.0}, 0.0});
    }
};

/// 2 x 2: red and green above, blue and white below.
image::CodedImage four_colors() {
    return {2, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}};
}
const Color kRed{1.0f, 0.0f, 0.0f};
const Color kGreen{0.0f, 1.0f, 0.0f};
const Color kBlue{0.0f, 0.0f, 1.0f};
const Color kWhite{1.0f};

TEST(ImageLookup, BottomLeftIsTheOriginUnderBothFilters) {
    for (const ImageFilter filter : {ImageFilter::nearest, ImageFilter::bilinear}) {
        const Lookup lookup(four_colors(), ImageWrap::repeat, filter);
        EXPECT_EQ(lookup.at(0.25, 0.25), kBlue);
        EXPECT_EQ(lookup.at(0.75, 0.25), kWhite);
        EXPECT_EQ(lookup.at(0.25, 0.75), kRed);
        EXPECT_EQ(lookup.at(0.75, 0.75), kGreen);
    }
}

TEST(ImageLookup, RepeatComesAgainAlsoBelowZero) {
    const Lookup lookup(four_colors(), ImageWrap::repeat, ImageFilter::nearest);
    for (const double i : {-2.0, -1.0, 1.0, 5.0}) {
        EXPECT_EQ(lookup.at(0.25 + i, 0.25 - i), kBlue) << i;
        EXPECT_EQ(lookup.at(0.75 - i, 0.75 + i), kGreen) << i;
    }
}

TEST(ImageLookup, MirrorTurnsAroundAtEachBorder) {
    const Lookup lookup(four_colors(), ImageWrap::mirror, ImageFilter::nearest);
    EXPECT_EQ(lookup.at(-0.25, 0.25), kBlue);
    EXPECT_EQ(lookup.at(1.25, 0.25), kWhite);
    EXPECT_EQ(lookup.at(1.75, 0.25), kBlue);
    EXPECT_EQ(lookup.at(2.25, 0.25), kBlue);
    EXPECT_EQ(lookup.at(0.25, -0.75), kRed);
}

TEST(ImageLookup, ClampStaysAsAtTheBorder) {
    const Lookup lookup(four_colors(), ImageWrap::clamp, ImageFilter::bilinear);
    EXPECT_EQ(lookup.at(-7.0, -1e300), kBlue);
    EXPECT_EQ(lookup.at(1.0, 0.0), kWhite);
    EXPECT_EQ(lookup.at(99.0, 99.0), kGreen);
}

TEST(ImageLookup, RepeatHasNoSeam) {
    const Lookup lookup(test::random_codes(5, 3, 11), ImageWrap::repeat, ImageFilter::bilinear);
    constexpr double kStep = 1e-9;
    for (const double y : {-0.4, 0.1, 0.5, 2.9}) {
        for (const double border : {-1.0, 0.0, 1.0}) {
            const Color before = lookup.at(border - kStep, y);
            const Color behind = lookup.at(border + kStep, y);
            for (int i = 0; i < 3; ++i) EXPECT_NEAR(before[i], behind[i], 1e-6f);
        }
        // On the border the outer pixels of both sides have equal parts.
        const Color left = lookup.at(0.1, y);
        const Color right = lookup.at(0.9, y);
        const Color middle = lookup.at(0.0, y);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(middle[i], 0.5f * (left[i] + right[i]), 1e-5f);
    }
}

TEST(ImageLookup, BilinearBlendsLinearLightNotCodes) {
    const Lookup lookup({2, 1, {0, 0, 0, 255, 255, 255}}, ImageWrap::clamp, ImageFilter::bilinear);
    EXPECT_EQ(lookup.at(0.5, 0.5), Color(0.5f));
    EXPECT_EQ(lookup.at(0.375, 0.5), Color(0.25f));
}

TEST(ImageLookup, CodesOfDataAreSharesOf255) {
    const image::CodedImage gray{1, 1, {51, 102, 204}};
    const Lookup data(gray, ImageWrap::repeat, ImageFilter::bilinear, false);
    EXPECT_EQ(data.at(0.5, 0.5), Color(0.2f, 0.4f, 0.8f));
    const Lookup colors(gray, ImageWrap::repeat, ImageFilter::bilinear);
    EXPECT_EQ(colors.at(0.5, 0.5), Color(image::srgb_decode_8(51), image::srgb_decode_8(102),
                                         image::srgb_decode_8(204)));
}

TEST(ImageLookup, ConstantPictureIsTheSameColourFromAnyDistance) {
    for (const auto& [width, height] : {std::pair{37u, 23u}, {1u, 64u}, {1u, 1u}, {100u, 1u}}) {
        for (const bool is_srgb : {true, false}) {
            image::CodedImage picture{width, height, {}};
            for (std::uint32_t i = 0; i < width * height; ++i) {
                picture.rgb.insert(picture.rgb.end(), {3, 130, 251});
            }
            const CodeValues& values = code_values(is_srgb);
            const Color color{values.linear[3], values.linear[130], values.linear[251]};
            const Lookup lookup(picture, ImageWrap::mirror, ImageFilter::bilinear, is_srgb);
            for (double extent = 1e-4; extent < 10.0; extent *= 1.3) {
                ASSERT_EQ(lookup.at(0.123, 0.789, extent), color) << extent;
            }
        }
    }
}

TEST(ImageLookup, MinifiedCheckerboardIsGrey) {
    image::CodedImage board{64, 64, {}};
    for (std::uint32_t i = 0; i < 64 * 64; ++i) {
        const std::uint8_t code = ((i + i / 64) & 1) == 0 ? 255 : 0;
        board.rgb.insert(board.rgb.end(), {code, code, code});
    }
    const Lookup lookup(board, ImageWrap::repeat, ImageFilter::nearest);
    EXPECT_EQ(lookup.at(0.5 / 64, 0.5 / 64).r, 0.0f);
    test::Random random(12);
    for (int trial = 0; trial < 100; ++trial) {
        const Color color = lookup.at(random.uniform(), random.uniform(), 2.0 / 64 + 0.01 * trial);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(color[i], 0.5f, 0.003f);
    }
}

TEST(ImageLookup, LevelsBlendWithoutAStep) {
    const Lookup lookup(test::random_codes(64, 32, 13), ImageWrap::repeat, ImageFilter::bilinear);
    for (int level = 0; level < 7; ++level) {
        const double extent = std::ldexp(1.0, level) / 64.0;
        const Color below = lookup.at(0.3, 0.7, extent * (1.0 - 1e-9));
        const Color above = lookup.at(0.3, 0.7, extent * (1.0 + 1e-9));
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(below[i], above[i], 1e-6f) << level;
    }
}

TEST(ImageLookup, FarthestIsTheMeanOfThePicture) {
    const image::CodedImage picture = test::random_codes(33, 65, 14);
    for (const bool is_srgb : {true, false}) {
        const Lookup lookup(picture, ImageWrap::repeat, ImageFilter::bilinear, is_srgb);
        const Color mean = image::mean_color(picture, is_srgb);
        for (const double extent : {1.0, 7.0, 1e300, 1e-300 / 0.0}) {
            const Color color = lookup.at(0.3, 0.7, extent);
            for (int i = 0; i < 3; ++i) EXPECT_NEAR(color[i], mean[i], 0.004f) << extent;
        }
    }
}

TEST(LightLookup, LightBeyondWhiteStaysBetweenPixelsAndFromAfar) {
    image::Image picture(2, 1);
    picture.at(0, 0) = {1000.0f, 0.001f, 0.0f};
    picture.at(1, 0) = {3000.0f, 0.003f, 1.0f};
    const LightMipChain chain(picture, true);
    ASSERT_EQ(chain.level_count(), 2u);
    EXPECT_EQ(chain.level(1).at(0, 0), (Color{2000.0f, 0.002f, 0.5f}));
    for (const bool is_srgb : {true, false}) {
        const LightLookup lookup(
            {scene::PictureId{}, ImageWrap::clamp, ImageFilter::bilinear, is_srgb}, chain);
        const auto at = [&](double x, double extent) {
            return test::color_of(lookup, {x, 0.5, 0.0}, {{extent, extent, 0.0}, 0.0});
        };
        EXPECT_EQ(at(0.25, 0.0), picture.at(0, 0));
        EXPECT_EQ(at(0.5, 0.0).r, 2000.0f);
        EXPECT_EQ(at(0.1, 9.0), chain.level(1).at(0, 0));
    }
    const LightLookup blocky({scene::PictureId{}, ImageWrap::repeat, ImageFilter::nearest, true},
                             chain);
    EXPECT_EQ(test::color_of(blocky, {1.6, 0.5, 0.0}, {}), picture.at(1, 0));
}

TEST(LightLookup, CodesAndTheirLightGiveTheSameColours) {
    const image::CodedImage codes = test::random_codes(13, 9, 21);
    const image::Image light = image::decode_srgb(codes);
    const MipChain coded_chain(codes, true);
    const LightMipChain light_chain(light, true);
    for (const ImageFilter filter : {ImageFilter::nearest, ImageFilter::bilinear}) {
        const scene::ImageTexture image{scene::PictureId{}, ImageWrap::mirror, filter, true};
        const ImageLookup coded(image, coded_chain);
        const LightLookup lit(image, light_chain);
        test::Random random(22);
        for (int trial = 0; trial < 500; ++trial) {
            const DVec3 p{random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0), 0.0};
            EXPECT_EQ(test::color_of(coded, p, {}), test::color_of(lit, p, {}));
        }
    }
}

TEST(MipChain, EachLevelIsHalfOfTheOneBeforeDownToOnePixel) {
    const image::CodedImage picture = test::random_codes(13, 3, 15);
    const MipChain chain(picture, true);
    ASSERT_EQ(chain.level_count(), 4u);
    const std::vector<std::pair<std::uint32_t, std::uint32_t>> sizes{
        {13, 3}, {6, 1}, {3, 1}, {1, 1}};
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        EXPECT_EQ(chain.level(i).width, sizes[i].first);
        EXPECT_EQ(chain.level(i).height, sizes[i].second);
        EXPECT_EQ(chain.level(i).rgb.size(), std::size_t{3} * sizes[i].first * sizes[i].second);
    }
}

TEST(MipChain, EveryLevelHasTheMeanOfThePicture) {
    for (const auto& [width, height] : {std::pair{64u, 64u}, {61u, 47u}, {1u, 100u}, {3u, 1u}}) {
        const image::CodedImage picture = test::random_codes(width, height, 16);
        for (const bool is_srgb : {true, false}) {
            const MipChain chain(picture, is_srgb);
            const Color mean = image::mean_color(picture, is_srgb);
            for (std::size_t level = 1; level < chain.level_count(); ++level) {
                const Color of_level = image::mean_color(chain.level(level), is_srgb);
                // Half a code, of which sRGB has the widest at the bright end.
                const float half_code = is_srgb ? 0.0045f : 0.002f;
                for (int i = 0; i < 3; ++i) EXPECT_NEAR(of_level[i], mean[i], half_code) << level;
            }
        }
    }
}

TEST(CodeValues, NearestCodeOfEachCodeIsItself) {
    for (const bool is_srgb : {true, false}) {
        const CodeValues& values = code_values(is_srgb);
        for (std::size_t code = 0; code < 256; ++code) {
            EXPECT_EQ(values.nearest_code(values.linear[code]), code);
            if (code == 0) continue;
            const float border = values.borders[code - 1];
            EXPECT_EQ(values.nearest_code(border), code);
            EXPECT_EQ(values.nearest_code(std::nextafter(border, 0.0f)), code - 1);
        }
        EXPECT_EQ(values.nearest_code(-1.0f), 0);
        EXPECT_EQ(values.nearest_code(9.0f), 255);
        EXPECT_EQ(values.nearest_code(std::nanf("")), 0);
    }
}

}  // namespace
}  // namespace lray::shade
