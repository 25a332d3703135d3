// The panel of keys and gestures.
#include <algorithm>

#include "gui/panels.h"
#include "gui/text_panel.h"

namespace lray::gui {

namespace {

constexpr std::size_t kColumnGap = 3;  // characters between two columns of lines

/// The lines with their keys and words below each other.
std::vector<PanelLine> aligned(const std::vector<HelpLine>& lines) {
    std::size_t key_columns = 0;
    for (const HelpLine& line : lines) key_columns = std::max(key_columns, line.keys.size());
    std::vector<PanelLine> result;
    for (const HelpLine& line : lines) {
        std::string keys = line.keys;
        keys.resize(key_columns + 2, ' ');
        result.push_back({keys + line.what});
    }
    return result;
}

/// The second half of the lines beside the first.
std::vector<PanelLine> in_two_columns(const std::vector<PanelLine>& lines) {
    const std::size_t rows = (lines.size() + 1) / 2;
    std::size_t width = 0;
    for (std::size_t i = 0; i < rows; ++i) width = std::max(width, lines[i].text.size());
    std::vector<PanelLine> result(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(rows));
    for (std::size_t i = rows; i < lines.size(); ++i) {
        std::string& left = result[i - rows].text;
        left.resize(width + kColumnGap, ' ');
        left += lines[i].text;
    }
    return result;
}

}  // namespace

void add_help(Overlay& overlay, const std::vector<HelpLine>& lines, const Font& font,
              WindowSize window) {
    const Box whole{0.0, 0.0, static_cast<double>(window.width),
                    static_cast<double>(window.height)};
    std::vector<PanelLine> shown = aligned(lines);
    const DVec2 wide = panel_size(in_two_columns(shown), font);
    if (panel_size(shown, font).y > whole.height() && wide.x <= whole.width()) {
        shown = in_two_columns(shown);
    }
    const DVec2 size = panel_size(shown, font);
    // Whole pixels: bitmap fonts are drawn at nothing else.
    const auto centered = [](double room, double length) {
        return std::max(0.0, static_cast<double>(static_cast<int>((room - length) / 2.0)));
    };
    const Box room{centered(whole.width(), size.x), centered(whole.height(), size.y), whole.right,
                   whole.bottom};
    add_text_panel(overlay, shown, room, font);
}

}  // namespace lray::gui
