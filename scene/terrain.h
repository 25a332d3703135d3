// Landscapes made of noise: grids of heights.
#pragma once

#include <cstdint>

#include "base/random.h"
#include "base/vec.h"
#include "scene/height_grid.h"

namespace lray::scene {

enum class TerrainMethod : std::uint8_t { diamond_square, fbm, ridged };

struct TerrainSettings {
    TerrainMethod method = TerrainMethod::diamond_square;
    std::uint32_t resolution = 257;  // vertices along each side, at least 2
    DVec2 size{100.0};
    double height = 10.0;    // of the point farthest from y = 0, up or down
    double roughness = 0.5;  // how much each octave, half the size, keeps of the height: 0 to 1
    KeyedRandom random{};
};

/// Returns how many heights are worked out for a terrain, or octaves of heights.
std::uint64_t terrain_steps(const TerrainSettings& settings);

/// Returns how many bytes making a terrain's grid takes at most, besides the grid.
std::uint64_t terrain_scratch_bytes(const TerrainSettings& settings);

/// Returns a landscape of settings.resolution squared heights in [-height, height].
/// diamond_square works on a grid of 2^k + 1 heights a side, the least that has enough, and is
/// sampled from it; displacements depend on their place and not on k, so that a finer grid of the
/// same seed is the same landscape with more detail, scaled to its height.
/// Source: Fournier, Fussell, Carpenter 1982, "Computer Rendering of Stochastic Models", with the
/// diamond step of Miller 1986, "The Definition and Rendering of Terrain Maps".
HeightGrid make_terrain(const TerrainSettings& settings);

}  // namespace lray::scene
