// Text from elsewhere as it may be sent to a terminal: escapes and display widths.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lray {

/// One code point, or one byte that belongs to none, as it is shown.
struct Glyph {
    std::size_t size = 0;      // bytes of the input
    std::string_view plain{};  // what to print when it needs no escape
    std::string escaped{};     // what to print otherwise
    std::size_t width = 0;     // columns

    std::string_view text() const { return escaped.empty() ? plain : std::string_view(escaped); }
};

/// Returns the first glyph of a text that is not empty. A tab is escaped like other controls.
Glyph first_glyph(std::string_view text);

/// Returns the text with control characters, invalid UTF-8, invisible characters and bidirectional
/// overrides written as escapes (`\n`, `\u{1b}`, `\xff`), so that nothing from a scene can command
/// a terminal or pass for something else. What follows after `max_size` bytes is cut off, and three
/// dots stand for it.
std::string escape_for_terminal(std::string_view text,
                                std::size_t max_size = std::string_view::npos);

}  // namespace lray
