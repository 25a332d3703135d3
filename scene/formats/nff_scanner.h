// The words of NFF text: where they begin and end, and which of them begin statements.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/source.h"

// All functions take a place in a Text and stop at its end, where the padding begins.
namespace lray::scene::nff {

inline bool is_line_end(char c) {
    return c == '\n' || c == '\r' || c == '\0';
}

inline bool is_space(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/// True at a byte order mark of UTF-16.
inline bool is_utf16(const char* at) {
    return (at[0] == '\xFF' && at[1] == '\xFE') || (at[0] == '\xFE' && at[1] == '\xFF');
}

inline bool is_token_end(char c) {
    return is_space(c) || c == '\0' || c == '#';
}

inline const char* skip_line(const char* at) {
    while (!is_line_end(*at)) ++at;
    return at;
}

/// Returns the begin of the next token, behind line ends and comments.
inline const char* skip_space(const char* at) {
    for (;;) {
        while (is_space(*at)) ++at;
        if (*at != '#') return at;
        at = skip_line(at);
    }
}

inline const char* skip_token(const char* at) {
    while (!is_token_end(*at)) ++at;
    return at;
}

inline std::string_view token_at(const char* begin) {
    return {begin, static_cast<std::size_t>(skip_token(begin) - begin)};
}

/// True where a number begins, or what was to be one.
inline bool is_number_begin(char c) {
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
}

enum class Statement : std::uint8_t {
    view,
    background,
    light,
    fill,
    sphere,
    cone,
    polygon,
    patch,
    none
};

/// As they are written, in the order of Statement.
inline constexpr std::array<std::string_view, 8> kKeywords = {"v", "b", "l", "f",
                                                              "s", "c", "p", "pp"};

/// Shape: not none.
inline std::string_view keyword_of(Statement statement) {
    return kKeywords[static_cast<std::size_t>(statement)];
}

/// Returns what the token at `at` begins.
inline Statement statement_at(const char* at) {
    if (at[0] == 'p' && at[1] == 'p' && is_token_end(at[2])) return Statement::patch;
    if (!is_token_end(at[0]) && !is_token_end(at[1])) return Statement::none;
    switch (at[0]) {
        case 'v':
            return Statement::view;
        case 'b':
            return Statement::background;
        case 'l':
            return Statement::light;
        case 'f':
            return Statement::fill;
        case 's':
            return Statement::sphere;
        case 'c':
            return Statement::cone;
        case 'p':
            return Statement::polygon;
        default:
            return Statement::none;
    }
}

/// The words inside of a `v`.
enum class ViewWord : std::uint8_t { from, at, up, angle, hither, yon, resolution, none };

/// As they are written, in the order of ViewWord.
inline constexpr std::array<std::string_view, 7> kViewWords = {
    "from", "at", "up", "angle", "hither", "yon", "resolution"};

inline ViewWord view_word_at(const char* at) {
    const std::string_view token = token_at(at);
    for (std::size_t i = 0; i < kViewWords.size(); ++i) {
        if (kViewWords[i] == token) return static_cast<ViewWord>(i);
    }
    return ViewWord::none;
}

}  // namespace lray::scene::nff
