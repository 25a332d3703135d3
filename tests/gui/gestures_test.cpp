#include "gui/gestures.h"

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace lray::gui {
namespace {

TEST(MouseGestures, APressAndReleaseNearbyIsAClick) {
    MouseGestures mouse;
    EXPECT_EQ(mouse.press(MouseButton::left, {10.0, 20.0}, false).kind, GestureKind::none);
    EXPECT_EQ(mouse.move({12.0, 22.0}).kind, GestureKind::none);
    const Gesture click = mouse.release(MouseButton::left, {12.0, 21.0});
    EXPECT_EQ(click.kind, GestureKind::click);
    EXPECT_EQ(click.at, DVec2(12.0, 21.0));
    EXPECT_FALSE(mouse.is_held());
}

TEST(MouseGestures, FourPixelsAwayADragBeginsWithAllOfItsWay) {
    MouseGestures mouse;
    mouse.press(MouseButton::left, {0.0, 0.0}, false);
    EXPECT_EQ(mouse.move({3.9, 0.0}).kind, GestureKind::none);
    const Gesture first = mouse.move({4.0, 0.0});
    EXPECT_EQ(first.kind, GestureKind::orbit);
    EXPECT_EQ(first.delta, DVec2(4.0, 0.0));
    const Gesture second = mouse.move({1.0, 1.0});  // back within the reach: still a drag
    EXPECT_EQ(second.kind, GestureKind::orbit);
    EXPECT_EQ(second.delta, DVec2(-3.0, 1.0));
    EXPECT_EQ(mouse.release(MouseButton::left, {1.0, 1.0}).kind, GestureKind::orbit);
}

TEST(MouseGestures, ShiftOrTheMiddleButtonPans) {
    MouseGestures mouse;
    mouse.press(MouseButton::left, {0.0, 0.0}, true);
    EXPECT_EQ(mouse.move({9.0, 0.0}).kind, GestureKind::pan);
    mouse.release(MouseButton::left, {9.0, 0.0});
    mouse.press(MouseButton::middle, {0.0, 0.0}, false);
    EXPECT_EQ(mouse.move({9.0, 0.0}).kind, GestureKind::pan);
}

TEST(MouseGestures, AMiddleClickIsNothing) {
    MouseGestures mouse;
    mouse.press(MouseButton::middle, {0.0, 0.0}, false);
    EXPECT_EQ(mouse.release(MouseButton::middle, {1.0, 0.0}).kind, GestureKind::none);
}

TEST(MouseGestures, TheRightButtonDrawsACropOrClearsIt) {
    MouseGestures mouse;
    mouse.press(MouseButton::right, {5.0, 5.0}, false);
    const Gesture drawn = mouse.move({20.0, 30.0});
    EXPECT_EQ(drawn.kind, GestureKind::crop_drawn);
    EXPECT_EQ(drawn.from, DVec2(5.0, 5.0));
    EXPECT_EQ(drawn.at, DVec2(20.0, 30.0));
    const Gesture chosen = mouse.release(MouseButton::right, {21.0, 31.0});
    EXPECT_EQ(chosen.kind, GestureKind::crop_chosen);
    EXPECT_EQ(chosen.from, DVec2(5.0, 5.0));
    EXPECT_EQ(chosen.at, DVec2(21.0, 31.0));
    mouse.press(MouseButton::right, {5.0, 5.0}, false);
    EXPECT_EQ(mouse.release(MouseButton::right, {5.0, 5.0}).kind, GestureKind::crop_cleared);
}

TEST(MouseGestures, ADragReportedOnlyByItsReleaseIsNoClick) {
    MouseGestures mouse;
    mouse.press(MouseButton::left, {0.0, 0.0}, false);
    const Gesture gesture = mouse.release(MouseButton::left, {50.0, 0.0});
    EXPECT_EQ(gesture.kind, GestureKind::orbit);
    EXPECT_EQ(gesture.delta, DVec2(50.0, 0.0));
}

TEST(MouseGestures, OtherButtonsDoNothingMeanwhileButTheWheelTurns) {
    MouseGestures mouse;
    mouse.press(MouseButton::left, {0.0, 0.0}, false);
    mouse.press(MouseButton::right, {0.0, 0.0}, false);
    EXPECT_EQ(mouse.release(MouseButton::right, {0.0, 0.0}).kind, GestureKind::none);
    const Gesture closer = mouse.press(MouseButton::wheel_up, {7.0, 8.0}, false);
    EXPECT_EQ(closer.kind, GestureKind::wheel);
    EXPECT_EQ(closer.delta.y, 1.0);
    EXPECT_EQ(closer.at, DVec2(7.0, 8.0));
    EXPECT_EQ(mouse.release(MouseButton::wheel_up, {7.0, 8.0}).kind, GestureKind::none);
    EXPECT_EQ(mouse.press(MouseButton::wheel_down, {7.0, 8.0}, false).delta.y, -1.0);
    EXPECT_EQ(mouse.move({9.0, 0.0}).kind, GestureKind::orbit);
}

TEST(MouseGestures, WithoutAPressNothingComes) {
    MouseGestures mouse;
    EXPECT_EQ(mouse.move({9.0, 0.0}).kind, GestureKind::none);
    EXPECT_EQ(mouse.release(MouseButton::left, {9.0, 0.0}).kind, GestureKind::none);
    mouse.press(MouseButton::left, {0.0, 0.0}, false);
    mouse.cancel();
    EXPECT_EQ(mouse.release(MouseButton::left, {0.0, 0.0}).kind, GestureKind::none);
}

TEST(MouseGestures, TheDeltasOfADragSumUpToItsWay) {
    constexpr std::uint64_t kSeed = 59;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    const auto position = [&] {
        return DVec2(static_cast<double>(random.below(800)),
                     static_cast<double>(random.below(600)));
    };
    for (int i = 0; i < 200; ++i) {
        MouseGestures mouse;
        const DVec2 from = position();
        DVec2 to = from;
        DVec2 sum{0.0};
        mouse.press(MouseButton::left, from, false);
        for (int k = 0; k < 20; ++k) {
            to = position();
            sum += mouse.move(to).delta;
        }
        sum += mouse.release(MouseButton::left, to).delta;
        EXPECT_EQ(sum, to - from);
    }
}

TEST(TouchedPixels, WhateverCornersItIsDrawnFrom) {
    for (const auto& [from, to] : {std::pair(DVec2(10.2, 20.8), DVec2(30.0, 40.1)),
                                   std::pair(DVec2(30.0, 20.8), DVec2(10.2, 40.1))}) {
        const auto rect = touched_pixels(from, to, {640, 480});
        ASSERT_TRUE(rect);
        EXPECT_EQ(rect->x0, 10u);
        EXPECT_EQ(rect->y0, 20u);
        EXPECT_EQ(rect->x1, 30u);
        EXPECT_EQ(rect->y1, 41u);
    }
}

TEST(TouchedPixels, EndsWithThePictureAndMayBeEmpty) {
    const auto rect = touched_pixels({-50.0, -3.0}, {9000.0, 2.0}, {640, 480});
    ASSERT_TRUE(rect);
    EXPECT_EQ(rect->x0, 0u);
    EXPECT_EQ(rect->y0, 0u);
    EXPECT_EQ(rect->x1, 640u);
    EXPECT_EQ(rect->y1, 2u);
    EXPECT_FALSE(touched_pixels({700.0, 0.0}, {800.0, 50.0}, {640, 480}));
    EXPECT_FALSE(touched_pixels({5.0, 5.0}, {5.0, 50.0}, {640, 480}));
    EXPECT_FALSE(touched_pixels({0.0, 0.0}, {5.0, 5.0}, {0, 0}));
}

}  // namespace
}  // namespace lray::gui
