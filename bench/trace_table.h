// The tables of trace_speed: what each scene gave, and all of them beside the targets.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "bvh/accel.h"

namespace lray::bench {

inline constexpr std::size_t kRayKinds = 3;
inline constexpr std::array<const char*, kRayKinds> kRayKindNames{"primary", "shadow", "bounce"};

/// How the hits of one kind of rays differ from those of lray.
struct Difference {
    std::uint64_t hits = 0;
    std::uint64_t only_one_hits = 0;
    std::uint64_t distances = 0;  // both hit, but not at the same t
};

struct SideResult {
    std::string name{};
    double build_seconds = 0.0;
    double bytes = 0.0;
    std::array<double, kRayKinds> rays_per_second{};
    std::array<Difference, kRayKinds> differences{};
};

/// Shape: lray's side first, then those of Embree: plain and robust, or none.
struct SceneResult {
    std::string name{};
    std::size_t primitive_count = 0;
    bool is_spheres = false;
    std::array<std::size_t, kRayKinds> ray_counts{};
    std::vector<SideResult> sides{};
};

void print_scene(const SceneResult& scene);

/// Prints geometric means over the scenes, the worst, and whether that is what it should be.
void print_summary(std::span<const SceneResult> scenes, bvh::BuildQuality quality, bool is_batched);

/// True if, of any kind of rays, so few hits differ that all sides have traced the same.
bool are_hits_alike(const SceneResult& scene);

}  // namespace lray::bench
