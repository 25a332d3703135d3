#include "image/write.h"

#include <gtest/gtest.h>

#include "image/read.h"
#include "tests/image/pictures.h"
#include "tests/support/temp_directory.h"

namespace lray::image {
namespace {

TEST(FindFormat, NamesInAnyCaseAndNothingElse) {
    EXPECT_EQ(find_format("ppm"), Format::ppm);
    EXPECT_EQ(find_format("PNG"), Format::png);
    EXPECT_EQ(find_format("Png"), Format::png);
    EXPECT_EQ(find_format("pfm"), Format::pfm);
    EXPECT_EQ(find_format(""), std::nullopt);
    EXPECT_EQ(find_format("pn"), std::nullopt);
    EXPECT_EQ(find_format("pngx"), std::nullopt);
    EXPECT_EQ(find_format("jpg"), Format::jpg);
    EXPECT_EQ(find_format("JPEG"), Format::jpg);
    EXPECT_EQ(find_format("jpe"), std::nullopt);
}

TEST(Extension, LastDotOfTheNameBeginsIt) {
    EXPECT_EQ(extension("a/b.png"), "png");
    EXPECT_EQ(extension("b.tar.PPM"), "PPM");
    EXPECT_EQ(extension("b."), "");
    EXPECT_EQ(extension("b"), "");
    EXPECT_EQ(extension("a.d/b"), "");
    EXPECT_EQ(extension(".png"), "");
    EXPECT_EQ(extension("a/.png"), "");
    EXPECT_EQ(extension(""), "");
}

std::string written(const Image& image, Format format) {
    const test::TempDirectory directory;
    std::string error;
    auto out = OutputFile::open(directory.path("picture"), error);
    EXPECT_TRUE(out) << error;
    EXPECT_TRUE(write_image(*out, image, format, Gamma::srgb, {}, error)) << error;
    EXPECT_TRUE(out->commit()) << out->error();
    return directory.read("picture");
}

TEST(WriteImage, EachCodedFormatIsToldApartWhenReadBack) {
    const Image image = test::random_image(7, 5, 1);
    for (const Format format : {Format::ppm, Format::png, Format::jpg}) {
        std::string error;
        const std::string file = written(image, format);
        const auto read = read_image(test::bytes_of(file), {}, error);
        ASSERT_TRUE(read) << error;
        EXPECT_EQ(read->width, image.width);
        EXPECT_EQ(read->height, image.height);
        if (format != Format::jpg) {
            EXPECT_EQ(read->pixels, image.pixels);
        }
        EXPECT_EQ(file.starts_with("P6"), format == Format::ppm);
    }
}

TEST(WriteImage, EachFormatBeginsWithItsOwnSignature) {
    const Image image = test::random_image(7, 5, 1);
    EXPECT_TRUE(written(image, Format::ppm).starts_with("P6\n"));
    EXPECT_TRUE(written(image, Format::png).starts_with("\x89PNG"));
    EXPECT_TRUE(written(image, Format::pfm).starts_with("PF\n"));
}

TEST(ReadImage, UnknownBytesAreRefused) {
    std::string error;
    EXPECT_FALSE(read_image(test::bytes_of("GIF89a"), {}, error));
    EXPECT_EQ(error, "this is not a PNG, JPEG, PPM, PFM, Radiance HDR or OpenEXR file");
}

}  // namespace
}  // namespace lray::image
