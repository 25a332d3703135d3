// Radiance pictures (.hdr): light with a shared exponent, in 32 bits a pixel.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "image/image.h"
#include "image/read.h"

namespace lray::image {

/// True if the file begins like a Radiance picture.
bool is_hdr(std::span<const std::byte> file);

/// Reads a picture in RGB, packed in the old way, the new one or not at all, its rows in any order.
/// Its EXPOSURE and COLORCORR are undone, so that pixels are the light that was photographed.
/// Errors: empty, and `error` tells why in words; a picture in XYZ is refused.
/// Source: Ward 1991, "Real Pixels", Graphics Gems II; Radiance, "File Formats", picture files.
std::optional<Image> read_hdr(std::span<const std::byte> file, const ReadLimits& limits,
                              std::string& error);

}  // namespace lray::image
