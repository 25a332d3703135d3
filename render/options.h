// What of a view is rendered, and how: the settings that render() takes.
#pragma once

#include <cstdint>
#include <optional>

#include "base/sampler.h"
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

struct RenderOptions {
    scene::Resolution resolution{};
    std::optional<PixelRect> crop{};  // empty: all. Asserts that it lies inside and is not empty
    SampleRange samples{};            // asserts that it holds some, and at most Film::kMaxSamples
    PixelPosition position = PixelPosition::center;
    SamplerKind sampler = SamplerKind::sobol;
    std::uint64_t seed = 0;          // of all that is chosen at random
    shade::Settings shading{};  // its depth_unit is set by the camera
    const shade::LitWorld* lit = nullptr;  // what `full` shading needs; asserted
    std::uint32_t thread_count = 0;  // 0: all
    /// Rays that are traced together, and so between two looks at whether to stop. Any number gives
    /// the same picture; one at a time is right where each ray takes long.
    std::uint32_t batch_size = 64;
};

}  // namespace lray::render
