// The window: loads the scene, shows it, and loads it again whenever something it reads changes.
#pragma once

#include "cli/exit_code.h"
#include "cli/options.h"

namespace lray::cli {

/// Returns when the window is closed.
/// Errors: those of the scene as for a picture, before a window is opened; no display or no OpenGL.
ExitCode show_window(const Options& options);

}  // namespace lray::cli
