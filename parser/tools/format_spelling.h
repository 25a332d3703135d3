// How the formatter spells numbers and colours.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace lray::parser {

/// Appends a number: `.5` as `0.5`, `1.` as `1`, hex digits and the `e` of exponents in lower case.
void append_number(std::string& text, std::string_view number);

/// Appends a colour in lower case.
void append_color(std::string& text, std::string_view color);

/// Appends a comment with `\n` for each line end.
void append_comment(std::string& text, std::string_view comment);

/// True for a number that append_number() spells otherwise than it is written.
bool is_respelled(std::string_view number);

/// How many columns append_number() takes.
std::uint32_t number_width(std::string_view number);

/// How many columns a text on one line takes: its code points.
std::uint32_t text_width(std::string_view text);

}  // namespace lray::parser
