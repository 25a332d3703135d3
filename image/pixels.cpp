#include "image/pixels.h"

#include <algorithm>

namespace lray::image {

std::uint32_t width_of(const Pixels& pixels) {
    return std::visit([](const auto& image) { return image.width; }, pixels);
}

std::uint32_t height_of(const Pixels& pixels) {
    return std::visit([](const auto& image) { return image.height; }, pixels);
}

Color mean_color(const Pixels& pixels, bool is_srgb) {
    if (const auto* coded = std::get_if<CodedImage>(&pixels)) return mean_color(*coded, is_srgb);
    const auto& light = std::get<Image>(pixels);
    LRAY_ASSERT(!light.pixels.empty());
    DVec3 sum{0.0};
    for (const Color& pixel : light.pixels) sum += DVec3{pixel};
    return Color{sum / static_cast<double>(light.pixels.size())};
}

std::uint64_t mend_light(Image& light) {
    std::uint64_t mended_count = 0;
    for (Color& pixel : light.pixels) {
        bool is_right = true;
        for (int channel = 0; channel < 3; ++channel) {
            float& value = pixel[channel];
            if (value >= 0.0f && value <= kMostPictureLight) continue;  // NaN is neither
            is_right = false;
            value = value > 0.0f ? kMostPictureLight : 0.0f;
        }
        if (!is_right) ++mended_count;
    }
    return mended_count;
}

}  // namespace lray::image
