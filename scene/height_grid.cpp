#include "scene/height_grid.h"

#include <algorithm>
#include <cmath>

#include "base/assert.h"

namespace lray::scene {

namespace {

/// The slope at an index of a line of heights: by central differences, one-sided at the ends.
template <class At>
double slope(At at, std::uint32_t i, std::uint32_t count, double spacing) {
    const std::uint32_t before = i == 0 ? 0 : i - 1;
    const std::uint32_t behind = std::min(i + 1, count - 1);
    return (at(behind) - at(before)) / ((behind - before) * spacing);
}

Vec3 normal_at(const HeightGrid& grid, std::uint32_t column, std::uint32_t row) {
    const double dx = slope([&](std::uint32_t i) { return grid.at(i, row); }, column, grid.columns,
                            grid.size.x / (grid.columns - 1.0));
    const double dz = slope([&](std::uint32_t j) { return grid.at(column, j); }, row, grid.rows,
                            grid.size.y / (grid.rows - 1.0));
    // (-dx, 1, -dz), with the greatest element made 1: slopes may be too large to be squared.
    const double greatest = std::max({std::fabs(dx), 1.0, std::fabs(dz)});
    if (!std::isfinite(greatest)) return {0.0f, 1.0f, 0.0f};
    return Vec3{glm::normalize(DVec3{-dx, 1.0, -dz} / greatest)};
}

}  // namespace

Mesh make_height_mesh(const HeightGrid& grid) {
    const std::size_t count = std::size_t{grid.columns} * grid.rows;
    LRAY_ASSERT(grid.columns >= 2 && grid.rows >= 2 && count <= kMaxHeightVertices);
    LRAY_ASSERT(grid.heights.size() == count);
    Mesh mesh;
    mesh.positions.reserve(count);
    mesh.normals.reserve(count);
    mesh.uvs.reserve(count);
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
        for (std::uint32_t column = 0; column < grid.columns; ++column) {
            const Vec3 position{DVec3{grid.x(column), grid.at(column, row), grid.z(row)}};
            LRAY_ASSERT(std::isfinite(position.y));
            mesh.positions.push_back(position);
            mesh.normals.push_back(normal_at(grid, column, row));
            mesh.uvs.push_back(
                Vec2{DVec2{column / (grid.columns - 1.0), 1.0 - row / (grid.rows - 1.0)}});
        }
    }
    mesh.triangles.reserve(2 * std::size_t{grid.columns - 1} * (grid.rows - 1));
    for (std::uint32_t row = 0; row + 1 < grid.rows; ++row) {
        for (std::uint32_t column = 0; column + 1 < grid.columns; ++column) {
            const std::uint32_t far_left = row * grid.columns + column;
            const std::uint32_t near_left = far_left + grid.columns;
            mesh.triangles.push_back({far_left, near_left, near_left + 1});
            mesh.triangles.push_back({far_left, near_left + 1, far_left + 1});
        }
    }
    mesh.normal_indices = mesh.triangles;
    mesh.uv_indices = mesh.triangles;
    return mesh;
}

}  // namespace lray::scene
