#include "cli/stats.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <array>
#include <string_view>

#include "base/assert.h"

namespace lray::cli {

namespace {

constexpr std::array<std::string_view, scene::kPrimitiveKindCount> kKindNames{
    "triangles", "rectangles", "spheres", "ellipsoids", "cylinders",
    "disks",     "boxes",      "planes",  "tori",       "instances"};

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

std::string format_kinds(const scene::World& world) {
    std::string text;
    for (std::size_t kind = 0; kind < kKindNames.size(); ++kind) {
        const std::size_t count = world.object_ids[kind].size();
        if (count == 0) continue;
        text += fmt::format("{}{} {}", text.empty() ? ": " : ", ", count, kKindNames[kind]);
    }
    return text;
}

/// What instances place, which is stored once; empty without instances.
std::string format_prototypes(const scene::World& world) {
    if (world.prototypes.empty()) return {};
    std::size_t primitive_count = 0;
    for (const scene::Geometry& prototype : world.prototypes) {
        primitive_count += prototype.primitive_count();
    }
    return fmt::format("stored once  {} thing{} of {} primitives, in {} places\n",
                       world.prototypes.size(), world.prototypes.size() == 1 ? "" : "s",
                       primitive_count, world.place_count - 1);
}

double peak_mebibytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;  // Linux counts KiB
}

double ratio(std::uint64_t a, std::uint64_t b) {
    return b == 0 ? 0.0 : static_cast<double>(a) / static_cast<double>(b);
}

}  // namespace

double Stopwatch::lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - last_;
    last_ = now;
    return passed.count();
}

std::string format_stats(const scene::World& world, bvh::AccelKind accel,
                         const render::RenderResult& result, const StageTimes& times) {
    const std::uint64_t rays = result.counts.rays;
    const double speed = times.render > 0.0 ? static_cast<double>(rays) / times.render * 1e-6 : 0.0;
    return fmt::format(
        "primitives   {}{}\n"
        "{}"
        "accelerator  {}\n"
        "picture      {} x {} pixels\n"
        "rays         {}, {:.1f} tests per ray\n"
        "samples      {} clamped, {} not a number\n"
        "seconds      {:.3f} parse, {:.3f} flatten, {:.3f} build, {:.3f} render, {:.3f} write\n"
        "speed        {:.3f} Mrays/s on {} thread{}\n"
        "memory       {:.1f} MiB at most\n",
        world.primitive_count(), format_kinds(world), format_prototypes(world), accel_name(accel),
        result.image.width, result.image.height, rays, ratio(result.counts.primitive_tests, rays),
        result.samples.clamped, result.samples.nan, times.load, times.flatten, times.build,
        times.render, times.write, speed, result.thread_count, result.thread_count == 1 ? "" : "s",
        peak_mebibytes());
}

}  // namespace lray::cli
