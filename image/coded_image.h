// Pictures as files hold them: codes of 8 or 16 bits, row 0 on top. Codes of 8 bits are a quarter
// of the size of linear pixels; textures are kept so.
#pragma once

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

#include "image/image.h"

namespace lray::image {

/// Shape: rgb.size() == 3 * width * height, R G B R G B ... row by row from the top left.
struct CodedImage {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> rgb{};

    std::array<std::uint8_t, 3> at(std::uint32_t x, std::uint32_t y) const {
        LRAY_DCHECK(x < width && y < height);
        const std::size_t first = 3 * (std::size_t{y} * width + x);
        return {rgb[first], rgb[first + 1], rgb[first + 2]};
    }
};

/// Codes of 16 bits: shares of 65535. Shape: as CodedImage.
struct DeepImage {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint16_t> rgb{};
};

using Codes = std::variant<CodedImage, DeepImage>;

/// The linear values that the codes stand for as sRGB.
Image decode_srgb(const CodedImage& coded);
Image decode_srgb(const DeepImage& deep);

/// Returns the picture with each code rounded to the nearest of 8 bits.
CodedImage rounded_to_8(const DeepImage& deep);

/// Returns the mean of the linear values of all pixels, the codes read as sRGB or as linear shares
/// of 255. Exact sums: the same on every processor.
Color mean_color(const CodedImage& coded, bool is_srgb);

}  // namespace lray::image
