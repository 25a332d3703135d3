#include "image/write.h"

#include <algorithm>

#include "image/exr.h"
#include "image/jpeg.h"
#include "image/pfm.h"
#include "image/png.h"
#include "image/ppm.h"

namespace lray::image {

namespace {

bool equal_ignoring_case(std::string_view a, std::string_view b) {
    const auto lower = [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace

std::optional<Format> find_format(std::string_view name) {
    for (const Format format : kFormats) {
        if (equal_ignoring_case(name, format_name(format))) return format;
    }
    if (equal_ignoring_case(name, "jpeg")) return Format::jpg;
    return std::nullopt;
}

std::string_view format_name(Format format) {
    switch (format) {
        case Format::ppm:
            return "ppm";
        case Format::png:
            return "png";
        case Format::jpg:
            return "jpg";
        case Format::pfm:
            return "pfm";
        case Format::exr:
            return "exr";
    }
    LRAY_ASSERT(false);
}

bool holds_light(Format format) {
    return format == Format::pfm || format == Format::exr;
}

std::optional<std::uint32_t> max_side(Format format) {
    if (format == Format::jpg) return kMaxJpegSide;
    return std::nullopt;
}

bool is_built(Format format) {
    return format != Format::exr || is_exr_built();
}

std::string_view extension(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    const std::string_view name = slash == path.npos ? path : path.substr(slash + 1);
    const std::size_t dot = name.rfind('.');
    // A leading dot hides a file; it does not begin an extension.
    if (dot == name.npos || dot == 0) return {};
    return name.substr(dot + 1);
}

bool write_image(OutputFile& out, const Image& image, Format format, Gamma gamma, Metadata metadata,
                 std::string& error, const WriteSettings& settings) {
    switch (format) {
        case Format::ppm:
            if (write_ppm(out, image, gamma)) return true;
            error = out.error();
            return false;
        case Format::png:
            return write_png(out, image, gamma, metadata, error, settings.png_bits);
        case Format::jpg:
            return write_jpeg(out, image, gamma, metadata, settings.jpeg_quality, error);
        case Format::pfm:
            if (write_pfm(out, image)) return true;
            error = out.error();
            return false;
        case Format::exr:
            return write_exr(out, image, metadata, error);
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::image
