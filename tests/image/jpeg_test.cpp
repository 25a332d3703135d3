#include "image/jpeg.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
// jpeglib.h needs stdio's FILE to be known.
#include <jpeglib.h>

#include "tests/image/pictures.h"
#include "tests/support/temp_directory.h"

namespace lray::image {
namespace {

using test::bytes_of;
using Texts = std::vector<std::pair<std::string, std::string>>;

std::string jpeg_bytes(const Image& image, int quality = 90, const Texts& metadata = {}) {
    const test::TempDirectory directory;
    std::string error;
    auto out = OutputFile::open(directory.path("a.jpg"), error);
    EXPECT_TRUE(out) << error;
    EXPECT_TRUE(write_jpeg(*out, image, Gamma::srgb, metadata, quality, error)) << error;
    EXPECT_TRUE(out->commit()) << out->error();
    return directory.read("a.jpg");
}

std::string read_error(std::string_view file, ReadLimits limits = {}) {
    std::string error;
    EXPECT_FALSE(read_jpeg(bytes_of(file), limits, error));
    return error;
}

CodedImage read_right(std::string_view file) {
    std::string error;
    const auto image = read_jpeg(bytes_of(file), {}, error);
    EXPECT_TRUE(image) << error;
    return image.value_or(CodedImage{});
}

/// How a foreign file is made.
struct Recipe {
    std::uint32_t width = 33;
    std::uint32_t height = 17;
    int components = 3;
    J_COLOR_SPACE colors = JCS_RGB;
    bool is_progressive = false;
    int scan_count = 0;  // 0: as usual
};

/// A picture that gets brighter to the right, made with the library itself.
std::string foreign_jpeg(const Recipe& recipe) {
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr manager{};
    jpeg.err = jpeg_std_error(&manager);
    jpeg_create_compress(&jpeg);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &bytes, &size);
    jpeg.image_width = recipe.width;
    jpeg.image_height = recipe.height;
    jpeg.input_components = recipe.components;
    jpeg.in_color_space = recipe.colors;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 100, TRUE);
    if (recipe.is_progressive) jpeg_simple_progression(&jpeg);
    std::vector<jpeg_scan_info> scans;
    if (recipe.scan_count > 0) {
        // The mean of each block bit by bit, then each frequency alone.
        for (int component = 0; component < recipe.components; ++component) {
            for (int bit = 10; bit >= 0; --bit) {
                scans.push_back({1, {component, 0, 0, 0}, 0, 0, bit == 10 ? 0 : bit + 1, bit});
            }
        }
        for (int component = 0; component < recipe.components; ++component) {
            for (int band = 1; band < 64; ++band) {
                scans.push_back({1, {component, 0, 0, 0}, band, band, 0, 0});
            }
        }
        scans.resize(static_cast<std::size_t>(recipe.scan_count));
        jpeg.scan_info = scans.data();
        jpeg.num_scans = static_cast<int>(scans.size());
    }
    jpeg_start_compress(&jpeg, TRUE);
    std::vector<JSAMPLE> row(std::size_t{recipe.width} * static_cast<unsigned>(recipe.components));
    for (std::size_t i = 0; i < row.size(); ++i) {
        row[i] =
            static_cast<JSAMPLE>(i / static_cast<unsigned>(recipe.components) * 255 / recipe.width);
    }
    JSAMPROW rows = row.data();
    while (jpeg.next_scanline < jpeg.image_height) jpeg_write_scanlines(&jpeg, &rows, 1);
    jpeg_finish_compress(&jpeg);
    std::string file(reinterpret_cast<char*>(bytes), size);
    jpeg_destroy_compress(&jpeg);
    std::free(bytes);
    return file;
}

void expect_brighter_to_the_right(const CodedImage& image) {
    ASSERT_EQ(image.width, 33u);
    ASSERT_EQ(image.height, 17u);
    for (std::uint32_t x = 0; x < image.width; ++x) {
        for (const std::uint8_t code : image.at(x, 16)) {
            EXPECT_NEAR(code, static_cast<int>(x * 255 / 33), 3) << x;
        }
    }
}

