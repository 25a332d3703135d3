#include "scene/formats/token_words.h"

#include <fmt/format.h>

#include "base/parse_number.h"

namespace lray::scene {

namespace {

bool is_not_finite(std::string_view word) {
    std::string lower(word.substr(0, 3));
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower == "nan" || lower == "inf";
}

}  // namespace

std::string quoted_token(std::string_view token) {
    constexpr std::size_t kMaxQuoted = 32;
    if (token.size() <= kMaxQuoted) return fmt::format("`{}`", token);
    std::size_t length = kMaxQuoted;
    // Not in the middle of a UTF-8 sequence.
    while (length > 0 && (static_cast<unsigned char>(token[length]) & 0xc0u) == 0x80u) --length;
    return fmt::format("`{}...`", token.substr(0, length));
}

std::string wrong_number_text(std::string_view token) {
    const std::string_view unsigned_token =
        token.starts_with('-') || token.starts_with('+') ? token.substr(1) : token;
    const char* const end = token.data() + token.size();
    const ParsedNumber number = parse_decimal(unsigned_token.data());
    if (number.end == end) {
        return fmt::format("{} is too large: numbers go up to 3.4e38", quoted_token(token));
    }
    if (is_not_finite(unsigned_token)) {
        return fmt::format("expected a finite number, found {}", quoted_token(token));
    }
    const bool is_decimal_comma = number.is_found() && number.end < end && *number.end == ',';
    return fmt::format("expected a number, found {}{}", quoted_token(token),
                       is_decimal_comma ? "; decimals are written with a point" : "");
}

}  // namespace lray::scene
