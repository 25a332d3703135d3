// What is looked at, and how: a camera with the settings of its picture.
#pragma once

#include <cstdint>

#include "render/options.h"
#include "scene/camera.h"

namespace lray::render {

struct View {
    scene::Camera camera{};
    RenderOptions render_options{};

    /// The full picture.
    PixelRect whole() const {
        return {0, 0, render_options.resolution.width, render_options.resolution.height};
    }

    /// What is rendered of it: the crop, if there is one.
    PixelRect area() const { return render_options.crop.value_or(whole()); }

    /// Of the crop, if there is one.
    std::uint64_t pixel_count() const { return area().pixel_count(); }

    /// From the camera; with limits, at least.
    std::uint64_t ray_count() const {
        const bool is_limited = render_options.limits.is_any();
        return pixel_count() * (is_limited ? 1 : render_options.samples.count());
    }
};

}  // namespace lray::render
