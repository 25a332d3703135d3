// How values become keys of random numbers.
#pragma once

#include "base/random.h"
#include "parser/values/value.h"

namespace lray::parser {

/// Folds a key, a number or a string, into random numbers.
KeyedRandom with_key(KeyedRandom random, const Value& key);

}  // namespace lray::parser
