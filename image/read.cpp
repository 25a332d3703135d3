#include "image/read.h"

#include <fmt/format.h>

#include "image/jpeg.h"
#include "image/png.h"
#include "image/ppm.h"

namespace lray::image {

bool ReadLimits::allow(std::uint32_t width, std::uint32_t height, std::string& error) const {
    if (std::uint64_t{width} * height <= pixels) return true;
    is_exceeded = true;
    error = fmt::format("{} x {} pixels are more than the limit of {}", width, height, pixels);
    return false;
}

std::optional<CodedImage> read_coded_image(std::span<const std::byte> file,
                                           const ReadLimits& limits, std::string& error) {
    if (is_png(file)) return read_png(file, limits, error);
    if (is_jpeg(file)) return read_jpeg(file, limits, error);
    if (file.size() >= 2 && file[0] == std::byte{'P'} && file[1] == std::byte{'6'}) {
        return read_ppm(file, limits, error);
    }
    error = "this is not a PNG, JPEG or binary PPM (P6) file";
    return std::nullopt;
}

std::optional<Image> read_image(std::span<const std::byte> file, const ReadLimits& limits,
                                std::string& error) {
    const std::optional<CodedImage> coded = read_coded_image(file, limits, error);
    if (!coded) return std::nullopt;
    return decode_srgb(*coded);
}

}  // namespace lray::image
