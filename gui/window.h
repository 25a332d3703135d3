// The window: the only place where GLUT is known.
#pragma once

#include <chrono>
#include <cstdint>

#include "gui/program.h"

namespace lray::gui {

enum class WindowEnd : std::uint8_t { closed, interrupted, out_of_memory };

struct WindowStats {
    double first_picture_seconds = 0.0;  // from the start of the program
    std::uint64_t passes = 0;            // over the picture, all views together
    double pass_seconds = 0.0;           // that they took
    std::uint64_t frames = 0;            // brought to OpenGL
    double upload_seconds = 0.0;         // that it took
};

struct WindowResult {
    WindowEnd end = WindowEnd::closed;
    /// A scene is still being loaded, by a thread that cannot be told to stop: the program must end
    /// without waiting for it.
    bool is_loading = false;
    WindowStats stats{};
};

/// False if the environment names no display that takes a connection.
bool has_display();

/// Shows a scene until the window is closed. `start` is when the program did.
/// Errors: where there is no OpenGL, or the display goes away, Program::end_without_window().
WindowResult show_window(LoadedScene first, Program program,
                         std::chrono::steady_clock::time_point start);

}  // namespace lray::gui
