// Runs a checked program: the tree in, a scene out.
#pragma once

#include <span>

#include "base/diagnostics.h"
#include "parser/check/checker.h"
#include "parser/file_loader.h"
#include "parser/load.h"
#include "parser/symbols.h"
#include "parser/syntax/ast.h"
#include "scene/scene.h"

namespace lray::parser {

/// Evaluates the items of a program, top to bottom, into the scene and makes its root.
/// Errors: E03.., E04.., E05.., E06.., E07.. at the expression; what depends on a failed value is
/// skipped in silence, the rest goes on.
void evaluate(std::span<Item* const> items, const Checked& checked, const Symbols& symbols,
              const Sources& sources, FileLoader& files, const LoadLimits& limits,
              scene::Scene& scene, Diagnostics& diagnostics);

}  // namespace lray::parser
