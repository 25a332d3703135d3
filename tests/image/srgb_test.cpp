#include "image/srgb.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace lray::image {
namespace {

// The standard's formulas, straight.
double encode_by_formula(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}
double decode_by_formula(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

TEST(SrgbDecode, All8BitCodesMatchTheFormula) {
    for (int code = 0; code < 256; ++code) {
        const double encoded = code / 255.0;
        const double expected = decode_by_formula(encoded);
        EXPECT_NEAR(srgb_decode(encoded), expected, 4e-16 + 4e-15 * expected) << code;
        EXPECT_EQ(srgb_decode_8(static_cast<std::uint8_t>(code)),
                  static_cast<float>(srgb_decode(encoded)));
    }
}

TEST(SrgbEncode, All8BitCodesComeBack) {
    for (int code = 0; code < 256; ++code) {
        EXPECT_EQ(srgb_encode_8(srgb_decode_8(static_cast<std::uint8_t>(code))), code);
    }
}

TEST(SrgbEncode, FineStepsMatchTheFormulaToFloatPrecision) {
    for (int step = 0; step <= 100'000; ++step) {
        const float linear = static_cast<float>(step) / 100'000.0f;
        const double expected = encode_by_formula(static_cast<double>(linear));
        ASSERT_NEAR(static_cast<double>(srgb_encode(linear)), expected, 3e-7) << linear;
    }
}

TEST(SrgbEncode, CodeBordersRoundToNearest) {
    for (int code = 0; code < 255; ++code) {
        const double border = decode_by_formula((code + 0.5) / 255.0);
        EXPECT_EQ(srgb_encode_8(static_cast<float>(border * (1.0 - 1e-5))), code);
        EXPECT_EQ(srgb_encode_8(static_cast<float>(border * (1.0 + 1e-5))), code + 1);
    }
}

TEST(SrgbEncode, CodesOfFloatsAreThoseOfTheFormula) {
    for (std::uint32_t bits = 0x30000000u; bits < 0x3f810000u; bits += 0x4d1) {
        const float x = std::bit_cast<float>(bits);
        ASSERT_EQ(srgb_encode_8(x), static_cast<int>(srgb_encode(x) * 255.0f + 0.5f)) << x;
    }
}

TEST(SrgbEncode, OutsideOfTheRangeIsClamped) {
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(srgb_encode(-1.0f), 0.0f);
    EXPECT_EQ(srgb_encode(1.0f), 1.0f);
    EXPECT_EQ(srgb_encode(infinity), 1.0f);
    EXPECT_EQ(srgb_encode(-infinity), 0.0f);
    EXPECT_EQ(srgb_encode(std::numeric_limits<float>::quiet_NaN()), 0.0f);
    EXPECT_EQ(srgb_encode_8(infinity), 255);
    EXPECT_EQ(srgb_decode(2.0), 1.0);
    EXPECT_EQ(srgb_decode(-1.0), 0.0);
    EXPECT_EQ(srgb_decode(std::numeric_limits<double>::quiet_NaN()), 0.0);
}

TEST(SrgbRow, RunsAndChangesEncodeLikeSinglePixels) {
    const std::vector<Color> pixels{{0.0f, 0.0f, 0.0f},
                                    {1.0f, 0.5f, 0.0f},
                                    {1.0f, 0.5f, 0.0f},
                                    {0.2f, 0.5f, 0.0f},
                                    {1.0f, 0.5f, 0.0f}};
    std::vector<std::uint8_t> bytes(15);
    encode_row(pixels, Gamma::srgb, bytes);
    for (std::size_t i = 0; i < 15; ++i) {
        EXPECT_EQ(bytes[i], srgb_encode_8(pixels[i / 3][static_cast<int>(i % 3)])) << i;
    }
    std::vector<Color> decoded(5);
    srgb_decode_row(bytes, decoded);
    EXPECT_EQ(decoded[3].g, srgb_decode_8(188));
}

TEST(SrgbRow, LinearCodesAreSharesOfWhite) {
    const std::vector<Color> pixels{{0.0f, 0.5f, 1.0f}, {-1.0f, 0.2f, 7.0f}};
    std::vector<std::uint8_t> bytes(6);
    encode_row(pixels, Gamma::linear, bytes);
    EXPECT_EQ(bytes, (std::vector<std::uint8_t>{0, 128, 255, 0, 51, 255}));
    EXPECT_EQ(linear_encode_8(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(SrgbSlope, IsTheDerivativeOfTheFormula) {
    for (int step = 1; step < 1000; ++step) {
        const double linear = step / 1000.0;
        const double h = 1e-6;
        const double expected =
            (encode_by_formula(linear + h) - encode_by_formula(linear - h)) / (2 * h);
        EXPECT_NEAR(static_cast<double>(srgb_slope(static_cast<float>(linear))), expected,
                    2e-6 * expected)
            << linear;
    }
    EXPECT_EQ(srgb_slope(-1.0f), 12.92f);
    EXPECT_EQ(srgb_slope(0.001f), 12.92f);
    EXPECT_EQ(srgb_slope(5.0f), srgb_slope(1.0f));
}

/// Source: IEC 61966-2-1, in long double.
long double encoded_by_formula(long double linear) {
    return linear <= 0.0031308L ? 12.92L * linear : 1.055L * std::pow(linear, 1.0L / 2.4L) - 0.055L;
}

TEST(Srgb, SixteenBitsAreTheNearestToTheEncodedValue) {
    for (std::uint32_t bits = 0; bits < 0x3f800000u; bits += 9973) {
        const float linear = std::bit_cast<float>(bits);
        const long double exact = encoded_by_formula(static_cast<long double>(linear)) * 65535.0L;
        const long double off = exact - static_cast<long double>(srgb_encode_16(linear));
        ASSERT_LE(std::fabs(off), 0.5L + 1e-9L) << linear;
    }
    EXPECT_EQ(srgb_encode_16(1.0f), 65535);
    EXPECT_EQ(srgb_encode_16(1e30f), 65535);
    EXPECT_EQ(srgb_encode_16(-1.0f), 0);
    EXPECT_EQ(srgb_encode_16(std::numeric_limits<float>::quiet_NaN()), 0);
    EXPECT_EQ(linear_encode_16(0.5f), 32768);
    EXPECT_EQ(linear_encode_16(2.0f), 65535);
    EXPECT_EQ(linear_encode_16(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(Srgb, SixteenBitsReadBack) {
    for (std::uint32_t code = 0; code < 65536; ++code) {
        ASSERT_EQ(srgb_encode_16(srgb_decode_16(static_cast<std::uint16_t>(code))), code);
    }
}

}  // namespace
}  // namespace lray::image
