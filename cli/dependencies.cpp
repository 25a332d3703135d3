#include "cli/dependencies.h"

#include <set>
#include <string>

#include "base/terminal_text.h"
#include "cli/console.h"
#include "cli/frames.h"
#include "cli/report.h"
#include "cli/run.h"
#include "parser/load.h"

namespace lray::cli {

ExitCode print_dependencies(const Options& options) {
    DiagnosticsReport report;
    std::set<std::string> is_listed;
    std::string lines;
    for (std::uint64_t i = 0; i < frame_count(options); ++i) {
        const Options frame = options_of_frame(options, i);
        Sources sources;
        Diagnostics diagnostics(options.warning_levels);
        FileAccess files = file_access(options);
        const auto loaded =
            parser::load(frame.scene_path, load_settings(frame), files, sources, diagnostics);
        if (!loaded.usage_mistakes.empty()) return report_usage_mistakes(loaded.usage_mistakes);
        if (const auto end = report.print(diagnostics, sources, frame)) return *end;
        for (const std::string& file : files.files_read()) {
            if (is_listed.insert(file).second) lines += escape_for_terminal(file) + "\n";
        }
    }
    return print_requested(lines);
}

}  // namespace lray::cli
