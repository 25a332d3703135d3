#include "bench/trace_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

namespace lray::bench {

namespace {

constexpr double kMega = 1e6;

/// Hits that may differ, in parts of the rays: along edges and where two surfaces all but meet.
constexpr double kMaxDifference = 1e-3;

constexpr std::size_t kPlain = 1;
constexpr std::size_t kRobust = 2;

/// Gathers ratios for their geometric mean.
class Ratios {
 public:
    void add(double ratio, const std::string& what) {
        logarithms_ += std::log(ratio);
        ++count_;
        if (ratio < worst_) {
            worst_ = ratio;
            worst_what_ = what;
        }
    }
    bool is_empty() const { return count_ == 0; }
    double mean() const { return std::exp(logarithms_ / count_); }
    double worst() const { return worst_; }
    const std::string& worst_what() const { return worst_what_; }

 private:
    double logarithms_ = 0.0;
    int count_ = 0;
    double worst_ = std::numeric_limits<double>::infinity();
    std::string worst_what_{};
};

/// lray over the other: less is better for the first two, more for rays.
struct SideRatios {
    Ratios build{};
    Ratios memory{};
    std::array<Ratios, kRayKinds> kinds{};
    Ratios rays{};  // of all kinds
};

/// Batches are for rays that run close together: bounces do not.
std::size_t kind_count(bool is_batched) {
    return is_batched ? kRayKinds - 1 : kRayKinds;
}

SideRatios gather(std::span<const SceneResult> scenes, std::size_t side, bool are_spheres,
                  std::size_t kinds) {
    SideRatios result;
    for (const SceneResult& scene : scenes) {
        if (scene.is_spheres != are_spheres || side >= scene.sides.size()) continue;
        const SideResult& lray = scene.sides.front();
        const SideResult& other = scene.sides[side];
        result.build.add(lray.build_seconds / other.build_seconds, scene.name);
        result.memory.add(lray.bytes / other.bytes, scene.name);
        for (std::size_t kind = 0; kind < kinds; ++kind) {
            if (scene.ray_counts[kind] == 0) continue;
            const double ratio = lray.rays_per_second[kind] / other.rays_per_second[kind];
            const std::string what =
                fmt::format("{} {}, {}", scene.name, kRayKindNames[kind], other.name);
            result.kinds[kind].add(ratio, what);
            result.rays.add(ratio, what);
        }
    }
    return result;
}

void print_means(std::string_view name, const SideRatios& ratios) {
    if (ratios.rays.is_empty()) return;
    fmt::print("  {:<22}{:>10.2f} {:>10.2f}", name, ratios.build.mean(), ratios.memory.mean());
    for (const Ratios& kind : ratios.kinds) {
        fmt::print(" {:>10}", kind.is_empty() ? "" : fmt::format("{:.2f}", kind.mean()));
    }
    fmt::print("   all rays {:.2f}, worst {:.2f} ({})\n", ratios.rays.mean(), ratios.rays.worst(),
               ratios.rays.worst_what());
}

enum class Bound { at_least, at_most };

void print_target(std::string_view what, double value, Bound bound, double target) {
    const bool is_met = bound == Bound::at_least ? value >= target : value <= target;
    fmt::print("  {:<34}{:>6.2f}  {} {:.2f}  {}\n", what, value,
               bound == Bound::at_least ? "at least" : "at most ", target,
               is_met ? "met" : "missed");
}

void print_medium_targets(const SideRatios& plain, const SideRatios& robust,
                          const SideRatios& spheres) {
    if (!plain.rays.is_empty()) {
        print_target("rays, Embree's flags plain", plain.rays.mean(), Bound::at_least, 1.0);
        print_target("rays, Embree's flag robust", robust.rays.mean(), Bound::at_least, 1.15);
        print_target("the worst of them", std::min(plain.rays.worst(), robust.rays.worst()),
                     Bound::at_least, 0.8);
        print_target("seconds of building", plain.build.mean(), Bound::at_most, 0.8);
        print_target("memory", plain.memory.mean(), Bound::at_most, 0.95);
    }
    if (!spheres.rays.is_empty()) {
        print_target("spheres, rays", spheres.rays.mean(), Bound::at_least, 1.5);
    }
}

}  // namespace

void print_scene(const SceneResult& scene) {
    fmt::print("{}: {} {}; rays: {} primary, {} shadow, {} bounce\n", scene.name,
               scene.primitive_count, scene.is_spheres ? "spheres" : "triangles",
               scene.ray_counts[0], scene.ray_counts[1], scene.ray_counts[2]);
    fmt::print("  {:<22}{:>10} {:>10} {:>10} {:>10} {:>10}   M rays/s\n", "", "build s", "MB",
               kRayKindNames[0], kRayKindNames[1], kRayKindNames[2]);
    for (const SideResult& side : scene.sides) {
        fmt::print("  {:<22}{:>10.3f} {:>10.1f}", side.name, side.build_seconds,
                   side.bytes / kMega);
        for (const double rate : side.rays_per_second) fmt::print(" {:>10.2f}", rate / kMega);
        fmt::print("\n");
    }
    const SideResult& lray = scene.sides.front();
    for (std::size_t i = kPlain; i < scene.sides.size(); ++i) {
        const SideResult& other = scene.sides[i];
        fmt::print("  {:<22}{:>10.2f} {:>10.2f}", "lray / " + other.name,
                   lray.build_seconds / other.build_seconds, lray.bytes / other.bytes);
        for (std::size_t kind = 0; kind < kRayKinds; ++kind) {
            fmt::print(" {:>10.2f}", lray.rays_per_second[kind] / other.rays_per_second[kind]);
        }
        fmt::print("\n");
    }
    for (const SideResult& side : scene.sides) {
        const bool is_lray = &side == &lray;
        fmt::print("  {:<43}", is_lray ? "hits" : "hit or not + other t, " + side.name);
        for (const Difference& it : side.differences) {
            fmt::print(" {:>10}", is_lray ? fmt::format("{}", it.hits)
                                          : fmt::format("{} + {}", it.only_one_hits, it.distances));
        }
        fmt::print("\n");
    }
    fmt::print("\n");
    std::fflush(stdout);
}

void print_summary(std::span<const SceneResult> scenes, bvh::BuildQuality quality,
                   bool is_batched) {
    const std::size_t kinds = kind_count(is_batched);
    const SideRatios plain = gather(scenes, kPlain, false, kinds);
    const SideRatios robust = gather(scenes, kRobust, false, kinds);
    const SideRatios spheres = gather(scenes, kPlain, true, kinds);
    if (plain.rays.is_empty() && spheres.rays.is_empty()) return;
    fmt::print("geometric means of lray / Embree\n");
    print_means("triangles, plain", plain);
    print_means("triangles, robust", robust);
    print_means("spheres", spheres);
    fmt::print("targets\n");
    if (is_batched) {
        if (!plain.rays.is_empty()) {
            print_target("batches, packets of 16", plain.rays.mean(), Bound::at_least, 0.9);
        }
    } else if (quality == bvh::BuildQuality::medium) {
        print_medium_targets(plain, robust, spheres);
    } else if (quality == bvh::BuildQuality::high) {
        for (const SceneResult& scene : scenes) {
            if (scene.name != "hall") continue;
            const SideRatios hall = gather(std::span(&scene, 1), kPlain, false, kinds);
            print_target("the hall, both of high quality", hall.rays.mean(), Bound::at_least, 1.0);
        }
    }
}

bool are_hits_alike(const SceneResult& scene) {
    for (const SideResult& side : scene.sides) {
        for (std::size_t kind = 0; kind < kRayKinds; ++kind) {
            const Difference& it = side.differences[kind];
            const double differing = static_cast<double>(it.only_one_hits + it.distances);
            if (differing > kMaxDifference * static_cast<double>(scene.ray_counts[kind])) {
                fmt::print(stderr, "{}: {} {} hits of {} are not those of lray\n", scene.name,
                           differing, kRayKindNames[kind], side.name);
                return false;
            }
        }
    }
    return true;
}

}  // namespace lray::bench
