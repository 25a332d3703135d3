#include "parser/tools/format_spelling.h"

#include <algorithm>

#include "parser/syntax/characters.h"

namespace lray::parser {

namespace {

void append_lower(std::string& text, std::string_view added) {
    for (const char c : added) text += c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c;
}

/// True for the `e` of an exponent, and not of a unit.
bool is_exponent(std::string_view number, std::size_t at) {
    if ((number[at] | 0x20) != 'e') return false;
    const std::size_t sign =
        at + 1 < number.size() && (number[at + 1] == '+' || number[at + 1] == '-');
    return at + 1 + sign < number.size() && is_a(number[at + 1 + sign], kDigit);
}

}  // namespace

void append_number(std::string& text, std::string_view number) {
    if (number.size() > 1 && number[0] == '0' && (number[1] | 0x20) == 'x') {
        append_lower(text, number);
        return;
    }
    if (number.front() == '.') text += '0';
    for (std::size_t i = 0; i < number.size(); ++i) {
        const bool has_fraction = i + 1 < number.size() && is_a(number[i + 1], kDigit);
        if (number[i] == '.' && !has_fraction) continue;
        if (is_a(number[i], kLetter) && number[i] != '_') {
            const bool has_exponent = is_exponent(number, i);
            if (has_exponent) text += 'e';
            text += number.substr(has_exponent ? i + 1 : i);
            return;
        }
        text += number[i];
    }
}

void append_color(std::string& text, std::string_view color) {
    append_lower(text, color);
}

void append_comment(std::string& text, std::string_view comment) {
    for (;;) {
        const std::size_t carriage_return = comment.find('\r');
        text += comment.substr(0, carriage_return);
        if (carriage_return == comment.npos) return;
        text += '\n';
        comment.remove_prefix(carriage_return + 1);
        if (comment.starts_with('\n')) comment.remove_prefix(1);
    }
}

bool is_respelled(std::string_view number) {
    if (number.front() == '.') return true;
    for (std::size_t i = 1; i < number.size(); ++i) {
        if (number[i] >= 'A' && number[i] <= 'Z') return true;
        const bool has_fraction = i + 1 < number.size() && is_a(number[i + 1], kDigit);
        if (number[i] == '.' && !has_fraction) return true;
    }
    return false;
}

std::uint32_t number_width(std::string_view number) {
    auto width = static_cast<std::uint32_t>(number.size());
    const std::size_t point = number.find('.');
    if (point == number.npos) return width;
    const bool has_fraction = point + 1 < number.size() && is_a(number[point + 1], kDigit);
    return width + (point == 0 ? 1 : 0) - (has_fraction ? 0 : 1);
}

std::uint32_t text_width(std::string_view text) {
    const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
    return static_cast<std::uint32_t>(std::count_if(text.begin(), text.end(), begins));
}

}  // namespace lray::parser
