// The rule of which properties a block needs, and which exclude each other.
#pragma once

#include <span>

#include "base/diagnostics.h"
#include "parser/blocks/schema.h"

namespace lray::parser {

/// Reports properties of two forms together (E0411) and, in a block that is new, those that are
/// missing (E0406); returns false if there were any.
/// Shape: `set` says where each property of the schema was set, nowhere if it was not.
bool check_complete(const BlockSchema& schema, std::span<const Span> set, Span head, bool is_new,
                    Diagnostics& diagnostics);

}  // namespace lray::parser
