#include "image/exr.h"

#include <gtest/gtest.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfTiledOutputFile.h>
#include <fmt/format.h>
#include <half.h>

#include <bit>
#include <cstring>
#include <limits>

#include "tests/image/pictures.h"
#include "tests/image/written.h"

namespace lray::image {
namespace {

using test::bytes_of;
using test::written;

std::string read_error(std::string_view file, ReadLimits limits = {}) {
    std::string error;
    EXPECT_FALSE(read_exr(bytes_of(file), limits, error));
    return error;
}

Image read_right(std::string_view file) {
    std::string error;
    const auto image = read_exr(bytes_of(file), {}, error);
    EXPECT_TRUE(image) << error;
    return image.value_or(Image(1, 1));
}

Image random_bits(std::uint32_t width, std::uint32_t height, std::uint64_t seed) {
    test::Random random(seed);
    Image image(width, height);
    for (Color& pixel : image.pixels) {
        for (int i = 0; i < 3; ++i) {
            pixel[i] = std::bit_cast<float>(static_cast<std::uint32_t>(random.below(1ull << 32)));
        }
    }
    return image;
}

bool has_same_bits(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height &&
           std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(Color)) == 0;
}

class Bytes final : public Imf::OStream {
 public:
    Bytes() : Imf::OStream("test") {}
    void write(const char bytes[], int count) override {
        const auto size = static_cast<std::size_t>(count);
        text.resize(std::max(text.size(), at_ + size));
        std::copy_n(bytes, size, text.begin() + static_cast<std::ptrdiff_t>(at_));
        at_ += size;
    }
    std::uint64_t tellp() override { return at_; }
    void seekp(std::uint64_t at) override { at_ = at; }

    std::string text{};

 private:
    std::size_t at_ = 0;
};

struct Recipe {
    Imf::Compression compression = Imf::NO_COMPRESSION;
    bool is_half = true;
    std::uint32_t tile = 0;  // its side; 0: scan lines
    std::vector<std::string> channels{"R", "G", "B"};
    int x_sampling = 1;
};

constexpr int kWidth = 19;
constexpr int kHeight = 37;

/// Pixel x, y, in the order from the first: x + 100 y; channels add a quarter each.
float value_at(int x, int y, std::size_t channel) {
    return static_cast<float>(x + 64 * y) * 0.25f + 16.0f * static_cast<float>(channel);
}

std::string foreign_exr(const Recipe& recipe) {
    const Imath::Box2i window({-5, 11}, {-5 + kWidth - 1, 11 + kHeight - 1});
    Imf::Header header(window, window);
    header.compression() = recipe.compression;
    const Imf::PixelType type = recipe.is_half ? Imf::HALF : Imf::FLOAT;
    Imf::FrameBuffer buffer;
    std::vector<std::vector<float>> floats(recipe.channels.size());
    std::vector<std::vector<Imath::half>> halves(recipe.channels.size());
    for (std::size_t c = 0; c < recipe.channels.size(); ++c) {
        header.channels().insert(recipe.channels[c], Imf::Channel(type, recipe.x_sampling, 1));
        for (int i = 0; i < kWidth * kHeight; ++i) {
            floats[c].push_back(value_at(i % kWidth, i / kWidth, c));
            halves[c].push_back(Imath::half(floats[c].back()));
        }
        const std::size_t size = recipe.is_half ? sizeof(Imath::half) : sizeof(float);
        char* const first = recipe.is_half ? reinterpret_cast<char*>(halves[c].data())
                                           : reinterpret_cast<char*>(floats[c].data());
        const std::ptrdiff_t before =
            (static_cast<std::ptrdiff_t>(window.min.y) * kWidth + window.min.x) *
            static_cast<std::ptrdiff_t>(size);
        buffer.insert(recipe.channels[c],
                      Imf::Slice(type, first - before, size, size * kWidth, recipe.x_sampling, 1));
    }
    Bytes bytes;
    if (recipe.tile > 0) {
        header.setTileDescription(Imf::TileDescription(recipe.tile, recipe.tile));
        Imf::TiledOutputFile file(bytes, header, 0);
        file.setFrameBuffer(buffer);
        file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    } else {
        Imf::OutputFile file(bytes, header, 0);
        file.setFrameBuffer(buffer);
        file.writePixels(kHeight);
    }
    return bytes.text;
}

void expect_values(const Image& image, bool is_grey = false) {
    ASSERT_EQ(image.width, static_cast<unsigned>(kWidth));
    ASSERT_EQ(image.height, static_cast<unsigned>(kHeight));
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            for (int c = 0; c < 3; ++c) {
                const std::size_t channel = is_grey ? 0 : static_cast<std::size_t>(c);
                ASSERT_EQ(image.at(static_cast<unsigned>(x), static_cast<unsigned>(y))[c],
                          static_cast<float>(Imath::half(value_at(x, y, channel))))
                    << x << ' ' << y;
            }
        }
    }
}

TEST(ExrWrite, EveryBitReadsBack) {
    for (const auto& [width, height] : {std::pair{1u, 1u}, {61u, 47u}, {3u, 33u}}) {
        const Image image = random_bits(width, height, 41);
        EXPECT_TRUE(has_same_bits(read_right(written(image, Format::exr)), image));
    }
}

TEST(ExrWrite, TheWidestPictureReadsBack) {
    const Image image(1 << 20, 17);
    EXPECT_TRUE(has_same_bits(read_right(written(image, Format::exr)), image));
}

