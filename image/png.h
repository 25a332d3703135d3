// Portable Network Graphics: RGB of 8 or 16 bits, marked as sRGB or as linear.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "base/output_file.h"
#include "image/coded_image.h"
#include "image/image.h"
#include "image/read.h"
#include "image/tone_map.h"
#include "image/write.h"

namespace lray::image {

/// Writes the picture with an sRGB chunk (or of linear codes a gAMA of 1) and the metadata as tEXt
/// (ASCII) or iTXt (other UTF-8). Keywords begin with a capital letter there and are cut to the 79
/// characters the format allows. No time is stored. Asserts a picture of at least one pixel.
/// Errors: false, and `error` tells why in words.
bool write_png(OutputFile& out, const Image& image, Gamma gamma, Metadata metadata,
               std::string& error, PngBits bits = PngBits::eight);

/// True if the file begins with the signature of a PNG.
bool is_png(std::span<const std::byte> file);

/// Reads any PNG as RGB, of 16 bits if it has so many, else of 8: palettes are looked up, greys
/// spread, transparency dropped. Text and colour profiles are skipped, not unpacked.
/// Errors: empty, and `error` tells why in words; also for damage that others read over.
std::optional<Codes> read_png(std::span<const std::byte> file, const ReadLimits& limits,
                              std::string& error);

}  // namespace lray::image
