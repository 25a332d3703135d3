// What each byte may be part of, and UTF-8.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace lray::parser {

enum CharacterClass : std::uint8_t {
    kLetter = 1,  // [A-Za-z_]
    kDigit = 2,
    kBlank = 4,  // space and tab
    kHex = 8,
};

inline constexpr auto kCharacterClasses = [] {
    std::array<std::uint8_t, 256> classes{};
    for (unsigned c = 'a'; c <= 'z'; ++c) classes[c] = kLetter;
    for (unsigned c = 'A'; c <= 'Z'; ++c) classes[c] = kLetter;
    classes['_'] = kLetter;
    for (unsigned c = '0'; c <= '9'; ++c) classes[c] = kDigit | kHex;
    for (unsigned c = 'a'; c <= 'f'; ++c) classes[c] |= kHex;
    for (unsigned c = 'A'; c <= 'F'; ++c) classes[c] |= kHex;
    classes[' '] = kBlank;
    classes['\t'] = kBlank;
    return classes;
}();

inline bool is_a(char c, unsigned classes) {
    return (kCharacterClasses[static_cast<unsigned char>(c)] & classes) != 0;
}

struct CodePoint {
    char32_t value = 0;
    unsigned length = 0;  // in bytes; 0: not valid UTF-8
};

/// Decodes the code point at the begin of the text. Overlong forms, surrogates and values beyond
/// U+10FFFF are not valid.
CodePoint decode_utf8(std::string_view text);

/// A letter that looks like an ASCII one.
struct Confusable {
    char32_t code_point = 0;
    char looks_like = 0;
    std::string_view name{};  // of the code point, in Unicode's words
};

/// Returns the entry of a code point; null if it resembles no ASCII letter.
const Confusable* find_confusable(char32_t code_point);

/// Punctuation that looks like ASCII and comes along with text copied from elsewhere.
struct Lookalike {
    char32_t code_point = 0;
    char looks_like = 0;
    std::string_view name{};
    std::string_view closing{};  // of a quote: its partner
};

/// Returns the entry of a code point; null if it resembles no ASCII punctuation.
const Lookalike* find_lookalike(char32_t code_point);

}  // namespace lray::parser
