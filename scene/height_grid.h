// Heights on a regular grid, and the mesh that they make.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "scene/mesh.h"

namespace lray::scene {

/// Shape: heights.size() == columns * rows, row by row from -Z to +Z, each from -X to +X.
/// Space: centred at the origin of XZ, over size.x along X and size.y along Z.
struct HeightGrid {
    std::uint32_t columns = 0;  // at least 2
    std::uint32_t rows = 0;     // at least 2
    DVec2 size{1.0};
    std::vector<double> heights{};

    double at(std::uint32_t column, std::uint32_t row) const {
        return heights[std::size_t{row} * columns + column];
    }
    double x(std::uint32_t column) const { return size.x * (column / (columns - 1.0) - 0.5); }
    double z(std::uint32_t row) const { return size.y * (row / (rows - 1.0) - 0.5); }
};

/// The most vertices that a height mesh may have: its triangles are counted in 32 bits.
inline constexpr std::uint64_t kMaxHeightVertices = std::uint64_t{1} << 30;

/// Returns how many bytes a height mesh takes, with the grid that it is made from.
constexpr std::uint64_t height_mesh_bytes(std::uint64_t columns, std::uint64_t rows) {
    const std::uint64_t vertices = columns * rows;
    const std::uint64_t triangles = 2 * vertices;  // a few less
    return vertices * (sizeof(double) + 2 * sizeof(Vec3) + sizeof(Vec2)) +
           triangles * 3 * sizeof(IndexTriple);
}

/// Returns a mesh with two triangles in each cell, counter-clockwise from above, smooth normals,
/// and texture coordinates in [0, 1]: u along +X, v along -Z.
/// Errors: asserts 2 to kMaxHeightVertices vertices, and heights that fit a float.
Mesh make_height_mesh(const HeightGrid& grid);

}  // namespace lray::scene
