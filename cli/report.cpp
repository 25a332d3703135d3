#include "cli/report.h"

#include <fmt/format.h>

#include <string_view>

#include "base/assert.h"
#include "base/diagnostic_json.h"
#include "base/diagnostic_printer.h"
#include "base/diagnostic_sarif.h"
#include "cli/console.h"

namespace lray::cli {

namespace {

std::string formatted(const Diagnostics& diagnostics, const Sources& sources,
                      const Options& options) {
    const std::size_t max_errors = options.max_errors.value_or(0);
    switch (options.diagnostics_format) {
        case DiagnosticsFormat::text:
            return format_diagnostics(diagnostics, sources, {use_color(options.color), max_errors});
        case DiagnosticsFormat::json:
            return format_json(diagnostics, sources, max_errors);
        case DiagnosticsFormat::sarif:
            return format_sarif(diagnostics, sources, max_errors);
    }
    LRAY_ASSERT(false);
}

/// "scene.lrs", "scene.lrs, frame 3 of 8".
std::string shown_scene(const Options& options) {
    const std::string name =
        options.scene_path == "-" ? "<stdin>" : escape_for_terminal(options.scene_path);
    return fmt::format("{}{}{}", name, options.frame_label.empty() ? "" : ", ",
                       options.frame_label);
}

/// "2 errors, 1 warning; nothing rendered".
std::string closing_line(const Diagnostics& diagnostics, const Options& options) {
    std::string line = summary(diagnostics);
    if (!diagnostics.has_errors()) {
        const std::size_t denied = diagnostics.denied_count();
        line +=
            denied == diagnostics.warning_count() ? ", denied" : fmt::format(", {} denied", denied);
        line += " by `--deny`";
    }
    if (options.mode == Mode::render) line += "; nothing rendered";
    if (options.mode == Mode::format) line += "; nothing formatted";
    return line + "\n";
}

}  // namespace

std::optional<ExitCode> DiagnosticsReport::print(const Diagnostics& diagnostics,
                                                 const Sources& sources, const Options& options) {
    std::string text = formatted(diagnostics, sources, options);
    const bool is_text = options.diagnostics_format == DiagnosticsFormat::text;
    const bool is_denied = diagnostics.denied_count() > 0;
    const bool has_failed = diagnostics.has_errors() || is_denied;
    if (has_failed || text != said_before_) print_message(text);
    said_before_ = std::move(text);
    if (has_failed) {
        if (is_text) print_message(closing_line(diagnostics, options));
        return diagnostics.has_limit_errors() ? ExitCode::limit : ExitCode::scene;
    }
    if (options.mode != Mode::check) return std::nullopt;
    if (!is_text) return ExitCode::done;
    const std::string counts = summary(diagnostics);
    return print_requested(fmt::format("{}: no errors{}{}\n", shown_scene(options),
                                       counts.empty() ? "" : ", ", counts));
}

ExitCode report_usage_mistakes(std::span<const std::string> mistakes) {
    for (const std::string& mistake : mistakes) report_failure({ExitCode::usage, mistake, {}});
    return ExitCode::usage;
}

}  // namespace lray::cli
