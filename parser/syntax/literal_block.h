// Places in blocks of literals, which have left no tree.
#pragma once

#include "base/source.h"

namespace lray::parser {

/// Returns where a block of literals that has a material names it: found in its text again, as it
/// is asked for in messages alone.
Span material_name(Span block, const Sources& sources);

}  // namespace lray::parser
