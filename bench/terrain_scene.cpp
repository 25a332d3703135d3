// The terrain: a fine regular mesh, as scans and height fields are.
#include <cstdint>

#include "base/noise.h"
#include "bench/trace_scenes.h"

namespace lray::bench {

TraceScene make_terrain(int cell_count) {
    constexpr Octaves kHills{12, 2.0, 0.5};
    constexpr double kHillsPerSide = 3.0;
    constexpr double kHeight = 0.25;
    const NoiseSeed seed(KeyedRandom{}.with("terrain"));
    TraceScene result;
    scene::World& world = result.world;
    const auto cells = static_cast<std::uint32_t>(cell_count);
    const auto row = std::size_t{cells} + 1;
    world.vertices.reserve(row * row + 1);
    world.triangles.reserve(2 * std::size_t{cells} * cells);
    for (std::uint32_t k = 0; k <= cells; ++k) {
        for (std::uint32_t i = 0; i <= cells; ++i) {
            const DVec2 p{static_cast<double>(i) / cells, static_cast<double>(k) / cells};
            world.vertices.emplace_back(
                DVec3{p.x, kHeight * fbm(kHillsPerSide * p, kHills, seed), p.y});
        }
    }
    for (std::uint32_t k = 0; k < cells; ++k) {
        for (std::uint32_t i = 0; i < cells; ++i) {
            const std::uint32_t a = k * (cells + 1) + i;
            const std::uint32_t d = a + cells + 1;
            world.triangles.push_back({{a, d, d + 1}});
            world.triangles.push_back({{a, d + 1, a + 1}});
        }
    }
    result.eye = {0.5f, 0.4f, 1.25f};
    result.target = {0.5f, -0.05f, 0.5f};
    result.view_width = 1.0;
    result.light = {-0.3f, 0.6f, 0.2f};
    return result;
}

}  // namespace lray::bench
