// Pictures in memory: linear float pixels, row 0 on top.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/assert.h"
#include "base/vec.h"

namespace lray::image {

/// Linear RGB. Shape: pixels.size() == width * height, row by row from the top left.
struct Image {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<Color> pixels{};

    Image() = default;
    Image(std::uint32_t width_pixels, std::uint32_t height_pixels)
        : width(width_pixels),
          height(height_pixels),
          pixels(std::size_t{width_pixels} * height_pixels, Color{0.0f}) {}

    Color& at(std::uint32_t x, std::uint32_t y) {
        LRAY_DCHECK(x < width && y < height);
        return pixels[std::size_t{y} * width + x];
    }
    const Color& at(std::uint32_t x, std::uint32_t y) const {
        LRAY_DCHECK(x < width && y < height);
        return pixels[std::size_t{y} * width + x];
    }
};

}  // namespace lray::image
