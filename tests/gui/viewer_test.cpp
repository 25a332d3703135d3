// The viewer without its window: the picture, and what is drawn over it.
#include "tests/gui/viewer_test.h"

namespace lray::gui {
namespace {

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
    EXPECT_TRUE(comes_true([&] { return shows("saved scene-001.png"); }));
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

TEST_F(ViewerTest, RowsThatNobodyDrewAreThoseOfTheFrame) {
    open();
    viewer_->resize({160, 400});
    come_to_rest();
    viewer_->resize({160, 120});
    come_to_rest();
    const auto rows = viewer_->take_changed_rows();
    ASSERT_TRUE(rows.has_value());
    EXPECT_EQ(rows->end, 120u);
}

TEST_F(ViewerTest, ACropKeepsItsPartOfTheWindow) {
    open();
    drag(MouseButton::right, {40, 30}, {80, 60});
    viewer_->resize({320, 240});
    come_to_rest();
    EXPECT_EQ(saved_picture().width, 80u);
    viewer_->resize({1, 1});
    come_to_rest();
    EXPECT_EQ(saved_picture().width, 1u);
}

TEST_F(ViewerTest, APictureThatWasAskedForIsSavedBeforeTheEnd) {
    open();
    for (int i = 0; i < 3; ++i) key('p');
    key('x');
    viewer_.reset();
    EXPECT_EQ(program_->save_count_, 3);
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
