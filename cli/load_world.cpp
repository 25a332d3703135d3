#include "cli/load_world.h"

#include "base/assert.h"
#include "cli/run.h"
#include "cli/view.h"
#include "render/threads.h"
#include "scene/flatten.h"
#include "scene/lint.h"

namespace lray::cli {

LoadedWorld load_world(const Options& options, Stopwatch& watch, StageTimes& times) {
    LoadedWorld loaded{.diagnostics = Diagnostics(options.warning_levels),
                       .files = file_access(options)};
    if (options.is_resuming || options.is_film) loaded.files.begin_fingerprint();
    render::with_threads(options.thread_count, [&] {
        loaded.result = parser::load(options.scene_path, load_settings(options), loaded.files,
                                     loaded.sources, loaded.diagnostics);
    });
    times.load += watch.lap();
    if (loaded.result.scene) {
        loaded.world = scene::flatten(loaded.scene(), options.flatten_limits, loaded.diagnostics);
    }
    if (loaded.world) {
        scene::lint(loaded.scene(), *loaded.world, {options.size, expects_light(options)},
                    loaded.diagnostics);
    }
    times.flatten += watch.lap();
    LRAY_ASSERT(loaded.world || loaded.diagnostics.has_errors() ||
                !loaded.result.usage_mistakes.empty());
    return loaded;
}

}  // namespace lray::cli