TEST(JpegWrite, PictureReadsBackAboutTheSame) {
    Image image(40, 24);
    for (std::uint32_t y = 0; y < 24; ++y) {
        for (std::uint32_t x = 0; x < 40; ++x) {
            image.pixels[y * 40 + x] = {0.02f * static_cast<float>(x),
                                        0.04f * static_cast<float>(y), 0.3f};
        }
    }
    const CodedImage read = read_right(jpeg_bytes(image));
    ASSERT_EQ(read.width, 40u);
    ASSERT_EQ(read.height, 24u);
    double error = 0.0;
    for (std::size_t i = 0; i < read.rgb.size(); ++i) {
        error +=
            std::abs(read.rgb[i] - srgb_encode_8(image.pixels[i / 3][static_cast<int>(i % 3)]));
    }
    EXPECT_LT(error / static_cast<double>(read.rgb.size()), 2.0);  // codes of 255
}

TEST(JpegWrite, HighQualityKeepsColoursSharp) {
    // Red and blue columns, one pixel wide each: at half the sharpness they would be violet.
    Image image(16, 16);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[i] = i % 2 == 0 ? Color{1.0f, 0.0f, 0.0f} : Color{0.0f, 0.0f, 1.0f};
    }
    const CodedImage sharp = read_right(jpeg_bytes(image, 95));
    EXPECT_GT(sharp.at(0, 8)[0], 230);
    EXPECT_LT(sharp.at(0, 8)[2], 25);
    const CodedImage soft = read_right(jpeg_bytes(image, 85));
    EXPECT_LT(soft.at(0, 8)[0], 200);
}

TEST(JpegWrite, LowerQualityTakesFewerBytes) {
    const Image image = test::random_image(64, 64, 21);
    EXPECT_LT(jpeg_bytes(image, 30).size(), jpeg_bytes(image, 90).size() / 2);
}

TEST(JpegWrite, MetadataIsCommentsAndBytesDependOnTheArgumentsAlone) {
    const Texts metadata{{"title", "Four primitives"}, {"long", std::string(70000, 'x')}};
    const std::string file = jpeg_bytes(test::random_image(9, 9, 22), 90, metadata);
    EXPECT_NE(file.find("title: Four primitives"), std::string::npos);
    EXPECT_NE(file.find("long: xxx"), std::string::npos);
    EXPECT_EQ(file, jpeg_bytes(test::random_image(9, 9, 22), 90, metadata));
    EXPECT_EQ(read_right(file).width, 9u);
}

TEST(JpegWrite, FullDiskIsAnErrorInWords) {
    std::string error;
    auto out = OutputFile::open("/dev/full", error);
    ASSERT_TRUE(out) << error;
    const bool is_written =
        write_jpeg(*out, test::random_image(400, 400, 23), Gamma::srgb, {}, 100, error) &&
        out->commit();
    EXPECT_FALSE(is_written);
    EXPECT_NE((error.empty() ? out->error() : error).find("space"), std::string::npos) << error;
}

TEST(JpegWrite, PictureWiderThanTheFormatAllowsIsAnErrorInWords) {
    std::string error;
    const test::TempDirectory directory;
    auto out = OutputFile::open(directory.path("a.jpg"), error);
    ASSERT_TRUE(out) << error;
    EXPECT_FALSE(write_jpeg(*out, Image(65501, 1), Gamma::srgb, {}, 90, error));
    EXPECT_NE(error.find("65500"), std::string::npos) << error;
}

TEST(JpegRead, BaselineAndProgressiveInGreyAndColour) {
    for (const bool is_progressive : {false, true}) {
        Recipe recipe;
        recipe.is_progressive = is_progressive;
        expect_brighter_to_the_right(read_right(foreign_jpeg(recipe)));
        recipe.components = 1;
        recipe.colors = JCS_GRAYSCALE;
        expect_brighter_to_the_right(read_right(foreign_jpeg(recipe)));
    }
}

