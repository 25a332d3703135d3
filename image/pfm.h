// Portable float maps: linear RGB as 32-bit floats, nothing clamped or encoded.
#pragma once

#include "base/output_file.h"
#include "image/image.h"

namespace lray::image {

/// Writes "PF\n<width> <height>\n-1.0\n" (little endian) and the rows from the bottom, each channel
/// with the bits it has. Asserts a picture of at least one pixel.
/// Errors: false; out.error() tells why.
/// Source: Debevec 2001, "PFM Portable FloatMap Image Format".
bool write_pfm(OutputFile& out, const Image& image);

}  // namespace lray::image
