// The characters of OBJ text: where blanks, tokens, lines and statements end. What the statements
// mean is scene/formats/obj_reader.cpp.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>

#include "base/parse_number.h"
#include "base/source.h"

// All functions take a place in a Text and stop at its end, where the padding begins: a NUL ends a
// line. A backslash at the end of a line joins it with the next.
namespace lray::scene::obj {

inline bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

inline bool is_line_end(char c) {
    return c == '\n' || c == '\r' || c == '\0';
}

/// True at a backslash that joins two lines.
inline bool is_continuation(const char* at) {
    return at[0] == '\\' && (at[1] == '\n' || at[1] == '\r');
}

inline bool is_token_end(const char* at) {
    return is_blank(*at) || is_line_end(*at) || is_continuation(at);
}

/// Returns the begin of the next token of the statement, or the end of its last line.
inline const char* skip_blanks(const char* at) {
    for (;;) {
        while (is_blank(*at)) ++at;
        if (*at != '\\' || !is_continuation(at)) return at;
        at += at[1] == '\r' && at[2] == '\n' ? 3 : 2;
    }
}

inline const char* skip_token(const char* at) {
    while (!is_token_end(at)) ++at;
    return at;
}

inline std::string_view token_at(const char* begin) {
    return {begin, static_cast<std::size_t>(skip_token(begin) - begin)};
}

/// Takes the number of a token, behind blanks; empty if it is none, or none that a float holds:
/// then `at` is the begin of the token.
inline std::optional<double> take_number(const char*& at) {
    at = skip_blanks(at);
    const bool is_negative = *at == '-';
    const ParsedNumber number = parse_decimal(*at == '-' || *at == '+' ? at + 1 : at);
    constexpr double kLargest = std::numeric_limits<float>::max();
    if (!number.is_found() || !is_token_end(number.end) || number.value > kLargest) {
        return std::nullopt;
    }
    at = number.end;
    return is_negative ? -number.value : number.value;
}

/// Returns the end of the line, eight bytes at a time; or a place at or behind `limit`.
/// Source: Warren, "Hacker's Delight", 2nd ed., 6-1: the lowest byte below a bound.
inline const char* find_line_end(const char* at, const char* limit) {
    constexpr std::uint64_t kOnes = 0x0101010101010101u;
    constexpr std::uint64_t kHighBits = 0x80 * kOnes;
    constexpr std::uint64_t kBound = ('\r' + 1) * kOnes;
    while (at < limit) {
        std::uint64_t bytes = 0;
        std::memcpy(&bytes, at, sizeof bytes);
        const std::uint64_t below = (bytes - kBound) & ~bytes & kHighBits;
        if (below == 0) {
            at += sizeof bytes;
            continue;
        }
        at += std::countr_zero(below) / 8;
        if (is_line_end(*at)) return at;
        ++at;  // a tab or another control character
    }
    return at;
}

/// Returns the end of the last line of the statement that begins at `begin`, from a place in it;
/// or a place at or behind `limit`.
inline const char* find_statement_end(const char* begin, const char* at, const char* limit) {
    for (;;) {
        at = find_line_end(at, limit);
        if (at >= limit || at == begin || !is_continuation(at - 1)) return at;
        at += at[0] == '\r' && at[1] == '\n' ? 2 : 1;
    }
}

enum class Statement : std::uint8_t {
    position,
    uv,
    normal,
    face,
    group,
    object,
    material,
    library,
    smoothing,
    free_form,  // `curv`, `curv2`, `surf`
    other,
};

/// Returns what a statement is by its keyword.
inline Statement statement_at(const char* at) {
    const auto is = [at](std::string_view keyword) {
        return std::memcmp(at, keyword.data(), keyword.size()) == 0 &&
               is_token_end(at + keyword.size());
    };
    switch (at[0]) {
        case 'v':
            if (is_token_end(at + 1)) return Statement::position;
            if (at[1] == 't' && is_token_end(at + 2)) return Statement::uv;
            if (at[1] == 'n' && is_token_end(at + 2)) return Statement::normal;
            return Statement::other;
        case 'f':
            return is_token_end(at + 1) ? Statement::face : Statement::other;
        case 'g':
            return is_token_end(at + 1) ? Statement::group : Statement::other;
        case 'o':
            return is_token_end(at + 1) ? Statement::object : Statement::other;
        case 's':
            if (is_token_end(at + 1)) return Statement::smoothing;
            return is("surf") ? Statement::free_form : Statement::other;
        case 'u':
            return is("usemtl") ? Statement::material : Statement::other;
        case 'm':
            return is("mtllib") ? Statement::library : Statement::other;
        case 'c':
            return is("curv") || is("curv2") ? Statement::free_form : Statement::other;
        default:
            return Statement::other;
    }
}

}  // namespace lray::scene::obj
