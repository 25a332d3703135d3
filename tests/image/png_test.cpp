#include "image/png.h"

#include <gtest/gtest.h>
#include <png.h>
#include <zlib.h>

#include <limits>

#include "tests/image/pictures.h"
#include "tests/image/written.h"
#include "tests/support/temp_directory.h"

namespace lray::image {
namespace {

using test::bytes_of;
using test::random_image;
using Texts = std::vector<std::pair<std::string, std::string>>;

std::string png_bytes(const Image& image, const Texts& metadata = {}) {
    const test::TempDirectory directory;
    std::string error;
    auto out = OutputFile::open(directory.path("a.png"), error);
    EXPECT_TRUE(out) << error;
    EXPECT_TRUE(write_png(*out, image, Gamma::srgb, metadata, error)) << error;
    EXPECT_TRUE(out->commit()) << out->error();
    return directory.read("a.png");
}

std::string read_error(std::string_view file, ReadLimits limits = {}) {
    std::string error;
    EXPECT_FALSE(read_png(bytes_of(file), limits, error));
    return error;
}

/// A PNG of one kind of colour, 2 x 1 pixels, made with libpng itself.
std::string foreign_png(int color_type, int bit_depth, int interlace, std::string_view row,
                        std::span<const png_color> palette = {}) {
    std::string file;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    const auto write = [](png_structp p, png_bytep bytes, std::size_t size) {
        static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<char*>(bytes), size);
    };
    png_set_write_fn(png, &file, write, nullptr);
    png_set_IHDR(png, info, 2, 1, bit_depth, color_type, interlace, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (!palette.empty()) {
        png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    }
    png_write_info(png, info);
    const int pass_count = png_set_interlace_handling(png);
    for (int pass = 0; pass < pass_count; ++pass) {
        png_write_row(png, reinterpret_cast<png_const_bytep>(row.data()));
    }
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return file;
}

void expect_codes(const std::string& file, const std::vector<int>& codes) {
    std::string error;
    const auto image = read_image(bytes_of(file), {}, error);
    ASSERT_TRUE(image) << error;
    ASSERT_EQ(image->pixels.size() * 3, codes.size());
    for (std::size_t i = 0; i < codes.size(); ++i) {
        EXPECT_EQ(srgb_encode_8(image->pixels[i / 3][static_cast<int>(i % 3)]), codes[i]) << i;
    }
}

TEST(PngWrite, PictureReadsBack) {
    const Image image = random_image(61, 47, 2);
    std::string error;
    const std::string file = png_bytes(image);
    const auto read = read_image(bytes_of(file), {}, error);
    ASSERT_TRUE(read) << error;
    EXPECT_EQ(read->width, 61u);
    EXPECT_EQ(read->height, 47u);
    EXPECT_EQ(read->pixels, image.pixels);
}

TEST(PngWrite, HeaderSaysRgb8AndSrgbAndNoTime) {
    const std::string file = png_bytes(random_image(3, 2, 3), {{"title", "a"}});
    const std::string header("IHDR\0\0\0\3\0\0\0\2\x08\x02\0\0\0", 17);
    EXPECT_EQ(file.substr(12, 17), header);
    EXPECT_NE(file.find("sRGB"), std::string::npos);
    EXPECT_EQ(file.find("tIME"), std::string::npos);
    EXPECT_EQ(file.find("Creation Time"), std::string::npos);
    EXPECT_EQ(file.find("gAMA"), std::string::npos);
}

TEST(PngWrite, SameArgumentsGiveTheSameBytes) {
    const Texts metadata{{"title", "Four primitives"}};
    EXPECT_EQ(png_bytes(random_image(20, 20, 4), metadata),
              png_bytes(random_image(20, 20, 4), metadata));
}

TEST(PngWrite, MetadataIsTextAsciiOrUtf8) {
    const std::string file = png_bytes(
        random_image(1, 1, 5), {{"title", "Four primitives"}, {"author", "Zo\xc3\xab"}, {"", "x"}});
    using namespace std::string_literals;
    EXPECT_NE(file.find("tEXtTitle\0Four primitives"s), std::string::npos);
    EXPECT_NE(file.find("iTXtAuthor\0\0\0\0\0Zo\xc3\xab"s), std::string::npos);
}

TEST(PngWrite, LongKeywordIsCutToWhatTheFormatAllows) {
    const std::string file = png_bytes(random_image(1, 1, 6), {{std::string(200, 'k'), "v"}});
    using namespace std::string_literals;
    EXPECT_NE(file.find("tEXtK" + std::string(78, 'k') + "\0v"s), std::string::npos);
}

TEST(PngWrite, FullDiskIsAnErrorInWords) {
    std::string error;
    auto out = OutputFile::open("/dev/full", error);
    ASSERT_TRUE(out) << error;
    const bool is_written =
        write_png(*out, random_image(300, 300, 7), Gamma::srgb, {}, error) && out->commit();
    EXPECT_FALSE(is_written);
    EXPECT_NE((error.empty() ? out->error() : error).find("space"), std::string::npos) << error;
}

TEST(PngRead, OtherKindsOfColourBecomeRgb8) {
    using namespace std::string_literals;
    const int plain = PNG_INTERLACE_NONE;
    expect_codes(foreign_png(PNG_COLOR_TYPE_GRAY, 8, plain, "\x10\xf0"s),
                 {16, 16, 16, 240, 240, 240});
    expect_codes(foreign_png(PNG_COLOR_TYPE_GRAY, 1, plain, "\x40"s), {0, 0, 0, 255, 255, 255});
    expect_codes(foreign_png(PNG_COLOR_TYPE_RGBA, 8, plain, "\1\2\3\0\4\5\6\x80"s),
                 {1, 2, 3, 4, 5, 6});
    const std::vector<png_color> palette{{9, 8, 7}, {6, 5, 4}};
    expect_codes(foreign_png(PNG_COLOR_TYPE_PALETTE, 8, plain, "\1\0"s, palette),
                 {6, 5, 4, 9, 8, 7});
    expect_codes(foreign_png(PNG_COLOR_TYPE_RGB, 8, PNG_INTERLACE_ADAM7, "\1\2\3\4\5\6"s),
                 {1, 2, 3, 4, 5, 6});
}

TEST(PngRead, EveryTruncationIsRefused) {
    const std::string file = png_bytes(random_image(9, 9, 8), {{"title", "a"}});
    for (std::size_t size = 0; size < file.size(); ++size) {
        EXPECT_FALSE(read_error(file.substr(0, size)).empty()) << size;
    }
}

TEST(PngRead, LimitIsCheckedBeforeMemoryIsTaken) {
    const std::string file = png_bytes(random_image(4, 3, 9));
    EXPECT_EQ(read_error(file, {11}), "4 x 3 pixels are more than the limit of 11");
    std::string error;
    EXPECT_TRUE(read_png(bytes_of(file), {12}, error)) << error;
}

TEST(PngWrite, LinearCodesAreMarkedAsSuch) {
    const auto written = [](Gamma gamma) {
        const test::TempDirectory directory;
        std::string error;
        auto out = OutputFile::open(directory.path("a.png"), error);
        Image picture(1, 1);
        picture.at(0, 0) = Color{0.0f, 0.5f, 1.0f};
        EXPECT_TRUE(out && write_png(*out, picture, gamma, {}, error) && out->commit()) << error;
        return directory.read("a.png");
    };
    const std::string linear = written(Gamma::linear);
    expect_codes(linear, {0, 128, 255});
    EXPECT_EQ(linear.find("sRGB"), std::string::npos);
    EXPECT_NE(linear.find(std::string("gAMA\0\x01\x86\xa0", 8)), std::string::npos);  // 1.00000
    const std::string srgb = written(Gamma::srgb);
    expect_codes(srgb, {0, 188, 255});
    EXPECT_NE(srgb.find("sRGB"), std::string::npos);
}

/// The codes of a picture of 16 bits.
std::vector<std::uint16_t> deep_codes(std::string_view file) {
    std::string error;
    const auto codes = read_png(bytes_of(file), {}, error);
    EXPECT_TRUE(codes) << error;
    const auto* const deep = codes ? std::get_if<DeepImage>(&*codes) : nullptr;
    EXPECT_NE(deep, nullptr) << "it has 8 bits";
    return deep != nullptr ? deep->rgb : std::vector<std::uint16_t>{};
}

TEST(PngRead, SixteenBitsAreKeptAndRoundedForTextures) {
    using namespace std::string_literals;
    const std::string file = foreign_png(PNG_COLOR_TYPE_RGB, 16, PNG_INTERLACE_ADAM7,
                                         "\x80\x80\0\1\xff\xff\1\1\x02\x81\2\x82"s);
    EXPECT_EQ(deep_codes(file),
              (std::vector<std::uint16_t>{0x8080, 1, 0xffff, 0x101, 0x281, 0x282}));
    std::string error;
    const auto image = read_image(bytes_of(file), {}, error);
    ASSERT_TRUE(image) << error;
    EXPECT_EQ(image->pixels[0].g, static_cast<float>(1.0 / 65535.0 / 12.92));
    const auto pixels = read_pixels(bytes_of(file), {}, error);
    ASSERT_TRUE(pixels) << error;
    EXPECT_EQ(std::get<CodedImage>(*pixels).rgb, (std::vector<std::uint8_t>{128, 0, 255, 1, 2, 2}));
}

TEST(PngWrite, SixteenBitsReadBackAndSaySo) {
    Image image(256, 257);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const float value =
            srgb_decode_16(static_cast<std::uint16_t>(std::min<std::size_t>(i, 65535)));
        image.pixels[i] = {value, 1.0f - value, 0.5f * value};
    }
    const std::string file =
        test::written(image, Format::png, {{"title", "a"}}, {.png_bits = PngBits::sixteen});
    EXPECT_EQ(file.substr(24, 2), "\x10\x02");  // bits, kind of colour
    EXPECT_NE(file.find("sRGB"), std::string::npos);
    EXPECT_NE(file.find("tEXtTitle"), std::string::npos);
    const auto codes = deep_codes(file);
    for (std::size_t i = 0; i < 65536; ++i) ASSERT_EQ(codes[3 * i], i);
    const std::string linear =
        test::written(image, Format::png, {}, {.png_bits = PngBits::sixteen}, Gamma::linear);
    EXPECT_NE(linear.find("gAMA"), std::string::npos);
    EXPECT_EQ(deep_codes(linear)[3 * 40000], linear_encode_16(srgb_decode_16(40000)));
}

/// Puts a chunk with a right checksum behind the header.
std::string with_chunk(const std::string& file, const std::string& kind, const std::string& data) {
    std::string chunk;
    const auto add_number = [&](std::uint32_t number) {
        for (int shift = 24; shift >= 0; shift -= 8) chunk += static_cast<char>(number >> shift);
    };
    add_number(static_cast<std::uint32_t>(data.size()));
    chunk += kind + data;
    const std::string summed = kind + data;
    std::uint32_t sum = 0xffffffffu;
    for (const char c : summed) {
        sum ^= static_cast<std::uint8_t>(c);
        for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ ((sum & 1) != 0 ? 0xedb88320u : 0u);
    }
    add_number(~sum);
    constexpr std::size_t kHeaderEnd = 8 + 25;
    return file.substr(0, kHeaderEnd) + chunk + file.substr(kHeaderEnd);
}

TEST(PngRead, PackedTextAndProfilesAreNotUnpacked) {
    // What is in them is no zlib stream: to have been read at all, it was not unpacked.
    const Image image = random_image(4, 3, 10);
    using namespace std::string_literals;
    std::string file = png_bytes(image);
    for (int i = 0; i < 2000; ++i) file = with_chunk(file, "zTXt", "a\0\0broken"s);
    for (const char* kind : {"iCCP", "iTXt", "sPLT", "tEXt", "eXIf", "qQqQ"}) {
        file = with_chunk(file, kind, "a\0\0broken"s);
    }
    std::string error;
    const auto read = read_image(bytes_of(file), {}, error);
    ASSERT_TRUE(read) << error;
    EXPECT_EQ(read->pixels, image.pixels);
}

TEST(PngRead, MorePixelsThanTheFileCanHoldAreRefusedByTheHeader) {
    std::string file = png_bytes(random_image(4, 3, 11));
    // 8000 x 8000: within the limit, and a zlib stream would have to be 180 kB at least.
    const std::string sides("\0\0\x1f\x40\0\0\x1f\x40", 8);
    const std::string rest = file.substr(33);
    const std::string kind("\x08\x02\0\0\0", 5);
    const std::string empty =
        file.substr(0, 8) + with_chunk(std::string(33, ' '), "IHDR", sides + kind).substr(33);
    EXPECT_EQ(read_error(empty + rest), "the file ends early");
}

TEST(PngRead, MoreBytesThanThePictureHasAreNotUnpackedToTheirEnd) {
    // A row of one grey pixel is 2 bytes; 64 MiB of zeros come behind it, packed to 64 kB. They are
    // told of, after which there is no picture.
    const std::string bomb = foreign_png(PNG_COLOR_TYPE_GRAY, 8, PNG_INTERLACE_NONE, "\1\2");
    std::vector<unsigned char> zeros(std::size_t{1} << 26);
    unsigned long size = compressBound(zeros.size());
    std::string packed(size, '\0');
    ASSERT_EQ(compress2(reinterpret_cast<unsigned char*>(packed.data()), &size, zeros.data(),
                        zeros.size(), 9),
              0);
    packed.resize(size);
    const std::string file = with_chunk(bomb, "IDAT", packed);
    EXPECT_NE(read_error(file), "");
}

}  // namespace
}  // namespace lray::image
