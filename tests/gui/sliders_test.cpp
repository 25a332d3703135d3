#include "gui/sliders.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace lray::gui {
namespace {

constexpr Font kFont{8, 13, 11};
constexpr WindowSize kWindow{800, 600};

Slider slider(std::string name, double value = 0.0) {
    return {.name = std::move(name), .value = value, .least = 0.0, .greatest = 10.0};
}

Sliders sliders_of(std::size_t count, WindowSize window = kWindow) {
    std::vector<Slider> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(slider(fmt::format("p{}", i)));
    Sliders sliders;
    sliders.set(all);
    sliders.lay_out(window, kFont);
    return sliders;
}

/// The middle of what a press on this slider can hit.
std::optional<DVec2> place_of(const Sliders& sliders, std::size_t index, WindowSize window) {
    DVec2 sum{0.0};
    double count = 0.0;
    for (int y = 0; y < window.height; ++y) {
        for (int x = std::max(0, window.width - 300); x < window.width; ++x) {
            if (sliders.at(DVec2(x, y)) != index) continue;
            sum += DVec2(x, y);
            count += 1.0;
        }
    }
    if (count == 0.0) return {};
    return sum / count;
}

std::string all_text(const Sliders& sliders) {
    Overlay overlay;
    sliders.draw(overlay);
    std::string all;
    for (const auto& mark : overlay.marks) {
        if (const auto* text = std::get_if<OverlayText>(&mark)) all += text->text + "\n";
    }
    return all;
}

TEST(Sliders, AreInTheTopRightCorner) {
    const Sliders sliders = sliders_of(3);
    DVec2 above{0.0};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto place = place_of(sliders, i, kWindow);
        ASSERT_TRUE(place);
        EXPECT_GT(place->x, 600.0);
        EXPECT_GT(place->y, above.y);
        EXPECT_LT(place->y, 100.0);
        above = *place;
    }
    EXPECT_FALSE(sliders.at({400.0, 20.0}));
    EXPECT_FALSE(sliders.at({780.0, 300.0}));
}

TEST(Sliders, APressSetsTheValueAndSelects) {
    Sliders sliders = sliders_of(3);
    const DVec2 place = place_of(sliders, 1, kWindow).value();
    EXPECT_TRUE(sliders.press(place));
    EXPECT_EQ(sliders.selected(), 1u);
    EXPECT_NEAR(sliders.all()[1].value, 5.0, 0.06);
    EXPECT_EQ(sliders.all()[0].value, 0.0);
    EXPECT_TRUE(sliders.take_change());
    EXPECT_FALSE(sliders.take_change());
}

TEST(Sliders, ADragFollowsTheMouseAnywhereAndEndsAtTheEnds) {
    Sliders sliders = sliders_of(3);
    ASSERT_TRUE(sliders.press(place_of(sliders, 1, kWindow).value()));
    double before = -1.0;
    for (double x = 0.0; x < 800.0; x += 10.0) {
        EXPECT_TRUE(sliders.drag({x, 599.0}));
        EXPECT_GE(sliders.all()[1].value, before);
        before = sliders.all()[1].value;
    }
    EXPECT_EQ(before, 10.0);
    sliders.drag({-1e9, 0.0});
    EXPECT_EQ(sliders.all()[1].value, 0.0);
    sliders.release();
    EXPECT_FALSE(sliders.drag({800.0, 0.0}));
    EXPECT_EQ(sliders.all()[1].value, 0.0);
}

TEST(Sliders, PressesElsewhereAreNotTaken) {
    Sliders sliders = sliders_of(3);
    EXPECT_FALSE(sliders.press({100.0, 100.0}));
    EXPECT_FALSE(sliders.is_dragging());
    EXPECT_FALSE(sliders.take_change());
    Sliders none;
    none.lay_out(kWindow, kFont);
    EXPECT_FALSE(none.press({790.0, 10.0}));
}

TEST(Sliders, KeysSelectAroundAndStep) {
    Sliders sliders = sliders_of(3);
    EXPECT_EQ(sliders.selected(), 0u);
    sliders.select_previous();
    EXPECT_EQ(sliders.selected(), 2u);
    sliders.select_next();
    sliders.select_next();
    EXPECT_EQ(sliders.selected(), 1u);
    sliders.step(1);
    EXPECT_EQ(sliders.all()[1].value, 0.2);
    EXPECT_TRUE(sliders.take_change());
    sliders.step(-1);
    sliders.take_change();
    sliders.step(-1);  // at the end already
    EXPECT_FALSE(sliders.take_change());
}

TEST(Sliders, WithoutAnyNothingHappens) {
    Sliders sliders;
    sliders.select_next();
    sliders.select_previous();
    sliders.step(1);
    sliders.lay_out(kWindow, kFont);
    EXPECT_FALSE(sliders.selected());
    EXPECT_TRUE(all_text(sliders).empty());
}

TEST(Sliders, AReloadKeepsTheSelectedOneByName) {
    Sliders sliders = sliders_of(3);
    sliders.select_next();
    sliders.set({slider("new"), slider("p2"), slider("p1"), slider("p0")});
    EXPECT_EQ(sliders.selected(), 2u);
    sliders.set({slider("other")});
    EXPECT_EQ(sliders.selected(), 0u);
    sliders.set({});
    EXPECT_FALSE(sliders.selected());
}

