// An NFF file as a part of a program: its shapes and lights are nodes at once, and what is left for
// running is to place them.
#pragma once

#include <span>
#include <string_view>

#include "base/diagnostics.h"
#include "base/source.h"
#include "parser/load.h"
#include "parser/syntax/ast.h"
#include "parser/syntax/parser.h"

namespace lray::parser {

/// True if a file of this name is NFF, which nothing else tells.
bool is_nff(std::string_view path);

/// Returns the items of an NFF file that is the scene, or is included: all shapes and lights are
/// placed, and its view is one of the scene's.
/// Errors: as scene::read_nff().
std::span<Item* const> nff_items(SourceId source, ParseContext& context, const LoadLimits& limits,
                                 Diagnostics& diagnostics);

/// Returns the items of an NFF file that is imported: the groups `shapes`, `lights` and `scene`,
/// which is both.
/// Errors: as scene::read_nff().
std::span<Item* const> nff_names(SourceId source, ParseContext& context, const LoadLimits& limits,
                                 Diagnostics& diagnostics);

}  // namespace lray::parser
