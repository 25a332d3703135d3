#include "render/live_picture.h"

#include <algorithm>
#include <array>

#include "base/assert.h"
#include "image/srgb.h"

namespace lray::render {

namespace {

constexpr std::size_t kBytesPerPixel = 4;
constexpr std::uint32_t kPixelsAtATime = 256;
constexpr std::uint64_t kNoVersion = ~std::uint64_t{0};

}  // namespace

LivePicture::LivePicture(scene::Resolution resolution, const image::DisplaySettings& display,
                         const LivePicture* before)
    : resolution_(resolution),
      light_(std::size_t{resolution.width} * resolution.height, Color{0.0f}),
      bytes_(light_.size() * kBytesPerPixel, 255),
      bands_((resolution.height + kBandHeight - 1) / kBandHeight) {
    if (before != nullptr) show_stretched(*before);
    for (std::size_t i = 0; i < bands_.size(); ++i) show_band(i, display);
}

void LivePicture::show_stretched(const LivePicture& before) {
    const std::uint64_t version = before.newest_version();
    for (Band& band : bands_) band.version = version;
    const auto [width, height] = before.resolution();
    const image::Image old = before.light({0, 0, width, height});
    const auto stretched = [](std::uint32_t at, std::uint32_t from, std::uint32_t to) {
        return static_cast<std::uint32_t>(std::uint64_t{at} * from / to);
    };
    for (std::uint32_t y = 0; y < resolution_.height; ++y) {
        const std::uint32_t old_y = stretched(y, height, resolution_.height);
        for (std::uint32_t x = 0; x < resolution_.width; ++x) {
            light_[place(x, y)] = old.at(stretched(x, width, resolution_.width), old_y);
        }
    }
}

std::uint64_t LivePicture::newest_version() const {
    std::uint64_t newest = 0;
    for (const Band& band : bands_) {
        const std::lock_guard lock(band.mutex);
        newest = std::max(newest, band.version);
    }
    return newest;
}

PixelRect LivePicture::rect_of(std::size_t band) const {
    const auto y0 = static_cast<std::uint32_t>(band) * kBandHeight;
    return {0, y0, resolution_.width, std::min(y0 + kBandHeight, resolution_.height)};
}

void LivePicture::show_band(std::size_t index, const image::DisplaySettings& settings) {
    Band& band = bands_[index];
    if (band.version != 0) ++band.version;  // else there is nothing to show anew
    band.display = settings;
    const image::Display display(settings);
    const PixelRect rect = rect_of(index);
    for (std::uint32_t y = rect.y0; y < rect.y1; ++y) encode(display, y, rect.x0, rect.x1);
}

void LivePicture::encode(const image::Display& display, std::uint32_t y, std::uint32_t x0,
                         std::uint32_t x1) {
    std::array<Color, kPixelsAtATime> shown;
    std::array<std::uint8_t, 3 * kPixelsAtATime> codes;
    for (std::uint32_t x = x0; x < x1; x += kPixelsAtATime) {
        const std::uint32_t count = std::min(kPixelsAtATime, x1 - x);
        const Color* const light = &light_[place(x, y)];
        std::transform(light, light + count, shown.begin(),
                       [&](const Color& value) { return display.shown(value); });
        image::encode_row(std::span(shown).first(count), display.gamma(),
                          std::span(codes).first(std::size_t{3} * count));
        std::uint8_t* target = &bytes_[place(x, y) * kBytesPerPixel];
        for (std::uint32_t i = 0; i < count; ++i) {
            std::copy_n(&codes[std::size_t{3} * i], 3, target + i * kBytesPerPixel);
        }
    }
}

void LivePicture::put(const PixelRect& part, std::span<const Color> light, std::uint32_t square) {
    const std::uint32_t columns = (part.width() + square - 1) / square;
    LRAY_ASSERT(part.x1 <= resolution_.width && part.y1 <= resolution_.height);
    LRAY_ASSERT(light.size() == std::size_t{columns} * ((part.height() + square - 1) / square));
    for (std::size_t i = part.y0 / kBandHeight; i < bands_.size(); ++i) {
        Band& band = bands_[i];
        const PixelRect rect = rect_of(i);
        if (rect.y0 >= part.y1) break;
        const std::lock_guard lock(band.mutex);
        ++band.version;
        const image::Display display(band.display);
        const std::uint32_t begin = std::max(rect.y0, part.y0);
        for (std::uint32_t y = begin; y < std::min(rect.y1, part.y1); ++y) {
            const std::uint32_t row = (y - part.y0) / square;
            const bool repeats = y > begin && row == (y - 1 - part.y0) / square;
            if (repeats) {
                std::copy_n(&light_[place(part.x0, y - 1)], part.width(),
                            &light_[place(part.x0, y)]);
                std::copy_n(&bytes_[place(part.x0, y - 1) * kBytesPerPixel],
                            part.width() * kBytesPerPixel,
                            &bytes_[place(part.x0, y) * kBytesPerPixel]);
                continue;
            }
            const Color* const source = &light[std::size_t{row} * columns];
            for (std::uint32_t x = part.x0; x < part.x1; ++x) {
                light_[place(x, y)] = source[(x - part.x0) / square];
            }
            encode(display, y, part.x0, part.x1);
        }
    }
}

void LivePicture::set_display(const image::DisplaySettings& settings) {
    for (std::size_t i = 0; i < bands_.size(); ++i) {
        const std::lock_guard lock(bands_[i].mutex);
        if (bands_[i].display != settings) show_band(i, settings);
    }
}

std::optional<RowRange> LivePicture::copy_changes(Frame& frame) const {
    if (newest_version() == 0) return std::nullopt;
    if (frame.resolution != resolution_ || frame.versions.size() != bands_.size()) {
        frame.resolution = resolution_;
        frame.bytes.resize(bytes_.size());
        frame.versions.assign(bands_.size(), kNoVersion);
    }
    std::optional<RowRange> changed;
    for (std::size_t i = 0; i < bands_.size(); ++i) {
        const PixelRect rect = rect_of(i);
        const std::lock_guard lock(bands_[i].mutex);
        if (frame.versions[i] == bands_[i].version) continue;
        frame.versions[i] = bands_[i].version;
        const std::size_t begin = place(0, rect.y0) * kBytesPerPixel;
        std::copy_n(&bytes_[begin], rect.pixel_count() * kBytesPerPixel, &frame.bytes[begin]);
        if (!changed) changed = RowRange{rect.y0, rect.y1};
        changed->end = rect.y1;
    }
    return changed;
}

image::Image LivePicture::light(const PixelRect& part) const {
    image::Image result(part.width(), part.height());
    for (std::size_t i = part.y0 / kBandHeight; i < bands_.size(); ++i) {
        const PixelRect rect = rect_of(i);
        if (rect.y0 >= part.y1) break;
        const std::lock_guard lock(bands_[i].mutex);
        for (std::uint32_t y = std::max(rect.y0, part.y0); y < std::min(rect.y1, part.y1); ++y) {
            std::copy_n(&light_[place(part.x0, y)], part.width(), &result.at(0, y - part.y0));
        }
    }
    return result;
}

}  // namespace lray::render
