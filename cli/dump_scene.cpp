#include "cli/dump_scene.h"

#include <string_view>
#include <utility>
#include <variant>

#include "cli/console.h"
#include "cli/report.h"
#include "cli/run.h"
#include "parser/load.h"
#include "parser/tools/dump.h"
#include "scene/flatten.h"

namespace lray::cli {

ExitCode dump_scene(const Options& options) {
    Sources sources;
    Diagnostics diagnostics(options.warning_levels);
    FileAccess files = file_access(options);
    const auto [scene, usage_mistakes, params] =
        parser::load(options.scene_path, load_settings(options), files, sources, diagnostics);
    if (!usage_mistakes.empty()) return report_usage_mistakes(usage_mistakes);
    // What cannot be placed is told of the original, where its author can mend it.
    if (scene) scene::flatten(*scene, options.flatten_limits, diagnostics);
    DiagnosticsReport report;
    if (const auto end = report.print(diagnostics, sources, options)) return *end;

    auto opened = open_output(options, files.files_read());
    if (const auto* failure = std::get_if<Failure>(&opened)) return report_failure(*failure);
    OutputFile& output = std::get<OutputFile>(opened);
    bool is_written = true;
    parser::dump(*scene,
                 [&](std::string_view text) { is_written = is_written && output.write(text); });
    if (!is_written || !output.commit()) {
        return report_failure({ExitCode::output, output.error(), {}});
    }
    return ExitCode::done;
}

}  // namespace lray::cli
