// The viewer without its window: events in, a picture and what is drawn over it out.
#include "gui/viewer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "base/diagnostic_printer.h"
#include "scene/lit.h"
#include "tests/parser/loaded.h"
#include "tests/support/temp_directory.h"

namespace lray::gui {
namespace {

using namespace std::chrono_literals;

constexpr Font kFont{.width = 1, .height = 2, .ascent = 1};  // much text has room
constexpr const char* kScene =
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
        auto result = parser::load(directory_.path("scene.lrs"), settings, files, sources,
                                   diagnostics);
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
            prepared->lit =
                std::make_unique<shade::LitWorld>(prepared->world, *prepared->accel);
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
        LoadedScene first = program_->load({});
        viewer_ = std::make_unique<Viewer>(std::move(first), program_->program(),
                                           KeyboardLayout::qwerty, kFont, now_);
        come_to_rest();
    }

    void key(char character, bool is_shift = false) { tap({SpecialKey::none, character, is_shift}); }
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
        const auto end = std::chrono::steady_clock::now() + 30s;
        while (std::chrono::steady_clock::now() < end) {
            now_ += 0.002;
            viewer_->tick(now_);
            if (condition()) return testing::AssertionSuccess();
            std::this_thread::sleep_for(2ms);
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
        EXPECT_TRUE(comes_true([&] { return shows("saved scene-001.png"); }));
        const std::lock_guard lock(program_->mutex_);
        return program_->saved_;
    }

    bool shows(std::string_view text) { return overlay_text().find(text) != std::string::npos; }

    int load_count() {
        const std::lock_guard lock(program_->mutex_);
        return program_->load_count_;
    }

    double now_ = 100.0;
    std::unique_ptr<FakeProgram> program_;
    std::unique_ptr<Viewer> viewer_;
};

void expect_near(DVec3 a, DVec3 b, double tolerance = 1e-9) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], tolerance);
}

TEST_F(ViewerTest, ShowsTheSceneAndComesToRest) {
    open();
    EXPECT_EQ(viewer_->frame().resolution, (scene::Resolution{160, 120}));
    const std::size_t middle = 4 * (60 * 160 + 80);
    EXPECT_GT(viewer_->frame().bytes[middle], 100) << "the red ball";
    EXPECT_EQ(viewer_->frame().bytes[middle + 1], 0);
    EXPECT_EQ(viewer_->status().passes, 4u);
    EXPECT_TRUE(viewer_->take_changed_rows().has_value());
    EXPECT_FALSE(viewer_->take_changed_rows().has_value());
    EXPECT_EQ(viewer_->status().total_passes, 4u);
}

TEST_F(ViewerTest, AtRestNothingIsDrawnAnew) {
    open();
    now_ += 10.0;  // messages are over
    viewer_->tick(now_);
    for (int i = 0; i < 20; ++i) {
        now_ += 0.1;
        const Tick tick = viewer_->tick(now_);
        EXPECT_FALSE(tick.needs_redraw);
        EXPECT_GE(tick.seconds_to_next, 0.1);
    }
}

TEST_F(ViewerTest, ArrowsMoveForwardBackAndTurn) {
    open();
    const scene::Camera start = camera();
    hold(SpecialKey::up, 0.5);
    const scene::Camera forward = camera();
    EXPECT_LT(forward.position.z, start.position.z - 0.1);
    expect_near(forward.look_at - forward.position, start.look_at - start.position);
    hold(SpecialKey::down, 0.5);
    expect_near(camera().position, start.position);
    hold(SpecialKey::left, 0.5);
    const scene::Camera left = camera();
    expect_near(left.position, start.position);
    EXPECT_LT(left.look_at.x, -1.0) << "what is left comes into view";
    hold(SpecialKey::right, 0.5);
    expect_near(camera().look_at, start.look_at);
}

TEST_F(ViewerTest, HowFarAHeldKeyLeadsDependsOnTimeAndSpeedAlone) {
    open();
    hold(SpecialKey::up, 0.4);
    const double way = 10.0 - camera().position.z;
    key(SpecialKey::home);
    viewer_->press({SpecialKey::up, '\0', false}, now_);
    viewer_->press({SpecialKey::up, '\0', false}, now_ + 0.1);  // a repeat that got through
    now_ += 0.2;
    viewer_->tick(now_);
    now_ += 0.2;
    viewer_->tick(now_);
    viewer_->release({SpecialKey::up, '\0', false}, now_);
    viewer_->tick(now_);
    EXPECT_NEAR(10.0 - camera().position.z, way, 1e-9);
    key(SpecialKey::home);
    key('+');
    hold(SpecialKey::up, 0.4);
    EXPECT_NEAR(10.0 - camera().position.z, 2.0 * way, 1e-9);
}

