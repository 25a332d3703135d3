// The panel of what went wrong with a scene.
#include <fmt/format.h>

#include <algorithm>

#include "gui/panels.h"
#include "gui/text_panel.h"

namespace lray::gui {

namespace {

constexpr std::size_t kMaxBytesPerCharacter = 4;  // of UTF-8

/// Of "scene.lrs:10:19: error[E0401]: ..." and the lines below it.
Rgba color_of(std::string_view line) {
    if (line.find(": error[") != line.npos) return kErrorColor;
    if (line.find(": warning[") != line.npos) return kAccentColor;
    return kTextColor;
}

/// The line without what no window of so many columns can show: one may be as long as the text.
std::string shown_line(std::string_view line, std::size_t columns) {
    // One character more than fits, so that cutting it is still to be seen.
    return shown_text(line.substr(0, (columns + 1) * kMaxBytesPerCharacter));
}

}  // namespace

void add_messages(Overlay& overlay, std::string_view text, const Font& font, WindowSize window) {
    constexpr double kMargin = 8.0;
    while (text.ends_with('\n')) text.remove_suffix(1);
    if (text.empty()) return;
    const Box room{kMargin, kMargin, window.width - kMargin, window.height - kMargin};
    const TextRoom fits = text_room(room, font);
    if (fits.rows == 0 || fits.columns == 0) return;

    const auto line_count = static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
    const std::size_t shown_count = line_count <= fits.rows ? line_count : fits.rows - 1;
    std::vector<PanelLine> lines;
    for (std::size_t i = 0; i < shown_count; ++i) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        lines.push_back({shown_line(line, fits.columns), color_of(line)});
    }
    if (shown_count < line_count) {
        const std::size_t rest = line_count - shown_count;
        lines.push_back(
            {fmt::format("{} more {}; see the terminal", rest, rest == 1 ? "line" : "lines"),
             kFaintColor});
    }
    const double top = std::max(room.top, room.bottom - panel_size(lines, font).y);
    const Box panel =
        add_text_panel(overlay, lines, {room.left, top, room.right, room.bottom}, font);
    overlay.add_rim(panel, kErrorColor);
}

}  // namespace lray::gui
