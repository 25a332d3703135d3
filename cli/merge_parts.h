// `lray merge PARTS -o FILE`: films of one picture, rendered apart, added up.
#pragma once

#include "cli/exit_code.h"
#include "cli/options.h"

namespace lray::cli {

/// Reads the films that the options name and writes their sum: a film, or if no sample is missing
/// the picture, the same bytes as if all samples were rendered in one go.
ExitCode merge_parts(const Options& options);

}  // namespace lray::cli
