// OpenEXR: light in floats, with names and notes. What lray is built without OpenEXR says so
// (no_exr.cpp); the library itself is known to exr.cpp alone.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "base/output_file.h"
#include "image/exr_header.h"
#include "image/image.h"
#include "image/read.h"
#include "image/write.h"

namespace lray::image {

/// False if lray was built without OpenEXR.
bool is_exr_built();

/// Writes R, G and B as 32-bit floats with the bits they have, in scan lines packed by ZIP, the
/// metadata as string attributes. No time is stored. Asserts a picture of at least one pixel.
/// Errors: false, and `error` tells why in words.
bool write_exr(OutputFile& out, const Image& image, Metadata metadata, std::string& error);

/// Reads a picture in scan lines or tiles, its colours R, G and B, or Y alone as grey, as floats or
/// halves. Of tiles in several sizes the largest counts. What lies outside of the data window is
/// left out.
/// Errors: empty, and `error` tells why in words. Deep pictures, several parts, brightness with
/// colour differences, and DWA, which is not unpacked to the same bits on every processor, are
/// refused.
std::optional<Image> read_exr(std::span<const std::byte> file, const ReadLimits& limits,
                              std::string& error);

}  // namespace lray::image
