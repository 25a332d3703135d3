// A panel of text lines on a translucent ground: what all panels are made of.
#pragma once

#include <string>
#include <vector>

#include "gui/overlay.h"

namespace lray::gui {

inline constexpr Rgba kPanelColor{0.05f, 0.06f, 0.08f, 0.75f};
inline constexpr Rgba kTextColor{0.92f, 0.92f, 0.92f, 1.0f};
inline constexpr Rgba kFaintColor{0.65f, 0.68f, 0.72f, 1.0f};
inline constexpr Rgba kAccentColor{1.0f, 0.78f, 0.30f, 1.0f};
inline constexpr Rgba kErrorColor{1.0f, 0.38f, 0.33f, 1.0f};

inline constexpr double kPanelPadding = 6.0;  // between the edge of a panel and its text

struct PanelLine {
    std::string text{};  // Latin-1
    Rgba color = kTextColor;
};

/// How many lines and columns of text fit into a panel that fills `room`.
struct TextRoom {
    std::size_t rows = 0;
    std::size_t columns = 0;
};
TextRoom text_room(const Box& room, const Font& font);

/// Returns the size of the panel that holds the lines, in pixels.
DVec2 panel_size(const std::vector<PanelLine>& lines, const Font& font);

/// Adds a panel at the top left of `room`, as large as its lines and `room` allow; the lines are
/// cut at the right, and left out at the bottom. Returns its box, which is empty, and nothing
/// added, where there is no room for a single letter.
Box add_text_panel(Overlay& overlay, const std::vector<PanelLine>& lines, const Box& room,
                   const Font& font);

}  // namespace lray::gui
