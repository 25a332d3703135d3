// What of a view is rendered, and how: the settings that render() takes.
#pragma once

#include <cstdint>
#include <optional>

#include "base/sampler.h"
#include "image/tone_map.h"
#include "scene/camera.h"
#include "shade/settings.h"
#include "shade/transport/lit_world.h"

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

/// Samples of each pixel, half open. A sample is the same in whatever range it is rendered.
struct SampleRange {
    std::uint32_t begin = 0;
    std::uint32_t end = 1;

    std::uint32_t count() const { return end - begin; }
    friend bool operator==(SampleRange, SampleRange) = default;
};

/// Where in its pixel the ray of a sample goes.
enum class PixelPosition : std::uint8_t { center, random };

/// What ends the samples of a picture or a pixel early.
struct SampleLimits {
    /// No pass over the picture begins after so many seconds of rendering; one is always made.
    std::optional<double> seconds{};
    /// A pixel gets no more samples once the standard error of each of its displayed values, as
    /// shares of white, is at most that. It is looked at when the pixel has kFirstNoiseCheck
    /// samples, and whenever it has twice as many: whether it ends depends on the pixel alone.
    std::optional<double> noise{};

    bool is_any() const { return seconds.has_value() || noise.has_value(); }
};

/// Fewer samples do not tell how much they vary: a detail that covers a tenth of a pixel is missed
/// by 32 random ones once in thirty pixels.
inline constexpr std::uint32_t kFirstNoiseCheck = 32;

struct RenderOptions {
    scene::Resolution resolution{};
    std::optional<PixelRect> crop{};  // empty: all. Asserts that it lies inside and is not empty
    SampleRange samples{};            // asserts that it holds some, and at most Film::kMaxSamples
    SampleLimits limits{};            // that may end a render before all its samples
    PixelPosition position = PixelPosition::center;
    SamplerKind sampler = SamplerKind::sobol;
    std::uint64_t seed = 0;                // of all that is chosen at random
    shade::Settings shading{};             // its depth_unit is set by the camera
    const shade::LitWorld* lit = nullptr;  // what `full` shading needs; asserted
    image::DisplaySettings display{};      // that noise is judged by
    std::uint32_t thread_count = 0;        // 0: all
    /// Rays that are traced together, and so between two looks at whether to stop. Any number gives
    /// the same picture; one at a time is right where each ray takes long.
    std::uint32_t batch_size = 64;
};

}  // namespace lray::render
