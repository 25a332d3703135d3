// Portable pixmaps, binary (P6) with 8 bits a channel.
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

/// Reads a P6 picture with a maximum of 255; comments in the header are skipped.
/// Errors: empty, and `error` tells why in words.
std::optional<CodedImage> read_ppm(std::span<const std::byte> file, const ReadLimits& limits,
                                   std::string& error);

}  // namespace lray::image
