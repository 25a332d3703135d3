// What the keys and the mouse do: one table, from which both lookup and the help text come.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace lray::gui {

/// Where letters lie on the keyboard. All that letters do, other keys do too.
enum class KeyboardLayout : std::uint8_t { qwerty, azerty };

/// Keys without a character; F1 to F12 follow each other.
enum class SpecialKey : std::uint8_t {
    none,  // the key has a character
    left,
    right,
    up,
    down,
    page_up,
    page_down,
    home,
    end,
    insert,
    del,
    f1,
    f2,
    f3,
    f4,
    f5,
    f6,
    f7,
    f8,
    f9,
    f10,
    f11,
    f12,
};

/// A key as the window system reports it.
struct Key {
    SpecialKey special = SpecialKey::none;
    char character = '\0';  // if not special: what was typed; with shift, mostly upper case
    bool is_shift = false;  // whether shift was held, which caps lock is not
};

enum class Action : std::uint8_t {
    none,
    // Movements, in force while the key is held.
    forward,
    back,
    turn_left,
    turn_right,
    strafe_left,
    strafe_right,
    go_up,
    go_down,
    // What happens once.
    faster,
    slower,
    orbit_or_fly,
    frame_all,
    scene_camera,
    recall_view,
    store_view,
    undo,
    redo,
    exposure_up,
    exposure_down,
    next_tone_map,
    next_shading,
    previous_shading,
    next_volumes,
    previous_volumes,
    pause,
    print_camera,
    save_picture,
    reload,
    hud,
    help,
    quit,
    previous_slider,
    next_slider,
    slider_down,
    slider_up,
};

inline constexpr std::size_t kMovementCount = 8;

constexpr bool is_movement(Action action) {
    return action >= Action::forward && action <= Action::go_down;
}

/// True if it is done again and again while the key is held.
constexpr bool repeats(Action action) {
    return action == Action::faster || action == Action::slower || action == Action::exposure_up ||
           action == Action::exposure_down || action == Action::slider_down ||
           action == Action::slider_up;
}

struct Bound {
    Action action = Action::none;
    int number = 0;  // of the view that is recalled or stored, from 1
    friend bool operator==(Bound, Bound) = default;
};

/// Returns what pressing a key does; Action::none if nothing.
Bound action_of(Key key, KeyboardLayout layout);

/// Returns the movement that a key is for, whatever shift is, which may have changed since the key
/// was pressed: what releasing the key ends. Action::none if it is for none.
Action movement_of(Key key, KeyboardLayout layout);

struct HelpLine {
    std::string keys{};  // "Up W Z, Down S"
    std::string what{};  // "forward, back"
};

/// Returns the keys and gestures of that keyboard, those of parameters only for scenes with some.
std::vector<HelpLine> help_lines(KeyboardLayout layout, bool has_sliders);

}  // namespace lray::gui
