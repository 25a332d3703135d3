#include "image/coded_image.h"

#include "image/srgb.h"

namespace lray::image {

Image decode_srgb(const CodedImage& coded) {
    Image image(coded.width, coded.height);
    srgb_decode_row(coded.rgb, image.pixels);
    return image;
}

Image decode_srgb(const DeepImage& deep) {
    Image image(deep.width, deep.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[i] = {srgb_decode_16(deep.rgb[3 * i]), srgb_decode_16(deep.rgb[3 * i + 1]),
                           srgb_decode_16(deep.rgb[3 * i + 2])};
    }
    return image;
}

CodedImage rounded_to_8(const DeepImage& deep) {
    CodedImage coded{deep.width, deep.height, {}};
    coded.rgb.reserve(deep.rgb.size());
    for (const std::uint32_t code : deep.rgb) {
        coded.rgb.push_back(static_cast<std::uint8_t>((code + 128) / 257));
    }
    return coded;
}

Color mean_color(const CodedImage& coded, bool is_srgb) {
    LRAY_ASSERT(!coded.rgb.empty());
    std::array<std::array<std::uint64_t, 256>, 3> counts{};
    for (std::size_t i = 0; i < coded.rgb.size(); i += 3) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            ++counts[channel][coded.rgb[i + channel]];
        }
    }
    const double pixel_count = static_cast<double>(coded.rgb.size() / 3);
    Color mean{0.0f};
    for (int channel = 0; channel < 3; ++channel) {
        double sum = 0.0;
        for (std::size_t code = 0; code < 256; ++code) {
            const double linear =
                is_srgb ? static_cast<double>(srgb_decode_8(static_cast<std::uint8_t>(code)))
                        : static_cast<double>(code) / 255.0;
            sum += linear * static_cast<double>(counts[static_cast<std::size_t>(channel)][code]);
        }
        mean[channel] = static_cast<float>(sum / pixel_count);
    }
    return mean;
}

}  // namespace lray::image