TEST(Sliders, AReloadDoesNotTakeADraggedSliderOutOfTheHand) {
    Sliders sliders = sliders_of(2);
    ASSERT_TRUE(sliders.press(place_of(sliders, 1, kWindow).value()));
    sliders.drag({0.0, 0.0});
    sliders.drag({800.0, 0.0});
    sliders.set({slider("p1", 3.0), slider("p0", 4.0)});
    EXPECT_TRUE(sliders.is_dragging());
    EXPECT_EQ(sliders.all()[0].value, 10.0);
    EXPECT_EQ(sliders.all()[1].value, 4.0);
    sliders.set({slider("p0")});
    EXPECT_FALSE(sliders.is_dragging());
    EXPECT_FALSE(sliders.drag({0.0, 0.0}));
}

TEST(Sliders, ShowsNamesAndValues) {
    Sliders sliders;
    sliders.set({slider("towers", 7.0),
                 {.name = "caf\u00e9", .value = 1.0, .choices = {"red", "green"}},
                 {.name = std::string(100, 'n'), .value = 0.5}});
    sliders.lay_out(kWindow, kFont);
    EXPECT_EQ(all_text(sliders), fmt::format("towers\n7\ncaf\xe9\ngreen\n{:n<21}...\n0.5\n", ""));
}

TEST(Sliders, WhatDoesNotFitIsScrolledToTheSelectedOne) {
    const WindowSize window{800, 140};
    Sliders sliders = sliders_of(20, window);
    EXPECT_TRUE(all_text(sliders).starts_with("parameters 1-4 of 20\np0\n")) << all_text(sliders);
    EXPECT_FALSE(place_of(sliders, 4, window));
    for (int i = 0; i < 4; ++i) sliders.select_next();
    EXPECT_TRUE(all_text(sliders).starts_with("parameters 2-5 of 20\np1\n")) << all_text(sliders);
    sliders.select_previous();  // still to be seen: nothing moves
    EXPECT_TRUE(all_text(sliders).starts_with("parameters 2-5 of 20\n"));
    for (int i = 0; i < 4; ++i) sliders.select_previous();
    EXPECT_EQ(sliders.selected(), 19u);
    EXPECT_TRUE(all_text(sliders).starts_with("parameters 17-20 of 20\n")) << all_text(sliders);
}

TEST(Sliders, AWindowThatGrowsIsFilledFromItsEnd) {
    Sliders sliders = sliders_of(20, {800, 140});
    sliders.select_previous();
    sliders.lay_out({800, 300}, kFont);
    EXPECT_TRUE(all_text(sliders).starts_with("parameters 10-20 of 20\n")) << all_text(sliders);
    sliders.lay_out(kWindow, kFont);
    EXPECT_TRUE(all_text(sliders).starts_with("p0\n")) << all_text(sliders);
}

TEST(Sliders, FewerAfterAReloadAreAllShown) {
    const WindowSize window{800, 140};
    Sliders sliders = sliders_of(20, window);
    sliders.select_previous();
    sliders.set({slider("p18"), slider("p19")});
    EXPECT_EQ(all_text(sliders), "p18\n0\np19\n0\n");
}

TEST(Sliders, APressWhileScrolledHitsWhatIsShown) {
    const WindowSize window{800, 140};
    Sliders sliders = sliders_of(20, window);
    for (int i = 0; i < 10; ++i) sliders.select_next();
    const DVec2 place = place_of(sliders, 8, window).value();
    EXPECT_TRUE(sliders.press(place));
    EXPECT_EQ(sliders.selected(), 8u);
    EXPECT_EQ(sliders.at(place), 8u);  // and it stays below the mouse
    EXPECT_NEAR(sliders.all()[8].value, 5.0, 0.06);
}

TEST(Sliders, WindowsOfAnySizeHoldWhatIsDrawn) {
    for (const WindowSize window :
         {WindowSize{0, 0}, {1, 1}, {20, 20}, {30, 500}, {500, 30}, {100, 60}, {800, 600}}) {
        SCOPED_TRACE(::testing::Message() << window.width << " x " << window.height);
        for (const std::size_t count : {1u, 3u, 1000u}) {
            const Sliders sliders = sliders_of(count, window);
            Overlay overlay;
            sliders.draw(overlay);
            for (const auto& mark : overlay.marks) {
                if (const auto* box = std::get_if<OverlayBox>(&mark)) {
                    EXPECT_GE(box->box.left, 0.0);
                    EXPECT_LE(box->box.left, box->box.right);
                    EXPECT_LE(box->box.right, window.width);
                    EXPECT_LE(box->box.bottom, window.height);
                } else {
                    const auto& text = std::get<OverlayText>(mark);
                    EXPECT_GE(text.at.x, 0.0);
                    EXPECT_LE(text.at.x + static_cast<double>(text.text.size()) * kFont.width,
                              window.width);
                    EXPECT_LE(text.at.y + kFont.height, window.height);
                }
            }
        }
    }
}

}  // namespace
}  // namespace lray::gui
