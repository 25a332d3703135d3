// What is kept of a picture file: the codes that it held, or linear light.
#pragma once

#include <cstdint>
#include <variant>

#include "image/coded_image.h"
#include "image/image.h"

namespace lray::image {

/// Codes of 8 bits take a quarter of the memory; light in floats has no white to end at.
using Pixels = std::variant<CodedImage, Image>;

std::uint32_t width_of(const Pixels& pixels);
std::uint32_t height_of(const Pixels& pixels);

/// Returns the mean of the linear values of all pixels, codes read as sRGB or as linear shares of
/// 255; light is linear, whatever is said. In one order: the same on every processor.
Color mean_color(const Pixels& pixels, bool is_srgb);

/// No light in a picture is brighter; the sun in photographs of the sky is near 1e6.
inline constexpr float kMostPictureLight = 1e9f;

/// Brings each channel into 0 to kMostPictureLight: what is negative or NaN to 0, what is infinite
/// or brighter to the most. Returns in how many pixels there was such a value.
std::uint64_t mend_light(Image& light);

}  // namespace lray::image
