// The rules of what may stand in a block: property names, duplicates, forms, required properties,
// children. Applied by the checker where the block's type is known from the text, and by the
// evaluator where it is not.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/diagnostics.h"
#include "parser/blocks/schema.h"
#include "parser/symbols.h"
#include "parser/syntax/ast.h"

namespace lray::parser {

/// What a block with braces does with its head.
enum class BlockUse : std::uint8_t {
    make,      // a built-in type: `sphere { }`
    copy,      // a value with other properties: `let big = ball { radius: 2 }`
    instance,  // a node placed again: `ball { translate: [2, 0, 0] }`
};

/// Where a property belongs: in the block's own table, or among the common ones.
struct PropertyPlace {
    const PropertySchema* schema = nullptr;  // null: there is no such property here
    std::size_t slot = 0;
    bool is_common = false;
};

PropertyPlace find_place(const BlockSchema& schema, std::string_view name);

/// Reports E0408 for a material, texture or record that is placed; `head` is its name in the scene,
/// or that of the built-in block.
void report_placed_value(BlockKind kind, std::string_view head, Span span,
                         Diagnostics& diagnostics);

/// Reports what is wrong with the body of a block; returns false if anything was.
/// Errors: E0401, E0402, E0406, E0411, E0412; warns W1401.
bool check_block(const BlockSchema& schema, const BlockExpr& block, BlockUse use,
                 const Symbols& symbols, const Sources& sources, Diagnostics& diagnostics);

}  // namespace lray::parser
