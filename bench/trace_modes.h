// What trace_speed measures beside rays on one thread.
#pragma once

#include <string>

#include "bench/trace_scenes.h"
#include "bvh/accel.h"

namespace lray::bench {

/// Prints what two threads gain over one: at arithmetic alone, at building and at tracing.
void measure_threads(const TraceScene& scene, const bvh::BuildOptions& options, int width,
                     int repeat_count);

/// Prints how long the program `lray` takes to begin to write a picture of one pixel.
/// Errors: false when it cannot be run.
bool measure_start(const std::string& lray_path, int repeat_count);

}  // namespace lray::bench
