#include "gui/panels.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace lray::gui {
namespace {

constexpr Font kSmall{8, 13, 11};
constexpr Font kLarge{9, 15, 12};

std::vector<OverlayText> texts_of(const Overlay& overlay) {
    std::vector<OverlayText> texts;
    for (const auto& mark : overlay.marks) {
        if (const auto* text = std::get_if<OverlayText>(&mark)) texts.push_back(*text);
    }
    return texts;
}

/// All text, a line each.
std::string all_text(const Overlay& overlay) {
    std::string all;
    for (const OverlayText& text : texts_of(overlay)) all += text.text + "\n";
    return all;
}

bool has(const Overlay& overlay, std::string_view text) {
    return all_text(overlay).find(text) != std::string::npos;
}

/// Nothing is outside of the window, and no box is inside out.
void expect_inside(const Overlay& overlay, const Font& font, WindowSize window) {
    for (const auto& mark : overlay.marks) {
        Box box;
        if (const auto* text = std::get_if<OverlayText>(&mark)) {
            box = {text->at.x, text->at.y,
                   text->at.x + static_cast<double>(text->text.size()) * font.width,
                   text->at.y + font.height};
        } else {
            box = std::get<OverlayBox>(mark).box;
        }
        EXPECT_GE(box.left, 0.0);
        EXPECT_GE(box.top, 0.0);
        EXPECT_LE(box.right, window.width);
        EXPECT_LE(box.bottom, window.height);
        EXPECT_LE(box.left, box.right);
        EXPECT_LE(box.top, box.bottom);
    }
}

constexpr WindowSize kWindow{800, 600};
constexpr WindowSize kWindows[] = {{0, 0},     {1, 1},     {8, 13},     {30, 20},
                                   {3000, 5},  {5, 3000},  {64, 64},    {200, 100},
                                   {320, 240}, {800, 600}, {3840, 2160}};

HudState full_state() {
    HudState state;
    state.pass_count = 12;
    state.pass_limit = 64;
    state.rays_per_second = 3.21e6;
    state.resolution = {640, 480};
    state.accel = "boxes";
    state.shading = "full";
    state.speed = 2.0;
    state.exposure = 0.5;
    state.tonemap = image::ToneMap::aces;
    state.volume_level = 3;
    state.picked = PickedObject{"tower / roof", "caf\u00e9.lrs:42:3"};
    return state;
}

TEST(Hud, ShowsWhatItKnows) {
    Overlay overlay;
    add_hud(overlay, full_state(), kSmall, kWindow);
    for (const char* text :
         {"pass 12 of 64", "3.21 Mrays/s", "640 x 480", "position [0, 0, 5]", "look_at [0, 0, 0]",
          "fov 45", "boxes", "orbit", "speed 2", "exposure +0.5", "aces", "shading full",
          "volumes of level 3", "tower / roof", "caf\xe9.lrs:42:3"}) {
        EXPECT_TRUE(has(overlay, text)) << text << " in\n" << all_text(overlay);
    }
}

TEST(Hud, EveryStateHasItsWords) {
    const auto first_line = [](const HudState& state) {
        Overlay overlay;
        add_hud(overlay, state, kSmall, kWindow);
        return texts_of(overlay).at(0).text;
    };
    HudState state = full_state();
    state.preview_divisor = 8;
    EXPECT_EQ(first_line(state), "preview 1/8  3.21 Mrays/s  640 x 480");
    state.preview_divisor = 1;
    state.pass_limit.reset();
    state.rays_per_second = 0.0;
    EXPECT_EQ(first_line(state), "pass 12  640 x 480");
    state.pass_count = 0;
    EXPECT_EQ(first_line(state), "first pass  640 x 480");
    state.state = RenderState::paused;
    state.pass_count = 1;
    EXPECT_EQ(first_line(state), "paused after 1 pass  640 x 480");
    state.state = RenderState::done;
    state.pass_count = 64;
    EXPECT_EQ(first_line(state), "done, 64 passes  640 x 480");
    state.state = RenderState::loading;
    EXPECT_EQ(first_line(state), "loading...  640 x 480");
}

TEST(Hud, ProjectionsShowTheirOwnSize) {
    HudState state = full_state();
    state.is_flying = true;
    state.camera.projection = scene::Projection::orthographic;
    Overlay flat;
    add_hud(flat, state, kSmall, kWindow);
    EXPECT_TRUE(has(flat, "height 2"));
    EXPECT_TRUE(has(flat, "fly"));
    state.camera.projection = scene::Projection::panorama;
    Overlay round;
    add_hud(round, state, kSmall, kWindow);
    EXPECT_TRUE(has(round, "panorama"));
}

TEST(Notice, StandsAtTheBottom) {
    Overlay overlay;
    add_notice(overlay, "saved caf\u00e9-001.png", kSmall, kWindow);
    const auto texts = texts_of(overlay);
    ASSERT_EQ(texts.size(), 1u);
    EXPECT_EQ(texts[0].text, "saved caf\xe9-001.png");
    EXPECT_GT(texts[0].at.y, kWindow.height - 3.0 * kSmall.height);
}

TEST(Panels, FitIntoWindowsOfAnySize) {
    const auto lines = help_lines(KeyboardLayout::azerty, true);
    HudState state = full_state();
    state.picked->name = std::string(5000, 'n');
    for (const WindowSize window : kWindows) {
        for (const Font& font : {kSmall, kLarge}) {
            SCOPED_TRACE(::testing::Message() << window.width << " x " << window.height);
            Overlay overlay;
            add_hud(overlay, state, font, window);
            add_notice(overlay, std::string(5000, 'm'), font, window);
            add_help(overlay, lines, font, window);
            add_messages(overlay, "error: one\n  two\n\nthree\n", font, window);
            expect_inside(overlay, font, window);
        }
    }
}

TEST(Help, ShowsAllLinesWhereTheyFitBelowEachOther) {
    const auto lines = help_lines(KeyboardLayout::qwerty, true);
    Overlay overlay;
    add_help(overlay, lines, kSmall, kWindow);
    const auto texts = texts_of(overlay);
    ASSERT_EQ(texts.size(), lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        EXPECT_TRUE(texts[i].text.starts_with(lines[i].keys));
        EXPECT_TRUE(texts[i].text.ends_with(lines[i].what));
    }
}

TEST(Help, LowWindowsHaveTwoColumnsWithAllLines) {
    const auto lines = help_lines(KeyboardLayout::qwerty, true);
    Overlay overlay;
    const WindowSize low{1200, 260};
    add_help(overlay, lines, kSmall, low);
    EXPECT_EQ(texts_of(overlay).size(), (lines.size() + 1) / 2);
    for (const HelpLine& line : lines) EXPECT_TRUE(has(overlay, line.what)) << line.what;
    expect_inside(overlay, kSmall, low);
}

TEST(Messages, ShowsEachLineInItsColour) {
    Overlay overlay;
    add_messages(overlay,
                 "a: error[E1]: caf\u00e9\n  \u256d\u2500 a.lrs:1:2\n\na: warning[W1]: w\n", kSmall,
                 kWindow);
    const auto texts = texts_of(overlay);
    ASSERT_EQ(texts.size(), 3u);  // the empty one needs no text, but its place
    EXPECT_EQ(texts[0].text, "a: error[E1]: caf\xe9");
    EXPECT_EQ(texts[1].text, "  +- a.lrs:1:2");
    EXPECT_EQ(texts[2].text, "a: warning[W1]: w");
    EXPECT_EQ(texts[2].at.y - texts[0].at.y, 3.0 * kSmall.height);
    EXPECT_NE(texts[0].color, texts[1].color);
    EXPECT_NE(texts[0].color, texts[2].color);
}

TEST(Messages, NothingToSayIsNoPanel) {
    Overlay overlay;
    add_messages(overlay, "", kSmall, kWindow);
    add_messages(overlay, "\n\n", kSmall, kWindow);
    EXPECT_TRUE(overlay.marks.empty());
}

TEST(Messages, LongLinesAreCutAndNotWrapped) {
    Overlay overlay;
    add_messages(overlay, "first " + std::string(1000, 'x') + "\nsecond", kSmall, kWindow);
    const auto texts = texts_of(overlay);
    ASSERT_EQ(texts.size(), 2u);
    EXPECT_TRUE(texts[0].text.ends_with("x..."));
    EXPECT_LE(texts[0].text.size(), 100u);
    EXPECT_EQ(texts[1].text, "second");
}

TEST(Messages, SaysHowManyLinesAreLeftOut) {
    std::string text;
    for (int i = 1; i <= 100; ++i) text += "line " + std::to_string(i) + "\n";
    Overlay overlay;
    add_messages(overlay, text, kSmall, kWindow);
    const auto texts = texts_of(overlay);
    EXPECT_EQ(texts[0].text, "line 1");
    const std::size_t shown = texts.size() - 1;
    EXPECT_GT(shown, 30u);
    EXPECT_EQ(texts.back().text, std::to_string(100 - shown) + " more lines; see the terminal");
    expect_inside(overlay, kSmall, kWindow);
}

TEST(Messages, ThatJustFitAreAllShown) {
    // Six of 13 pixels, the padding and the margin.
    const WindowSize window{400, 6 * 13 + 12 + 16};
    Overlay overlay;
    add_messages(overlay, "1\n2\n3\n4\n5\n6\n", kSmall, window);
    EXPECT_EQ(all_text(overlay), "1\n2\n3\n4\n5\n6\n");
    Overlay more;
    add_messages(more, "1\n2\n3\n4\n5\n6\n7\n", kSmall, window);
    EXPECT_EQ(all_text(more), "1\n2\n3\n4\n5\n2 more lines; see the terminal\n");
    Overlay single;
    add_messages(single, "1\n2\n", kSmall, {400, 13 + 12 + 16});
    EXPECT_EQ(all_text(single), "2 more lines; see the terminal\n");
}

TEST(Messages, AMegabyteIsAFewLines) {
    for (const std::string& text : {std::string(1 << 20, '\n') + "x", std::string(1 << 20, 'x'),
                                    std::string(1 << 20, '\xff')}) {
        Overlay overlay;
        add_messages(overlay, text, kSmall, kWindow);
        EXPECT_LE(overlay.marks.size(), 60u);
        expect_inside(overlay, kSmall, kWindow);
    }
}

TEST(Messages, StandAtTheBottom) {
    Overlay overlay;
    add_messages(overlay, "one\ntwo\n", kSmall, kWindow);
    const auto texts = texts_of(overlay);
    EXPECT_GT(texts.back().at.y, kWindow.height - 3.0 * kSmall.height);
    EXPECT_GT(texts.front().at.y, kWindow.height - 4.0 * kSmall.height);
}

TEST(Messages, HaveARimAroundThem) {
    Overlay overlay;
    add_messages(overlay, "error", kSmall, kWindow);
    std::vector<OverlayBox> boxes;
    for (const auto& mark : overlay.marks) {
        if (const auto* box = std::get_if<OverlayBox>(&mark)) boxes.push_back(*box);
    }
    ASSERT_EQ(boxes.size(), 5u);
    EXPECT_GT(boxes[1].color.r, 2.0f * boxes[1].color.g);
    EXPECT_EQ(boxes[1].box.left, boxes[0].box.left);
    EXPECT_EQ(boxes[2].box.bottom, boxes[0].box.bottom);
}

TEST(ShortCount, ThreeDigitsAndAUnit) {
    EXPECT_EQ(short_count(0.0), "0 ");
    EXPECT_EQ(short_count(-1.0), "0 ");
    EXPECT_EQ(short_count(7.0), "7 ");
    EXPECT_EQ(short_count(999.4), "999 ");
    EXPECT_EQ(short_count(999.6), "1.00 k");
    EXPECT_EQ(short_count(12345.0), "12.3 k");
    EXPECT_EQ(short_count(3.2e6), "3.20 M");
    EXPECT_EQ(short_count(999.7e6), "1.00 G");
    EXPECT_EQ(short_count(123e9), "123 G");
    EXPECT_EQ(short_count(9.996e6), "10.0 M");
}

}  // namespace
}  // namespace lray::gui
