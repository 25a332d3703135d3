#include "scene/formats/ply_mistakes.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/assert.h"

namespace lray::scene::ply {

std::string quoted(std::string_view word) {
    constexpr std::size_t kMaxQuoted = 32;
    if (word.size() <= kMaxQuoted) return fmt::format("`{}`", word);
    std::size_t length = kMaxQuoted;
    // Not in the middle of a UTF-8 sequence.
    while (length > 0 && (static_cast<unsigned char>(word[length]) & 0xc0u) == 0x80u) --length;
    return fmt::format("`{}...`", word.substr(0, length));
}

void Mistakes::in_text(Code code, std::string_view place, std::string message) {
    LRAY_ASSERT(!are_any_);
    const std::size_t begin = byte_at(place.data());
    if (!is_text(place)) {
        in_bytes(code, fmt::format("at byte {}: {}", begin, message));
        return;
    }
    are_any_ = true;
    const Span span = Span::make(id_, begin, begin + place.size());
    Diagnostic& diagnostic = diagnostics_.error(code, span, std::move(message));
    if (!loaded_at_.is_nowhere()) diagnostic.with_label(loaded_at_, "loaded here");
}

void Mistakes::in_bytes(Code code, std::string message) {
    LRAY_ASSERT(!are_any_);
    are_any_ = true;
    diagnostics_.error(code, loaded_at_, std::move(message));
}

/// True if what an excerpt shows of the place is made of characters: no bytes that a body in binary
/// has, and no line of megabytes that is one.
bool Mistakes::is_text(std::string_view place) const {
    constexpr std::size_t kShown = 400;
    const std::string_view text = text_.view();
    const std::size_t place_begin = byte_at(place.data());
    const std::size_t place_end = place_begin + place.size();
    std::size_t begin = text.substr(0, place_begin).find_last_of("\r\n");
    begin = begin == text.npos ? 0 : begin + 1;
    std::size_t end = std::min(text.find_first_of("\r\n", place_end), text.size());
    begin = std::max(begin, place_begin - std::min(place_begin, kShown));
    end = std::min(end, place_end + kShown);
    const std::string_view shown = text.substr(begin, end - begin);
    return std::all_of(shown.begin(), shown.end(),
                       [](char c) { return c == '\t' || (c >= ' ' && c <= '~'); });
}

}  // namespace lray::scene::ply
