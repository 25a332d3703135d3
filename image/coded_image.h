// Pictures as files hold them: 8-bit codes, row 0 on top. A quarter of the size of linear pixels;
// textures are kept so.
#pragma once

#include <array>
#include <cstdint>
#include <span>
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

/// The linear values that the codes stand for as sRGB.
Image decode_srgb(const CodedImage& coded);

/// Returns the mean of the linear values of all pixels, the codes read as sRGB or as linear shares
/// of 255. Exact sums: the same on every processor.
Color mean_color(const CodedImage& coded, bool is_srgb);

}  // namespace lray::image