TEST_F(ViewerTest, UndoLeadsBackThroughEachMoveAndRedoAgain) {
    open();
    const scene::Camera start = camera();
    hold(SpecialKey::up, 0.3);
    const scene::Camera second = camera();
    drag(MouseButton::left, {80, 60}, {120, 70});
    const scene::Camera third = camera();
    EXPECT_NE(third.position, second.position);
    key('u');
    EXPECT_EQ(camera().position, second.position);
    key('u');
    EXPECT_EQ(camera().position, start.position);
    key('u');
    EXPECT_TRUE(shows("nothing to undo"));
    key('y');
    key('y');
    EXPECT_EQ(camera().position, third.position);
    key(SpecialKey::home);
    EXPECT_EQ(camera().position, start.position);
    key('u');
    EXPECT_EQ(camera().position, third.position);
}

TEST_F(ViewerTest, TheMouseOrbitsPansAndGoesCloser) {
    open();
    const scene::Camera start = camera();
    drag(MouseButton::left, {80, 60}, {110, 60});
    scene::Camera now = camera();
    EXPECT_EQ(now.look_at, start.look_at);
    EXPECT_NEAR(length(now.position), 10.0, 1e-9);
    EXPECT_LT(now.position.x, -1.0) << "the scene follows the mouse to the right";
    key(SpecialKey::home);
    drag(MouseButton::left, {80, 60}, {80, 30}, true);
    now = camera();
    expect_near(now.look_at - now.position, start.look_at - start.position);
    EXPECT_LT(now.position.y, -1.0) << "the scene follows the mouse upwards";
    key(SpecialKey::home);
    viewer_->press(MouseButton::wheel_up, {80, 60}, false, now_);
    viewer_->press(MouseButton::wheel_up, {80, 60}, false, now_);
    EXPECT_LT(camera().position.z, 9.0);
    key('u');
    EXPECT_EQ(camera().position, start.position) << "turns of the wheel in a row are one move";
    key('\t');
    drag(MouseButton::left, {80, 60}, {110, 60});
    EXPECT_EQ(camera().position, start.position) << "flying, the head turns";
    EXPECT_NE(camera().look_at, start.look_at);
}

TEST_F(ViewerTest, FramingShowsAllThereIs) {
    open();
    hold(SpecialKey::left, 1.0);
    key('f');
    come_to_rest();
    const image::Image picture = saved_picture();
    const auto is_seen = [](const Color& pixel) { return pixel != Color{0.0f}; };
    EXPECT_TRUE(std::any_of(picture.pixels.begin(), picture.pixels.end(), is_seen));
    for (std::uint32_t x = 0; x < 160; ++x) {
        EXPECT_FALSE(is_seen(picture.at(x, 0)));
        EXPECT_FALSE(is_seen(picture.at(x, 119)));
    }
}

TEST_F(ViewerTest, ASavedFileIsShownAndTheCameraKept) {
    open();
    hold(SpecialKey::up, 0.3);
    const scene::Camera moved = camera();
    std::string text = kScene;
    text.replace(text.find("red"), 3, "blue");
    program_->write_scene(text);
    EXPECT_TRUE(comes_true([&] { return load_count() == 2; }));
    come_to_rest();
    EXPECT_EQ(camera().position, moved.position);
    const std::size_t middle = 4 * (60 * 160 + 80);
    EXPECT_EQ(viewer_->frame().bytes[middle], 0);
    EXPECT_GT(viewer_->frame().bytes[middle + 2], 100) << "the ball is blue";
}

TEST_F(ViewerTest, ACameraChangedInTheFileIsFollowed) {
    open();
    hold(SpecialKey::up, 0.3);
    const scene::Camera moved = camera();
    std::string text = kScene;
    text.replace(text.find("[0, 0, 10]"), 10, "[0, 3, 12]");
    program_->write_scene(text);
    key('r');
    EXPECT_TRUE(comes_true([&] { return load_count() >= 2 && !viewer_->is_loading(); }));
    expect_near(camera().position, {0.0, 3.0, 12.0});
    key('u');
    EXPECT_EQ(camera().position, moved.position) << "the way back is kept";
}

TEST_F(ViewerTest, AMistakeIsShownOverThePictureUntilItIsMended) {
    open();
    const auto before = viewer_->frame().bytes;
    program_->write_scene("sphere { radus: 1 }\n");
    key('r');
    EXPECT_TRUE(comes_true([&] { return shows("radus"); }));
    come_to_rest();
    EXPECT_EQ(viewer_->frame().bytes, before) << "the last good picture stays";
    key('i');
    EXPECT_TRUE(shows("did you mean"));
    key('i');
    program_->write_scene(kScene);
    EXPECT_TRUE(comes_true([&] { return !shows("radus"); }));
}

