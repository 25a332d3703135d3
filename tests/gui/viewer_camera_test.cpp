// Where keys, mouse and stored views lead the camera of the viewer.
#include "tests/gui/viewer_test.h"

namespace lray::gui {
namespace {

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

TEST_F(ViewerTest, AWindowWithoutTheKeyboardRepeatsNothing) {
    open();
    viewer_->press({SpecialKey::page_up, '\0', false}, now_);
    EXPECT_TRUE(viewer_->has_held_keys());
    viewer_->release_all_keys(now_);
    EXPECT_FALSE(viewer_->has_held_keys());
    for (int i = 0; i < 100; ++i) viewer_->tick(now_ += 0.1);
    EXPECT_TRUE(shows("exposure +0.0")) << "this scene is flat, and has none";
}

TEST_F(ViewerTest, AHeldKeyRepeats) {
    open();
    viewer_->press({SpecialKey::none, '+', false}, now_);
    for (int i = 0; i < 10; ++i) viewer_->tick(now_ += 0.1);
    viewer_->release({SpecialKey::none, '+', false}, now_);
    EXPECT_FALSE(shows("speed 2 ")) << "but more";
    EXPECT_FALSE(shows("speed 1 "));
}

}  // namespace
}  // namespace lray::gui