TEST(JpegRead, PrintingInksAreRefused) {
    Recipe recipe;
    recipe.components = 4;
    recipe.colors = JCS_CMYK;
    EXPECT_EQ(read_error(foreign_jpeg(recipe)), "it is in printing inks (CMYK); save it as RGB");
    recipe.components = 2;
    recipe.colors = JCS_UNKNOWN;
    EXPECT_EQ(read_error(foreign_jpeg(recipe)),
              "its colours are neither grey nor RGB; save it as RGB");
}

TEST(JpegRead, EveryTruncationIsRefused) {
    for (const bool is_progressive : {false, true}) {
        Recipe recipe;
        recipe.is_progressive = is_progressive;
        const std::string file = foreign_jpeg(recipe);
        for (std::size_t size = 0; size < file.size(); ++size) {
            EXPECT_FALSE(read_error(file.substr(0, size)).empty()) << size;
        }
        EXPECT_EQ(read_error(file.substr(0, file.size() - 20)), "the file ends early");
    }
}

TEST(JpegRead, DamageIsRefusedOrReadAndNothingWorse) {
    for (const bool is_progressive : {false, true}) {
        Recipe recipe;
        recipe.is_progressive = is_progressive;
        const std::string file = foreign_jpeg(recipe);
        constexpr std::uint64_t kSeed = 24;
        LRAY_TRACE_SEED(kSeed);
        test::Random random(kSeed);
        int refused_count = 0;
        for (int trial = 0; trial < 2000; ++trial) {
            std::string damaged = file;
            for (int i = 0; i < 3; ++i) {
                damaged[3 + random.below(file.size() - 3)] = static_cast<char>(random.below(256));
            }
            std::string error;
            const auto image = read_jpeg(bytes_of(damaged), {std::uint64_t{1} << 16}, error);
            EXPECT_NE(image.has_value(), !error.empty());
            refused_count += image ? 0 : 1;
        }
        EXPECT_GT(refused_count, 500);
    }
}

TEST(JpegRead, LimitIsCheckedByTheHeader) {
    const std::string file = foreign_jpeg({});
    EXPECT_EQ(read_error(file, {560}), "33 x 17 pixels are more than the limit of 560");
    std::string error;
    EXPECT_TRUE(read_jpeg(bytes_of(file), {561}, error)) << error;
    // The header alone decides: there is nothing behind it.
    const std::size_t scan = file.find("\xff\xda");
    EXPECT_EQ(read_error(file.substr(0, scan + 14), {560}),
              "33 x 17 pixels are more than the limit of 560");
}

TEST(JpegRead, MoreScansThanAnyPictureNeedsAreRefused) {
    Recipe recipe;
    recipe.is_progressive = true;
    recipe.scan_count = 64;
    EXPECT_EQ(read_right(foreign_jpeg(recipe)).width, 33u);
    recipe.scan_count = 65;
    EXPECT_EQ(read_error(foreign_jpeg(recipe)),
              "it has more than 64 scans, which no picture needs; save it anew");
}

TEST(JpegRead, LargePicturesMayHaveFewerScans) {
    // Each scan costs a pass over all pixels: of 2^25 only 32.
    Recipe recipe;
    recipe.width = 8192;
    recipe.height = 4096;
    recipe.components = 1;
    recipe.colors = JCS_GRAYSCALE;
    recipe.is_progressive = true;
    recipe.scan_count = 33;
    EXPECT_EQ(read_error(foreign_jpeg(recipe)),
              "it has more than 32 scans, which no picture of its size needs; save it anew");
}

TEST(JpegRead, OtherFilesAreRefused) {
    EXPECT_EQ(read_error("P6 1 1 255"), "this is not a JPEG file");
    EXPECT_EQ(read_error(""), "this is not a JPEG file");
    EXPECT_FALSE(read_error("\xff\xd8\xff").empty());
}

}  // namespace
}  // namespace lray::image
