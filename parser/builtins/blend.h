// Values between two values: for mix() and keys().
#pragma once

#include "parser/builtins/builtins.h"

namespace lray::parser {

/// Returns a at t = 0 and b at t = 1, of numbers, lists of numbers or colours. A number stands for
/// each component; with a colour, three numbers are a colour.
/// Errors: poison; E0302 when the lengths differ, E0301 when one is a colour and the other cannot
/// be, E0503 when the result is not finite; all at the call.
Value blend(Call& call, const Value& a, const Value& b, double t);

}  // namespace lray::parser
