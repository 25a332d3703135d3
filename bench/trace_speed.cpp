// How fast rays are traced, and hierarchies built, beside Embree.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <tbb/global_control.h>

#include "bench/processor_time.h"
#include "bench/trace_modes.h"
#include "bench/trace_rays.h"
#include "bench/trace_scenes.h"
#include "bench/trace_side.h"
#include "bench/trace_table.h"
#include "bvh/boxes/box_accel.h"

namespace {

using namespace lray;
using namespace lray::bench;

constexpr std::string_view kUsage =
    "usage: trace_speed [OPTION...]\n"
    "  --scene NAME      bunny, hall, terrain-1m, terrain-10m, soup or spheres; may be repeated\n"
    "                    (all; the bunny with --mesh alone)\n"
    "  --mesh FILE       the OBJ file of the bunny\n"
    "  --repeat K        how often each is measured (5); the best counts\n"
    "  --size N          pixels on a side, a multiple of 8 (1024)\n"
    "  --quality Q       of building, of both sides: low, medium (the default) or high\n"
    "  --accel A         lray's hierarchy: boxes (the default) or spheres\n"
    "  --batches         64 rays at once; Embree: packets of 16, coherent\n"
    "  --threads         two threads against one, beside arithmetic (terrain-1m)\n"
    "  --start LRAY      how soon that program begins to write a picture\n";

struct Options {
    std::vector<std::string> scenes{};
    std::string mesh_path{};
    int repeat_count = 5;
    int width = 1024;
    bvh::BuildOptions build{};
    bool is_batched = false;
    bool is_threads = false;
    std::string lray_path{};
};

/// Building is not repeated once a side has taken so long: its noise is small then.
constexpr double kEnoughSeconds = 2.0;

/// Distances further apart than this, in parts of them, are different hits.
constexpr float kSameDistance = 1e-4f;

constexpr std::array<std::string_view, 3> kQualities{"low", "medium", "high"};

std::string_view quality_name(bvh::BuildQuality quality) {
    return kQualities[static_cast<std::size_t>(quality)];
}

bool is_quality(std::string_view word, bvh::BuildOptions& options) {
    const auto found = std::find(kQualities.begin(), kQualities.end(), word);
    options.quality = static_cast<bvh::BuildQuality>(found - kQualities.begin());
    return found != kQualities.end();
}

bool is_accel(std::string_view word, bvh::BuildOptions& options) {
    options.kind = word == "spheres" ? bvh::AccelKind::spheres : bvh::AccelKind::boxes;
    return word == "boxes" || word == "spheres";
}

std::optional<Options> parse_options(int argc, char** argv) {
    Options result;
    for (int i = 1; i < argc; ++i) {
        const std::string_view name = argv[i];
        if (name == "--batches" || name == "--threads") {
            (name == "--batches" ? result.is_batched : result.is_threads) = true;
            continue;
        }
        if (++i >= argc) return std::nullopt;
        const char* value = argv[i];
        if (name == "--scene") {
            result.scenes.emplace_back(value);
        } else if (name == "--mesh") {
            result.mesh_path = value;
        } else if (name == "--repeat") {
            result.repeat_count = std::atoi(value);
        } else if (name == "--size") {
            result.width = std::atoi(value);
        } else if (name == "--start") {
            result.lray_path = value;
        } else if (!(name == "--quality" && is_quality(value, result.build)) &&
                   !(name == "--accel" && is_accel(value, result.build))) {
            return std::nullopt;
        }
    }
    const bool is_sound = result.repeat_count > 0 && result.width > 0 && result.width <= 16384 &&
                          result.width % kTileWidth == 0;
    if (!is_sound) return std::nullopt;
    if (result.scenes.empty() && result.is_threads) result.scenes = {"terrain-1m"};
    if (result.scenes.empty()) {
        for (const std::string_view scene : trace_scene_names()) {
            if (scene != "bunny" || !result.mesh_path.empty()) result.scenes.emplace_back(scene);
        }
    }
    return result;
}

double best_build_seconds(TraceSide& side, int repeat_count) {
    double best = std::numeric_limits<double>::infinity();
    double all = 0.0;
    for (int i = 0; i < repeat_count && all < kEnoughSeconds; ++i) {
        side.clear();
        const double begin = processor_seconds();
        side.build();
        const double seconds = processor_seconds() - begin;
        best = std::min(best, seconds);
        all += seconds;
    }
    return best;
}

Difference compare(const std::vector<float>& lray, const std::vector<float>& other) {
    Difference result;
    for (std::size_t i = 0; i < lray.size(); ++i) {
        const bool is_hit = other[i] < kInfinity;
        if (is_hit) ++result.hits;
        if (is_hit != (lray[i] < kInfinity)) {
            ++result.only_one_hits;
        } else if (is_hit && !(std::fabs(lray[i] - other[i]) <= kSameDistance * lray[i])) {
            ++result.distances;
        }
    }
    return result;
}

/// Traces one kind of rays on all sides in turn, so that what else the machine does meets all.
void measure_rays(const RaySet& rays, std::size_t kind, int repeat_count,
                  const std::vector<TraceSide*>& sides, SceneResult& result) {
    result.ray_counts[kind] = rays.size();
    std::vector<double> best(sides.size(), std::numeric_limits<double>::infinity());
    for (int k = 0; k < repeat_count; ++k) {
        for (std::size_t i = 0; i < sides.size(); ++i) {
            sides[i]->load(rays);
            const double begin = processor_seconds();
            sides[i]->trace();
            best[i] = std::min(best[i], processor_seconds() - begin);
        }
    }
    const std::vector<float> expected = sides.front()->distances();
    for (std::size_t i = 0; i < sides.size(); ++i) {
        SideResult& side = result.sides[i];
        side.rays_per_second[kind] = static_cast<double>(rays.size()) / best[i];
        side.differences[kind] = compare(expected, sides[i]->distances());
    }
}

SceneResult measure_scene(const TraceScene& scene, const Options& options) {
    SceneResult result;
    result.name = scene.name;
    result.primitive_count = scene.primitive_count();
    result.is_spheres = scene.is_spheres();
    LraySide lray(scene.world, options.build, options.is_batched);
    const auto embree = make_embree_sides(scene.world, options.build.quality, options.is_batched);
    std::vector<TraceSide*> sides{&lray};
    for (const auto& side : embree) sides.push_back(side.get());
    for (TraceSide* side : sides) {
        SideResult& it = result.sides.emplace_back();
        it.name = side->name();
        it.build_seconds = best_build_seconds(*side, options.repeat_count);
        it.bytes = static_cast<double>(side->bytes());
    }
    const RaySet primary = primary_rays(scene, options.width);
    lray.load(primary);
    lray.trace();
    const RaySet shadow = shadow_rays(scene, primary, lray.hits());
    const RaySet bounce = bounce_rays(primary, lray.hits());
    measure_rays(primary, 0, options.repeat_count, sides, result);
    measure_rays(shadow, 1, options.repeat_count, sides, result);
    measure_rays(bounce, 2, options.repeat_count, sides, result);
    return result;
}

int measure_all(const Options& options) {
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    fmt::print("one thread, best of {}, {} quality; boxes are walked with {}\n\n",
               options.repeat_count, quality_name(options.build.quality),
               bvh::fastest_walks().name);
    std::vector<SceneResult> results;
    bool are_alike = true;
    for (const std::string& name : options.scenes) {
        const auto scene = make_trace_scene(name, options.mesh_path);
        if (!scene) return 1;
        results.push_back(measure_scene(*scene, options));
        print_scene(results.back());
        are_alike = are_hits_alike(results.back()) && are_alike;
    }
    print_summary(results, options.build.quality, options.is_batched);
    return are_alike ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    const auto options = parse_options(argc, argv);
    if (!options) {
        fmt::print(stderr, "{}", kUsage);
        return 2;
    }
    if (!options->lray_path.empty()) {
        return measure_start(options->lray_path, options->repeat_count) ? 0 : 1;
    }
    if (!options->is_threads) return measure_all(*options);
    for (const std::string& name : options->scenes) {
        const auto scene = make_trace_scene(name, options->mesh_path);
        if (!scene) return 1;
        measure_threads(*scene, options->build, options->width, options->repeat_count);
    }
    return 0;
}
