// The scene that is shown: loaded again when it changes, looked at as the user wants it.
#include <algorithm>
#include <array>
#include <utility>

#include "base/assert.h"
#include "gui/viewer.h"

namespace lray::gui {

namespace {

/// So many volumes are drawn at most: more are no help to the eye.
constexpr std::size_t kMaxVolumes = 4096;

constexpr std::array kOtherShaders{shade::Shader::normals, shade::Shader::depth,
                                   shade::Shader::cost};

}  // namespace

/// Loads the scene on a thread of its own; once more if it is asked for meanwhile.
void Viewer::load() {
    if (!program_.can_load_again) {
        return tell("a scene from stdin cannot be read again", now_);
    }
    is_load_wanted_ = true;
    if (is_loading_) return;
    is_load_wanted_ = false;
    is_loading_ = true;
    needs_redraw_ = true;
    const auto end_loading = [this] {
        is_loading_ = false;
        take(std::exchange(loaded_, {}));
        if (is_load_wanted_) load();
    };
    const auto job = [this, end_loading, params = params_] {
        loaded_ = program_.load(params);
        return end_loading;
    };
    loader_.start(job, [this, end_loading] {
        loaded_ = {};
        loaded_.messages = "there is not enough memory to load the scene\n";
        end_loading();
    });
}

void Viewer::take(LoadedScene loaded) {
    needs_redraw_ = true;
    if (!loaded.files.empty()) watch_.watch(loaded.files);
    messages_ = loaded.prepared ? "" : std::move(loaded.messages);
    if (!loaded.prepared) return;

    // Whoever has gone elsewhere stays there, unless the file's own camera was changed.
    const scene::Camera& before = scene_view_.camera;
    const scene::Camera& after = loaded.view.camera;
    const bool was_written = !after.span.is_nowhere();
    const bool has_changed = !is_same_view(before, after);
    if (has_changed && (was_written || is_same_view(camera_, before))) {
        history_.remember(camera_);
        camera_ = after;
    }
    if (loaded.view.render_options.resolution != scene_view_.render_options.resolution) {
        wanted_size_ = loaded.view.render_options.resolution;
    }
    scene_view_ = std::move(loaded.view);
    bounds_ = loaded.bounds;
    hierarchy_ = std::move(loaded.hierarchy);
    picked_.reset();
    ++loads_;
    session_.cancel_picks();
    if (program_.can_load_again && !is_load_wanted_) take_sliders(std::move(loaded.sliders));
    change_time_ = now_;
    change_ = session_.set_scene(std::move(loaded.prepared), shown_view());
}

/// Those of the user's values that the scene has not taken are forgotten.
void Viewer::take_sliders(std::vector<Slider> sliders) {
    slider_texts_.clear();
    for (const Slider& slider : sliders) slider_texts_[slider.name] = value_text(slider);
    std::erase_if(params_, [&](const ParamText& param) {
        const auto shown = slider_texts_.find(param.first);
        return shown == slider_texts_.end() || shown->second != param.second;
    });
    sliders_.set(std::move(sliders));
    sliders_.lay_out(window(), font_);
}

/// Evaluates the scene with the values that differ from those it was loaded with.
void Viewer::use_sliders() {
    needs_redraw_ = true;
    if (!sliders_.take_change()) return;
    for (const Slider& slider : sliders_.all()) {
        const std::string text = value_text(slider);
        if (slider_texts_[slider.name] == text) continue;
        slider_texts_[slider.name] = text;
        const auto known =
            std::find_if(params_.begin(), params_.end(),
                         [&](const ParamText& param) { return param.first == slider.name; });
        if (known == params_.end()) {
            params_.emplace_back(slider.name, text);
        } else {
            known->second = text;
        }
    }
    load();
}

shade::Shader Viewer::shader() const {
    return shading_ == 0 ? scene_view_.render_options.shading.shader : kOtherShaders[shading_ - 1];
}

/// Goes around through the shading of the scene and the others.
void Viewer::choose_shading(int step) {
    constexpr int kCount = static_cast<int>(kOtherShaders.size()) + 1;
    do {
        shading_ = static_cast<std::size_t>((static_cast<int>(shading_) + kCount + step) % kCount);
    } while (shading_ != 0 && shader() == scene_view_.render_options.shading.shader);
    show();
}

/// Exposure and tone map are for light: what else is shown has values of its own.
image::DisplaySettings Viewer::shown_display() const {
    image::DisplaySettings display = scene_view_.render_options.display;
    if (shader() != shade::Shader::full) return {.gamma = display.gamma};
    display.exposure += exposure_;
    display.tonemap = tonemap_.value_or(display.tonemap);
    return display;
}

render::View Viewer::shown_view() const {
    render::View view = scene_view_;
    view.camera = camera_;
    view.render_options.resolution = size_;
    view.render_options.crop = crop_;
    view.render_options.shading.shader = shader();
    view.render_options.display = shown_display();
    return view;
}

void Viewer::show() {
    needs_redraw_ = true;
    change_time_ = now_;
    change_ = session_.set_view(shown_view());
}

void Viewer::show_crop() {
    needs_redraw_ = true;
    change_time_ = now_;
    change_ = session_.set_crop(crop_);
}

/// Noise is that of what is shown: another display needs other samples.
void Viewer::show_display() {
    if (scene_view_.render_options.limits.noise) return show();
    needs_redraw_ = true;
    session_.set_display(shown_display());
}

/// Looks up the volumes of the level, if any are shown.
void Viewer::find_volumes() {
    needs_redraw_ = true;
    volumes_ = {};
    if (volume_level_) volumes_ = session_.volumes(*volume_level_, kMaxVolumes);
}

}  // namespace lray::gui
