// A viewer without its window, and a program around it, for its tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/diagnostic_printer.h"
#include "gui/viewer.h"
#include "scene/lit.h"
#include "tests/parser/loaded.h"
#include "tests/support/temp_directory.h"
#include "tests/support/wait_until.h"

namespace lray::gui {
inline constexpr Font kFont{.width = 1, .height = 2, .ascent = 1};  // much text has room
inline constexpr const char* kScene =
    "render { resolution: [160, 120] }\n"
    "camera { position: [0, 0, 10], look_at: [0, 0, 0] }\n"
    "sphere \"ball\" { radius: 1, material: material { diffuse: red } }\n"
    "sphere { center: [4, 0, 0], radius: 0.5 }\n";

/// The program around the viewer, as the tests want it.
class FakeProgram {
 public:
    explicit FakeProgram(std::string text) : text_(std::move(text)) {
        directory_.write("scene.lrs", text_);
    }

    Program program() {
        Program program;
        program.title = "scene.lrs";
        program.load = [this](std::span<const ParamText> params) { return load(params); };
        program.save = [this](image::Image light, const image::DisplaySettings& display) {
            const std::lock_guard lock(mutex_);
            saved_ = std::move(light);
            saved_display_ = display;
            ++save_count_;
            return Outcome{true, "saved scene-001.png"};
        };
        program.camera_text = [this](const scene::Camera& camera) {
            camera_ = camera;
            return std::string("camera { }");
        };
        program.read_views = [this] { return views_; };
        program.write_views = [this](const StoredViews& views) {
            if (views_fail_) return Outcome{false, "the disk is full"};
            views_ = views;
            return Outcome{true, "stored"};
        };
        program.print = [this](std::string_view line) { printed_ += std::string(line) + "\n"; };
        program.is_interrupted = [this] { return is_interrupted_; };
        return program;
    }

    LoadedScene load(std::span<const ParamText> params) {
        const std::lock_guard lock(mutex_);
        ++load_count_;
        params_.assign(params.begin(), params.end());
        parser::LoadSettings settings;
        for (const auto& [name, value] : params) settings.definitions.push_back({name, value});
        FileAccess files;
        Sources sources;
        Diagnostics diagnostics;
        auto result =
            parser::load(directory_.path("scene.lrs"), settings, files, sources, diagnostics);
        LoadedScene loaded;
        loaded.files.assign(files.files_read().begin(), files.files_read().end());
        loaded.messages = format_diagnostics(diagnostics, sources, {});
        if (!result.scene) return loaded;
        auto world = scene::flatten(*result.scene, {}, diagnostics);
        loaded.view.render_options.resolution = result.scene->render.resolution;
        loaded.view.render_options.position = render::PixelPosition::random;
        loaded.view.render_options.samples = {0, 4};
        if (!result.scene->cameras.empty()) loaded.view.camera = result.scene->cameras.front();
        loaded.bounds = finite_bounds(*world);
        loaded.hierarchy = "boxes";
        loaded.sliders = sliders_;
        for (Slider& slider : loaded.sliders) {
            for (const auto& [name, value] : params) {
                if (slider.name == name) slider.value = std::stod(value);
            }
        }
        auto prepared = std::make_unique<render::PreparedScene>(
            std::move(sources), std::move(*result.scene), std::move(*world));
        prepared->accel = bvh::build(prepared->world, {});
        if (scene::is_lit(prepared->scene, prepared->world)) {
            loaded.view.render_options.shading.shader = shade::Shader::full;
            prepared->lit = std::make_unique<shade::LitWorld>(prepared->world, *prepared->accel);
        }
        loaded.prepared = std::move(prepared);
        return loaded;
    }

    void write_scene(const std::string& text) { directory_.write("scene.lrs", text); }

