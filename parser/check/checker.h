// Resolves names and checks all that can be told without running: before anything is evaluated,
// for the whole program, also in branches that will not run.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/diagnostics.h"
#include "parser/arena.h"
#include "parser/symbols.h"
#include "parser/syntax/ast.h"

namespace lray::parser {

/// What the evaluator needs to know of a checked program.
struct Checked {
    std::vector<Span> variables{};  // where each slot is defined
};

/// Checks a program, and writes into its tree what names mean.
/// Errors: E0115 when blocks, expressions and includes together are nested too deep to walk over,
/// E0118, E02.., E03.. of literals, E04..; warns W11.., W14...
Checked check(std::span<Item* const> items, const Symbols& symbols, const Sources& sources,
              std::uint32_t max_nesting, Arena& arena, Diagnostics& diagnostics);

}  // namespace lray::parser
