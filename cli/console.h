// What the program says, outside of diagnostics: requested text on stdout, all else on stderr.
#pragma once

#include <string_view>

#include "cli/exit_code.h"
#include "cli/options.h"

namespace lray::cli {

/// Writes requested text to stdout.
/// Errors: returns ExitCode::output, having said so, when stdout does not take it.
ExitCode print_requested(std::string_view text);

/// Writes text to stderr as it is.
void print_message(std::string_view text);

/// Writes "lray: message" and the help to stderr, control characters escaped; returns its code.
ExitCode report_failure(const Failure& failure);

/// Writes "lray: warning: text" or "lray: note: text" to stderr, control characters escaped.
void print_warning(std::string_view text);
void print_note(std::string_view text);

/// True if messages are to be coloured: as asked for; otherwise if stderr is a terminal that knows
/// colours and NO_COLOR is not set (https://no-color.org).
bool use_color(ColorMode mode);

bool stderr_is_terminal();

}  // namespace lray::cli
