// The animation block, which is read before anything is evaluated: `time` depends on it.
#pragma once

#include <optional>
#include <span>

#include "base/diagnostics.h"
#include "parser/syntax/ast.h"
#include "scene/camera.h"

namespace lray::parser {

/// Returns what the `animation` block among the top-level items says, those of included files
/// counted; empty if there is none. Its values are numbers, with a sign if need be.
/// Errors: E0301 for what has to be computed, E0405 for a second block. Names that it does not have
/// and numbers that do not fit are left to check().
std::optional<scene::Animation> read_animation(std::span<Item* const> top_level_items,
                                               const Symbols& symbols, Diagnostics& diagnostics);

}  // namespace lray::parser
