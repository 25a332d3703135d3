#include "cli/frames.h"

#include <gtest/gtest.h>

namespace lray::cli {
namespace {

TEST(NumberedPath, LastRunOfTheFileNameIsTheNumber) {
    EXPECT_EQ(numbered_path("out-####.png", 7), "out-0007.png");
    EXPECT_EQ(numbered_path("out-#.png", 12), "out-12.png");
    EXPECT_EQ(numbered_path("##/a#b-###.png", 5), "##/a#b-005.png");
    EXPECT_EQ(numbered_path("####", 123456), "123456");
    EXPECT_EQ(numbered_path("out.png", 7), "out.png");
    EXPECT_EQ(numbered_path("#/out.png", 7), "#/out.png");
    EXPECT_TRUE(has_frame_number("a/#"));
    EXPECT_FALSE(has_frame_number("a#/b"));
}

TEST(OptionsOfFrame, EachHasItsNumberItsOutputAndItsLabel) {
    Options options;
    options.output_path = "out-##.png";
    options.frames = {3, 5};
    ASSERT_EQ(frame_count(options), 3u);
    const Options last = options_of_frame(options, 2);
    EXPECT_EQ(last.frames, (FrameRange{5, 5}));
    EXPECT_EQ(last.output_path, "out-05.png");
    EXPECT_EQ(last.frame_label, "frame 3 of 3");
    options.frames = {4, 4};
    EXPECT_EQ(options_of_frame(options, 0).output_path, "out-04.png");
    EXPECT_EQ(options_of_frame(options, 0).frame_label, "");
    options.frames.reset();
    EXPECT_EQ(frame_count(options), 1u);
    EXPECT_EQ(options_of_frame(options, 0).output_path, "out-##.png");
}

}  // namespace
}  // namespace lray::cli
