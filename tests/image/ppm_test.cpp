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

TEST(PpmRead, BrokenFilesAreRefusedInWords) {
    EXPECT_EQ(read_error(""), "this is not a binary PPM (P6) file");
    EXPECT_EQ(read_error("P3\n1 1\n255\n1 2 3"), "this is not a binary PPM (P6) file");
    const std::string header = "the PPM header needs a width, a height and a maximum";
    EXPECT_EQ(read_error("P6"), header);
    EXPECT_EQ(read_error("P61 1 255\nabc"), header);
    EXPECT_EQ(read_error("P6\n1 -1\n255\nabc"), header);
    EXPECT_EQ(read_error("P6\n0 1\n255\n"), header);
    EXPECT_EQ(read_error("P6\n99999999999 1\n255\nabc"), header);
    EXPECT_EQ(read_error("P6\n1 1\n255"), header);
    EXPECT_EQ(read_error("P6\n#"), header);
    EXPECT_EQ(read_error("P6\n1 1\n65535\nabcdef"), "the PPM maximum is 65535; only 255 is read");
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
