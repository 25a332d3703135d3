// Portable float maps: linear RGB as 32-bit floats, nothing clamped or encoded.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "base/output_file.h"
#include "image/image.h"
#include "image/read.h"

namespace lray::image {

/// Writes "PF\n<width> <height>\n-1.0\n" (little endian) and the rows from the bottom, each channel
/// with the bits it has. Asserts a picture of at least one pixel.
/// Errors: false; out.error() tells why.
/// Source: Debevec 2001, "PFM Portable FloatMap Image Format".
bool write_pfm(OutputFile& out, const Image& image);

/// True if the file begins like a PFM in colour or grey.
bool is_pfm(std::span<const std::byte> file);

/// Reads colours (PF) and greys (Pf) of either byte order, times the size of the scale that the
/// header gives; with a scale of 1 to the bit, whatever the values are.
/// Errors: empty, and `error` tells why in words.
std::optional<Image> read_pfm(std::span<const std::byte> file, const ReadLimits& limits,
                              std::string& error);

}  // namespace lray::image
