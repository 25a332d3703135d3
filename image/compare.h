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
    std::uint64_t beyond_count = 0;
    std::uint32_t worst_x = 0;  // the first pixel that differs by `max`
    std::uint32_t worst_y = 0;
    bool is_none =
        true;  // all pixels have the same bits, also those that no file of codes tells apart
};

/// Returns the difference of two pictures; empty if their sizes differ. Between pictures read from
/// 8-bit files differences are whole levels up to rounding: set the threshold between them, at 1.5
/// for "more than one level".
std::optional<Difference> compare(const Image& a, const Image& b, float threshold);

/// Returns a picture of the difference: black where there is none, blue where a pixel differs by
/// up to the threshold, the brighter the more, and beyond it from red to white, which is the worst.
/// Shape: asserts pictures of the same size.
Image difference_picture(const Image& a, const Image& b, float threshold);

}  // namespace lray::image
