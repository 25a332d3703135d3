// Values that are plain to see in the text.
#pragma once

#include <optional>

#include "parser/arena.h"
#include "parser/syntax/ast.h"
#include "parser/values/value.h"

namespace lray::parser {

/// Returns the value of a literal, a signed number, a list of such, or a name of the prelude, once
/// names are resolved; empty for everything that has to be computed.
std::optional<Value> constant_value(const Expr& expr, Arena& arena);

}  // namespace lray::parser
