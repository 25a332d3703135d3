// Smooth normals: which corners share one, what it is, and that no order shows in it.
#include "scene/smooth_normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace lray::scene {
namespace {

constexpr double degrees(double d) {
    return d * (std::numbers::pi / 180.0);
}

/// A cube of 12 triangles; `is_soup`: no two of them share an index.
Mesh cube(bool is_soup) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.positions.push_back(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    if (!is_soup) return mesh;
    Mesh soup;
    for (const IndexTriple& triple : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(soup.positions.size());
        for (const std::uint32_t index : triple) soup.positions.push_back(mesh.positions[index]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    return soup;
}

/// Two squares that meet at an angle along the z axis, facing up.
Mesh hinge(double angle) {
    Mesh mesh;
    const auto c = static_cast<float>(std::cos(angle));
    const auto s = static_cast<float>(std::sin(angle));
    mesh.positions = {{0, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {-1, 0, 1}, {c, s, 0}, {c, s, 1}};
    mesh.triangles = {{2, 3, 1}, {2, 1, 0}, {0, 1, 5}, {0, 5, 4}};
    return mesh;
}

Vec3 normal_at(const Mesh& mesh, std::size_t triangle, std::size_t corner) {
    return mesh.normals[mesh.normal_indices[triangle][corner]];
}

/// The normals of all corners, with where they are, in an order of their own.
std::multiset<std::array<float, 6>> corners_of(const Mesh& mesh) {
    std::multiset<std::array<float, 6>> corners;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 p = mesh.positions[mesh.triangles[i][k]];
            const Vec3 n =
                mesh.normal_indices[i][k] == Mesh::kNone ? Vec3(0) : normal_at(mesh, i, k);
            corners.insert({p.x, p.y, p.z, n.x, n.y, n.z});
        }
    }
    return corners;
}

TEST(SmoothByAngle, CubeBelowItsAngleIsFacettedAndAboveItRound) {
    for (const bool is_soup : {false, true}) {
        Mesh facetted = cube(is_soup);
        smooth_by_angle(facetted, degrees(89));
        for (std::size_t i = 0; i < 12; ++i) {
            // The two triangles of a side are smooth with each other.
            EXPECT_EQ(normal_at(facetted, i, 0), normal_at(facetted, i, 2)) << i;
        }
        Mesh round = cube(is_soup);
        smooth_by_angle(round, degrees(91));
        for (std::size_t i = 0; i < 12; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                // By the angles of the corners: whichever way the sides are cut.
                const Vec3 p = round.positions[round.triangles[i][k]];
                const Vec3 n = normal_at(round, i, k);
                EXPECT_NEAR(n.x, p.x / std::sqrt(3.0f), 2e-7f);
                EXPECT_NEAR(n.y, p.y / std::sqrt(3.0f), 2e-7f);
                EXPECT_NEAR(n.z, p.z / std::sqrt(3.0f), 2e-7f);
            }
        }
    }
}

TEST(SmoothByAngle, FacesThatMeetAtLessThanTheAngleAreSmooth) {
    for (const double angle : {5.0, 30.0, 60.0, 120.0, 175.0}) {
        Mesh below = hinge(degrees(angle));
        smooth_by_angle(below, degrees(angle + 0.001));
        EXPECT_EQ(normal_at(below, 0, 2), normal_at(below, 2, 1)) << angle;
        Mesh above = hinge(degrees(angle));
        smooth_by_angle(above, degrees(angle - 0.001));
        EXPECT_NE(normal_at(above, 0, 2), normal_at(above, 2, 1)) << angle;
    }
}

TEST(SmoothByAngle, ZeroIsFacettedAndForgetsTheNormalsOfTheFile) {
    Mesh mesh = hinge(degrees(10));
    mesh.normals = {Vec3(0, 0, 1)};
    mesh.normal_indices.assign(4, {0, 0, 0});
    smooth_by_angle(mesh, 0.0);
    EXPECT_TRUE(mesh.normals.empty());
    EXPECT_TRUE(mesh.normal_indices.empty());
}

TEST(SmoothByAngle, ConesThatTouchAtTheirTipsAreApart) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}};
    for (const float y : {1.0f, -1.0f}) {
        for (int i = 0; i < 8; ++i) {
            const double turn = degrees(45.0 * i);
            mesh.positions.push_back(Vec3(DVec3(0.1 * std::cos(turn), y, 0.1 * std::sin(turn))));
        }
    }
    for (std::uint32_t i = 0; i < 8; ++i) {
        mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % 8});
        mesh.triangles.push_back({0, 9 + (i + 1) % 8, 9 + i});
    }
    smooth_by_angle(mesh, degrees(180));
    EXPECT_NE(mesh.normal_indices[0][0], mesh.normal_indices[1][0]);
    EXPECT_EQ(mesh.normal_indices[0][0], mesh.normal_indices[2][0]);
    EXPECT_LT(normal_at(mesh, 0, 0).y, -0.999f);
    EXPECT_GT(normal_at(mesh, 1, 0).y, 0.999f);
}

