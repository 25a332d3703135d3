#include "gui/overlay.h"

#include <algorithm>
#include <cstdint>

#include "base/utf8.h"

namespace lray::gui {

namespace {

struct Replacement {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::string_view by{};
};

// What diagnostics and file names hold most often of what Latin-1 lacks.
constexpr Replacement kReplacements[] = {
    {0x00ad, 0x00ad, "-"},  // a soft hyphen, which Latin-1 has and fonts show as they like
    {0x2010, 0x2015, "-"},   {0x2018, 0x201b, "'"},  {0x201c, 0x201f, "\""}, {0x2022, 0x2022, "*"},
    {0x2026, 0x2026, "..."}, {0x2190, 0x2190, "<-"}, {0x2192, 0x2192, "->"}, {0x2212, 0x2212, "-"},
    {0x2264, 0x2264, "<="},  {0x2265, 0x2265, ">="}, {0x2500, 0x2501, "-"},  {0x2502, 0x2503, "|"},
    {0x2504, 0x2505, "-"},   {0x2506, 0x2507, "|"},  {0x2508, 0x2509, "-"},  {0x250a, 0x250b, "|"},
    {0x250c, 0x254b, "+"},   {0x254c, 0x254d, "-"},  {0x254e, 0x254f, "|"},  {0x2550, 0x2550, "="},
    {0x2551, 0x2551, "|"},   {0x2552, 0x2570, "+"},  {0x2574, 0x2574, "-"},  {0x2575, 0x2575, "|"},
    {0x2576, 0x2576, "-"},   {0x2577, 0x2577, "|"},
};

void add_shown(std::string& text, std::uint32_t code_point) {
    const Replacement* found = std::ranges::find_if(kReplacements, [&](const Replacement& r) {
        return code_point >= r.first && code_point <= r.last;
    });
    if (found != std::end(kReplacements)) {
        text += found->by;
    } else if (code_point < 0x20 || (code_point >= 0x7f && code_point <= 0xa0)) {
        text += ' ';
    } else {
        text += code_point <= 0xff ? static_cast<char>(code_point) : '?';
    }
}

}  // namespace

void Overlay::add_rim(const Box& box, Rgba color) {
    add_box({box.left, box.top, box.right, box.top + 1.0}, color);
    add_box({box.left, box.bottom - 1.0, box.right, box.bottom}, color);
    add_box({box.left, box.top + 1.0, box.left + 1.0, box.bottom - 1.0}, color);
    add_box({box.right - 1.0, box.top + 1.0, box.right, box.bottom - 1.0}, color);
}

std::string shown_text(std::string_view utf8) {
    std::string text;
    while (!utf8.empty()) {
        const DecodedCodePoint decoded = decode_utf8(utf8);
        if (decoded.size == 0) {
            text += '?';
            utf8.remove_prefix(1);
            continue;
        }
        add_shown(text, decoded.code_point);
        utf8.remove_prefix(decoded.size);
    }
    return text;
}

std::string cut_text(std::string text, std::size_t max_size) {
    if (text.size() <= max_size) return text;
    const std::size_t dot_count = std::min<std::size_t>(3, max_size);
    text.resize(max_size - dot_count);
    text.append(dot_count, '.');
    return text;
}

std::size_t columns_in(double width, const Font& font) {
    return width >= font.width ? static_cast<std::size_t>(width / font.width) : 0;
}

}  // namespace lray::gui
