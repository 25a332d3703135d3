// The X display, asked beside GLUT, which ends the program by itself where there is none.
#pragma once

#include <functional>
#include <memory>
#include <string_view>

#include "gui/key_bindings.h"
#include "scene/camera.h"

namespace lray::gui {

/// A connection of our own to the display that the environment names.
class XDisplay {
 public:
    /// Returns nothing where there is no display that takes a connection.
    static std::unique_ptr<XDisplay> open();
    ~XDisplay();
    XDisplay(const XDisplay&) = delete;
    XDisplay& operator=(const XDisplay&) = delete;

    /// From now on the end of the connection to the display is told to `end`, which must not
    /// return, and mistakes that X reports of single requests end nothing. For all connections.
    static void when_lost(std::function<void()> end);

    scene::Resolution screen_size() const;

    /// What the keyboard writes where US keyboards have their Q.
    KeyboardLayout keyboard_layout() const;

    /// True if any key is down: who leaves the window with a key held lets it go elsewhere.
    bool is_any_key_down() const;

 private:
    explicit XDisplay(void* display) : display_(display) {}

    void* display_;  // Display*: its header defines names like None and Bool
};

}  // namespace lray::gui
