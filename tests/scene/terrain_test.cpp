// Meshes of heights: their shape, orientation and normals; landscapes: that they are the same
// everywhere and as high as wanted.
#include "scene/terrain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "scene/height_grid.h"

namespace lray::scene {
namespace {

constexpr TerrainMethod kMethods[] = {TerrainMethod::diamond_square, TerrainMethod::fbm,
                                      TerrainMethod::ridged};

TerrainSettings settings_of(TerrainMethod method, std::uint32_t resolution, double seed = 42.0) {
    TerrainSettings settings;
    settings.method = method;
    settings.resolution = resolution;
    settings.random = KeyedRandom{}.with(seed);
    return settings;
}

/// FNV-1a over the bits of the positions' floats.
std::uint64_t hash_of(const Mesh& mesh) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const Vec3& position : mesh.positions) {
        for (const float number : {position.x, position.y, position.z}) {
            hash = (hash ^ std::bit_cast<std::uint32_t>(number)) * 0x100000001b3u;
        }
    }
    return hash;
}

TEST(HeightMesh, GridMakesTwoTrianglesACell) {
    const HeightGrid grid{3, 2, {4.0, 6.0}, {0, 1, 2, 3, 4, 5}};
    const Mesh mesh = make_height_mesh(grid);
    ASSERT_EQ(mesh.positions.size(), 6u);
    EXPECT_EQ(mesh.positions[0], (Vec3{-2, 0, -3}));
    EXPECT_EQ(mesh.positions[1], (Vec3{0, 1, -3}));
    EXPECT_EQ(mesh.positions[5], (Vec3{2, 5, 3}));
    EXPECT_EQ(mesh.uvs[0], (Vec2{0, 1}));
    EXPECT_EQ(mesh.uvs[2], (Vec2{1, 1}));
    EXPECT_EQ(mesh.uvs[3], (Vec2{0, 0}));
    EXPECT_EQ(mesh.triangles.size(), 4u);
    EXPECT_EQ(mesh.normal_indices, mesh.triangles);
    EXPECT_EQ(mesh.uv_indices, mesh.triangles);
}

TEST(HeightMesh, TrianglesFaceUpAndCoverTheGridOnce) {
    const Mesh mesh = make_height_mesh(make_terrain(settings_of(TerrainMethod::fbm, 20)));
    double area = 0.0;
    for (const IndexTriple& t : mesh.triangles) {
        const Vec3 a = mesh.positions[t[0]];
        const Vec3 cross = glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
        EXPECT_GT(cross.y, 0.0f);
        area += 0.5 * static_cast<double>(cross.y);
    }
    EXPECT_NEAR(area, 100.0 * 100.0, 0.01);
    EXPECT_EQ(mesh.triangles.size(), 2u * 19 * 19);
}

TEST(HeightMesh, NormalsOfAPlaneAreItsNormalAtTheBorderToo) {
    HeightGrid grid{5, 4, {8.0, 3.0}, {}};
    for (std::uint32_t j = 0; j < 4; ++j) {
        for (std::uint32_t i = 0; i < 5; ++i) {
            grid.heights.push_back(0.5 * grid.x(i) - 2.0 * grid.z(j));
        }
    }
    const Vec3 expected{glm::normalize(DVec3{-0.5, 1.0, 2.0})};
    for (const Vec3& normal : make_height_mesh(grid).normals) {
        EXPECT_NEAR(glm::distance(normal, expected), 0.0f, 1e-6f);
    }
}

TEST(HeightMesh, NormalsOfABowlPointAtItsAxis) {
    HeightGrid grid{65, 65, {2.0, 2.0}, {}};
    for (std::uint32_t j = 0; j < 65; ++j) {
        for (std::uint32_t i = 0; i < 65; ++i) {
            grid.heights.push_back(grid.x(i) * grid.x(i) + grid.z(j) * grid.z(j));
        }
    }
    const Mesh mesh = make_height_mesh(grid);
    for (std::uint32_t j = 1; j < 64; ++j) {
        for (std::uint32_t i = 1; i < 64; ++i) {
            const Vec3 expected{
                glm::normalize(DVec3{-2.0 * grid.x(i), 1.0, -2.0 * grid.z(j)})};  // exact for x^2
            EXPECT_NEAR(glm::distance(mesh.normals[j * 65 + i], expected), 0.0f, 1e-6f);
        }
    }
}

TEST(HeightMesh, CliffsOfAnyHeightHaveUnitNormals) {
    const HeightGrid grid{2, 2, {1e-30, 1e30}, {-3e38, 3e38, 0.0, 1e-300}};
    for (const Vec3& normal : make_height_mesh(grid).normals) {
        EXPECT_NEAR(glm::length(normal), 1.0f, 1e-6f);
    }
}

TEST(Terrain, ReachesItsHeightAndNoMore) {
    for (const TerrainMethod method : kMethods) {
        for (const std::uint32_t resolution : {2u, 3u, 4u, 17u, 100u, 257u}) {
            const HeightGrid grid = make_terrain(settings_of(method, resolution));
            ASSERT_EQ(grid.heights.size(), std::size_t{resolution} * resolution);
            double greatest = 0.0;
            for (const double height : grid.heights) {
                greatest = std::max(greatest, std::fabs(height));
            }
            EXPECT_EQ(greatest, 10.0) << resolution;
        }
    }
}

