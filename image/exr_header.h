// Looks through the header of an OpenEXR file before the library does: it would take the memory
// that sizes in it ask for.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "image/read.h"

namespace lray::image {

/// A part of what the header says.
struct ExrHeader {
    std::array<std::int32_t, 2> first{};  // of the data window: x, y
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::array<std::string, 3> channels{};  // those to be read: R, G, B, or Y three times
};

/// True if the file begins with the signature of an OpenEXR file.
bool is_exr(std::span<const std::byte> file);

/// Returns the header of a picture that may be read.
/// Errors: empty, and `error` tells why in words: a damaged header, sizes beyond the limits or
/// beyond what the file can hold, and kinds that are not read.
std::optional<ExrHeader> read_exr_header(std::span<const std::byte> file, const ReadLimits& limits,
                                         std::string& error);

}  // namespace lray::image
