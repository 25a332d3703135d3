// A picture divided into squares: the tiles that threads take, and the blocks of a tile.
#pragma once

#include <algorithm>
#include <cstdint>

#include "render/options.h"

namespace lray::render {

/// A grid of squares over an area, those at its right and lower edge cut off.
struct Squares {
    PixelRect area{};
    std::uint32_t size = 1;

    std::uint64_t count() const {
        return std::uint64_t{along(area.width())} * along(area.height());
    }

    PixelRect at(std::uint64_t index) const {
        const std::uint32_t columns = along(area.width());
        const std::uint32_t x = static_cast<std::uint32_t>(index % columns) * size;
        const std::uint32_t y = static_cast<std::uint32_t>(index / columns) * size;
        return {area.x0 + x, area.y0 + y, area.x0 + std::min(x + size, area.width()),
                area.y0 + std::min(y + size, area.height())};
    }

 private:
    std::uint32_t along(std::uint32_t pixel_count) const {
        return pixel_count / size + (pixel_count % size != 0 ? 1 : 0);
    }
};

}  // namespace lray::render
