// How much two pictures differ.
#pragma once

#include <cstdint>
#include <optional>

#include "image/image.h"

namespace lray::image {

/// In levels: steps of 1/255 of the sRGB-encoded value, what an 8-bit file can tell apart. A NaN
/// differs from anything by 255 levels.
struct Difference {
    float max = 0.0f;           // over all pixels and channels
    double rms = 0.0;           // root of the mean square, over all pixels and channels
    double share_beyond = 0.0;  // of pixels with a channel that differs by more than the threshold
};

/// Returns the difference of two pictures; empty if their sizes differ. Between pictures read from
/// 8-bit files differences are whole levels up to rounding: set the threshold between them, at 1.5
/// for "more than one level".
std::optional<Difference> compare(const Image& a, const Image& b, float threshold);

}  // namespace lray::image
