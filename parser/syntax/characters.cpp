#include "parser/syntax/characters.h"

namespace lray::parser {

namespace {

// Source: Unicode Technical Standard 39, confusables.txt: the letters whose usual glyph is that of
// an ASCII letter.
constexpr std::array<Confusable, 40> kConfusables = {{
    {0x0391, 'A', "GREEK ALPHA"},   {0x0392, 'B', "GREEK BETA"},   {0x0395, 'E', "GREEK EPSILON"},
    {0x0396, 'Z', "GREEK ZETA"},    {0x0397, 'H', "GREEK ETA"},    {0x0399, 'I', "GREEK IOTA"},
    {0x039A, 'K', "GREEK KAPPA"},   {0x039C, 'M', "GREEK MU"},     {0x039D, 'N', "GREEK NU"},
    {0x039F, 'O', "GREEK OMICRON"}, {0x03A1, 'P', "GREEK RHO"},    {0x03A4, 'T', "GREEK TAU"},
    {0x03A5, 'Y', "GREEK UPSILON"}, {0x03A7, 'X', "GREEK CHI"},    {0x03BF, 'o', "GREEK OMICRON"},
    {0x03BD, 'v', "GREEK NU"},      {0x0405, 'S', "CYRILLIC DZE"}, {0x0406, 'I', "CYRILLIC I"},
    {0x0408, 'J', "CYRILLIC JE"},   {0x0410, 'A', "CYRILLIC A"},   {0x0412, 'B', "CYRILLIC VE"},
    {0x0415, 'E', "CYRILLIC IE"},   {0x041A, 'K', "CYRILLIC KA"},  {0x041C, 'M', "CYRILLIC EM"},
    {0x041D, 'H', "CYRILLIC EN"},   {0x041E, 'O', "CYRILLIC O"},   {0x0420, 'P', "CYRILLIC ER"},
    {0x0421, 'C', "CYRILLIC ES"},   {0x0422, 'T', "CYRILLIC TE"},  {0x0425, 'X', "CYRILLIC HA"},
    {0x0430, 'a', "CYRILLIC A"},    {0x0435, 'e', "CYRILLIC IE"},  {0x043E, 'o', "CYRILLIC O"},
    {0x0440, 'p', "CYRILLIC ER"},   {0x0441, 'c', "CYRILLIC ES"},  {0x0443, 'y', "CYRILLIC U"},
    {0x0445, 'x', "CYRILLIC HA"},   {0x0455, 's', "CYRILLIC DZE"}, {0x0456, 'i', "CYRILLIC I"},
    {0x0458, 'j', "CYRILLIC JE"},
}};

constexpr std::array<Lookalike, 15> kLookalikes = {{
    {0x00A0, ' ', "a no-break space", {}},
    {0x00AB, '"', "a guillemet", "\xC2\xBB"},
    {0x00D7, '*', "a multiplication sign", {}},
    {0x2003, ' ', "an em space", {}},
    {0x2009, ' ', "a thin space", {}},
    {0x200B, ' ', "a zero-width space", {}},
    {0x2013, '-', "an en dash", {}},
    {0x2014, '-', "an em dash", {}},
    {0x2018, '"', "a curly quote", "\xE2\x80\x99"},
    {0x201C, '"', "a curly quote", "\xE2\x80\x9D"},
    {0x201D, '"', "a curly quote", "\xE2\x80\x9D"},
    {0x201E, '"', "a curly quote", "\xE2\x80\x9C"},
    {0x202F, ' ', "a narrow no-break space", {}},
    {0x2212, '-', "a minus sign", {}},
    {0xFEFF, ' ', "a byte order mark", {}},
}};

}  // namespace

CodePoint decode_utf8(std::string_view text) {
    if (text.empty()) return {};
    const auto byte = [&](std::size_t i) -> unsigned {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
    };
    const unsigned first = byte(0);
    if (first < 0x80) return {first, 1};
    const unsigned length = first >= 0xF0 ? 4u : first >= 0xE0 ? 3u : 2u;
    if (first < 0xC2 || first > 0xF4) return {};
    char32_t value = first & (0xFFu >> (length + 1));
    for (unsigned i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0u) != 0x80u) return {};
        value = value << 6 | (byte(i) & 0x3Fu);
    }
    constexpr std::array<char32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
    const bool is_surrogate = value >= 0xD800 && value <= 0xDFFF;
    if (value < kLeast[length] || value > 0x10FFFF || is_surrogate) return {};
    return {value, length};
}

const Confusable* find_confusable(char32_t code_point) {
    for (const Confusable& confusable : kConfusables) {
        if (confusable.code_point == code_point) return &confusable;
    }
    return nullptr;
}

const Lookalike* find_lookalike(char32_t code_point) {
    for (const Lookalike& lookalike : kLookalikes) {
        if (lookalike.code_point == code_point) return &lookalike;
    }
    return nullptr;
}

}  // namespace lray::parser
