#include "gui/key_bindings.h"

#include <gtest/gtest.h>

#include <set>

namespace lray::gui {
namespace {

constexpr KeyboardLayout kLayouts[] = {KeyboardLayout::qwerty, KeyboardLayout::azerty};

Key typed(char character, bool is_shift = false) {
    return {.character = character, .is_shift = is_shift};
}
Key special(SpecialKey key, bool is_shift = false) {
    return {.special = key, .is_shift = is_shift};
}

struct Case {
    Key key{};
    Action action = Action::none;
};

TEST(ActionOf, WhatIsTheSameOnAllKeyboards) {
    const Case kCases[] = {
        {special(SpecialKey::up), Action::forward},
        {special(SpecialKey::down), Action::back},
        {special(SpecialKey::left), Action::turn_left},
        {special(SpecialKey::right), Action::turn_right},
        {special(SpecialKey::up, true), Action::previous_slider},
        {special(SpecialKey::down, true), Action::next_slider},
        {special(SpecialKey::left, true), Action::slider_down},
        {special(SpecialKey::right, true), Action::slider_up},
        {special(SpecialKey::page_up), Action::exposure_up},
        {special(SpecialKey::page_down), Action::exposure_down},
        {special(SpecialKey::home), Action::scene_camera},
        {special(SpecialKey::end), Action::none},
        {special(SpecialKey::insert), Action::none},
        {special(SpecialKey::f10), Action::none},
        {typed('w'), Action::forward},
        {typed('z'), Action::forward},
        {typed('s'), Action::back},
        {typed('d'), Action::strafe_right},
        {typed('e'), Action::go_up},
        {typed('\t'), Action::orbit_or_fly},
        {typed('+'), Action::faster},
        {typed('='), Action::faster},
        {typed('+', true), Action::faster},
        {typed('-'), Action::slower},
        {typed('_', true), Action::slower},
        {typed('f'), Action::frame_all},
        {typed('u'), Action::undo},
        {typed('y'), Action::redo},
        {typed('t'), Action::next_tone_map},
        {typed('v'), Action::next_shading},
        {typed('V', true), Action::previous_shading},
        {typed('b'), Action::next_volumes},
        {typed('B', true), Action::previous_volumes},
        {typed(' '), Action::pause},
        {typed('c'), Action::print_camera},
        {typed('p'), Action::save_picture},
        {typed('r'), Action::reload},
        {typed('i'), Action::hud},
        {typed('h'), Action::help},
        {typed('?', true), Action::help},
        {typed('\x1b'), Action::quit},
        {typed('x'), Action::quit},
        {typed('\x03'), Action::none},  // Ctrl+C, as GLUT reports it
        {typed('1'), Action::none},
        {typed('\0'), Action::none},
        {typed('\xe9'), Action::none},
    };
    for (const KeyboardLayout layout : kLayouts) {
        for (const Case& one : kCases) {
            EXPECT_EQ(action_of(one.key, layout), (Bound{one.action, 0}))
                << static_cast<int>(one.key.character) << " or special "
                << static_cast<int>(one.key.special);
        }
    }
}

TEST(ActionOf, QAndAChangePlacesOnAFrenchKeyboard) {
    EXPECT_EQ(action_of(typed('a'), KeyboardLayout::qwerty).action, Action::strafe_left);
    EXPECT_EQ(action_of(typed('q'), KeyboardLayout::qwerty).action, Action::go_down);
    EXPECT_EQ(action_of(typed('q'), KeyboardLayout::azerty).action, Action::strafe_left);
    EXPECT_EQ(action_of(typed('a'), KeyboardLayout::azerty).action, Action::go_down);
}

TEST(ActionOf, LettersDoNotHeedTheirCaseButWhatShiftMeans) {
    for (const KeyboardLayout layout : kLayouts) {
        for (char c = 'a'; c <= 'z'; ++c) {
            const char upper = static_cast<char>(c - 'a' + 'A');
            // Caps lock gives the other case, with and without shift.
            EXPECT_EQ(action_of(typed(c), layout), action_of(typed(upper), layout)) << c;
            EXPECT_EQ(action_of(typed(c, true), layout), action_of(typed(upper, true), layout))
                << c;
            if (c == 'b' || c == 'v') continue;
            EXPECT_EQ(action_of(typed(c), layout), action_of(typed(c, true), layout)) << c;
        }
    }
}

TEST(ActionOf, FunctionKeysHaveNumbers) {
    for (int i = 1; i <= 9; ++i) {
        const auto key = static_cast<SpecialKey>(static_cast<int>(SpecialKey::f1) + i - 1);
        EXPECT_EQ(action_of(special(key), KeyboardLayout::qwerty), (Bound{Action::recall_view, i}));
        EXPECT_EQ(action_of(special(key, true), KeyboardLayout::qwerty),
                  (Bound{Action::store_view, i}));
    }
}

TEST(ActionOf, EveryActionHasAKeyOnEveryKeyboard) {
    for (const KeyboardLayout layout : kLayouts) {
        std::set<Action> reached;
        for (const bool is_shift : {false, true}) {
            for (int c = 1; c < 128; ++c) {
                reached.insert(action_of(typed(static_cast<char>(c), is_shift), layout).action);
            }
            for (int k = 1; k <= static_cast<int>(SpecialKey::f12); ++k) {
                const Key key = special(static_cast<SpecialKey>(k), is_shift);
                reached.insert(action_of(key, layout).action);
            }
        }
        for (int i = 1; i <= static_cast<int>(Action::slider_up); ++i) {
            EXPECT_TRUE(reached.contains(static_cast<Action>(i))) << i;
        }
    }
}

TEST(IsMovement, TheEightOfThem) {
    std::size_t count = 0;
    for (int i = 0; i <= static_cast<int>(Action::slider_up); ++i) {
        if (is_movement(static_cast<Action>(i))) ++count;
    }
    EXPECT_EQ(count, kMovementCount);
    EXPECT_FALSE(is_movement(Action::none));
    EXPECT_TRUE(is_movement(Action::go_down));
    EXPECT_FALSE(is_movement(Action::faster));
}

TEST(MovementOf, ShiftPressedInTheMeantimeDoesNotMatter) {
    const KeyboardLayout layout = KeyboardLayout::qwerty;
    EXPECT_EQ(movement_of(special(SpecialKey::up, true), layout), Action::forward);
    EXPECT_EQ(movement_of(special(SpecialKey::left, true), layout), Action::turn_left);
    EXPECT_EQ(movement_of(typed('D', true), layout), Action::strafe_right);
    EXPECT_EQ(movement_of(typed('q'), KeyboardLayout::azerty), Action::strafe_left);
    EXPECT_EQ(movement_of(typed('b'), layout), Action::none);
}

std::string keys_for(const std::vector<HelpLine>& lines, std::string_view what) {
    for (const HelpLine& line : lines) {
        if (line.what == what) return line.keys;
    }
    return "nothing";
}

TEST(HelpLines, NamesTheKeysOfTheKeyboard) {
    const auto qwerty = help_lines(KeyboardLayout::qwerty, false);
    const auto azerty = help_lines(KeyboardLayout::azerty, false);
    EXPECT_EQ(keys_for(qwerty, "forward, back"), "Up W Z, Down S");
    EXPECT_EQ(keys_for(qwerty, "fly left, right"), "A, D");
    EXPECT_EQ(keys_for(azerty, "fly left, right"), "Q, D");
    EXPECT_EQ(keys_for(azerty, "fly up, down"), "E, A");
    EXPECT_EQ(keys_for(qwerty, "faster, slower"), "+, -");
    EXPECT_EQ(keys_for(qwerty, "recall, store a view"), "F1-F9, Shift+F1-F9");
    EXPECT_EQ(keys_for(qwerty, "next, previous shading"), "V, Shift+V");
    EXPECT_EQ(keys_for(qwerty, "pause"), "Space");
    EXPECT_EQ(keys_for(qwerty, "orbit or fly"), "Tab");
    EXPECT_EQ(keys_for(qwerty, "quit"), "Esc X");
    EXPECT_EQ(keys_for(qwerty, "closer, farther"), "wheel");
}

TEST(HelpLines, ParametersOnlyWhereThereAreSome) {
    const auto without = help_lines(KeyboardLayout::qwerty, false);
    const auto with = help_lines(KeyboardLayout::qwerty, true);
    EXPECT_EQ(with.size(), without.size() + 3);
    EXPECT_EQ(keys_for(without, "choose a parameter"), "nothing");
    EXPECT_EQ(keys_for(with, "choose a parameter"), "Shift+Up, Shift+Down");
}

}  // namespace
}  // namespace lray::gui