TEST(ExrWrite, MetadataIsAttributesAndBytesDependOnTheArgumentsAlone) {
    const test::Texts metadata{
        {"title", "Zo\xc3\xab"}, {"channels", "no1"}, {"version", "no2"}, {"", "x"}};
    const Image image = random_bits(5, 4, 42);
    const std::string file = written(image, Format::exr, metadata);
    EXPECT_EQ(file, written(image, Format::exr, metadata));
    using namespace std::string_literals;
    EXPECT_NE(file.find("title\0string\0\4\0\0\0Zo\xc3\xab"s), std::string::npos);
    for (const char* word : {"capDate", "utcOffset", "no1", "no2"}) {
        EXPECT_EQ(file.find(word), std::string::npos) << word;
    }
    EXPECT_TRUE(has_same_bits(read_right(file), image));
}

TEST(ExrWrite, FullDiskIsAnErrorInWords) {
    std::string error;
    auto out = OutputFile::open("/dev/full", error);
    ASSERT_TRUE(out) << error;
    const bool is_written =
        write_exr(*out, test::random_image(300, 300, 43), {}, error) && out->commit();
    EXPECT_FALSE(is_written);
    EXPECT_NE((error.empty() ? out->error() : error).find("space"), std::string::npos) << error;
}

TEST(ExrRead, EveryPackingInLinesAndTilesWithAWindowAwayFromTheOrigin) {
    for (const Imf::Compression compression :
         {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
          Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION}) {
        for (const std::uint32_t tile : {0u, 8u, 64u}) {
            expect_values(read_right(foreign_exr({compression, true, tile, {"R", "G", "B"}})));
            if (compression == Imf::PXR24_COMPRESSION) continue;  // drops bits of floats
            const Image image =
                read_right(foreign_exr({compression, false, tile, {"R", "G", "B"}}));
            EXPECT_EQ(image.at(18, 36).b, value_at(18, 36, 2));
        }
    }
}

TEST(ExrRead, GreyAndOtherChannelsBesideColours) {
    expect_values(read_right(foreign_exr({Imf::ZIP_COMPRESSION, true, 0, {"Y"}})), true);
    expect_values(
        read_right(foreign_exr({Imf::ZIP_COMPRESSION, true, 0, {"R", "G", "B", "A", "Z"}})));
}

TEST(ExrRead, KindsThatAreNotReadAreToldInWords) {
    EXPECT_EQ(read_error(foreign_exr({Imf::DWAA_COMPRESSION})),
              "it is packed by DWA, which processors unpack to different bits; save it with ZIP or "
              "PIZ");
    EXPECT_EQ(read_error(foreign_exr({Imf::ZIP_COMPRESSION, true, 0, {"Z"}})),
              "it has no channels R, G and B, and no Y");
    EXPECT_EQ(read_error(foreign_exr({Imf::ZIP_COMPRESSION, true, 0, {"Y", "RY", "BY"}})),
              "its colours are brightness and differences; save it as RGB");
    std::string file = foreign_exr({});
    file[5] |= 0x10;
    EXPECT_EQ(read_error(file), "it has several parts; save one alone");
    file[5] |= 0x08;
    EXPECT_EQ(read_error(file),
              "it is a deep picture, with several depths in a pixel; save it flat");
    std::vector<std::string> many;
    for (int i = 0; i < 70; ++i) many.push_back(fmt::format("a{}", i));
    EXPECT_EQ(read_error(foreign_exr({Imf::ZIP_COMPRESSION, true, 0, many})),
              "it has more than 64 channels; save its colours alone");
    EXPECT_EQ(read_error("P6"), "this is not an OpenEXR file");
}

/// The file with another data window.
std::string with_window(std::string file, std::array<std::int32_t, 4> window) {
    const std::string name("dataWindow\0box2i\0", 17);
    const std::size_t at = file.find(name) + name.size() + 4;
    std::memcpy(file.data() + at, window.data(), sizeof window);
    return file;
}

TEST(ExrRead, SizesAreCheckedBeforeTheLibrarySeesThem) {
    const std::string file = foreign_exr({});
    EXPECT_EQ(read_error(with_window(file, {0, 0, 99'999, 99'999})),
              "100000 x 100000 pixels are more than the limit of 67108864");
    EXPECT_EQ(read_error(file, {702}), "19 x 37 pixels are more than the limit of 702");
    const int low = std::numeric_limits<std::int32_t>::min();
    const int high = std::numeric_limits<std::int32_t>::max();
    for (const auto& window : {std::array{low, 0, high, 1}, {0, high, 0, high}, {5, 0, 4, 0}}) {
        EXPECT_EQ(read_error(with_window(file, window)),
                  "the header of the OpenEXR file is damaged");
    }
    // More lines than the file has room to say where they are.
    const std::string large =
        "its lines or tiles are larger than a picture of its size needs, or "
        "the OpenEXR file ends early";
    EXPECT_EQ(read_error(with_window(file, {0, 0, 0, 60'000'000})), large);
    std::string tiled = foreign_exr({Imf::NO_COMPRESSION, true, 8});
    const std::string name("tiles\0tiledesc\0", 15);
    const std::size_t at = tiled.find(name) + name.size() + 4;
    for (const std::uint32_t side : {0u, 1u << 30}) {
        std::memcpy(tiled.data() + at, &side, sizeof side);
        EXPECT_EQ(read_error(tiled), large);
    }
}

}  // namespace
}  // namespace lray::image
