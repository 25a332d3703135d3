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

enum class Format : std::uint8_t { ppm, png, jpg, pfm, exr };
inline constexpr std::array kFormats{Format::ppm, Format::png, Format::jpg, Format::pfm,
                                     Format::exr};

/// Returns the format of that file extension or name ("png", "jpg", "jpeg", any case); empty
/// if unknown.
std::optional<Format> find_format(std::string_view name);

/// Returns the name of a format, which is its file extension too.
std::string_view format_name(Format format);

/// True for formats that hold the light itself, as floats, without exposure and tone map.
bool holds_light(Format format);

/// Returns how many pixels wide and high a picture of that format may be; empty if there is more
/// room than pixels.
std::optional<std::uint32_t> max_side(Format format);

/// False for a format whose library lray was built without.
bool is_built(Format format);

/// Returns the extension of a path without its dot ("a/b.png" -> "png"), empty if it has none.
std::string_view extension(std::string_view path);

/// Keyword and text, stored in the file where the format can (PNG: iTXt or tEXt; JPEG: comments;
/// EXR: attributes).
using Metadata = std::span<const std::pair<std::string, std::string>>;

enum class PngBits : std::uint8_t { eight, sixteen };

/// How the picture is written in a format; each regards its own.
struct WriteSettings {
    int jpeg_quality = 90;  // 1 to 100
    PngBits png_bits = PngBits::eight;
};

/// Writes the picture, PFM and EXR as it is, the others in codes. The bytes depend on the arguments
/// alone: no time, no version.
/// Errors: false, and `error` tells why in words. Asserts a format that is_built().
bool write_image(OutputFile& out, const Image& image, Format format, Gamma gamma, Metadata metadata,
                 std::string& error, const WriteSettings& settings = {});

}  // namespace lray::image
