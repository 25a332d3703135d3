// Encodes pictures into file formats.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "base/output_file.h"
#include "image/image.h"
#include "image/tone_map.h"

namespace lray::image {

enum class Format : std::uint8_t { ppm, png, jpg, pfm };
inline constexpr std::array kFormats{Format::ppm, Format::png, Format::jpg, Format::pfm};

/// Returns the format of that file extension or name ("png", "jpg", "jpeg", any case); empty
/// if unknown.
std::optional<Format> find_format(std::string_view name);

/// Returns the name of a format, which is its file extension too.
std::string_view format_name(Format format);

/// Returns the extension of a path without its dot ("a/b.png" -> "png"), empty if it has none.
std::string_view extension(std::string_view path);

/// Keyword and text, stored in the file where the format can (PNG: iTXt or tEXt; JPEG: comments).
using Metadata = std::span<const std::pair<std::string, std::string>>;

inline constexpr int kDefaultJpegQuality = 90;

/// Writes the picture, PFM as it is, the others in 8 bits. The bytes depend on the arguments alone:
/// no time, no version. `jpeg_quality`, 1 to 100, is regarded by JPEG only.
/// Errors: false, and `error` tells why in words.
bool write_image(OutputFile& out, const Image& image, Format format, Gamma gamma, Metadata metadata,
                 std::string& error, int jpeg_quality = kDefaultJpegQuality);

}  // namespace lray::image
