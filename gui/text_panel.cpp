#include "gui/text_panel.h"

#include <algorithm>

namespace lray::gui {

TextRoom text_room(const Box& room, const Font& font) {
    const double height = room.height() - 2.0 * kPanelPadding;
    TextRoom result;
    result.columns = columns_in(room.width() - 2.0 * kPanelPadding, font);
    if (height >= font.height) result.rows = static_cast<std::size_t>(height / font.height);
    return result;
}

DVec2 panel_size(const std::vector<PanelLine>& lines, const Font& font) {
    std::size_t columns = 0;
    for (const PanelLine& line : lines) columns = std::max(columns, line.text.size());
    return {static_cast<double>(columns) * font.width + 2.0 * kPanelPadding,
            static_cast<double>(lines.size()) * font.height + 2.0 * kPanelPadding};
}

Box add_text_panel(Overlay& overlay, const std::vector<PanelLine>& lines, const Box& room,
                   const Font& font) {
    const TextRoom fits = text_room(room, font);
    const std::size_t rows = std::min(fits.rows, lines.size());
    if (rows == 0 || fits.columns == 0) return {};
    const DVec2 size = panel_size(lines, font);
    const Box panel{room.left, room.top, std::min(room.left + size.x, room.right),
                    std::min(room.top + size.y, room.bottom)};
    overlay.add_box(panel, kPanelColor);
    DVec2 at{panel.left + kPanelPadding, panel.top + kPanelPadding};
    for (std::size_t i = 0; i < rows; ++i) {
        if (!lines[i].text.empty()) {
            overlay.add_text(at, cut_text(lines[i].text, fits.columns), lines[i].color);
        }
        at.y += font.height;
    }
    return panel;
}

}  // namespace lray::gui