TEST(Terrain, IsTheSameEverywhere) {
    const auto hash = [](TerrainMethod method, std::uint32_t resolution) {
        return hash_of(make_height_mesh(make_terrain(settings_of(method, resolution))));
    };
    EXPECT_EQ(hash(TerrainMethod::diamond_square, 65), 2218985969997049384u);
    EXPECT_EQ(hash(TerrainMethod::diamond_square, 50), 8245156077921738880u);
    EXPECT_EQ(hash(TerrainMethod::fbm, 65), 15604604743413879439u);
    EXPECT_EQ(hash(TerrainMethod::ridged, 65), 6919783660051353553u);
}

TEST(Terrain, SeedsMakeOtherLandscapes) {
    for (const TerrainMethod method : kMethods) {
        const HeightGrid a = make_terrain(settings_of(method, 33, 1.0));
        const HeightGrid b = make_terrain(settings_of(method, 33, 2.0));
        int same = 0;
        for (std::size_t i = 0; i < a.heights.size(); ++i) same += a.heights[i] == b.heights[i];
        EXPECT_LT(same, 5);
    }
}

TEST(Terrain, FinerDiamondSquareIsTheSameLandscape) {
    const HeightGrid coarse = make_terrain(settings_of(TerrainMethod::diamond_square, 33));
    const HeightGrid fine = make_terrain(settings_of(TerrainMethod::diamond_square, 65));
    const double ratio = fine.at(0, 0) / coarse.at(0, 0);  // each is scaled to its height
    for (std::uint32_t j = 0; j < 33; ++j) {
        for (std::uint32_t i = 0; i < 33; ++i) {
            EXPECT_NEAR(fine.at(2 * i, 2 * j), ratio * coarse.at(i, j), 1e-12);
        }
    }
}

/// How far heights are from the middle of their neighbours, on average.
double mean_bend(const HeightGrid& grid) {
    double sum = 0.0;
    for (std::uint32_t j = 0; j < grid.rows; ++j) {
        for (std::uint32_t i = 1; i + 1 < grid.columns; ++i) {
            sum += std::fabs(0.5 * (grid.at(i - 1, j) + grid.at(i + 1, j)) - grid.at(i, j));
        }
    }
    return sum / (grid.rows * (grid.columns - 2.0));
}

TEST(Terrain, RoughnessMakesItRough) {
    for (const TerrainMethod method : kMethods) {
        double before = -1.0;
        for (const double roughness : {0.0, 0.3, 0.5, 0.7, 0.9}) {
            TerrainSettings settings = settings_of(method, 129);
            settings.roughness = roughness;
            const double bend = mean_bend(make_terrain(settings));
            EXPECT_GT(bend, before) << roughness;
            before = bend;
        }
    }
}

TEST(Terrain, DiamondSquareWithoutRoughnessFollowsItsCorners) {
    TerrainSettings settings = settings_of(TerrainMethod::diamond_square, 17);
    settings.roughness = 0.0;
    const HeightGrid grid = make_terrain(settings);
    const double middle =
        0.25 * (grid.at(0, 0) + grid.at(16, 0) + grid.at(0, 16) + grid.at(16, 16));
    EXPECT_NEAR(grid.at(8, 8), middle, 1e-12);
}

TEST(Terrain, StepsAndBytesAreThoseOfTheWorkingGrid) {
    EXPECT_EQ(terrain_steps(settings_of(TerrainMethod::diamond_square, 257)), 257u * 257);
    EXPECT_EQ(terrain_steps(settings_of(TerrainMethod::diamond_square, 258)), 513u * 513);
    EXPECT_EQ(terrain_steps(settings_of(TerrainMethod::fbm, 257)), 257u * 257 * 6);
    EXPECT_EQ(terrain_scratch_bytes(settings_of(TerrainMethod::diamond_square, 257)), 0u);
    EXPECT_EQ(terrain_scratch_bytes(settings_of(TerrainMethod::diamond_square, 258)),
              513u * 513 * sizeof(double));
    EXPECT_EQ(terrain_scratch_bytes(settings_of(TerrainMethod::ridged, 258)), 0u);
}

TEST(Terrain, NonSquareSizesKeepTheShapeOfNoise) {
    // The same noise at the same place, whichever side is the longer one.
    TerrainSettings wide = settings_of(TerrainMethod::fbm, 33);
    wide.size = {100.0, 50.0};
    TerrainSettings square = settings_of(TerrainMethod::fbm, 33);
    const HeightGrid a = make_terrain(wide);
    const HeightGrid b = make_terrain(square);
    const double ratio = a.at(0, 16) / b.at(0, 16);  // z = 0
    for (std::uint32_t i = 0; i < 33; ++i) {
        EXPECT_NEAR(a.at(i, 16), ratio * b.at(i, 16), 1e-9);
    }
}

}  // namespace
}  // namespace lray::scene
