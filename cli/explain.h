// `--explain`: what a code, a block, a function or a topic means.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/exit_code.h"

namespace lray::cli {

/// Prints what the word means.
/// Errors: a usage error for an unknown word, with the nearest ones.
ExitCode explain(std::string_view word);

/// Returns every word that `--explain` knows, but for the codes.
std::vector<std::string_view> explained_words();

}  // namespace lray::cli