TEST(SmoothByAngle, AtAnEdgeOfManyFacesNeighboursInAngleAreJoined) {
    // Pages of a book, 10 degrees apart but for a gap in the middle.
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 0, 1}};
    for (const double angle : {0.0, 70.0, 20.0, 60.0, 10.0}) {
        const auto tip = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(
            Vec3(DVec3(std::cos(degrees(angle)), std::sin(degrees(angle)), 0)));
        mesh.triangles.push_back({0, 1, tip});
    }
    smooth_by_angle(mesh, degrees(15));
    const auto number = [&](std::size_t i) { return mesh.normal_indices[i][0]; };
    EXPECT_EQ(number(0), number(4));
    EXPECT_EQ(number(0), number(2));
    EXPECT_EQ(number(1), number(3));
    EXPECT_NE(number(0), number(1));
}

TEST(SmoothByAngle, FacesThatCancelOutHaveNoNormals) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 1}, {0, 0, 1}};
    smooth_by_groups(mesh, std::array{SmoothingRun{0, 1}});
    for (const IndexTriple& triple : mesh.normal_indices) EXPECT_EQ(triple[0], Mesh::kNone);
}

TEST(SmoothByAngle, NormalsDoNotDependOnTheOrderOfTheTriangles) {
    std::mt19937 random(20);
    Mesh grid;
    constexpr std::uint32_t kSide = 20;
    std::uniform_real_distribution<float> height(0.0f, 0.06f);
    for (std::uint32_t z = 0; z < kSide; ++z) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            grid.positions.push_back(Vec3(0.05f * float(x), height(random), 0.05f * float(z)));
        }
    }
    for (std::uint32_t z = 0; z + 1 < kSide; ++z) {
        for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
            const std::uint32_t a = z * kSide + x;
            grid.triangles.push_back({a, a + kSide, a + kSide + 1});
            grid.triangles.push_back({a, a + kSide + 1, a + 1});
        }
    }
    Mesh one = grid;
    smooth_by_angle(one, degrees(50));
    const auto expected = corners_of(one);
    EXPECT_GT(one.normals.size(), kSide * kSide);  // some edges are sharp
    for (int i = 0; i < 5; ++i) {
        Mesh other = grid;
        std::shuffle(other.triangles.begin(), other.triangles.end(), random);
        smooth_by_angle(other, degrees(50));
        EXPECT_EQ(corners_of(other), expected);
    }
}

TEST(SmoothByAngle, APointOfManyFacesTakesNoLongerThanMany) {
    constexpr std::uint32_t kCount = 300'000;
    Mesh mesh;
    mesh.positions = {{0, 1, 0}, {0, -1, 0}};
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / kCount;
        mesh.positions.push_back(Vec3(DVec3(std::cos(turn), 0.0, std::sin(turn))));
    }
    for (std::uint32_t i = 0; i < kCount; ++i) {
        mesh.triangles.push_back({0, 2 + (i + 1) % kCount, 2 + i});
        mesh.triangles.push_back({0, 1, 2 + i});  // and an edge of as many
    }
    const auto begin = std::chrono::steady_clock::now();
    smooth_by_angle(mesh, degrees(30));
    // Quadratic would be 10^11 steps.
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
    EXPECT_EQ(mesh.normal_indices.size(), mesh.triangles.size());
}

TEST(SmoothByGroups, OnlyFacesOfOneGroupWithoutNormalsAreSmoothed) {
    Mesh mesh = hinge(degrees(90));
    mesh.normals = {Vec3(0, 0, 1)};
    mesh.normal_indices.assign(4, {Mesh::kNone, Mesh::kNone, Mesh::kNone});
    mesh.normal_indices[3] = {0, 0, 0};
    smooth_by_groups(mesh, std::array{SmoothingRun{0, 7}, SmoothingRun{2, 7}});
    EXPECT_EQ(mesh.normal_indices[3], (IndexTriple{0, 0, 0}));
    EXPECT_EQ(normal_at(mesh, 0, 2), normal_at(mesh, 2, 1));

    Mesh apart = hinge(degrees(10));
    smooth_by_groups(apart, std::array{SmoothingRun{0, 1}, SmoothingRun{2, 2}});
    EXPECT_NE(normal_at(apart, 0, 2), normal_at(apart, 2, 1));
    Mesh off = hinge(degrees(10));
    smooth_by_groups(off, std::array{SmoothingRun{0, 0}});
    EXPECT_TRUE(off.normals.empty());
}

}  // namespace
}  // namespace lray::scene
