// `lray diff A B`: how much two pictures differ.
#pragma once

#include "cli/exit_code.h"
#include "cli/options.h"

namespace lray::cli {

/// Tells on stdout how much the two pictures of the options differ, and writes a picture of that
/// if it is asked for. Returns ExitCode::done if no pixel differs by more than the threshold,
/// ExitCode::scene (1) if one does or their sizes differ; what cannot be read is a usage error.
ExitCode diff_pictures(const Options& options);

}  // namespace lray::cli
