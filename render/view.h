// What is looked at, and how: a camera with the settings of its picture.
#pragma once

#include <cstdint>

#include "render/options.h"
#include "scene/camera.h"

namespace lray::render {

struct View {
    scene::Camera camera{};
    RenderOptions render_options{};

    /// Of the crop, if there is one.
    std::uint64_t pixel_count() const {
        const auto [width, height] = render_options.resolution;
        const std::uint64_t all = std::uint64_t{width} * height;
        return render_options.crop ? render_options.crop->pixel_count() : all;
    }

    /// From the camera; with limits, at least.
    std::uint64_t ray_count() const {
        const bool is_limited = render_options.limits.is_any();
        return pixel_count() * (is_limited ? 1 : render_options.samples.count());
    }
};

}  // namespace lray::render