TEST_F(ViewerTest, SavesWhileLoadingLeadToTheLastOne) {
    open();
    for (int i = 0; i < 20; ++i) {
        std::string text = kScene;
        text.replace(text.find("160"), 3, std::to_string(200 + i));
        program_->write_scene(text);
        key('r');
    }
    EXPECT_TRUE(comes_true([&] { return viewer_->wanted_size().width == 219; }));
    EXPECT_LT(load_count(), 21);
}

TEST_F(ViewerTest, ASlidersValueIsGivenToTheScene) {
    program_ = std::make_unique<FakeProgram>("param size = 1 in [0.5, 2]\n"
                                             "param other = 1 in [0, 2]\n"
                                             "sphere { radius: size * other }\n");
    program_->sliders_ = {{"size", 1.0, 0.5, 2.0, false, {}}, {"other", 1.0, 0.0, 2.0, false, {}}};
    open_again();
    key(SpecialKey::right, true);
    EXPECT_TRUE(comes_true([&] { return load_count() == 2 && !viewer_->is_loading(); }));
    {
        const std::lock_guard lock(program_->mutex_);
        ASSERT_EQ(program_->params_.size(), 1u);
        EXPECT_EQ(program_->params_[0].first, "size");
        EXPECT_GT(std::stod(program_->params_[0].second), 1.0);
    }
    key(SpecialKey::down, true);
    key(SpecialKey::left, true);
    EXPECT_TRUE(comes_true([&] { return load_count() == 3 && !viewer_->is_loading(); }));
    const std::lock_guard lock(program_->mutex_);
    ASSERT_EQ(program_->params_.size(), 2u) << "the first one stays";
    EXPECT_LT(std::stod(program_->params_[1].second), 1.0);
}

TEST_F(ViewerTest, AMouseOnASliderMovesItAndNotTheCamera) {
    program_ = std::make_unique<FakeProgram>(std::string("param size = 1 in [0, 2]\n") + kScene);
    program_->sliders_ = {{"size", 0.0, 0.0, 2.0, false, {}}};
    open_again();
    const scene::Camera start = camera();
    for (double y = 8.0; y < 30.0 && !viewer_->is_loading(); y += 1.0) {  // below its name
        viewer_->press(MouseButton::left, {150.0, y}, false, now_);
        viewer_->move({140.0, y}, now_);
        viewer_->release(MouseButton::left, {140.0, y}, now_);
    }
    EXPECT_TRUE(comes_true([&] { return load_count() >= 2 && !viewer_->is_loading(); }));
    EXPECT_EQ(camera().position, start.position);
    const std::lock_guard lock(program_->mutex_);
    ASSERT_EQ(program_->params_.size(), 1u);
    EXPECT_GT(std::stod(program_->params_[0].second), 0.0);
}

TEST_F(ViewerTest, ASceneFromStdinIsNotLoadedAgain) {
    open();
    program_->sliders_ = {{"size", 1.0, 0.5, 2.0, false, {}}};
    Program program = program_->program();
    program.can_load_again = false;
    viewer_ = std::make_unique<Viewer>(program_->load({}), std::move(program),
                                       KeyboardLayout::qwerty, kFont, now_);
    key('r');
    EXPECT_TRUE(shows("stdin"));
    EXPECT_FALSE(viewer_->is_loading());
    EXPECT_FALSE(shows("size")) << "a slider that does nothing";
}

TEST_F(ViewerTest, ViewsAreStoredAndRecalled) {
    open();
    key(SpecialKey::f3);
    EXPECT_TRUE(shows("there is no view 3"));
    hold(SpecialKey::up, 0.3);
    const scene::Camera stored = camera();
    key(SpecialKey::f3, true);
    EXPECT_TRUE(shows("view 3 stored"));
    EXPECT_EQ(program_->views_.at(3).position, stored.position);
    key(SpecialKey::home);
    key(SpecialKey::f3);
    EXPECT_EQ(camera().position, stored.position);
    open_again();
    key(SpecialKey::f3);
    EXPECT_EQ(camera().position, stored.position) << "also by the next viewer";
    program_->views_fail_ = true;
    key(SpecialKey::f4, true);
    EXPECT_TRUE(shows("the disk is full"));
}

TEST_F(ViewerTest, AClickTellsWhatItIs) {
    open();
    drag(MouseButton::left, {80, 60}, {80, 60});
    EXPECT_TRUE(comes_true([&] { return shows("sphere `ball`"); }));
    EXPECT_NE(program_->printed_.find("scene.lrs:3:1: sphere `ball`"), std::string::npos)
        << program_->printed_;
    EXPECT_TRUE(shows("scene.lrs:3:1"));
    drag(MouseButton::left, {5, 110}, {5, 110});
    EXPECT_TRUE(comes_true([&] { return !shows("sphere `ball`"); }));
}

