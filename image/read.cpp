#include "image/read.h"

#include <fmt/format.h>

#include <utility>
#include <variant>

#include "image/exr.h"
#include "image/hdr.h"
#include "image/jpeg.h"
#include "image/pfm.h"
#include "image/png.h"
#include "image/ppm.h"

namespace lray::image {

bool ReadLimits::allow(std::uint32_t width, std::uint32_t height, std::string& error) const {
    if (std::uint64_t{width} * height <= pixels) return true;
    is_exceeded = true;
    error = fmt::format("{} x {} pixels are more than the limit of {}", width, height, pixels);
    return false;
}

namespace {

using File = std::span<const std::byte>;
using Decoded = std::variant<CodedImage, DeepImage, Image>;

template <class Picture>
std::optional<Decoded> decoded(std::optional<Picture> picture) {
    if (!picture) return std::nullopt;
    return std::move(*picture);
}

std::optional<Decoded> decoded(std::optional<Codes> codes) {
    if (!codes) return std::nullopt;
    return std::visit([](auto& picture) { return Decoded(std::move(picture)); }, *codes);
}

std::optional<Decoded> decode(File file, const ReadLimits& limits, std::string& error) {
    if (is_png(file)) return decoded(read_png(file, limits, error));
    if (is_jpeg(file)) return decoded(read_jpeg(file, limits, error));
    if (is_ppm(file)) return decoded(read_ppm(file, limits, error));
    if (is_pfm(file)) return decoded(read_pfm(file, limits, error));
    if (is_hdr(file)) return decoded(read_hdr(file, limits, error));
    if (is_exr(file)) return decoded(read_exr(file, limits, error));
    error = "this is not a PNG, JPEG, PPM, PFM, Radiance HDR or OpenEXR file";
    return std::nullopt;
}

struct ToPixels {
    Pixels operator()(CodedImage& coded) const { return std::move(coded); }
    Pixels operator()(const DeepImage& deep) const { return rounded_to_8(deep); }
    Pixels operator()(Image& light) const { return std::move(light); }
};

struct ToImage {
    Image operator()(const CodedImage& coded) const { return decode_srgb(coded); }
    Image operator()(const DeepImage& deep) const { return decode_srgb(deep); }
    Image operator()(Image& light) const { return std::move(light); }
};

}  // namespace

std::optional<Pixels> read_pixels(File file, const ReadLimits& limits, std::string& error) {
    std::optional<Decoded> picture = decode(file, limits, error);
    if (!picture) return std::nullopt;
    return std::visit(ToPixels{}, *picture);
}

std::optional<Image> read_image(File file, const ReadLimits& limits, std::string& error) {
    std::optional<Decoded> picture = decode(file, limits, error);
    if (!picture) return std::nullopt;
    return std::visit(ToImage{}, *picture);
}

}  // namespace lray::image
