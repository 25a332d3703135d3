// Decodes picture files: bounded before any memory is taken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "image/image.h"
#include "image/pixels.h"

namespace lray::image {

struct ReadLimits {
    std::uint64_t pixels = std::uint64_t{1} << 26;
    mutable bool is_exceeded = false;  // a picture was refused for its size

    /// Returns true if a picture of that size may be read; if not, `error` tells why in words.
    bool allow(std::uint32_t width, std::uint32_t height, std::string& error) const;
};

/// Decodes a picture file, its format told by its first bytes: PNG, JPEG, PPM and PGM to 8-bit
/// codes (those of 16 are rounded), PFM, Radiance HDR and OpenEXR to light. Errors: empty, and
/// `error` tells why in words. A picture beyond the limits is refused by its header.
std::optional<Pixels> read_pixels(std::span<const std::byte> file, const ReadLimits& limits,
                                  std::string& error);

/// Likewise, all to linear pixels: codes as sRGB, 16 bits as they are.
/// Errors: as read_pixels().
std::optional<Image> read_image(std::span<const std::byte> file, const ReadLimits& limits,
                                std::string& error);

}  // namespace lray::image
