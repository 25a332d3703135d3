// Runs a checked program: the tree in, a scene out.
#pragma once

#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/diagnostics.h"
#include "parser/check/checker.h"
#include "parser/evaluate/listed_params.h"
#include "parser/file_loader.h"
#include "parser/load.h"
#include "parser/symbols.h"
#include "parser/syntax/ast.h"
#include "parser/values/value.h"
#include "scene/scene.h"

namespace lray::parser {

/// What a program runs with.
struct Environment {
    const Checked& checked;
    Symbols& symbols;
    const Sources& sources;
    FileLoader& files;
    const LoadSettings& settings;
    double time = 0.0;
    std::unordered_map<const LetItem*, Value> params{};  // given on the command line
    std::vector<std::string>* usage_mistakes = nullptr;  // takes what is wrong with those
    ListedParams* listed_params = nullptr;               // takes what the params are; may be null
};

/// Evaluates the items of a program, top to bottom, into the scene and makes its root.
/// Errors: E02.., E03.., E04.., E05.., E06.., E07.. at the expression; what depends on a failed
/// value is skipped in silence, a loop or function ends with its first error, the rest goes on.
void evaluate(std::span<Item* const> items, const Environment& environment, scene::Scene& scene,
              Diagnostics& diagnostics);

}  // namespace lray::parser
