#include "render/live_picture.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "image/srgb.h"

namespace lray::render {
namespace {

constexpr Color kRed{1.0f, 0.0f, 0.0f};
constexpr Color kGrey{0.25f};

std::array<int, 4> pixel(const Frame& frame, std::uint32_t x, std::uint32_t y) {
    const std::size_t at = 4 * (std::size_t{y} * frame.resolution.width + x);
    return {frame.bytes[at], frame.bytes[at + 1], frame.bytes[at + 2], frame.bytes[at + 3]};
}

TEST(LivePicture, IsNothingToCopyBeforeAnythingWasPut) {
    LivePicture picture({5, 40}, {});
    picture.set_display({.exposure = 1.0});
    Frame frame;
    EXPECT_FALSE(picture.copy_changes(frame).has_value());
    EXPECT_TRUE(frame.bytes.empty());
}

TEST(LivePicture, IsBlackWhereNothingWasPut) {
    LivePicture picture({5, 40}, {});
    picture.put({0, 0, 1, 1}, std::array<Color, 1>{kRed}, 1);
    Frame frame;
    EXPECT_TRUE(picture.copy_changes(frame).has_value());
    EXPECT_EQ(pixel(frame, 0, 0), (std::array<int, 4>{255, 0, 0, 255}));
    for (const std::uint32_t y : {1u, 39u}) {
        EXPECT_EQ(pixel(frame, 4, y), (std::array<int, 4>{0, 0, 0, 255}));
    }
}

TEST(LivePicture, ShowsValuesInSquaresThatThePartCutsOff) {
    LivePicture picture({20, 40}, {});
    const std::array<Color, 4> light{kRed, kGrey, kGrey, kRed};
    picture.put({2, 10, 9, 20}, light, 6);
    Frame frame;
    picture.copy_changes(frame);
    const int grey = image::srgb_encode_8(0.25f);
    for (std::uint32_t y = 0; y < 40; ++y) {
        for (std::uint32_t x = 0; x < 20; ++x) {
            const bool is_inside = x >= 2 && x < 9 && y >= 10 && y < 20;
            const bool is_red = (x < 8) == (y < 16);
            const std::array<int, 4> expected = !is_inside ? std::array<int, 4>{0, 0, 0, 255}
                                                : is_red
                                                    ? std::array<int, 4>{255, 0, 0, 255}
                                                    : std::array<int, 4>{grey, grey, grey, 255};
            ASSERT_EQ(pixel(frame, x, y), expected) << x << ", " << y;
        }
    }
    EXPECT_EQ(picture.light({2, 10, 9, 20}).at(6, 0), kGrey);
}

TEST(LivePicture, CopiesTheRowsThatChanged) {
    LivePicture picture({20, 100}, {});
    Frame frame;
    picture.put({0, 0, 1, 100}, std::vector<Color>(100, kGrey), 1);
    picture.copy_changes(frame);
    picture.put({0, 50, 1, 51}, std::array<Color, 1>{kRed}, 1);
    const auto rows = picture.copy_changes(frame);
    ASSERT_TRUE(rows.has_value());
    EXPECT_LE(rows->begin, 50u);
    EXPECT_GE(rows->end, 51u);
    EXPECT_LT(rows->end - rows->begin, 50u);
    EXPECT_EQ(pixel(frame, 0, 50)[0], 255);
    EXPECT_FALSE(picture.copy_changes(frame).has_value());
}

TEST(LivePicture, OfAnotherSizeShowsTheOldOneStretched) {
    LivePicture small({2, 2}, {});
    small.put({0, 0, 2, 2}, std::array<Color, 4>{kRed, kGrey, kGrey, kRed}, 1);
    const LivePicture large({40, 60}, {.exposure = 1.0}, &small);
    Frame frame;
    large.copy_changes(frame);
    const int grey = image::srgb_encode_8(0.5f);
    EXPECT_EQ(pixel(frame, 19, 29), (std::array<int, 4>{255, 0, 0, 255}));
    EXPECT_EQ(pixel(frame, 20, 29), (std::array<int, 4>{grey, grey, grey, 255}));
    EXPECT_EQ(pixel(frame, 39, 59), (std::array<int, 4>{255, 0, 0, 255}));
}

TEST(LivePicture, OfTheSameSizeIsTakenForAnother) {
    LivePicture first({20, 20}, {});
    Frame frame;
    first.put({0, 0, 1, 1}, std::array<Color, 1>{kRed}, 1);
    first.copy_changes(frame);
    const LivePicture second({20, 20}, {}, &first);
    EXPECT_TRUE(second.copy_changes(frame).has_value());
}

}  // namespace
}  // namespace lray::render
