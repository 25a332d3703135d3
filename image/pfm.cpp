#include "image/pfm.h"

#include <fmt/format.h>

#include <bit>
#include <span>

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

}  // namespace lray::image