TEST_F(ViewerTest, ExposureAndToneMapAreForLightAlone) {
    open("render { resolution: [160, 120] }\nenvironment { color: white }\n" +
         std::string(kScene).substr(std::string(kScene).find("camera")));
    key(SpecialKey::page_up);
    key('t');
    saved_picture();
    EXPECT_EQ(program_->saved_display_.exposure, 0.5);
    EXPECT_EQ(program_->saved_display_.tonemap, image::ToneMap::reinhard);
    key('v');
    saved_picture();
    EXPECT_EQ(program_->saved_display_.exposure, 0.0) << "of normals";
    EXPECT_EQ(program_->saved_display_.tonemap, image::ToneMap::none);
}

TEST_F(ViewerTest, ACropIsAveragedAndSavedAlone) {
    open();
    const auto mark_count = [&] { return viewer_->overlay().marks.size(); };
    const std::size_t before = mark_count();
    drag(MouseButton::right, {20, 30}, {100, 70});
    come_to_rest();
    EXPECT_GT(mark_count(), before) << "its rim";
    const image::Image part = saved_picture();
    EXPECT_EQ(part.width, 80u);
    EXPECT_EQ(part.height, 40u);
    drag(MouseButton::right, {50, 50}, {50, 50});
    come_to_rest();
    EXPECT_EQ(saved_picture().width, 160u);
}

TEST_F(ViewerTest, VolumesGoDownLevelByLevelAndAway) {
    open();
    EXPECT_TRUE(viewer_->overlay().lines.empty());
    key('b');
    const std::size_t first = viewer_->overlay().lines.size();
    EXPECT_EQ(first, 12u) << "the edges of one box";
    key('b', true);
    EXPECT_TRUE(viewer_->overlay().lines.empty());
    key('B', true);
    EXPECT_FALSE(viewer_->overlay().lines.empty()) << "backwards, the deepest comes first";
    for (int i = 0; i < 100 && !viewer_->overlay().lines.empty(); ++i) key('b');
    EXPECT_TRUE(viewer_->overlay().lines.empty());
}

TEST_F(ViewerTest, ShadingsGoAround) {
    open();
    std::vector<std::vector<std::uint8_t>> pictures;
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(std::count(pictures.begin(), pictures.end(), viewer_->frame().bytes), 0);
        pictures.push_back(viewer_->frame().bytes);
        key('v');
        come_to_rest();
    }
    EXPECT_EQ(viewer_->frame().bytes, pictures[0]) << "the first again";
    key('v', true);
    EXPECT_TRUE(shows("cost"));
}

TEST_F(ViewerTest, PausedItStaysPausedOverMoves) {
    open();
    key(' ');
    hold(SpecialKey::up, 0.3);
    come_to_rest();
    EXPECT_EQ(viewer_->status().passes, 1u);
    EXPECT_TRUE(viewer_->status().is_paused);
    EXPECT_TRUE(shows("paused"));
    key('i');
    key('p');
    EXPECT_TRUE(comes_true([&] { return shows("saved"); })) << "also without the information";
    key('i');
    key(' ');
    come_to_rest();
    EXPECT_EQ(viewer_->status().passes, 4u);
}

TEST_F(ViewerTest, AnotherSizeIsRenderedAtThatSize) {
    open();
    viewer_->resize({200, 50});
    come_to_rest();
    EXPECT_EQ(viewer_->frame().resolution, (scene::Resolution{200, 50}));
}

TEST_F(ViewerTest, TheSizeThatTheFileAsksForIsAskedOfTheWindow) {
    open();
    std::string text = kScene;
    text.replace(text.find("[160, 120]"), 10, "[300, 200]");
    program_->write_scene(text);
    key('r');
    std::optional<scene::Resolution> wanted;
    EXPECT_TRUE(comes_true([&] {
        const Tick tick = viewer_->tick(now_);
        if (tick.wanted_size) wanted = tick.wanted_size;
        return viewer_->wanted_size().width == 300;
    }));
}

TEST_F(ViewerTest, HelpAndQuit) {
    open();
    EXPECT_FALSE(shows("undo, redo"));
    key('h');
    EXPECT_TRUE(shows("undo, redo"));
    key('?');
    EXPECT_FALSE(shows("undo, redo"));
    EXPECT_EQ(viewer_->state(), ViewerState::open);
    key('\x1b');
    EXPECT_EQ(viewer_->state(), ViewerState::closed);
}

TEST_F(ViewerTest, AnInterruptEndsIt) {
    open();
    program_->is_interrupted_ = true;
    viewer_->tick(now_);
    EXPECT_EQ(viewer_->state(), ViewerState::interrupted);
}

}  // namespace
}  // namespace lray::gui
