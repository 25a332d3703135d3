// What becomes of the viewer when its scene is loaded again: by a save, a key or a slider.
#include "tests/gui/viewer_test.h"

namespace lray::gui {
namespace {

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
    {
        const std::lock_guard lock(program_->mutex_);  // the first of them waits in load()
        for (int i = 0; i < 20; ++i) {
            std::string text = kScene;
            text.replace(text.find("160"), 3, std::to_string(200 + i));
            program_->write_scene(text);
            key('r');
        }
    }
    EXPECT_TRUE(comes_true([&] {
        return wanted_size_ == scene::Resolution{219, 120} && !viewer_->is_loading();
    }));
    // At the start, twice for the keys, and once for the watch, which noticed the files too.
    EXPECT_LE(load_count(), 4);
}

TEST_F(ViewerTest, ASlidersValueIsGivenToTheScene) {
    program_ = std::make_unique<FakeProgram>(
        "param size = 1 in [0.5, 2]\n"
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
    viewer_.reset();
    open_program(std::move(program));
    key('r');
    EXPECT_TRUE(shows("stdin"));
    EXPECT_FALSE(viewer_->is_loading());
    EXPECT_FALSE(shows("size")) << "a slider that does nothing";
}

TEST_F(ViewerTest, TheSizeThatTheFileAsksForIsAskedOfTheWindow) {
    open();
    std::string text = kScene;
    text.replace(text.find("[160, 120]"), 10, "[300, 200]");
    program_->write_scene(text);
    key('r');
    EXPECT_TRUE(comes_true([&] { return wanted_size_.has_value(); }));
    EXPECT_EQ(wanted_size_, (scene::Resolution{300, 200}));
}

TEST_F(ViewerTest, WithoutMemoryALoadOrASaveIsToldAndNothingEnds) {
    open();
    Program program = program_->program();
    program.load = [](std::span<const ParamText>) -> LoadedScene { throw std::bad_alloc(); };
    program.save = [](image::Image, const image::DisplaySettings&) -> Outcome {
        throw std::length_error("too long");
    };
    viewer_.reset();
    open_program(std::move(program));
    key('p');
    EXPECT_TRUE(comes_true([&] { return shows("not enough memory to save"); }));
    key('r');
    EXPECT_TRUE(comes_true([&] { return shows("not enough memory to load"); }));
    come_to_rest();
    EXPECT_EQ(viewer_->state(), ViewerState::open);
}

}  // namespace
}  // namespace lray::gui
