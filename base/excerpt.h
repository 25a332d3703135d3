// Lines of source text with marks under them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "base/source.h"

namespace lray {

/// Bytes of a message, note or label that are printed: one may quote a name of a megabyte.
inline constexpr std::size_t kMaxMessageSize = 2000;

/// The escape sequences of each part of a message; all empty without colours.
struct Palette {
    std::string_view primary{};    // severity and carets
    std::string_view secondary{};  // other marks
    std::string_view gutter{};
    std::string_view strong{};
    std::string_view reset{};
};

/// A place in a source whose text is at hand, and what is written beside it.
struct Mark {
    Span span{};
    std::string text{};
    bool is_primary = false;  // carets, else dashes
};

/// Returns how many digits the line numbers of these marks have.
std::size_t line_number_width(const Sources& sources, std::span<const Mark> marks);

/// Returns the lines that the marks touch, of a mark over several lines the first and the last,
/// each with its marks below. Long lines are cut around their first mark.
/// Shape: all marks in one source.
std::string format_excerpt(const Sources& sources, std::span<const Mark> marks,
                           std::size_t number_width, const Palette& palette);

}  // namespace lray
