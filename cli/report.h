// Tells the diagnostics of a load in the form that was asked for, and whether the program goes on.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "base/diagnostics.h"
#include "base/source.h"
#include "cli/exit_code.h"
#include "cli/options.h"

namespace lray::cli {

/// Prints the diagnostics of one frame after the other; what was said of the frame before is not
/// said again.
class DiagnosticsReport {
 public:
    /// Prints the diagnostics and, as text, their closing line. Returns how the program ends, if it
    /// ends here: after errors, after warnings that are denied, and when checking was all that was
    /// asked for.
    std::optional<ExitCode> print(const Diagnostics& diagnostics, const Sources& sources,
                                  const Options& options);

 private:
    std::string said_before_;
};

/// Prints what is wrong with `-D`.
ExitCode report_usage_mistakes(std::span<const std::string> mistakes);

}  // namespace lray::cli
