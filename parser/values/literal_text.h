// Values as literals of the language, which `-D name=value` reads back.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "parser/values/value.h"

namespace lray::parser {

/// Lists in a literal nest so deep.
inline constexpr std::uint8_t kMaxLiteralDepth = 32;

/// Returns a value as it is written, read back to the same bits: numbers in their shortest exact
/// form, strings with quotes, colours like `#ff8000` or, where that is not exact, `rgb(1, 0.5, 0)`.
/// Empty for what takes more than `limit` bytes, for lists nested deeper than kMaxLiteralDepth, for
/// transparent colours that `#rrggbbaa` cannot tell, and for all that is not a number, a boolean, a
/// string, a colour or a list of those.
std::optional<std::string> literal_text(const Value& value, std::size_t limit);

}  // namespace lray::parser
