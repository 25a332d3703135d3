// `--dump`: the scene as it was evaluated.
#pragma once

#include "cli/exit_code.h"
#include "cli/options.h"

namespace lray::cli {

/// Writes the evaluated scene to stdout or where `-o` says.
/// Errors: those of the scene are told, and nothing is written; an output error.
ExitCode dump_scene(const Options& options);

}  // namespace lray::cli
