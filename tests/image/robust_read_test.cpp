// Every reader on small files of its format that are cut and damaged in all places: a picture or a
// reason in words, and nothing else.
#include <gtest/gtest.h>

#include "image/exr.h"
#include "image/read.h"
#include "tests/image/pictures.h"
#include "tests/image/written.h"

namespace lray::image {
namespace {

using namespace std::string_literals;
using test::bytes_of;
using test::written;

struct Sample {
    std::string name{};
    std::string file{};
    std::size_t least = 0;  // bytes without which it is no picture
};

std::ostream& operator<<(std::ostream& out, const Sample& sample) {
    return out << sample.name;
}

std::vector<Sample> samples() {
    const Image image = test::random_image(9, 7, 51);
    std::vector<Sample> all;
    const auto add = [&](std::string name, std::string file, std::size_t tail = 0) {
        all.push_back({std::move(name), file, file.size() - tail});
    };
    add("ppm", written(image, Format::ppm));
    add("png", written(image, Format::png));
    add("png16", written(image, Format::png, {{"title", "a"}}, {.png_bits = PngBits::sixteen}));
    add("jpeg", written(image, Format::jpg));
    add("pfm", written(image, Format::pfm));
    if (is_exr_built()) add("exr", written(image, Format::exr, {{"title", "a"}}));
    add("decimal", "P3\n2 2\n15\n1 2 3 4 5 6 7 8 9 10 11 12"s, 1);
    add("deep", "P5\n2 1\n1000\n\1\2\3\xff"s);
    std::string hdr = "#?RADIANCE\nEXPOSURE=2\n\n-Y 2 +X 8\n";
    for (int line = 0; line < 2; ++line) {
        hdr += "\2\2\0\x08\x88\x40\x04zbcd\x84\x20\x88\x10\x87\x81\x01\x80"s;
    }
    add("hdr", hdr);
    return all;
}

class RobustRead : public testing::TestWithParam<Sample> {};

TEST_P(RobustRead, WholeFileIsRead) {
    std::string error;
    EXPECT_TRUE(read_pixels(bytes_of(GetParam().file), {}, error)) << error;
    EXPECT_EQ(error, "");
}

TEST_P(RobustRead, EveryTruncationIsRefusedInWords) {
    for (std::size_t size = 0; size < GetParam().least; ++size) {
        std::string error;
        EXPECT_FALSE(read_image(bytes_of(GetParam().file.substr(0, size)), {}, error)) << size;
        EXPECT_NE(error, "") << size;
    }
}

TEST_P(RobustRead, DamageIsRefusedInWordsOrReadAsPixels) {
    constexpr std::uint64_t kSeed = 52;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    const ReadLimits limits{std::uint64_t{1} << 16};
    int refused_count = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        std::string damaged = GetParam().file;
        for (std::uint64_t i = 0; i <= random.below(3); ++i) {
            damaged[random.below(damaged.size())] ^= static_cast<char>(1u << random.below(8));
        }
        std::string error;
        const auto image = read_image(bytes_of(damaged), limits, error);
        ASSERT_EQ(image.has_value(), error.empty());
        refused_count += image ? 0 : 1;
        if (!image) continue;
        ASSERT_EQ(image->pixels.size(), std::size_t{image->width} * image->height);
    }
    EXPECT_GT(refused_count, 10);
}

INSTANTIATE_TEST_SUITE_P(Formats, RobustRead, testing::ValuesIn(samples()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace lray::image
