#include "cli/stats.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <array>
#include <string_view>

#include "base/assert.h"
#include "base/json_writer.h"
#include "bvh/boxes/box_accel.h"
#include "cli/console.h"

namespace lray::cli {

namespace {

constexpr std::array<std::string_view, scene::kPrimitiveKindCount> kKindNames{
    "triangles", "rectangles", "spheres", "ellipsoids", "cylinders",
    "disks",     "boxes",      "planes",  "tori",       "instances"};

constexpr double kMebibyte = 1048576.0;

std::string_view accel_name(bvh::AccelKind kind) {
    switch (kind) {
        case bvh::AccelKind::none:
            return "none";
        case bvh::AccelKind::spheres:
            return "spheres";
        case bvh::AccelKind::boxes:
            return "boxes";
    }
    LRAY_ASSERT(false);
}

/// How many of each kind there are in the world and once in each prototype.
std::array<std::uint64_t, scene::kPrimitiveKindCount> kind_counts(const scene::World& world) {
    std::array<std::uint64_t, scene::kPrimitiveKindCount> counts{};
    const auto add = [&](const scene::Geometry& geometry) {
        for (std::size_t kind = 0; kind < counts.size(); ++kind) {
            counts[kind] += geometry.object_ids[kind].size();
        }
    };
    add(world);
    for (const scene::Geometry& prototype : world.prototypes) add(prototype);
    return counts;
}

std::uint64_t peak_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts KiB
}

double ratio(std::uint64_t a, std::uint64_t b) {
    return b == 0 ? 0.0 : static_cast<double>(a) / static_cast<double>(b);
}

double mrays_per_second(const RenderReport& report) {
    const double seconds = report.times.render;
    return seconds > 0.0 ? static_cast<double>(report.result.primary.rays) / seconds * 1e-6 : 0.0;
}

std::string line(std::string_view name, std::string_view text) {
    return fmt::format("{:<12} {}\n", name, text);
}

std::string primitives_text(const scene::World& world) {
    std::string kinds;
    std::uint64_t total = 0;
    const auto counts = kind_counts(world);
    for (std::size_t kind = 0; kind < counts.size(); ++kind) {
        if (counts[kind] == 0) continue;
        total += counts[kind];
        kinds +=
            fmt::format("{}{} {}", kinds.empty() ? ": " : ", ", counts[kind], kKindNames[kind]);
    }
    std::string places;
    if (!world.prototypes.empty()) {
        places = fmt::format("; {} prototypes in {} places", world.prototypes.size(),
                             world.place_count - 1);
    }
    return fmt::format("{}{}{}", total, kinds, places);
}

/// What the processor walks boxes with, as Highway calls it; empty for the other hierarchies.
std::string_view simd_name(const RenderReport& report) {
    return report.options.accel == bvh::AccelKind::boxes ? bvh::fastest_walks().name : "";
}

std::string hierarchy_text(const RenderReport& report) {
    const bvh::AccelStats& accel = report.accel;
    std::string name(accel_name(*report.options.accel));
    if (!simd_name(report).empty()) name += fmt::format(" ({})", simd_name(report));
    const double mebibytes = static_cast<double>(accel.bytes) / kMebibyte;
    if (accel.nodes == 0) return fmt::format("{}, {:.2f} MiB", name, mebibytes);
    return fmt::format(
        "{}: {} nodes, {} of them leaves, at most {} deep; {} references, cost {:.2f}, {:.2f} MiB",
        name, accel.nodes, accel.leaves, accel.depth, accel.references, accel.cost, mebibytes);
}

double mean_samples(const RenderReport& report) {
    return ratio(report.result.sample_count, report.view.pixel_count());
}

std::string picture_text(const RenderReport& report) {
    const render::RenderResult& result = report.result;
    const render::SampleLimits& limits = report.view.render_options.limits;
    const std::string size = fmt::format("{} x {} pixels", result.image.width, result.image.height);
    if (!limits.is_any()) {
        const std::uint32_t samples = report.view.render_options.samples.count();
        return fmt::format("{}, {} sample{} each", size, samples, samples == 1 ? "" : "s");
    }
    std::string text = fmt::format("{}, {} samples, {:.1f} each on average", size,
                                   result.sample_count, mean_samples(report));
    if (limits.noise) {
        const double share = ratio(result.converged_pixels, report.view.pixel_count());
        text += fmt::format("; {:.1f} % of the pixels are as quiet as asked for", 100.0 * share);
    }
    return text;
}

std::string tests_text(const bvh::TraceCounts& counts) {
    return fmt::format("{:.2f} nodes, {:.2f} primitives, {:.2f} instances per ray",
                       ratio(counts.node_tests, counts.rays),
                       ratio(counts.primitive_tests, counts.rays),
                       ratio(counts.instance_tests, counts.rays));
}

/// What full shading sends after the rays of the camera; nothing of other shadings.
std::string light_text(const shade::LightCounts& light) {
    std::string text;
    if (light.onward.rays > 0) {
        text += line("onward", fmt::format("{} rays reflected or let through; {}",
                                           light.onward.rays, tests_text(light.onward)));
    }
    if (light.shadow.rays > 0) {
        text += line("shadow", fmt::format("{} rays to lights; {}", light.shadow.rays,
                                           tests_text(light.shadow)));
    }
    return text;
}

void write_counts(JsonWriter& json, std::string_view name, const bvh::TraceCounts& counts) {
    json.key(name).begin_object();
    json.member("count", counts.rays).member("node_tests", counts.node_tests);
    json.member("primitive_tests", counts.primitive_tests);
    json.member("instance_tests", counts.instance_tests).end_object();
}

}  // namespace

