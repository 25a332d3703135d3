#include "cli/format_files.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "base/output_file.h"
#include "base/source.h"
#include "base/terminal_text.h"
#include "cli/console.h"
#include "cli/report.h"
#include "cli/run.h"
#include "parser/nff_items.h"
#include "parser/tools/format.h"

namespace lray::cli {

namespace {

ExitCode report_errors(const Diagnostics& diagnostics, const Sources& sources,
                       const Options& options) {
    DiagnosticsReport report;
    return report.print(diagnostics, sources, options).value_or(ExitCode::done);
}

ExitCode write_text(const std::string& path, std::string_view text) {
    std::string error;
    auto output = OutputFile::open(path, error);
    if (!output) return report_failure({ExitCode::output, error, {}});
    if (!output->write(text) || !output->commit()) {
        return report_failure({ExitCode::output, output->error(), {}});
    }
    return ExitCode::done;
}

/// True for what cannot be put in the place of what was read: a pipe, a device.
bool has_no_place(const std::string& path) {
    struct stat status {};
    return stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

ExitCode format_one(const std::string& path, const Options& options) {
    const bool is_in_place = options.output_path.empty() && path != "-";
    if (is_in_place && !options.only_lists_unformatted && has_no_place(path)) {
        return report_failure({ExitCode::usage,
                               fmt::format("`{}` is no file that could be rewritten", path),
                               "say with `-o` where to write; `-` reads stdin and writes stdout"});
    }
    if (parser::is_nff(path)) {
        return report_failure({ExitCode::usage,
                               fmt::format("`{}` is NFF; only `.lrs` files are formatted", path),
                               "`--dump` writes what it shows as `.lrs`"});
    }
    Sources sources;
    Diagnostics diagnostics;
    FileAccess files = file_access(options);
    const auto formatted =
        parser::format_file(path, options.load_limits, files, sources, diagnostics);
    if (!formatted) return report_errors(diagnostics, sources, options);
    const bool has_changed = sources[formatted->source].text.view() != formatted->text;
    const std::string shown = escape_for_terminal(path == "-" ? "<stdin>" : path);
    if (options.only_lists_unformatted) {
        if (!has_changed) return ExitCode::done;
        return std::max(print_requested(shown + "\n"), ExitCode::scene);
    }
    if (!is_in_place) {
        return write_text(options.output_path.empty() ? "-" : options.output_path, formatted->text);
    }
    if (!has_changed) return ExitCode::done;
    const ExitCode written = write_text(path, formatted->text);
    if (written == ExitCode::done && !options.quiet) {
        print_message(fmt::format("formatted {}\n", shown));
    }
    return written;
}

}  // namespace

ExitCode format_files(const Options& options) {
    ExitCode highest = ExitCode::done;
    for (const std::string& path : options.paths) {
        highest = std::max(highest, format_one(path, options));
    }
    return highest;
}

}  // namespace lray::cli
