#include "image/ppm.h"

#include <gtest/gtest.h>

#include "image/srgb.h"
#include "tests/image/pictures.h"
#include "tests/support/temp_directory.h"

namespace lray::image {
namespace {

using test::bytes_of;
using test::random_image;

std::string ppm_bytes(const Image& image) {
    const test::TempDirectory directory;
    std::string error;
    auto out = OutputFile::open(directory.path("a.ppm"), error);
    EXPECT_TRUE(out) << error;
    EXPECT_TRUE(write_ppm(*out, image, Gamma::srgb)) << out->error();
    EXPECT_TRUE(out->commit()) << out->error();
    return directory.read("a.ppm");
}

std::string read_error(std::string_view file, ReadLimits limits = {}) {
    std::string error;
    EXPECT_FALSE(read_ppm(bytes_of(file), limits, error));
    return error;
}

TEST(PpmWrite, KnownPictureGivesKnownBytes) {
    Image image(2, 2);
    image.at(0, 0) = {1.0f, 0.0f, 0.0f};
    image.at(1, 0) = {0.0f, 1.0f, 0.0f};
    image.at(0, 1) = {0.0f, 0.0f, 1.0f};
    image.at(1, 1) = {0.5f, 0.5f, 0.5f};  // 188 in sRGB
    using namespace std::string_literals;
    EXPECT_EQ(ppm_bytes(image),
              "P6\n2 2\n255\n"
              "\xff\x00\x00\x00\xff\x00"
              "\x00\x00\xff\xbc\xbc\xbc"s);
}

TEST(PpmWrite, PictureOfSeveralBatchesReadsBack) {
    const Image image = random_image(401, 173, 1);  // more than one batch, not a multiple of it
    const std::string file = ppm_bytes(image);
    std::string error;
    const auto read = read_image(bytes_of(file), {}, error);
    ASSERT_TRUE(read) << error;
    EXPECT_EQ(read->width, 401u);
    EXPECT_EQ(read->height, 173u);
    EXPECT_EQ(read->pixels, image.pixels);
}

TEST(PpmRead, CommentsAndAnyWhiteSpaceInTheHeader) {
    using namespace std::string_literals;
    std::string error;
    const std::string whole = "P6 # made by hand\n# two lines\n1\t1\r\n255 \xff\x80\x00"s;
    const auto read = read_image(bytes_of(whole), {}, error);
    ASSERT_TRUE(read) << error;
    EXPECT_EQ(read->at(0, 0), Color(1.0f, srgb_decode_8(128), 0.0f));
}

/// The codes of a picture, as numbers.
std::vector<int> codes_of(std::string_view file) {
    std::string error;
    const auto codes = read_ppm(bytes_of(file), {}, error);
    EXPECT_TRUE(codes) << error;
    if (!codes) return {};
    return std::visit(
        [](const auto& image) { return std::vector<int>(image.rgb.begin(), image.rgb.end()); },
        *codes);
}

TEST(PpmRead, GreysDecimalsAndOtherMaxima) {
    using namespace std::string_literals;
    EXPECT_EQ(codes_of("P5 2 1 255 \1\xff"s), (std::vector{1, 1, 1, 255, 255, 255}));
    EXPECT_EQ(codes_of("P2 2 1 4 # four\n1 # one\n 9"), (std::vector{64, 64, 64, 255, 255, 255}));
    EXPECT_EQ(codes_of("P3\n1 1 255\n1 2 3"), (std::vector{1, 2, 3}));
    EXPECT_EQ(codes_of("P6 1 1 1\n\0\1\2"s), (std::vector{0, 255, 255}));
    EXPECT_EQ(codes_of("P6 1 1 65535\n\1\2\3\4\xff\xff"s), (std::vector{258, 772, 65535}));
    EXPECT_EQ(codes_of("P2 1 1 1000 500"), (std::vector{32768, 32768, 32768}));
}

TEST(PpmRead, BrokenFilesAreRefusedInWords) {
    EXPECT_EQ(read_error(""), "this is not a PPM or PGM (P6, P5, P3, P2) file");
    EXPECT_EQ(read_error("P4\n1 1\n1"), "this is not a PPM or PGM (P6, P5, P3, P2) file");
    const std::string header = "the PPM header needs a width, a height and a maximum";
    EXPECT_EQ(read_error("P6"), header);
    EXPECT_EQ(read_error("P61 1 255\nabc"), header);
    EXPECT_EQ(read_error("P6\n1 -1\n255\nabc"), header);
    EXPECT_EQ(read_error("P6\n0 1\n255\n"), header);
    EXPECT_EQ(read_error("P6\n99999999999 1\n255\nabc"), header);
    EXPECT_EQ(read_error("P6\n1 1\n255"), header);
    EXPECT_EQ(read_error("P6\n#"), header);
    EXPECT_EQ(read_error("P6\n1 1\n65536\nabcdef"), "the PPM maximum is 65536; it is 1 to 65535");
    EXPECT_EQ(read_error("P6\n1 1\n0\nabc"), "the PPM maximum is 0; it is 1 to 65535");
    EXPECT_EQ(read_error("P3\n1 1\n255\n1 2 x  "),
              "among the numbers of the PPM file is something else");
    EXPECT_EQ(read_error("P3\n1 1\n255\n1  2    "),
              "the PPM file ends early: 2 of 3 numbers of pixels");
    EXPECT_EQ(read_error("P5\n2 1\n256\nabc"), "the PPM file ends early: 3 of 4 bytes of pixels");
}

TEST(PpmRead, LimitIsCheckedBeforeThePixelsAre) {
    EXPECT_EQ(read_error("P6\n4294967295 4294967295\n255\nabc"),
              "4294967295 x 4294967295 pixels are more than the limit of 67108864");
    EXPECT_EQ(read_error("P6\n3 2\n255\nabc", {5}), "3 x 2 pixels are more than the limit of 5");
    EXPECT_EQ(read_error("P6\n3 2\n255\nabc", {6}),
              "the PPM file ends early: 3 of 18 bytes of pixels");
}

}  // namespace
}  // namespace lray::image
