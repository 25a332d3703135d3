// The text that format() takes: `x = {}, {:.2}`.
#pragma once

#include <optional>
#include <vector>

#include "parser/builtins/builtins.h"

namespace lray::parser {

/// A format text taken apart: what stands between the places, and the values for these, in order.
/// Joined without separator they are the result.
struct FormatText {
    std::vector<Value> pieces{};
};

inline constexpr unsigned kMaxDecimals = 17;  // a double has no more

/// Takes the first argument of a call apart, with `rest` as its values.
/// Errors: empty; E0312 for what no place looks like, E0305 and E0306 for values missing or too
/// many, E0301 for decimals of what is no number.
std::optional<FormatText> parse_format(Call& call);

}  // namespace lray::parser
