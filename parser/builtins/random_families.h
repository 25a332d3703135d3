// The families of built-in functions that are random: noise, and random numbers by keys.
#pragma once

#include <span>

#include "base/random.h"
#include "parser/builtins/builtins.h"

namespace lray::parser {

/// noise, fbm, ridged, worley.
std::span<const Builtin> noise_builtins();

/// rand and its kin.
std::span<const Builtin> random_builtins();

/// Folds a key, a number or a string, into random numbers.
KeyedRandom with_key(KeyedRandom random, const Value& key);

}  // namespace lray::parser
