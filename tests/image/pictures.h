// Pictures to write and read back.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "image/image.h"
#include "image/srgb.h"
#include "tests/support/random.h"

namespace lray::test {

/// Every pixel is a colour that 8 bits hold exactly.
inline image::Image random_image(std::uint32_t width, std::uint32_t height, std::uint64_t seed) {
    Random random(seed);
    image::Image picture(width, height);
    const auto channel = [&] {
        return image::srgb_decode_8(static_cast<std::uint8_t>(random.below(256)));
    };
    for (Color& pixel : picture.pixels) {
        pixel.r = channel();
        pixel.g = channel();
        pixel.b = channel();
    }
    return picture;
}

inline std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

}  // namespace lray::test
