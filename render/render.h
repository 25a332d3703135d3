// Camera -> film: blocking rendering on all cores.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

#include "bvh/accel.h"
#include "image/image.h"
#include "render/film.h"
#include "scene/camera.h"
#include "scene/world.h"

namespace lray::render {

/// Half open: x in [x0, x1), y in [y0, y1), from the top left of the full picture.
struct PixelRect {
    std::uint32_t x0 = 0;
    std::uint32_t y0 = 0;
    std::uint32_t x1 = 0;
    std::uint32_t y1 = 0;

    std::uint32_t width() const { return x1 - x0; }
    std::uint32_t height() const { return y1 - y0; }
    std::uint64_t pixel_count() const { return std::uint64_t{width()} * height(); }
};

struct RenderOptions {
    scene::Resolution resolution{};
    std::optional<PixelRect> crop{};  // empty: all. Asserts that it lies inside and is not empty
    Color background{0.0f};
    std::uint32_t thread_count = 0;  // 0: all
};

struct RenderProgress {
    std::uint64_t done_pixels = 0;
    std::uint64_t total_pixels = 0;
};

struct RenderResult {
    image::Image image{};  // of the crop's size
    bvh::TraceCounts counts{};
    FilmCounts samples{};
    std::uint32_t thread_count = 1;  // that were used
    bool is_complete = true;         // false if cancelled: pixels not reached are black
};

using ProgressFunction = std::function<void(const RenderProgress&)>;

/// Renders one view, flat: the colour of the object hit, or the background. The picture does not
/// depend on the number of threads; a crop is the same pixels of the whole.
/// `on_progress` (may be empty) is called from render threads, one at a time, at most some ten
/// times a second. `cancel` is polled per pixel.
RenderResult render(const scene::World& world, const bvh::Accel& accel, const scene::Camera& camera,
                    const RenderOptions& options, const ProgressFunction& on_progress,
                    const std::atomic<bool>& cancel);

}  // namespace lray::render
