// The first half of the pipeline: from a file to what is traced, with all that is said of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/file_access.h"
#include "base/source.h"
#include "cli/options.h"
#include "cli/stats.h"
#include "parser/load.h"
#include "scene/scene.h"
#include "scene/world.h"

namespace lray::cli {

/// The world refers to the scene, the spans of both to the sources.
struct LoadedWorld {
    Sources sources{};
    Diagnostics diagnostics;
    FileAccess files;
    parser::LoadResult result{};
    std::optional<scene::World> world{};  // empty when an error was reported

    const scene::Scene& scene() const { return *result.scene; }
};

/// Loads the scene that the options name, flattens it and looks for what seems wrong with it. The
/// times of these stages are added up in `times`.
LoadedWorld load_world(const Options& options, Stopwatch& watch, StageTimes& times);

}  // namespace lray::cli
