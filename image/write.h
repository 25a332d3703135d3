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

namespace lray::image {

enum class Format : std::uint8_t { ppm, png, pfm };
inline constexpr std::array kFormats{Format::ppm, Format::png, Format::pfm};

/// Returns the format of that file extension or name ("png", "ppm", "pfm", any case); empty if
/// unknown.
std::optional<Format> find_format(std::string_view name);

/// Returns the name of a format, which is its file extension too.
std::string_view format_name(Format format);

/// Returns the extension of a path without its dot ("a/b.png" -> "png"), empty if it has none.
std::string_view extension(std::string_view path);

/// Keyword and text, stored in the file where the format can (PNG: iTXt or tEXt).
using Metadata = std::span<const std::pair<std::string, std::string>>;

/// Writes the picture, PPM and PNG as 8-bit sRGB, PFM as it is. The bytes depend on the arguments
/// alone: no time, no version. Errors: false, and `error` tells why in words.
bool write_image(OutputFile& out, const Image& image, Format format, Metadata metadata,
                 std::string& error);

}  // namespace lray::image
