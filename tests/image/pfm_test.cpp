#include "image/pfm.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>

#include "tests/image/pictures.h"
#include "tests/support/temp_directory.h"

namespace lray::image {
namespace {

std::string pfm_bytes(const Image& image) {
    const test::TempDirectory directory;
    std::string error;
    auto out = OutputFile::open(directory.path("a.pfm"), error);
    EXPECT_TRUE(out) << error;
    EXPECT_TRUE(write_pfm(*out, image)) << out->error();
    EXPECT_TRUE(out->commit()) << out->error();
    return directory.read("a.pfm");
}

/// The bits of the float that begins at a byte, read as little endian on any machine.
std::uint32_t bits_at(std::string_view file, std::size_t at) {
    std::uint32_t bits = 0;
    for (std::size_t i = 4; i-- > 0;) bits = bits << 8 | static_cast<std::uint8_t>(file.at(at + i));
    return bits;
}

TEST(PfmWrite, KnownPictureGivesKnownBytesBottomRowFirst) {
    Image image(2, 2);
    image.at(0, 0) = {1.0f, 0.0f, 0.0f};
    image.at(1, 0) = {0.0f, 0.5f, 0.0f};
    image.at(0, 1) = {0.0f, 0.0f, 2.0f};
    image.at(1, 1) = {-1.0f, 0.0f, 0.0f};
    using namespace std::string_literals;
    const std::string zero = "\0\0\0\0"s;
    EXPECT_EQ(pfm_bytes(image), "PF\n2 2\n-1.0\n"s +                 //
                                    zero + zero + "\0\0\0\x40"s +    // bottom left
                                    "\0\0\x80\xbf"s + zero + zero +  //
                                    "\0\0\x80\x3f"s + zero + zero +  // top left
                                    zero + "\0\0\0\x3f"s + zero);
}

TEST(PfmWrite, NothingIsClampedRoundedOrEncoded) {
    using Limits = std::numeric_limits<float>;
    Image image(2, 1);
    image.at(0, 0) = {Limits::max(), Limits::denorm_min(), -0.0f};
    image.at(1, 0) = {Limits::infinity(), Limits::quiet_NaN(), 0.1f};
    const std::string file = pfm_bytes(image);
    constexpr std::string_view kHeader = "PF\n2 1\n-1.0\n";
    ASSERT_EQ(file.size(), kHeader.size() + 2 * 12);
    for (std::size_t i = 0; i < 6; ++i) {
        const Color& pixel = image.pixels[i / 3];
        const float channel = i % 3 == 0 ? pixel.r : i % 3 == 1 ? pixel.g : pixel.b;
        EXPECT_EQ(bits_at(file, kHeader.size() + 4 * i), std::bit_cast<std::uint32_t>(channel))
            << i;
    }
}

TEST(PfmWrite, RowsOfAPictureThatIsNotSquareStayWhole) {
    Image image(3, 2);
    for (std::uint32_t y = 0; y < 2; ++y) {
        for (std::uint32_t x = 0; x < 3; ++x) {
            image.at(x, y) = Color(static_cast<float>(10 * y + x));
        }
    }
    const std::string file = pfm_bytes(image);
    constexpr std::string_view kHeader = "PF\n3 2\n-1.0\n";
    EXPECT_TRUE(file.starts_with(kHeader));
    const float expected[] = {10, 11, 12, 0, 1, 2};
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(std::bit_cast<float>(bits_at(file, kHeader.size() + 12 * i)), expected[i]) << i;
    }
}

TEST(PfmWrite, FullDiskIsTold) {
    std::string error;
    auto out = OutputFile::open("/dev/full", error);
    ASSERT_TRUE(out) << error;
    EXPECT_FALSE(write_pfm(*out, Image(64, 64)) && out->commit());
    EXPECT_FALSE(out->error().empty());
}

std::string read_error(std::string_view file, ReadLimits limits = {}) {
    std::string error;
    EXPECT_FALSE(read_pfm(test::bytes_of(file), limits, error));
    return error;
}

TEST(PfmRead, EveryBitReadsBack) {
    test::Random random(61);
    Image image(31, 17);
    for (Color& pixel : image.pixels) {
        for (int i = 0; i < 3; ++i) {
            pixel[i] = std::bit_cast<float>(static_cast<std::uint32_t>(random.below(1ull << 32)));
        }
    }
    std::string error;
    const auto read = read_pfm(test::bytes_of(pfm_bytes(image)), {}, error);
    ASSERT_TRUE(read) << error;
    ASSERT_EQ(read->width, 31u);
    ASSERT_EQ(read->height, 17u);
    EXPECT_EQ(0, std::memcmp(read->pixels.data(), image.pixels.data(),
                             image.pixels.size() * sizeof(Color)));
}

TEST(PfmRead, EitherByteOrderGreysAndScale) {
    using namespace std::string_literals;
    std::string error;
    const auto read =
        read_pfm(test::bytes_of("Pf\n1 2\n2.0\n\x3f\x80\0\0\xc0\0\0\0"s), {}, error);  // 1, -2
    ASSERT_TRUE(read) << error;
    EXPECT_EQ(read->at(0, 1), Color{2.0f});  // rows from the bottom
    EXPECT_EQ(read->at(0, 0), Color{-4.0f});
    const auto little = read_pfm(test::bytes_of("Pf\n1 1\n-1\n\0\0\x80\x3f"s), {}, error);
    ASSERT_TRUE(little) << error;
    EXPECT_EQ(little->at(0, 0), Color{1.0f});
}

TEST(PfmRead, BrokenFilesAreRefusedInWords) {
    EXPECT_EQ(read_error("P6"), "this is not a PFM file");
    EXPECT_EQ(read_error("PF\n1 1"), "the PFM header needs a width, a height and a scale");
    EXPECT_EQ(read_error("PF\n0 1 -1\n"), "the PFM header needs a width, a height and a scale");
    for (const char* scale : {"0", "inf", "nan", "-inf"}) {
        EXPECT_EQ(read_error("PF\n1 1\n" + std::string(scale) + "\nabcdabcdabcd"),
                  "the scale of the PFM is 0 or not finite; -1 is usual");
    }
    EXPECT_EQ(read_error("PF\n2 1\n-1\nabc"), "the PFM file ends early: 3 of 24 bytes of pixels");
    EXPECT_EQ(read_error("PF\n4294967295 4294967295\n-1\nabc"),
              "4294967295 x 4294967295 pixels are more than the limit of 67108864");
}

}  // namespace
}  // namespace lray::image