double Stopwatch::lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - last_;
    last_ = now;
    return passed.count();
}

std::string format_stats(const RenderReport& report) {
    const render::RenderResult& result = report.result;
    const StageTimes& times = report.times;
    return line("primitives", primitives_text(report.world)) +
           line("hierarchy", hierarchy_text(report)) + line("picture", picture_text(report)) +
           line("rays", fmt::format("{} primary", result.primary.rays)) +
           line("tests", tests_text(result.primary)) + light_text(result.light) +
           line("samples", fmt::format("{} clamped, {} not a number", result.samples.clamped,
                                       result.samples.nan)) +
           line("seconds",
                fmt::format("{:.3f} parse, {:.3f} flatten, {:.3f} build, {:.3f} render, "
                            "{:.3f} write",
                            times.load, times.flatten, times.build, times.render, times.write)) +
           line("speed", fmt::format("{:.3f} Mrays/s on {} thread{}", mrays_per_second(report),
                                     result.thread_count, result.thread_count == 1 ? "" : "s")) +
           line("memory",
                fmt::format("{:.1f} MiB at most", static_cast<double>(peak_bytes()) / kMebibyte));
}

std::string format_stats_json(const RenderReport& report) {
    const render::RenderResult& result = report.result;
    const bvh::AccelStats& accel = report.accel;
    const auto& samples = report.view.render_options.samples;
    JsonWriter json;
    json.begin_object();
    json.key("primitives").begin_object();
    const auto counts = kind_counts(report.world);
    for (std::size_t kind = 0; kind < counts.size(); ++kind) {
        json.member(kKindNames[kind], counts[kind]);
    }
    json.end_object();
    json.member("prototypes", std::uint64_t{report.world.prototypes.size()});
    json.member("places", std::uint64_t{report.world.place_count - 1});
    json.key("hierarchy").begin_object();
    json.member("kind", accel_name(*report.options.accel)).member("simd", simd_name(report));
    json.member("nodes", accel.nodes);
    json.member("leaves", accel.leaves).member("depth", std::uint64_t{accel.depth});
    json.member("references", accel.references).key("cost").decimal(accel.cost);
    json.member("bytes", std::uint64_t{accel.bytes}).end_object();
    json.key("picture").begin_object();
    json.member("width", std::uint64_t{result.image.width});
    json.member("height", std::uint64_t{result.image.height});
    json.member("first_sample", std::uint64_t{samples.begin});
    json.member("samples", std::uint64_t{samples.count()});
    json.member("samples_taken", result.sample_count);
    json.key("samples_per_pixel").decimal(mean_samples(report));
    json.member("converged_pixels", result.converged_pixels).end_object();
    json.key("rays").begin_object();
    write_counts(json, "primary", result.primary);
    write_counts(json, "onward", result.light.onward);
    write_counts(json, "shadow", result.light.shadow);
    json.end_object();
    json.member("clamped", result.samples.clamped).member("not_a_number", result.samples.nan);
    json.key("seconds").begin_object().key("parse").decimal(report.times.load);
    json.key("flatten").decimal(report.times.flatten).key("build").decimal(report.times.build);
    json.key("render").decimal(report.times.render).key("write").decimal(report.times.write);
    json.end_object();
    json.member("threads", std::uint64_t{result.thread_count});
    json.member("peak_bytes", peak_bytes());
    json.end_object();
    return json.take() + "\n";
}

std::string hierarchy_name(bvh::AccelKind kind, const bvh::AccelStats& stats) {
    const std::string name(kind == bvh::AccelKind::none ? "no hierarchy" : accel_name(kind));
    return stats.nodes == 0 ? name : fmt::format("{}, {} nodes", name, stats.nodes);
}

void print_stats(const RenderReport& report) {
    switch (report.options.stats) {
        case StatsFormat::none:
            return;
        case StatsFormat::text:
            print_message(format_stats(report));
            return;
        case StatsFormat::json:
            print_message(format_stats_json(report));
            return;
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::cli
