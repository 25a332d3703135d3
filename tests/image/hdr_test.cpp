#include "image/hdr.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "tests/image/pictures.h"

namespace lray::image {
namespace {

using namespace std::string_literals;
using test::bytes_of;

std::string read_error(std::string_view file, ReadLimits limits = {}) {
    std::string error;
    EXPECT_FALSE(read_hdr(bytes_of(file), limits, error));
    return error;
}

Image read_right(std::string_view file) {
    std::string error;
    const auto image = read_hdr(bytes_of(file), {}, error);
    EXPECT_TRUE(image) << error;
    return image.value_or(Image(1, 1));
}

std::string header(std::string_view size, std::string_view more = {}) {
    return "#?RADIANCE\n"s + std::string(more) + "FORMAT=32-bit_rle_rgbe\n\n" + std::string(size) +
           "\n";
}

/// Ward's way of packing a colour.
std::string packed(const Color& color) {
    const float most = std::max({color.r, color.g, color.b});
    if (most < 1e-32f) return "\0\0\0\0"s;
    int exponent = 0;
    const float scale = std::frexp(most, &exponent) * 256.0f / most;
    std::string bytes;
    for (int i = 0; i < 3; ++i) bytes += static_cast<char>(static_cast<int>(color[i] * scale));
    return bytes + static_cast<char>(exponent + 128);
}

Image random_light(std::uint32_t width, std::uint32_t height, std::uint64_t seed) {
    test::Random random(seed);
    Image image(width, height);
    for (Color& pixel : image.pixels) {
        const double strength = std::exp2(random.uniform(-20.0, 20.0));
        pixel = {static_cast<float>(strength * random.uniform()),
                 static_cast<float>(strength * random.uniform()), static_cast<float>(strength)};
    }
    return image;
}

std::string flat(const Image& image) {
    std::string bytes =
        header("-Y " + std::to_string(image.height) + " +X " + std::to_string(image.width));
    for (const Color& pixel : image.pixels) bytes += packed(pixel);
    return bytes;
}

/// Each channel of a line as runs of what is equal and stretches of what is not.
std::string in_new_way(const Image& image) {
    std::string bytes =
        header("-Y " + std::to_string(image.height) + " +X " + std::to_string(image.width));
    for (std::size_t y = 0; y < image.height; ++y) {
        bytes +=
            "\2\2"s + static_cast<char>(image.width / 256) + static_cast<char>(image.width % 256);
        for (std::size_t channel = 0; channel < 4; ++channel) {
            std::string line;
            for (std::size_t x = 0; x < image.width; ++x) {
                line += packed(image.pixels[y * image.width + x])[channel];
            }
            for (std::size_t x = 0; x < line.size();) {
                std::size_t end = x + 1;
                while (end < line.size() && end - x < 127 && line[end] == line[x]) ++end;
                if (end - x > 2) {
                    bytes += static_cast<char>(128 + (end - x));
                    bytes += line[x];
                } else {
                    end = std::min(x + 100, line.size());
                    bytes += static_cast<char>(end - x);
                    bytes += line.substr(x, end - x);
                }
                x = end;
            }
        }
    }
    return bytes;
}

void expect_within_mantissa(const Image& read, const Image& image) {
    ASSERT_EQ(read.pixels.size(), image.pixels.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Color& pixel = image.pixels[i];
        // The mantissa of the greatest has its highest bit set: a unit is 1/128 of it at most.
        const float unit = std::max({pixel.r, pixel.g, pixel.b}) / 128.0f;
        for (int c = 0; c < 3; ++c) {
            EXPECT_LE(read.pixels[i][c], pixel[c]) << i;
            EXPECT_GE(read.pixels[i][c], pixel[c] - unit) << i;
        }
    }
}

TEST(HdrRead, FlatAndPackedPicturesAreWithinTheirMantissa) {
    const Image narrow = random_light(7, 5, 31);
    expect_within_mantissa(read_right(flat(narrow)), narrow);
    Image wide = random_light(300, 4, 32);
    std::fill_n(wide.pixels.begin() + 20, 200, Color{0.25f, 0.5f, 1.0f});  // runs
    expect_within_mantissa(read_right(in_new_way(wide)), wide);
    EXPECT_EQ(read_right(in_new_way(wide)).pixels, read_right(flat(wide)).pixels);
}

TEST(HdrRead, ValuesAreMantissaTimesPowerOfTwo) {
    const Image image =
        read_right(header("-Y 1 +X 3") + "\x80\x40\xff\x81"s + "\1\2\3\0"s + "\x80\0\0\x01"s);
    EXPECT_EQ(image.pixels[0], (Color{1.0f, 0.5f, 255.0f / 128.0f}));
    EXPECT_EQ(image.pixels[1], Color{0.0f});
    EXPECT_EQ(image.pixels[2].r, std::ldexp(1.0f, -128));
}

TEST(HdrRead, OldRunsRepeatAndGrowBy256) {
    const std::string pixel = "\x80\x80\x80\x81"s;
    const Image image = read_right(header("-Y 1 +X 261") + pixel + "\1\1\1\4"s + "\1\1\1\1"s);
    ASSERT_EQ(image.pixels.size(), 261u);
    for (const Color& c : image.pixels) EXPECT_EQ(c, Color{1.0f});
    EXPECT_EQ(read_error(header("-Y 1 +X 260") + pixel + "\1\1\1\4"s + "\1\1\1\1"s),
              "a line of the Radiance file is longer than it may be");
    EXPECT_EQ(read_error(header("-Y 1 +X 4") + "\1\1\1\4"s),
              "a line of the Radiance file is longer than it may be");
}

TEST(HdrRead, EveryOrderOfLinesIsTurnedUpright) {
    // The picture is 2 x 3, red: x + 1, green: y + 1.
    const auto pixel = [](int x, int y) {
        return std::string{static_cast<char>(16 * (x + 1)), static_cast<char>(16 * (y + 1)), '\x80',
                           '\x88'};
    };
    for (const char first_sign : {'-', '+'}) {
        for (const char second_sign : {'-', '+'}) {
            for (const bool is_by_columns : {false, true}) {
                const char x_sign = is_by_columns ? first_sign : second_sign;
                const char y_sign = is_by_columns ? second_sign : first_sign;
                const std::string x_text = " "s + x_sign + "X 2";
                const std::string y_text = " "s + y_sign + "Y 3";
                std::string file =
                    header((is_by_columns ? x_text + y_text : y_text + x_text).substr(1));
                for (int i = 0; i < 6; ++i) {
                    int x = is_by_columns ? i / 3 : i % 2;
                    int y = is_by_columns ? i % 3 : i / 2;
                    if (x_sign == '-') x = 1 - x;
                    if (y_sign == '+') y = 2 - y;
                    file += pixel(x, y);
                }
                const Image image = read_right(file);
                ASSERT_EQ(image.width, 2u);
                ASSERT_EQ(image.height, 3u);
                for (std::uint32_t y = 0; y < 3; ++y) {
                    for (std::uint32_t x = 0; x < 2; ++x) {
                        EXPECT_EQ(image.at(x, y).r, 16.0f * static_cast<float>(x + 1)) << file;
                        EXPECT_EQ(image.at(x, y).g, 16.0f * static_cast<float>(y + 1)) << file;
                    }
                }
            }
        }
    }
}

TEST(HdrRead, ExposuresAndColourCorrectionsAreUndone) {
    const std::string more = "EXPOSURE=4\nSOFTWARE=a=b\n# a note\nEXPOSURE= 0.5\nCOLORCORR=1 2 4\n";
    const Image image = read_right(header("-Y 1 +X 1", more) + "\x80\x80\x80\x84"s);
    EXPECT_EQ(image.pixels[0], (Color{4.0f, 2.0f, 1.0f}));
}

TEST(HdrRead, WrongHeadersAreToldInWords) {
    const std::map<std::string, std::string> cases{
        {"P6", "this is not a Radiance picture"},
        {"#?RADIANCE", "the Radiance file ends early"},
        {"#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\nabcd",
         "its colours are XYZ; save it as RGB"},
        {"#?RGBE\nFORMAT=float\n\n-Y 1 +X 1\nabcd", "its format is not 32-bit_rle_rgbe"},
        {"#?RGBE\nEXPOSURE=0\n\n-Y 1 +X 1\nabcd",
         "its exposure or colour correction is not a number above 0"},
        {"#?RGBE\nEXPOSURE=nan\n\n-Y 1 +X 1\nabcd",
         "its exposure or colour correction is not a number above 0"},
        {"#?RGBE\nCOLORCORR=1 1\n\n-Y 1 +X 1\nabcd",
         "its exposure or colour correction is not a number above 0"},
        {"#?RGBE\n" + std::string(5000, 'a') + "\n\n-Y 1 +X 1\nabcd",
         "a line of the Radiance header does not end"},
        {"#?RGBE\n\n-Y 1 +X 1\nabc", "the Radiance file ends early"},
        {header("-Y 1 +X 8") + "\2\2\0\7"s,
         "a line of the Radiance file is not as long as the picture is wide"},
        {header("-Y 1 +X 8") + "\2\2\0\x08\x89\1"s,
         "a line of the Radiance file is longer than it may be"},
        {header("-Y 1 +X 8") + "\2\2\0\x08\0\1"s,
         "a line of the Radiance file is longer than it may be"},
    };
    for (const auto& [file, message] : cases) EXPECT_EQ(read_error(file), message) << file;
    for (const char* size : {"", "-Y 1", "-Y 0 +X 1", "-Y 1 -Y 1", "Y 1 X 1", "-Y 1 +X 1 1",
                             "-Y 1 +X 99999999999", "-Z 1 +X 1"}) {
        EXPECT_EQ(read_error(header(size) + "abcd"),
                  "the Radiance header needs a size like `-Y 480 +X 640` after an empty line")
            << size;
    }
}

TEST(HdrRead, LimitIsCheckedByTheHeaderAndMemoryIsNotTakenForIt) {
    EXPECT_EQ(read_error(header("-Y 100000 +X 100000")),
              "100000 x 100000 pixels are more than the limit of 67108864");
    // Nothing behind a size that is within the limit: the first line already is not there.
    EXPECT_EQ(read_error(header("-Y 8192 +X 8192")), "the Radiance file ends early");
}

}  // namespace
}  // namespace lray::image
