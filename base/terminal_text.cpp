#include "base/terminal_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <span>

namespace lray {
namespace {

struct Range {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
};

// clang-format off

// Controls, and what is invisible or reorders the line: zero-width space, direction marks,
// embeddings, overrides and isolates, separators, byte order mark, interlinear marks, tags.
constexpr Range kEscaped[] = {
    {0x0000, 0x001f}, {0x007f, 0x009f}, {0x00ad, 0x00ad}, {0x061c, 0x061c}, {0x180e, 0x180e},
    {0x200b, 0x200b}, {0x200e, 0x200f}, {0x2028, 0x202e}, {0x2060, 0x206f}, {0xfeff, 0xfeff},
    {0xfff9, 0xfffb}, {0xe0000, 0xe007f},
};

// Combining marks, joiners and variation selectors of the scripts in wide use (Unicode 15,
// general categories Mn, Me, Cf).
constexpr Range kZeroWidth[] = {
    {0x0300, 0x036f}, {0x0483, 0x0489}, {0x0591, 0x05bd}, {0x05bf, 0x05bf}, {0x05c1, 0x05c2},
    {0x05c4, 0x05c5}, {0x0610, 0x061a}, {0x064b, 0x065f}, {0x0670, 0x0670}, {0x06d6, 0x06dc},
    {0x06df, 0x06e4}, {0x0900, 0x0902}, {0x093c, 0x093c}, {0x0941, 0x0948}, {0x094d, 0x094d},
    {0x0e31, 0x0e31}, {0x0e34, 0x0e3a}, {0x0e47, 0x0e4e}, {0x1160, 0x11ff}, {0x1ab0, 0x1aff},
    {0x1dc0, 0x1dff}, {0x200c, 0x200d}, {0x20d0, 0x20ff}, {0x302a, 0x302d}, {0x3099, 0x309a},
    {0xfe00, 0xfe0f}, {0xfe20, 0xfe2f}, {0xe0100, 0xe01ef},
};

// Unicode Standard Annex 11, East Asian Width W and F, neighbouring ranges put together.
constexpr Range kWide[] = {
    {0x1100, 0x115f}, {0x231a, 0x231b}, {0x2329, 0x232a}, {0x23e9, 0x23ec}, {0x23f0, 0x23f0},
    {0x23f3, 0x23f3}, {0x25fd, 0x25fe}, {0x2614, 0x2615}, {0x2648, 0x2653}, {0x267f, 0x267f},
    {0x2693, 0x2693}, {0x26a1, 0x26a1}, {0x26aa, 0x26ab}, {0x26bd, 0x26be}, {0x26c4, 0x26c5},
    {0x26ce, 0x26ce}, {0x26d4, 0x26d4}, {0x26ea, 0x26ea}, {0x26f2, 0x26f3}, {0x26f5, 0x26f5},
    {0x26fa, 0x26fa}, {0x26fd, 0x26fd}, {0x2705, 0x2705}, {0x270a, 0x270b}, {0x2728, 0x2728},
    {0x274c, 0x274c}, {0x274e, 0x274e}, {0x2753, 0x2755}, {0x2757, 0x2757}, {0x2795, 0x2797},
    {0x27b0, 0x27b0}, {0x27bf, 0x27bf}, {0x2b1b, 0x2b1c}, {0x2b50, 0x2b50}, {0x2b55, 0x2b55},
    {0x2e80, 0x303e}, {0x3041, 0x4dbf}, {0x4e00, 0xa4cf}, {0xa960, 0xa97f}, {0xac00, 0xd7a3},
    {0xf900, 0xfaff}, {0xfe10, 0xfe19}, {0xfe30, 0xfe6f}, {0xff01, 0xff60}, {0xffe0, 0xffe6},
    {0x16fe0, 0x18cff}, {0x1aff0, 0x1b2fb}, {0x1f004, 0x1f004}, {0x1f0cf, 0x1f0cf},
    {0x1f18e, 0x1f18e}, {0x1f191, 0x1f19a}, {0x1f200, 0x1f320}, {0x1f32d, 0x1f335},
    {0x1f337, 0x1f37c}, {0x1f37e, 0x1f393}, {0x1f3a0, 0x1f3ca}, {0x1f3cf, 0x1f3d3},
    {0x1f3e0, 0x1f3f0}, {0x1f3f4, 0x1f3f4}, {0x1f3f8, 0x1f43e}, {0x1f440, 0x1f440},
    {0x1f442, 0x1f4fc}, {0x1f4ff, 0x1f53d}, {0x1f54b, 0x1f54e}, {0x1f550, 0x1f567},
    {0x1f57a, 0x1f57a}, {0x1f595, 0x1f596}, {0x1f5a4, 0x1f5a4}, {0x1f5fb, 0x1f64f},
    {0x1f680, 0x1f6c5}, {0x1f6cc, 0x1f6cc}, {0x1f6d0, 0x1f6d2}, {0x1f6d5, 0x1f6df},
    {0x1f6eb, 0x1f6ec}, {0x1f6f4, 0x1f6fc}, {0x1f7e0, 0x1f7eb}, {0x1f90c, 0x1f93a},
    {0x1f93c, 0x1f945}, {0x1f947, 0x1f9ff}, {0x1fa70, 0x1faff}, {0x20000, 0x3fffd},
};
// clang-format on

bool is_in(std::span<const Range> ranges, std::uint32_t code_point) {
    const auto range =
        std::lower_bound(ranges.begin(), ranges.end(), code_point,
                         [](Range r, std::uint32_t value) { return r.last < value; });
    return range != ranges.end() && range->first <= code_point;
}

struct Decoded {
    std::uint32_t code_point = 0;
    std::size_t size = 0;  // 0: the first byte begins no well-formed sequence
};

/// Source: The Unicode Standard 15, table 3-7, "Well-Formed UTF-8 Byte Sequences".
Decoded decode(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(text[i]))
                               : 0u;
    };
    const std::uint32_t lead = byte(0);
    if (lead < 0x80) return {lead, 1};
    const std::size_t size = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4) return {};
    std::uint32_t code_point = lead & (0x7fu >> size);
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xc0u) != 0x80u) return {};
        code_point = code_point << 6 | (byte(i) & 0x3fu);
    }
    constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool is_surrogate = code_point >= 0xd800 && code_point <= 0xdfff;
    if (code_point < kLeast[size] || code_point > 0x10ffff || is_surrogate) return {};
    return {code_point, size};
}

}  // namespace

Glyph first_glyph(std::string_view text) {
    Glyph glyph;
    const Decoded decoded = decode(text);
    const std::uint32_t c = decoded.code_point;
    if (decoded.size == 0) {
        glyph.size = 1;
        glyph.escaped = fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
    } else if (is_in(kEscaped, c)) {
        glyph.size = decoded.size;
        glyph.escaped = c == '\n' ? "\\n" : c == '\t' ? "\\t" : fmt::format("\\u{{{:x}}}", c);
    } else {
        glyph.size = decoded.size;
        glyph.plain = text.substr(0, decoded.size);
        glyph.width = is_in(kZeroWidth, c) ? 0u : is_in(kWide, c) ? 2u : 1u;
    }
    if (!glyph.escaped.empty()) glyph.width = glyph.escaped.size();
    return glyph;
}

std::string escape_for_terminal(std::string_view text, std::size_t max_size) {
    std::string result;
    result.reserve(std::min(text.size(), max_size));
    while (!text.empty()) {
        if (result.size() >= max_size) return result + "...";
        const Glyph glyph = first_glyph(text);
        result += glyph.text();
        text.remove_prefix(glyph.size);
    }
    return result;
}

}  // namespace lray
