// What every fuzzer of pictures asks of a reader.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "base/assert.h"
#include "image/read.h"

namespace lray::fuzz {

/// So few that any picture is read in milliseconds.
inline constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 16;

/// Reads the bytes as a picture: it has the pixels it says, or there is a reason in words.
inline void read_picture(std::span<const std::byte> file) {
    const image::ReadLimits limits{kMaxPixels};
    std::string error;
    const auto pixels = image::read_pixels(file, limits, error);
    LRAY_ASSERT(pixels.has_value() == error.empty());
    if (!pixels) return;
    const std::size_t count = std::size_t{image::width_of(*pixels)} * image::height_of(*pixels);
    LRAY_ASSERT(count > 0 && count <= kMaxPixels);
    if (const auto* const coded = std::get_if<image::CodedImage>(&*pixels)) {
        LRAY_ASSERT(coded->rgb.size() == 3 * count);
        return;
    }
    image::Image light = std::get<image::Image>(*pixels);
    LRAY_ASSERT(light.pixels.size() == count);
    image::mend_light(light);
    for (const Color& pixel : light.pixels) {
        for (int i = 0; i < 3; ++i) {
            LRAY_ASSERT(pixel[i] >= 0.0f && pixel[i] <= image::kMostPictureLight);
        }
    }
}

}  // namespace lray::fuzz
