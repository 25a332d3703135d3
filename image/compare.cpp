#include "image/compare.h"

#include <algorithm>
#include <cmath>

#include "image/srgb.h"

namespace lray::image {

namespace {

float level_difference(float a, float b) {
    if (std::isnan(a) != std::isnan(b)) return 255.0f;
    return 255.0f * std::fabs(srgb_encode(a) - srgb_encode(b));
}

}  // namespace

std::optional<Difference> compare(const Image& a, const Image& b, float threshold) {
    if (a.width != b.width || a.height != b.height) return std::nullopt;
    Difference result;
    double square_sum = 0.0;
    std::size_t beyond_count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        float pixel_max = 0.0f;
        for (int channel = 0; channel < 3; ++channel) {
            const float difference = level_difference(a.pixels[i][channel], b.pixels[i][channel]);
            pixel_max = std::max(pixel_max, difference);
            square_sum += static_cast<double>(difference) * static_cast<double>(difference);
        }
        result.max = std::max(result.max, pixel_max);
        if (pixel_max > threshold) ++beyond_count;
    }
    if (a.pixels.empty()) return result;
    const auto pixel_count = static_cast<double>(a.pixels.size());
    result.rms = std::sqrt(square_sum / (3.0 * pixel_count));
    result.share_beyond = static_cast<double>(beyond_count) / pixel_count;
    return result;
}

}  // namespace lray::image
