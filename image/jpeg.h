// JPEG: photographs to read as textures, and small pictures to write.
#pragma once

#include <cstddef>
#include <cstdint>
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

inline constexpr std::uint32_t kMaxJpegSide = 65500;

/// Writes the picture in a JFIF file, the metadata as comments ("title: A room"). From a
/// quality of 90 on colours are as sharp as brightness, below half as sharp. No time is stored.
/// Asserts a picture of at least one pixel and a quality of 1 to 100.
/// Errors: false, and `error` tells why in words.
bool write_jpeg(OutputFile& out, const Image& image, Gamma gamma, Metadata metadata, int quality,
                std::string& error);

/// True if the file begins with the signature of a JPEG.
bool is_jpeg(std::span<const std::byte> file);

/// Reads a baseline or progressive JPEG, grey or in colour, as 8-bit RGB. Pictures in printing inks
/// (CMYK) are refused, as are damaged and truncated files, of which other programs show a part, and
/// more scans than pictures have. Notes of a camera on how it was held are not followed.
/// Errors: empty, and `error` tells why in words.
std::optional<CodedImage> read_jpeg(std::span<const std::byte> file, const ReadLimits& limits,
                                    std::string& error);

}  // namespace lray::image
