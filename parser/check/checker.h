// Resolves names and checks all that can be told without running: before anything is evaluated,
// for the whole program, also in branches that will not run.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "parser/arena.h"
#include "parser/symbols.h"
#include "parser/syntax/ast.h"
#include "scene/scene.h"

namespace lray::parser {

/// A place where a function or component is named, and so called or made a value.
struct FunctionUse {
    Function* function = nullptr;
    std::span<const std::uint32_t> capture_slots{};  // what it captures, in the frame around
};

/// A `param`, and what it is called on the command line: `lib.name` in an import.
struct Param {
    const LetItem* item = nullptr;
    std::string name{};
};

/// What the evaluator needs to know of a checked program, besides what stands in its tree.
struct Checked {
    std::uint32_t global_count = 0;
    std::uint32_t function_count = 0;
    std::uint32_t module_count = 0;
    std::uint32_t frame_size = 0;  // of the main file
    std::vector<FunctionUse> uses{};
    std::vector<Param> params{};
};

/// Checks a program, and writes into its tree what names mean. `nodes` are those that the parser
/// made of literals.
/// Errors: E0115 when blocks, expressions and includes together are nested too deep to walk over,
/// E0118, E02.., E03.. of literals, E04..; warns W11.., W14...
Checked check(std::span<Item* const> items, std::span<const scene::Node> nodes, Symbols& symbols,
              const Sources& sources, std::uint32_t max_nesting, Arena& arena,
              Diagnostics& diagnostics);

}  // namespace lray::parser
