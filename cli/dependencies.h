// `--deps`: the files that a scene reads.
#pragma once

#include "cli/exit_code.h"
#include "cli/options.h"

namespace lray::cli {

/// Prints every file that is read for the frames asked for, one per line, the scene itself first.
/// Errors: those of the scene are told, and no file is.
ExitCode print_dependencies(const Options& options);

}  // namespace lray::cli
