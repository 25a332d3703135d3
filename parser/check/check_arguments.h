// The rules of what a built-in function is called with.
#pragma once

#include "base/diagnostics.h"
#include "parser/builtins/builtins.h"
#include "parser/symbols.h"
#include "parser/syntax/ast.h"

namespace lray::parser {

/// Reports arguments that a function does not have or does not get: E0305, E0306, each at its
/// place. What the arguments are is seen when they are evaluated.
void check_arguments(const CallExpr& expr, const Builtin& builtin, const Symbols& symbols,
                     Diagnostics& diagnostics);

}  // namespace lray::parser
