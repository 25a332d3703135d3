// What --stats prints: what was rendered, what the hierarchy is like, what it cost.
#pragma once

#include <chrono>
#include <string>

#include "bvh/accel.h"
#include "cli/options.h"
#include "cli/view.h"
#include "render/render.h"
#include "scene/world.h"

namespace lray::cli {

/// Measures one stage after another.
class Stopwatch {
 public:
    /// Returns the seconds since the last call, or since it was made.
    double lap();

 private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Seconds of each stage.
struct StageTimes {
    double load = 0.0;
    double flatten = 0.0;
    double build = 0.0;
    double render = 0.0;
    double write = 0.0;
};

/// All that there is to say of a picture that was rendered.
struct RenderReport {
    const scene::World& world;
    const Options& options;
    const View& view;
    const bvh::AccelStats& accel;
    const render::RenderResult& result;
    const StageTimes& times;
};

/// Returns the lines of --stats.
std::string format_stats(const RenderReport& report);

/// Returns the same for machines: one line of JSON.
std::string format_stats_json(const RenderReport& report);

/// Returns a hierarchy in a few words: "boxes, 1234 nodes".
std::string hierarchy_name(bvh::AccelKind kind, const bvh::AccelStats& stats);

/// Prints what `--stats` asks for: on stderr, since the picture may go to stdout.
void print_stats(const RenderReport& report);

}  // namespace lray::cli
