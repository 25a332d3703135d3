#include "scene/terrain.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/assert.h"
#include "base/noise.h"

namespace lray::scene {

namespace {

// A grid's side is 2^k cells, at most 2^kMaxLevels: what keys of places are counted in.
constexpr std::uint32_t kMaxLevels = 15;

std::uint32_t levels_of(std::uint32_t resolution) {
    return static_cast<std::uint32_t>(std::bit_width(resolution - 2));  // 2^k + 1 >= resolution
}

/// Diamond-square on a grid of 2^levels cells a side.
class DiamondSquare {
 public:
    DiamondSquare(std::uint32_t levels, double roughness, KeyedRandom random)
        : levels_(levels),
          cells_(std::uint32_t{1} << levels),
          random_(random),
          values_(std::size_t{cells_ + 1} * (cells_ + 1)) {
        double amplitude = 1.0;
        for (const std::uint32_t j : {0u, cells_}) {
            for (const std::uint32_t i : {0u, cells_}) at(i, j) = displacement(i, j);
        }
        for (std::uint32_t step = cells_; step > 1; step /= 2) {
            amplitude *= roughness;
            diamonds(step, amplitude);
            squares(step, amplitude);
        }
    }

    std::vector<double> take() { return std::move(values_); }

 private:
    double& at(std::uint32_t i, std::uint32_t j) {
        return values_[std::size_t{j} * (cells_ + 1) + i];
    }

    /// In [-1, 1), by the place alone.
    double displacement(std::uint32_t i, std::uint32_t j) const {
        const std::uint64_t x = std::uint64_t{i} << (kMaxLevels - levels_);
        const std::uint64_t z = std::uint64_t{j} << (kMaxLevels - levels_);
        return 2.0 * random_.with_bits(x << 32 | z).number() - 1.0;
    }

    // The middle of each cell: the mean of its corners, displaced.
    void diamonds(std::uint32_t step, double amplitude) {
        const std::uint32_t half = step / 2;
        for (std::uint32_t j = half; j < cells_; j += step) {
            for (std::uint32_t i = half; i < cells_; i += step) {
                const double mean = 0.25 * (at(i - half, j - half) + at(i + half, j - half) +
                                            at(i - half, j + half) + at(i + half, j + half));
                at(i, j) = mean + amplitude * displacement(i, j);
            }
        }
    }

    // The middle of each edge: the mean of what is around it, three points at the border.
    void squares(std::uint32_t step, double amplitude) {
        const std::uint32_t half = step / 2;
        for (std::uint32_t j = 0; j <= cells_; j += half) {
            for (std::uint32_t i = (j / half) % 2 == 0 ? half : 0; i <= cells_; i += step) {
                double sum = 0.0;
                int count = 0;
                const auto add = [&](bool is_inside, std::uint32_t x, std::uint32_t z) {
                    if (!is_inside) return;
                    sum += at(x, z);
                    ++count;
                };
                add(i >= half, i - half, j);
                add(i + half <= cells_, i + half, j);
                add(j >= half, i, j - half);
                add(j + half <= cells_, i, j + half);
                at(i, j) = sum / count + amplitude * displacement(i, j);
            }
        }
    }

    std::uint32_t levels_;
    std::uint32_t cells_;
    KeyedRandom random_;
    std::vector<double> values_;
};

/// Samples a square grid of `count` values a side at `resolution` points a side, bilinearly.
std::vector<double> resample(std::vector<double> values, std::uint32_t count,
                             std::uint32_t resolution) {
    if (count == resolution) return values;
    std::vector<double> result;
    result.reserve(std::size_t{resolution} * resolution);
    const double step = (count - 1.0) / (resolution - 1.0);
    for (std::uint32_t row = 0; row < resolution; ++row) {
        const double z = row * step;
        const std::uint32_t j = std::min(static_cast<std::uint32_t>(z), count - 2);
        for (std::uint32_t column = 0; column < resolution; ++column) {
            const double x = column * step;
            const std::uint32_t i = std::min(static_cast<std::uint32_t>(x), count - 2);
            const double* const corner = &values[std::size_t{j} * count + i];
            const double u = x - i;
            const double v = z - j;
            const double far_side = corner[0] + u * (corner[1] - corner[0]);
            const double near_side = corner[count] + u * (corner[count + 1] - corner[count]);
            result.push_back(far_side + v * (near_side - far_side));
        }
    }
    return result;
}

// The longer side of a terrain of noise has so many cells of its first octave.
constexpr double kFirstCells = 4.0;

/// As many octaves as the grid can show: the finest has two grid cells or more in each of its own.
Octaves octaves_of(const TerrainSettings& settings) {
    Octaves octaves{1, 2.0, settings.roughness};
    double cells = 2.0 * kFirstCells;
    while (2.0 * cells <= settings.resolution - 1.0) {
        cells *= 2.0;
        ++octaves.count;
    }
    return octaves;
}

std::vector<double> heights_of_noise(const HeightGrid& grid, const TerrainSettings& settings) {
    const Octaves octaves = octaves_of(settings);
    const NoiseSeed seed(settings.random);
    const double scale = kFirstCells / std::max(settings.size.x, settings.size.y);
    std::vector<double> heights;
    heights.reserve(std::size_t{grid.columns} * grid.rows);
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
        for (std::uint32_t column = 0; column < grid.columns; ++column) {
            const DVec2 p = DVec2{grid.x(column), grid.z(row)} * scale;
            heights.push_back(settings.method == TerrainMethod::fbm ? fbm(p, octaves, seed)
                                                                    : ridged(p, octaves, seed));
        }
    }
    return heights;
}

}  // namespace

std::uint64_t terrain_steps(const TerrainSettings& settings) {
    const bool is_noise = settings.method != TerrainMethod::diamond_square;
    const std::uint64_t side =
        is_noise ? settings.resolution : (std::uint64_t{1} << levels_of(settings.resolution)) + 1;
    return side * side * (is_noise ? static_cast<std::uint64_t>(octaves_of(settings).count) : 1);
}

std::uint64_t terrain_scratch_bytes(const TerrainSettings& settings) {
    if (settings.method != TerrainMethod::diamond_square) return 0;
    const std::uint64_t side = (std::uint64_t{1} << levels_of(settings.resolution)) + 1;
    return side == settings.resolution ? 0 : side * side * sizeof(double);
}

HeightGrid make_terrain(const TerrainSettings& settings) {
    LRAY_ASSERT(settings.resolution >= 2 && levels_of(settings.resolution) <= kMaxLevels);
    HeightGrid grid{settings.resolution, settings.resolution, settings.size, {}};
    if (settings.method == TerrainMethod::diamond_square) {
        const std::uint32_t levels = levels_of(settings.resolution);
        grid.heights = resample(DiamondSquare(levels, settings.roughness, settings.random).take(),
                                (std::uint32_t{1} << levels) + 1, settings.resolution);
    } else {
        grid.heights = heights_of_noise(grid, settings);
    }
    double greatest = 0.0;
    for (const double height : grid.heights) greatest = std::max(greatest, std::fabs(height));
    if (greatest == 0.0) return grid;
    for (double& height : grid.heights) height = height / greatest * settings.height;
    return grid;
}

}  // namespace lray::scene
