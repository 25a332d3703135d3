// Ctrl-C and SIGTERM: asked to stop, a render ends early and what there is gets written.
#pragma once

#include <atomic>
#include <optional>

#include "cli/exit_code.h"

namespace lray::cli {

/// From now on the first SIGINT or SIGTERM sets the flag that stop_requested() returns; the next
/// one ends the process at once. What was ignored before (nohup) stays so.
void catch_interrupts();

/// Set by the first signal.
const std::atomic<bool>& stop_requested();

/// Which signal that was, as an exit code; empty if none came.
std::optional<ExitCode> interrupt_exit_code();

/// Writing to a closed pipe becomes an error of that write instead of ending the process.
void ignore_broken_pipes();

}  // namespace lray::cli
