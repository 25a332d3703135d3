#include "gui/camera_history.h"

#include <gtest/gtest.h>

namespace lray::gui {
namespace {

scene::Camera at(double x) {
    scene::Camera camera;
    camera.position.x = x;
    return camera;
}

/// Where a camera is, or -1 if there is none.
double place(const std::optional<scene::Camera>& camera) {
    return camera ? camera->position.x : -1.0;
}

TEST(CameraHistory, GoesBackAndForth) {
    CameraHistory history;
    history.remember(at(1.0));
    history.remember(at(2.0));
    EXPECT_EQ(place(history.undo(at(3.0))), 2.0);
    EXPECT_EQ(place(history.undo(at(2.0))), 1.0);
    EXPECT_EQ(place(history.undo(at(1.0))), -1.0);
    EXPECT_EQ(place(history.redo(at(1.0))), 2.0);
    EXPECT_EQ(place(history.redo(at(2.0))), 3.0);
    EXPECT_EQ(place(history.redo(at(3.0))), -1.0);
    EXPECT_EQ(place(history.undo(at(3.0))), 2.0);
}

TEST(CameraHistory, ANewMoveForgetsWhatWasUndone) {
    CameraHistory history;
    history.remember(at(1.0));
    EXPECT_EQ(place(history.undo(at(2.0))), 1.0);
    history.remember(at(1.0));
    EXPECT_EQ(place(history.redo(at(5.0))), -1.0);
    EXPECT_EQ(place(history.undo(at(5.0))), 1.0);
}

TEST(CameraHistory, TheSameViewTwiceIsOneEntry) {
    CameraHistory history;
    history.remember(at(1.0));
    history.remember(at(1.0));
    EXPECT_EQ(place(history.undo(at(2.0))), 1.0);
    EXPECT_EQ(place(history.undo(at(1.0))), -1.0);
}

TEST(CameraHistory, UndoSkipsMovesThatWentNowhere) {
    CameraHistory history;
    history.remember(at(1.0));
    history.remember(at(2.0));  // a press of the mouse without a drag
    EXPECT_EQ(place(history.undo(at(2.0))), 1.0);
    EXPECT_EQ(place(history.redo(at(1.0))), 2.0);
}

TEST(CameraHistory, TheOldestAreForgotten) {
    CameraHistory history;
    const auto count = static_cast<int>(CameraHistory::kMaxSize) + 10;
    for (int i = 0; i < count; ++i) history.remember(at(i));
    scene::Camera current = at(count);
    std::size_t undone = 0;
    while (const auto camera = history.undo(current)) {
        current = *camera;
        ++undone;
    }
    EXPECT_EQ(undone, CameraHistory::kMaxSize);
    EXPECT_EQ(current.position.x, 10.0);
}

TEST(IsSameView, WhatIsSeenCountsAndNamesDoNot) {
    scene::Camera camera;
    camera.name = "other";
    EXPECT_TRUE(is_same_view(camera, {}));
    camera.focus = 3.0;
    EXPECT_FALSE(is_same_view(camera, {}));
    camera = {};
    camera.height = 3.0;
    EXPECT_FALSE(is_same_view(camera, {}));
}

}  // namespace
}  // namespace lray::gui
