// Values as text, for print(), str() and messages.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "parser/symbols.h"
#include "parser/values/value.h"

namespace lray::parser {

/// Returns how many bytes the text of a value has; empty if they are more than `limit`. Takes time
/// in proportion to the limit at most, however large a list is that is shared in many places.
std::optional<std::uint64_t> text_size(const Value& value, const Symbols& symbols,
                                       std::uint64_t limit);

/// Writes the text of a value, text_size() bytes, and returns their end. Numbers are in their
/// shortest exact form, lists like `[1, 2]`, colours like `rgb(1, 0.5, 0)`, linear; strings are
/// bare, and quoted inside of lists and records.
char* write_text(const Value& value, const Symbols& symbols, char* out);

/// Returns the text of a value, cut with `...` to at most `limit` bytes, and between characters.
/// Shape: `limit` is 3 at least.
std::string value_text(const Value& value, const Symbols& symbols, std::size_t limit);

}  // namespace lray::parser