    test::TempDirectory directory_{};
    std::string text_;
    std::vector<Slider> sliders_{};
    std::mutex mutex_{};  // of what the workers write
    int load_count_ = 0;
    std::vector<ParamText> params_{};
    int save_count_ = 0;
    image::Image saved_{};
    image::DisplaySettings saved_display_{};
    scene::Camera camera_{};
    StoredViews views_{};
    bool views_fail_ = false;
    std::string printed_{};
    bool is_interrupted_ = false;
};

class ViewerTest : public testing::Test {
 protected:
    void open(const std::string& text = kScene) {
        program_ = std::make_unique<FakeProgram>(text);
        open_again();
    }
    void open_again() {
        viewer_.reset();
        open_program(program_->program());
    }
    void open_program(Program program) {
        LoadedScene first = program_->load({});
        const scene::Resolution size = first.view.render_options.resolution;
        viewer_ = std::make_unique<Viewer>(std::move(first), std::move(program),
                                           KeyboardLayout::qwerty, kFont, size, now_);
        come_to_rest();
    }

    void key(char character, bool is_shift = false) {
        tap({SpecialKey::none, character, is_shift});
    }
    void key(SpecialKey special, bool is_shift = false) { tap({special, '\0', is_shift}); }
    void tap(const Key& pressed) {
        viewer_->press(pressed, now_);
        viewer_->release(pressed, now_);
        viewer_->tick(now_);
    }

    /// Holds a key for so many seconds.
    void hold(SpecialKey special, double seconds) {
        viewer_->press({special, '\0', false}, now_);
        const double end = now_ + seconds;
        while (now_ < end) {
            now_ = std::min(now_ + 0.01, end);
            viewer_->tick(now_);
        }
        viewer_->release({special, '\0', false}, now_);
        viewer_->tick(now_);
    }

    void drag(MouseButton button, DVec2 from, DVec2 to, bool is_shift = false) {
        viewer_->press(button, from, is_shift, now_);
        viewer_->move(0.5 * (from + to), now_);
        viewer_->move(to, now_);
        viewer_->release(button, to, now_);
        viewer_->tick(now_);
    }

    /// The camera as it is now.
    scene::Camera camera() {
        key('c');
        return program_->camera_;
    }

    /// Ticks until a condition holds, in real time.
    template <class Condition>
    testing::AssertionResult comes_true(Condition condition) {
        const auto tick_and_ask = [&] {
            now_ += 0.002;
            const Tick tick = viewer_->tick(now_);
            if (tick.wanted_size) wanted_size_ = tick.wanted_size;
            return condition();
        };
        if (test::wait_until(tick_and_ask, std::chrono::milliseconds(2))) {
            return testing::AssertionSuccess();
        }
        return testing::AssertionFailure() << "not within half a minute";
    }

    void come_to_rest() {
        EXPECT_TRUE(comes_true([&] { return viewer_->is_at_rest(); }));
    }

    std::string overlay_text() {
        std::string text;
        for (const auto& mark : viewer_->overlay().marks) {
            if (const auto* run = std::get_if<OverlayText>(&mark)) text += run->text + "\n";
        }
        return text;
    }

    image::Image saved_picture() {
        const auto count = [&] {
            const std::lock_guard lock(program_->mutex_);
            return program_->save_count_;
        };
        const int before = count();
        key('p');
        EXPECT_TRUE(comes_true([&] { return count() > before; }));
        const std::lock_guard lock(program_->mutex_);
        return program_->saved_;
    }

    bool shows(std::string_view text) { return overlay_text().find(text) != std::string::npos; }

    int load_count() {
        const std::lock_guard lock(program_->mutex_);
        return program_->load_count_;
    }

    double now_ = 100.0;
    std::optional<scene::Resolution> wanted_size_{};  // that was asked of the window
    std::unique_ptr<FakeProgram> program_;
    std::unique_ptr<Viewer> viewer_;
};

inline void expect_near(DVec3 a, DVec3 b, double tolerance = 1e-9) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], tolerance);
}

}  // namespace lray::gui
