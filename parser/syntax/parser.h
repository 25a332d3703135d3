// Tokens to syntax tree, by recursive descent; grammar.md holds the productions.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "base/source.h"
#include "parser/arena.h"
#include "parser/syntax/ast.h"
#include "parser/syntax/lexer.h"
#include "parser/syntax/packed_numbers.h"
#include "scene/scene.h"

namespace lray::parser {

/// What all files of one load share while they are parsed.
struct ParseContext {
    const Sources& sources;
    Symbols& symbols;
    Arena& arena;
    scene::Scene& scene;                    // takes the blocks that are all literals
    std::vector<OwnedNumbers>& long_lists;  // takes what is too long for the arena
    std::uint32_t max_nesting = 256;
    bool use_literal_fast_path = true;
};

struct ParsedFile {
    std::span<Item* const> items{};
    std::vector<IncludeItem*> includes{};
    std::vector<ImportItem*> imports{};

    /// Braces do not match: what stands in which block is a guess, not to be checked.
    bool is_structure_known = true;
};

/// Parses one file. Always returns a tree of what could be understood.
/// Errors: E00.., E01.., each at its place; the parser goes on at the next item.
ParsedFile parse(SourceId source, ParseContext& context, Diagnostics& diagnostics);

}  // namespace lray::parser
