// Walks over the command line and stores what each option says by itself. What goes together and
// what is left out is options.cpp's.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "cli/commands.h"
#include "cli/options.h"

namespace lray::cli {

/// Returns a mistake in the command line; without another help it points to --help.
Failure usage_error(std::string message, std::string help = "`lray --help` shows all options");

/// Stores the options, and the names of files, in `options`.
/// Shape: `command` may be null; the arguments of a command are those behind its name.
/// Errors: a usage error for options that are unknown or no part of the command, values that are
/// missing or wrong, empty names, two scenes.
std::optional<Failure> read_arguments(std::span<const char* const> arguments,
                                      const Command* command, Options& options);

}  // namespace lray::cli
