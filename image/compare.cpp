#include "image/compare.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "image/srgb.h"

namespace lray::image {

namespace {

float level_difference(float a, float b) {
    if (std::isnan(a) != std::isnan(b)) return 255.0f;
    return 255.0f * std::fabs(srgb_encode(a) - srgb_encode(b));
}

/// The greatest of its channels.
float level_difference(const Color& a, const Color& b) {
    float greatest = 0.0f;
    for (int channel = 0; channel < 3; ++channel) {
        greatest = std::max(greatest, level_difference(a[channel], b[channel]));
    }
    return greatest;
}

}  // namespace

std::optional<Difference> compare(const Image& a, const Image& b, float threshold) {
    if (a.width != b.width || a.height != b.height) return std::nullopt;
    Difference result;
    double square_sum = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        float pixel_max = 0.0f;
        for (int channel = 0; channel < 3; ++channel) {
            const float difference = level_difference(a.pixels[i][channel], b.pixels[i][channel]);
            pixel_max = std::max(pixel_max, difference);
            square_sum += static_cast<double>(difference) * static_cast<double>(difference);
        }
        if (pixel_max > result.max) {
            result.max = pixel_max;
            result.worst_x = static_cast<std::uint32_t>(i % a.width);
            result.worst_y = static_cast<std::uint32_t>(i / a.width);
        }
        if (pixel_max > threshold) ++result.beyond_count;
    }
    if (a.pixels.empty()) return result;
    const auto pixel_count = static_cast<double>(a.pixels.size());
    result.rms = std::sqrt(square_sum / (3.0 * pixel_count));
    result.share_beyond = static_cast<double>(result.beyond_count) / pixel_count;
    result.is_none =
        std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(Color)) == 0;
    return result;
}

Image difference_picture(const Image& a, const Image& b, float threshold) {
    LRAY_ASSERT(a.width == b.width && a.height == b.height);
    constexpr float kFaintest = 0.2f;  // encoded: what differs at all is seen
    float worst = 0.0f;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        worst = std::max(worst, level_difference(a.pixels[i], b.pixels[i]));
    }
    Image picture(a.width, a.height);
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const float levels = level_difference(a.pixels[i], b.pixels[i]);
        if (!(levels > 0.0f)) continue;
        const auto linear = [](float encoded) {
            return static_cast<float>(srgb_decode(double{encoded}));
        };
        if (levels > threshold) {
            const float white = linear(levels / worst);
            picture.pixels[i] = {1.0f, white, white};
        } else {
            const float share = levels / threshold;
            picture.pixels[i] = {0.0f, 0.0f, linear(kFaintest + (1.0f - kFaintest) * share)};
        }
    }
    return picture;
}

}  // namespace lray::image
