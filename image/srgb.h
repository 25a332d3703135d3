// The sRGB transfer functions (IEC 61966-2-1) and quantisation. The only place that knows sRGB.
#pragma once

#include <cstdint>
#include <span>

#include "base/vec.h"
#include "image/tone_map.h"

namespace lray::image {

/// Linear [0, 1] to encoded [0, 1]; clamps what is outside, NaN becomes 0.
float srgb_encode(float linear);

/// The derivative of srgb_encode() in [0, 1], clamped likewise.
float srgb_slope(float linear);

/// Encoded [0, 1] to linear [0, 1], in double precision and the same on every processor; clamps
/// what is outside, NaN becomes 0.
double srgb_decode(double encoded);

/// Encoded sRGB in 8 bits, rounded to nearest.
std::uint8_t srgb_encode_8(float linear);

/// A linear value in 8 bits as it is, rounded to nearest; clamps, NaN becomes 0.
std::uint8_t linear_encode_8(float linear);

/// Encoded sRGB in 16 bits, and a linear value as it is: of the exact value times 65535 the nearest
/// whole number. Both clamp; NaN becomes 0.
std::uint16_t srgb_encode_16(float linear);
std::uint16_t linear_encode_16(float linear);

/// The linear value that the code stands for.
float srgb_decode_8(std::uint8_t code);
float srgb_decode_16(std::uint16_t code);

/// Encodes a row of pixels as bytes R G B R G B ...
/// Shape: bytes.size() == 3 * pixels.size().
void encode_row(std::span<const Color> pixels, Gamma gamma, std::span<std::uint8_t> bytes);

/// Encodes a row in 16 bits, the higher byte of each code first.
/// Shape: bytes.size() == 6 * pixels.size().
void encode_row_16(std::span<const Color> pixels, Gamma gamma, std::span<std::uint8_t> bytes);

/// Decodes bytes R G B R G B ... into linear pixels. Shape: as encode_row().
void srgb_decode_row(std::span<const std::uint8_t> bytes, std::span<Color> pixels);

}  // namespace lray::image
