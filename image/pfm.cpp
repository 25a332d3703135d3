#include "image/pfm.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>

#include "image/netpbm_header.h"

namespace lray::image {

// Rows are handed over as they are in memory.
static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Color) == 3 * sizeof(float));

bool write_pfm(OutputFile& out, const Image& image) {
    LRAY_ASSERT(image.width > 0 && image.height > 0);
    if (!out.write(fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height))) return false;
    const std::span pixels(image.pixels);
    for (std::size_t y = image.height; y-- > 0;) {
        if (!out.write(std::as_bytes(pixels.subspan(y * image.width, image.width)))) return false;
    }
    return true;
}

bool is_pfm(std::span<const std::byte> file) {
    return file.size() >= 2 && file[0] == std::byte{'P'} &&
           (file[1] == std::byte{'F'} || file[1] == std::byte{'f'});
}

std::optional<Image> read_pfm(std::span<const std::byte> file, const ReadLimits& limits,
                              std::string& error) {
    if (!is_pfm(file)) {
        error = "this is not a PFM file";
        return std::nullopt;
    }
    NetpbmHeader header(file);
    header.skip_magic();
    const auto width = header.take_number<std::uint32_t>();
    const auto height = header.take_number<std::uint32_t>();
    const auto scale = header.take_number<float>();
    const auto bytes = header.take_pixels();
    if (!width || !height || !scale || !bytes || *width == 0 || *height == 0) {
        error = "the PFM header needs a width, a height and a scale";
        return std::nullopt;
    }
    if (!std::isfinite(*scale) || *scale == 0.0f) {
        error = "the scale of the PFM is 0 or not finite; -1 is usual";
        return std::nullopt;
    }
    if (!limits.allow(*width, *height, error)) return std::nullopt;
    const std::uint64_t channel_count = file[1] == std::byte{'F'} ? 3 : 1;
    const std::uint64_t needed = sizeof(float) * channel_count * *width * *height;
    if (bytes->size() < needed) {
        error =
            fmt::format("the PFM file ends early: {} of {} bytes of pixels", bytes->size(), needed);
        return std::nullopt;
    }
    const bool is_swapped = *scale > 0.0f;
    const float factor = std::fabs(*scale);
    const char* at = bytes->data();
    const auto take_float = [&] {
        std::uint32_t bits = 0;
        std::memcpy(&bits, at, sizeof bits);
        at += sizeof bits;
        if (is_swapped) bits = __builtin_bswap32(bits);
        const float value = std::bit_cast<float>(bits);
        return factor == 1.0f ? value : factor * value;
    };
    Image image(*width, *height);
    for (std::uint32_t y = *height; y-- > 0;) {
        for (std::uint32_t x = 0; x < *width; ++x) {
            Color& pixel = image.at(x, y);
            pixel.r = take_float();
            pixel.g = channel_count == 3 ? take_float() : pixel.r;
            pixel.b = channel_count == 3 ? take_float() : pixel.r;
        }
    }
    return image;
}

}  // namespace lray::image
