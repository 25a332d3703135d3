// Two threads against one.
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>
#include <string_view>

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "base/random.h"
#include "bench/processor_time.h"
#include "bench/trace_modes.h"
#include "bench/trace_rays.h"
#include "bench/trace_side.h"

namespace lray::bench {

namespace {

/// What arithmetic gains at least where two threads have a core each for themselves.
constexpr double kQuietGain = 1.7;

/// The best times, in seconds of the wall, of one and of two threads.
struct Best {
    double one = std::numeric_limits<double>::infinity();
    double two = std::numeric_limits<double>::infinity();

    double gain() const { return one / two; }
};

template <class Work>
double wall_seconds_of(tbb::task_arena& arena, const Work& work) {
    const double begin = wall_seconds();
    arena.execute(work);
    return wall_seconds() - begin;
}

/// Arithmetic without memory, cut into pieces as the rays are: what the machine gives two threads
/// at best while others use it, too.
void calibrate(std::atomic<std::uint64_t>& sink) {
    constexpr int kPieces = 256;
    constexpr std::uint64_t kSteps = 100'000;
    tbb::parallel_for(tbb::blocked_range<int>(0, kPieces), [&](const auto& range) {
        for (int piece = range.begin(); piece < range.end(); ++piece) {
            std::uint64_t x = static_cast<std::uint64_t>(piece);
            for (std::uint64_t k = 0; k < kSteps; ++k) x = mix_bits(x + k);
            sink ^= x;
        }
    });
}

void trace_tiles(LraySide& side, std::size_t ray_count) {
    constexpr std::size_t kGrain = 16;
    const std::size_t tiles = (ray_count + kTileRays - 1) / kTileRays;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tiles, kGrain), [&](const auto& range) {
        const std::size_t first = range.begin() * kTileRays;
        side.trace(first, std::min(range.end() * kTileRays, ray_count) - first);
    });
}

void print_row(std::string_view what, const Best& best, const Best& calibration) {
    fmt::print("  {:<12}{:>10.3f} {:>12.3f} {:>8.2f} {:>20.2f}\n", what, best.one, best.two,
               best.gain(), best.gain() / calibration.gain());
}

}  // namespace

void measure_threads(const TraceScene& scene, const bvh::BuildOptions& options, int width,
                     int repeat_count) {
    tbb::task_arena one(1);
    tbb::task_arena two(2);
    std::atomic<std::uint64_t> sink{0};
    LraySide side(scene.world, options, false);
    const RaySet primary = primary_rays(scene, width);
    RaySet bounce;
    Best calibration;
    Best build;
    Best trace;
    // Interleaved: what else the machine does comes and goes.
    const auto measure = [&](Best& best, const auto& prepare, const auto& work) {
        prepare();
        best.one = std::min(best.one, wall_seconds_of(one, work));
        prepare();
        best.two = std::min(best.two, wall_seconds_of(two, work));
    };
    for (int i = 0; i < repeat_count; ++i) {
        measure(
            calibration, [] {}, [&] { calibrate(sink); });
        measure(
            build, [&] { side.clear(); }, [&] { side.build(); });
        if (i == 0) {
            side.load(primary);
            side.trace();
            bounce = bounce_rays(primary, side.hits());
        }
        measure(
            trace, [&] { side.load(bounce); }, [&] { trace_tiles(side, bounce.size()); });
    }
    fmt::print("{}, {}: wall seconds, best of {}\n", scene.name, side.name(), repeat_count);
    fmt::print("  {:<12}{:>10} {:>12} {:>8} {:>20}\n", "", "one thread", "two threads", "gain",
               "of arithmetic's gain");
    print_row("arithmetic", calibration, calibration);
    print_row("build", build, calibration);
    print_row("trace", trace, calibration);
    fmt::print("target: at least 0.93 of arithmetic's gain\n");
    if (calibration.gain() < kQuietGain) {
        fmt::print("the second core was not free: measure again on a quiet machine\n");
    }
}

}  // namespace lray::bench
