// Decodes picture files: bounded before any memory is taken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "image/coded_image.h"
#include "image/image.h"

namespace lray::image {

struct ReadLimits {
    std::uint64_t pixels = std::uint64_t{1} << 26;
    mutable bool is_exceeded = false;  // a picture was refused for its size

    /// Returns true if a picture of that size may be read; if not, `error` tells why in words.
    bool allow(std::uint32_t width, std::uint32_t height, std::string& error) const;
};

/// Decodes a PPM, PNG or JPEG file, told apart by its first bytes, to 8-bit codes.
/// Errors: empty, and `error` tells why in words. A picture beyond the limits is refused by its
/// header.
std::optional<CodedImage> read_coded_image(std::span<const std::byte> file,
                                           const ReadLimits& limits, std::string& error);

/// Likewise, to linear pixels.
/// Errors: empty, and `error` tells why in words.
std::optional<Image> read_image(std::span<const std::byte> file, const ReadLimits& limits,
                                std::string& error);

}  // namespace lray::image
