// The panels over the picture: information, help, and what went wrong with a scene. Laid out for
// windows of any size; what has no room is cut off.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gui/key_bindings.h"
#include "gui/overlay.h"
#include "image/tone_map.h"
#include "scene/camera.h"

namespace lray::gui {

enum class RenderState : std::uint8_t { loading, rendering, paused, done };

/// What was clicked.
struct PickedObject {
    std::string name{};   // the path of names to it
    std::string place{};  // "scene.lrs:42:3"
};

struct HudState {
    RenderState state = RenderState::rendering;
    std::uint64_t pass_count = 0;               // averaged in the picture
    std::optional<std::uint64_t> pass_limit{};  // that the render ends after
    std::uint32_t preview_divisor = 1;          // 8: one pixel in 8 by 8 is rendered
    double rays_per_second = 0.0;
    scene::Resolution resolution{};
    scene::Camera camera{};
    std::string accel{};
    std::string shading{};
    bool is_flying = false;
    double speed = 1.0;
    double exposure = 0.0;  // stops
    image::ToneMap tonemap = image::ToneMap::none;
    std::optional<int> volume_level{};  // of the bounding volumes that are drawn
    std::optional<PickedObject> picked{};
};

/// Adds the state of the render at the top left.
void add_hud(Overlay& overlay, const HudState& state, const Font& font, WindowSize window);

/// Adds what was done last at the bottom left: "saved scene-001.png".
void add_notice(Overlay& overlay, std::string_view text, const Font& font, WindowSize window);

/// Adds the help in the middle, in two columns where one is too high.
void add_help(Overlay& overlay, const std::vector<HelpLine>& lines, const Font& font,
              WindowSize window);

/// Adds the diagnostics of a scene that failed to load, at the bottom: a line for each of the text,
/// never wrapped. Shape: UTF-8 of any size; what is not shown costs little more than the search for
/// line ends.
void add_messages(Overlay& overlay, std::string_view text, const Font& font, WindowSize window);

/// "3.2 M" and the like: three digits at most, and a letter for thousands, millions, billions.
std::string short_count(double count);

}  // namespace lray::gui
