// `--fmt`: files in the canonical style, or a list of those that are not in it.
#pragma once

#include "cli/exit_code.h"
#include "cli/options.h"

namespace lray::cli {

/// Formats each file in its place, or to `-o`; stdin to stdout. A file that is formatted already is
/// not touched; one with errors is left as it is, and the others go on.
/// Errors: the highest code of all files.
ExitCode format_files(const Options& options);

}  // namespace lray::cli
