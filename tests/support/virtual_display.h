// A display without a screen, for programs with windows: what they show, and hands on its keyboard
// and mouse.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/process.h"
#include "tests/support/temp_directory.h"

namespace lray::test {

/// Shape: 3 bytes for each pixel, R G B, row by row from the top.
struct Screenshot {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> bytes{};

    const std::uint8_t* pixel(std::uint32_t x, std::uint32_t y) const {
        return &bytes[3 * (std::size_t{y} * width + x)];
    }
};

/// Runs Xvfb on a display number of its own, and xdotool on it.
class VirtualDisplay {
 public:
    static constexpr std::uint32_t kWidth = 1280;
    static constexpr std::uint32_t kHeight = 800;

    /// True if the programs that it needs are installed.
    static bool is_possible();

    VirtualDisplay();
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;

    /// What DISPLAY has to be: ":7".
    const std::string& name() const { return name_; }

    /// What the whole screen shows now.
    Screenshot screenshot() const;

    /// Gives commands to xdotool, in a row. Returns what it prints; throws if it fails.
    std::string hands(const std::vector<std::string>& commands) const;

    /// Asks the program of the window with that in its title to close it, as the button that a
    /// window manager draws does.
    void ask_to_close(const std::string& title) const;

    /// Ends it, windows and all.
    void vanish();

 private:
    TempDirectory files_;
    std::string name_;
    std::unique_ptr<Process> server_;
};

}  // namespace lray::test
