#include "gui/key_bindings.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "base/assert.h"

namespace lray::gui {

namespace {

enum class Shift : std::uint8_t { either, up, down };

/// One way to call an action. Chords that are not `shown` are for other spellings of a shown one.
struct Chord {
    Action action = Action::none;
    SpecialKey special = SpecialKey::none;
    SpecialKey last = SpecialKey::none;  // of a range that begins at `special`
    char character = '\0';               // lower case
    Shift shift = Shift::either;
    std::optional<KeyboardLayout> layout{};  // empty: all
    bool is_shown = true;
};

constexpr Chord letter(Action action, char character, Shift shift = Shift::either) {
    return {.action = action, .character = character, .shift = shift};
}
constexpr Chord letter_of(KeyboardLayout layout, Action action, char character) {
    return {.action = action, .character = character, .layout = layout};
}
constexpr Chord unshown(Action action, char character) {
    return {.action = action, .character = character, .is_shown = false};
}
constexpr Chord special(Action action, SpecialKey key, Shift shift = Shift::either) {
    return {.action = action, .special = key, .shift = shift};
}
constexpr Chord range(Action action, SpecialKey first, SpecialKey last, Shift shift) {
    return {.action = action, .special = first, .last = last, .shift = shift};
}

/// A line of the help: chords of one action follow each other, those of different ones are
/// separated by a comma, as are the words for them.
struct Row {
    std::string_view what{};
    std::array<Chord, 5> chords{};  // unused ones at the end have Action::none
};

constexpr char kTab = '\t';
constexpr char kEscape = '\x1b';

constexpr auto kQwerty = KeyboardLayout::qwerty;
constexpr auto kAzerty = KeyboardLayout::azerty;

// Z is forward on both, so that a French keyboard works before anybody has said that it is one; Q
// and A are left on both sides of W and Z.
constexpr std::array kRows = {
    Row{"forward, back",
        {special(Action::forward, SpecialKey::up, Shift::up), letter(Action::forward, 'w'),
         letter(Action::forward, 'z'), special(Action::back, SpecialKey::down, Shift::up),
         letter(Action::back, 's')}},
    Row{"turn left, right",
        {special(Action::turn_left, SpecialKey::left, Shift::up),
         special(Action::turn_right, SpecialKey::right, Shift::up)}},
    Row{"fly left, right",
        {letter_of(kQwerty, Action::strafe_left, 'a'), letter_of(kAzerty, Action::strafe_left, 'q'),
         letter(Action::strafe_right, 'd')}},
    Row{"fly up, down",
        {letter(Action::go_up, 'e'), letter_of(kQwerty, Action::go_down, 'q'),
         letter_of(kAzerty, Action::go_down, 'a')}},
    Row{"faster, slower",
        {letter(Action::faster, '+'), unshown(Action::faster, '='), letter(Action::slower, '-'),
         unshown(Action::slower, '_')}},
    Row{"orbit or fly", {letter(Action::orbit_or_fly, kTab)}},
    Row{"see everything", {letter(Action::frame_all, 'f')}},
    Row{"back to the scene's camera", {special(Action::scene_camera, SpecialKey::home)}},
    Row{"recall, store a view",
        {range(Action::recall_view, SpecialKey::f1, SpecialKey::f9, Shift::up),
         range(Action::store_view, SpecialKey::f1, SpecialKey::f9, Shift::down)}},
    Row{"undo, redo the camera", {letter(Action::undo, 'u'), letter(Action::redo, 'y')}},
    Row{"brighter, darker",
        {special(Action::exposure_up, SpecialKey::page_up),
         special(Action::exposure_down, SpecialKey::page_down)}},
    Row{"tone map", {letter(Action::next_tone_map, 't')}},
    Row{"next, previous shading",
        {letter(Action::next_shading, 'v', Shift::up),
         letter(Action::previous_shading, 'v', Shift::down)}},
    Row{"bounding volumes, a level deeper, higher",
        {letter(Action::next_volumes, 'b', Shift::up),
         letter(Action::previous_volumes, 'b', Shift::down)}},
    Row{"pause", {letter(Action::pause, ' ')}},
    Row{"print the camera", {letter(Action::print_camera, 'c')}},
    Row{"save the picture", {letter(Action::save_picture, 'p')}},
    Row{"reload the scene", {letter(Action::reload, 'r')}},
    Row{"information", {letter(Action::hud, 'i')}},
    Row{"this help", {letter(Action::help, 'h'), letter(Action::help, '?')}},
    Row{"quit", {letter(Action::quit, kEscape), letter(Action::quit, 'x')}},
};

constexpr std::array kSliderRows = {
    Row{"choose a parameter",
        {special(Action::previous_slider, SpecialKey::up, Shift::down),
         special(Action::next_slider, SpecialKey::down, Shift::down)}},
    Row{"change it",
        {special(Action::slider_down, SpecialKey::left, Shift::down),
         special(Action::slider_up, SpecialKey::right, Shift::down)}},
};

struct MouseRow {
    std::string_view keys{};
    std::string_view what{};
};

constexpr std::array kMouseRows = {
    MouseRow{"drag", "orbit; look around when flying"},
    MouseRow{"Shift+drag", "pan; so does the middle button"},
    MouseRow{"wheel", "closer, farther"},
    MouseRow{"click", "what is it?"},
    MouseRow{"right drag", "render this part only"},
    MouseRow{"right click", "render all again"},
};

constexpr MouseRow kSliderMouseRow{"drag a parameter", "change it"};

constexpr char lower_case(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool is_key_of(const Chord& chord, Key key, KeyboardLayout layout) {
    if (chord.action == Action::none) return false;
    if (chord.layout && *chord.layout != layout) return false;
    if (chord.special == SpecialKey::none) {
        return key.special == SpecialKey::none && lower_case(key.character) == chord.character;
    }
    const SpecialKey last = chord.last == SpecialKey::none ? chord.special : chord.last;
    return key.special >= chord.special && key.special <= last;
}

bool is_shift_of(const Chord& chord, bool is_shift) {
    return chord.shift == Shift::either || (chord.shift == Shift::down) == is_shift;
}

/// The first chord for which `is_meant` holds.
template <class IsMeant>
const Chord* find_chord(IsMeant is_meant) {
    for (const std::span<const Row> rows : {std::span<const Row>(kRows), {kSliderRows}}) {
        for (const Row& row : rows) {
            for (const Chord& chord : row.chords) {
                if (is_meant(chord)) return &chord;
            }
        }
    }
    return nullptr;
}

std::string_view name_of(SpecialKey key) {
    switch (key) {
        case SpecialKey::none:
            break;
        case SpecialKey::left:
            return "Left";
        case SpecialKey::right:
            return "Right";
        case SpecialKey::up:
            return "Up";
        case SpecialKey::down:
            return "Down";
        case SpecialKey::page_up:
            return "Page Up";
        case SpecialKey::page_down:
            return "Page Down";
        case SpecialKey::home:
            return "Home";
        case SpecialKey::end:
            return "End";
        case SpecialKey::insert:
            return "Insert";
        case SpecialKey::del:
            return "Delete";
        case SpecialKey::f1:
            return "F1";
        case SpecialKey::f2:
            return "F2";
        case SpecialKey::f3:
            return "F3";
        case SpecialKey::f4:
            return "F4";
        case SpecialKey::f5:
            return "F5";
        case SpecialKey::f6:
            return "F6";
        case SpecialKey::f7:
            return "F7";
        case SpecialKey::f8:
            return "F8";
        case SpecialKey::f9:
            return "F9";
        case SpecialKey::f10:
            return "F10";
        case SpecialKey::f11:
            return "F11";
        case SpecialKey::f12:
            return "F12";
    }
    LRAY_ASSERT(false);
}

std::string name_of(const Chord& chord) {
    std::string name = chord.shift == Shift::down ? "Shift+" : "";
    if (chord.special != SpecialKey::none) {
        name += name_of(chord.special);
        if (chord.last == SpecialKey::none) return name;
        name += '-';
        name += name_of(chord.last);
        return name;
    }
    switch (chord.character) {
        case kTab:
            return name + "Tab";
        case kEscape:
            return name + "Esc";
        case ' ':
            return name + "Space";
        default: {
            const char c = chord.character;
            return name + (c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c);
        }
    }
}

HelpLine help_line(const Row& row, KeyboardLayout layout) {
    HelpLine line{.what = std::string(row.what)};
    Action before = Action::none;
    for (const Chord& chord : row.chords) {
        if (chord.action == Action::none || !chord.is_shown) continue;
        if (chord.layout && *chord.layout != layout) continue;
        if (before != Action::none) line.keys += chord.action == before ? " " : ", ";
        line.keys += name_of(chord);
        before = chord.action;
    }
    return line;
}

}  // namespace

Bound action_of(Key key, KeyboardLayout layout) {
    const Chord* chord = find_chord([&](const Chord& candidate) {
        return is_key_of(candidate, key, layout) && is_shift_of(candidate, key.is_shift);
    });
    if (chord == nullptr) return {};
    if (chord->last == SpecialKey::none) return {chord->action, 0};
    return {chord->action, static_cast<int>(key.special) - static_cast<int>(chord->special) + 1};
}

Action movement_of(Key key, KeyboardLayout layout) {
    const Chord* chord = find_chord([&](const Chord& candidate) {
        return is_movement(candidate.action) && is_key_of(candidate, key, layout);
    });
    return chord == nullptr ? Action::none : chord->action;
}

std::vector<HelpLine> help_lines(KeyboardLayout layout, bool has_sliders) {
    std::vector<HelpLine> lines;
    for (const Row& row : kRows) lines.push_back(help_line(row, layout));
    if (has_sliders) {
        for (const Row& row : kSliderRows) lines.push_back(help_line(row, layout));
    }
    for (const MouseRow& row : kMouseRows) {
        lines.push_back({std::string(row.keys), std::string(row.what)});
    }
    if (has_sliders) {
        lines.push_back({std::string(kSliderMouseRow.keys), std::string(kSliderMouseRow.what)});
    }
    return lines;
}

}  // namespace lray::gui
