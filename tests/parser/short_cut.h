// Scenes loaded with the short cut for blocks of literals, and without it.
#pragma once

#include <string>

#include "tests/parser/loaded.h"

namespace lray::test {

/// Returns what a scene holds and all that is said about it, as text: equal for equal outcomes.
std::string outcome(const Loaded& loaded);

parser::LoadSettings without_short_cut(parser::LoadSettings settings = {});

}  // namespace lray::test
