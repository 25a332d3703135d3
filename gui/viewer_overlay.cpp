// What is drawn over the picture.
#include <fmt/format.h>

#include "base/assert.h"
#include "gui/project.h"
#include "gui/viewer.h"
#include "gui/wireframe.h"

namespace lray::gui {

namespace {

constexpr Rgba kCropRim{1.0f, 0.8f, 0.2f, 0.9f};
constexpr Rgba kLeaf{0.35f, 1.0f, 0.45f, 0.55f};
constexpr Rgba kNode{0.4f, 0.75f, 1.0f, 0.65f};
constexpr Rgba kInstance{1.0f, 0.65f, 0.25f, 0.65f};

Rgba color_of(const render::BoundingVolume& volume) {
    if (volume.is_instance) return kInstance;
    return volume.is_leaf ? kLeaf : kNode;
}

std::string_view name_of(shade::Shader shader) {
    switch (shader) {
        case shade::Shader::full:
            return "full";
        case shade::Shader::flat:
            return "flat";
        case shade::Shader::normals:
            return "normals";
        case shade::Shader::uv:
            return "uv";
        case shade::Shader::depth:
            return "depth";
        case shade::Shader::cost:
            return "cost";
    }
    LRAY_ASSERT(false);
}

}  // namespace

WindowSize Viewer::window() const {
    return {static_cast<int>(size_.width), static_cast<int>(size_.height)};
}

HudState Viewer::hud_state() const {
    HudState state;
    const render::SessionStatus& status = seen_;
    state.state = is_loading_        ? RenderState::loading
                  : status.is_done   ? RenderState::done
                  : status.is_paused ? RenderState::paused
                                     : RenderState::rendering;
    state.pass_count = status.passes;
    if (status.pass_limit < render::Film::kMaxSamples) state.pass_limit = status.pass_limit;
    state.preview_divisor = std::max(status.square, 1u);
    state.rays_per_second = status.rays_per_second;
    state.resolution = size_;
    state.camera = camera_;
    state.accel = hierarchy_;
    state.shading = name_of(shader());
    state.is_flying = is_flying_;
    state.speed = speed_;
    const image::DisplaySettings display = shown_display();
    state.exposure = display.exposure;
    state.tonemap = display.tonemap;
    if (volume_level_) state.volume_level = static_cast<int>(*volume_level_);
    state.picked = picked_;
    return state;
}

void Viewer::add_volumes(Overlay& overlay) const {
    const Projector projector(camera_, size_);
    for (const render::BoundingVolume& volume : volumes_.volumes) {
        const Volume shape{volume.center, volume.half_axes};
        switch (volume.shape) {
            case render::BoundingVolume::Shape::box:
                add_wireframe_box(overlay, shape, color_of(volume), projector);
                break;
            case render::BoundingVolume::Shape::ellipsoid:
                add_wireframe_ellipsoid(overlay, shape, color_of(volume), projector);
                break;
        }
    }
}

void Viewer::add_crop(Overlay& overlay) const {
    std::optional<render::PixelRect> crop = crop_;
    if (crop_drawn_) crop = touched_pixels(crop_drawn_->from, crop_drawn_->at, size_);
    if (!crop) return;
    overlay.add_rim({double(crop->x0), double(crop->y0), double(crop->x1), double(crop->y1)},
                    kCropRim);
}

Overlay Viewer::overlay() const {
    Overlay overlay;
    add_volumes(overlay);
    add_crop(overlay);
    if (!messages_.empty()) add_messages(overlay, messages_, font_, window());
    if (shows_hud_) {
        add_hud(overlay, hud_state(), font_, window());
        sliders_.draw(overlay);  // one of them may mend what is wrong
    }
    if (!message_.empty()) add_notice(overlay, message_, font_, window());
    if (shows_help_) {
        add_help(overlay, help_lines(layout_, !sliders_.is_empty()), font_, window());
    }
    return overlay;
}

}  // namespace lray::gui
