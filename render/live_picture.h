// A picture that is shown while it is made: its light, and the bytes that a screen shows of it.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "image/image.h"
#include "image/tone_map.h"
#include "render/options.h"
#include "scene/camera.h"

namespace lray::render {

/// A copy of what a screen shows. Shape: 4 bytes for each pixel, R G B 255, row by row from the
/// top.
struct Frame {
    scene::Resolution resolution{0, 0};
    std::vector<std::uint8_t> bytes{};
    std::vector<std::uint64_t> versions{};  // of its bands
};

/// Rows of a frame, half open.
struct RowRange {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
};

/// Written by any thread, read by any other, neither waits for more than a band to be copied.
class LivePicture {
 public:
    /// Black, or what is shown of another one, stretched.
    LivePicture(scene::Resolution resolution, const image::DisplaySettings& display,
                const LivePicture* before = nullptr);

    scene::Resolution resolution() const { return resolution_; }

    /// Shows light in a part of the picture, each value in a square of `square` by `square` pixels,
    /// cut off at the part's right and lower edge. Shape: `light` row by row from the top left.
    void put(const PixelRect& part, std::span<const Color> light, std::uint32_t square);

    /// Shows the same light in another way, from now on. Does nothing where it is shown so already.
    void set_display(const image::DisplaySettings& settings);

    /// Copies what has changed since the last call for that frame, or all of it if the size has.
    /// Returns the rows that hold every change; empty if there is none, as long as nothing was put.
    std::optional<RowRange> copy_changes(Frame& frame) const;

    /// Returns the light of a part.
    image::Image light(const PixelRect& part) const;

 private:
    static constexpr std::uint32_t kBandHeight = 16;

    /// Some rows. What it guards lies in the arrays of the picture.
    struct Band {
        mutable std::mutex mutex{};
        /// 0: nothing was put. A frame never meets one of another picture again.
        std::uint64_t version = 0;
        image::DisplaySettings display{};
    };

    PixelRect rect_of(std::size_t band) const;
    std::uint64_t newest_version() const;
    void show_stretched(const LivePicture& before);
    std::size_t place(std::uint32_t x, std::uint32_t y) const {
        return std::size_t{y} * resolution_.width + x;
    }
    /// Shows the light of a band anew. Called with its lock.
    void show_band(std::size_t index, const image::DisplaySettings& settings);
    void encode(const image::Display& display, std::uint32_t y, std::uint32_t x0, std::uint32_t x1);

    scene::Resolution resolution_{};
    std::vector<Color> light_;
    std::vector<std::uint8_t> bytes_;
    std::vector<Band> bands_;
};

}  // namespace lray::render
