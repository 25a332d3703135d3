// What --stats prints.
#pragma once

#include <chrono>
#include <string>

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

/// Returns the lines of --stats: primitives, rays, times, speed, memory of the process so far.
std::string format_stats(const scene::World& world, bvh::AccelKind accel,
                         const render::RenderResult& result, const StageTimes& times);

}  // namespace lray::cli
