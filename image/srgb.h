// The sRGB transfer functions (IEC 61966-2-1) and quantisation.
#pragma once

#include <cstdint>

namespace lray::image {

/// Linear [0, 1] to encoded [0, 1]; clamps what is outside, NaN becomes 0.
float srgb_encode(float linear);

/// Encoded [0, 1] to linear [0, 1].
double srgb_decode(double encoded);

/// Encoded sRGB in 8 bits, rounded to nearest.
std::uint8_t srgb_encode_8(float linear);

}  // namespace lray::image
