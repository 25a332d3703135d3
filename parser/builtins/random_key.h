// How values become keys of random numbers.
#pragma once

#include "base/random.h"
#include "parser/builtins/builtins.h"

namespace lray::parser {

/// Folds a key, a number or a string, into random numbers. A long string takes steps: E0512 at the
/// call when they are spent.
KeyedRandom with_key(Call& call, KeyedRandom random, const Value& key);

}  // namespace lray::parser
