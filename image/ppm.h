// Portable pixmaps: written in binary (P6) with 8 bits a channel, read in all kinds with levels.
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

namespace lray::image {

/// Writes "P6\n<width> <height>\n255\n" and the rows from the top. Asserts a picture of at least
/// one pixel.
/// Errors: false; out.error() tells why.
bool write_ppm(OutputFile& out, const Image& image, Gamma gamma);

/// True if the file begins like a PPM or PGM.
bool is_ppm(std::span<const std::byte> file);

/// Reads colours (P6, P3) and greys (P5, P2), binary or in decimal numbers. A maximum to 255 is
/// spread to 8 bits, one to 65535 to 16; comments are skipped.
/// Errors: empty, and `error` tells why in words.
std::optional<Codes> read_ppm(std::span<const std::byte> file, const ReadLimits& limits,
                              std::string& error);

}  // namespace lray::image
