#include "gui/x_display.h"

#include <X11/XKBlib.h>
#include <X11/Xlib.h>
#include <X11/keysym.h>

#include <algorithm>
#include <array>
#include <utility>

namespace lray::gui {

namespace {

constexpr KeyCode kPlaceOfQ = 24;  // of the evdev and the older PC keycodes alike

Display* of(void* display) {
    return static_cast<Display*>(display);
}

/// Xlib's handlers reach nothing but globals.
std::function<void()>& end_when_lost() {
    static std::function<void()> end;
    return end;
}

int on_lost(Display*) {
    end_when_lost()();
    return 0;
}

int on_mistake(Display*, XErrorEvent*) {
    return 0;
}

}  // namespace

std::unique_ptr<XDisplay> XDisplay::open() {
    Display* const display = XOpenDisplay(nullptr);
    if (display == nullptr) return nullptr;
    return std::unique_ptr<XDisplay>(new XDisplay(display));
}

XDisplay::~XDisplay() {
    XCloseDisplay(of(display_));
}

void XDisplay::when_lost(std::function<void()> end) {
    end_when_lost() = std::move(end);
    XSetIOErrorHandler(on_lost);
    XSetErrorHandler(on_mistake);
}

scene::Resolution XDisplay::screen_size() const {
    const int screen = DefaultScreen(of(display_));
    return {static_cast<std::uint32_t>(std::max(DisplayWidth(of(display_), screen), 1)),
            static_cast<std::uint32_t>(std::max(DisplayHeight(of(display_), screen), 1))};
}

KeyboardLayout XDisplay::keyboard_layout() const {
    XkbStateRec state{};
    XkbGetState(of(display_), XkbUseCoreKbd, &state);
    const KeySym symbol = XkbKeycodeToKeysym(of(display_), kPlaceOfQ, state.group, 0);
    return symbol == XK_a ? KeyboardLayout::azerty : KeyboardLayout::qwerty;
}

bool XDisplay::is_any_key_down() const {
    std::array<char, 32> keys{};
    XQueryKeymap(of(display_), keys.data());
    return std::any_of(keys.begin(), keys.end(), [](char bits) { return bits != 0; });
}

}  // namespace lray::gui
