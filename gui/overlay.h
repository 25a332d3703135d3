// What is drawn over the picture, as plain data: boxes, lines and text. No drawing is done here.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/vec.h"

namespace lray::gui {

/// Red, green, blue and opacity, codes of sRGB in [0, 1].
struct Rgba {
    float r = 1.0f;
    float g = 1.0f;
    float b = 1.0f;
    float a = 1.0f;
    friend bool operator==(Rgba, Rgba) = default;
};

/// Window pixels from the top left, y down; half open.
struct Box {
    double left = 0.0;
    double top = 0.0;
    double right = 0.0;
    double bottom = 0.0;

    double width() const { return right - left; }
    double height() const { return bottom - top; }
    bool contains(DVec2 p) const {
        return p.x >= left && p.x < right && p.y >= top && p.y < bottom;
    }
    friend bool operator==(const Box&, const Box&) = default;
};

struct WindowSize {
    int width = 0;
    int height = 0;
};

/// A font of fixed pitch, in pixels.
struct Font {
    int width = 8;
    int height = 13;  // from one line to the next
    int ascent = 11;  // of it, above the line that letters stand on
};

struct OverlayBox {
    Box box{};
    Rgba color{};
};

/// One line of text. Shape: as shown_text() returns it, in Latin-1.
struct OverlayText {
    DVec2 at{0.0};  // top left
    std::string text{};
    Rgba color{};
};

struct OverlayLine {
    DVec2 from{0.0};
    DVec2 to{0.0};
    Rgba color{};
};

/// Drawn in this order: the lines, then the marks, the first of each lowest.
struct Overlay {
    std::vector<OverlayLine> lines{};
    std::vector<std::variant<OverlayBox, OverlayText>> marks{};

    void add_line(DVec2 from, DVec2 to, Rgba color) { lines.push_back({from, to, color}); }
    void add_box(const Box& box, Rgba color) { marks.emplace_back(OverlayBox{box, color}); }
    void add_text(DVec2 at, std::string text, Rgba color) {
        marks.emplace_back(OverlayText{at, std::move(text), color});
    }
    /// Four lines just inside of the box.
    void add_rim(const Box& box, Rgba color);
};

/// Returns the text as bitmap fonts can show it, in Latin-1: a byte for each character. What they
/// lack is replaced by what looks alike, or by '?'; controls, tabs and ends of lines by a blank.
std::string shown_text(std::string_view utf8);

/// Returns the text cut to at most so many characters; three dots stand for what is cut off, or
/// fewer where there is no room for them. Shape: Latin-1.
std::string cut_text(std::string text, std::size_t max_size);

/// Returns how many characters fit into so many pixels.
std::size_t columns_in(double width, const Font& font);

}  // namespace lray::gui
