// Rays aimed at the vertices and edges that surfaces share: none may slip through. Random rays
// would find nothing.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "tests/bvh/worlds.h"

namespace lray::bvh {
namespace {

using scene::PrimitiveId;
using scene::PrimitiveKind;
using scene::World;

struct IndexedMesh {
    std::vector<DVec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The icosahedron, each face split in four as often as asked, on the unit sphere.
IndexedMesh make_icosphere(int subdivisions) {
    const double g = std::numbers::phi;
    IndexedMesh mesh;
    mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                     {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (int i = 0; i < subdivisions; ++i) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> midpoints;
        const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
            const auto [entry, is_new] = midpoints.try_emplace(
                {std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(mesh.vertices.size()));
            if (is_new) mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]) * 0.5);
            return entry->second;
        };
        std::vector<std::array<std::uint32_t, 3>> finer;
        for (const auto& [a, b, c] : mesh.triangles) {
            const std::uint32_t ab = midpoint(a, b);
            const std::uint32_t bc = midpoint(b, c);
            const std::uint32_t ca = midpoint(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        mesh.triangles = finer;
    }
    for (DVec3& v : mesh.vertices) v = glm::normalize(v);
    return mesh;
}

IndexedMesh make_torus(std::uint32_t rings, std::uint32_t sides) {
    IndexedMesh mesh;
    for (std::uint32_t i = 0; i < rings; ++i) {
        for (std::uint32_t j = 0; j < sides; ++j) {
            const double a = 2.0 * std::numbers::pi * i / rings;
            const double b = 2.0 * std::numbers::pi * j / sides;
            const double r = 1.0 + 0.4 * std::cos(b);
            mesh.vertices.push_back({r * std::cos(a), 0.4 * std::sin(b), r * std::sin(a)});
        }
    }
    const auto at = [&](std::uint32_t i, std::uint32_t j) {
        return (i % rings) * sides + j % sides;
    };
    for (std::uint32_t i = 0; i < rings; ++i) {
        for (std::uint32_t j = 0; j < sides; ++j) {
            mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
            mesh.triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
        }
    }
    return mesh;
}

World world_of(const IndexedMesh& mesh, const DMat3& linear, DVec3 offset) {
    World world;
    world.objects.emplace_back();
    for (const DVec3 v : mesh.vertices) world.vertices.push_back(Vec3{linear * v + offset});
    for (const auto& triangle : mesh.triangles) {
        world.triangles.push_back({triangle});
        world.object_ids[static_cast<std::size_t>(PrimitiveKind::triangle)].push_back(
            scene::ObjectId{0});
    }
    return world;
}

/// For each vertex, the triangles around it.
std::vector<std::vector<std::uint32_t>> rings_of(const World& world) {
    std::vector<std::vector<std::uint32_t>> rings(world.vertices.size());
    for (std::uint32_t i = 0; i < world.triangles.size(); ++i) {
        for (const std::uint32_t v : world.triangles[i].vertices) rings[v].push_back(i);
    }
    return rings;
}

bool is_hit(const World& world, const std::vector<std::uint32_t>& triangles,
            const PreparedRay& ray) {
    for (const std::uint32_t i : triangles) {
        if (!intersect(world, {PrimitiveKind::triangle, i}, ray, {}).is_none()) return true;
    }
    return false;
}

/// Returns a point on the border of a random triangle: a vertex, or a point of an edge, and the
/// two vertices of that edge.
struct Target {
    Vec3 point{};
    std::uint32_t a = 0;
    std::uint32_t b = 0;
};
Target random_target(const World& world, Random& random) {
    const auto& triangle = world.triangles[static_cast<std::size_t>(
        random.below(static_cast<int>(world.triangles.size())))];
    const auto i = static_cast<std::size_t>(random.below(3));
    Target target;
    target.a = triangle.vertices[i];
    target.b = triangle.vertices[(i + 1) % 3];
    const Vec3 a = world.vertices[target.a];
    const Vec3 b = world.vertices[target.b];
    const double s = random.below(2) == 0 ? 0.0 : static_cast<double>(random.uniform(0.0f, 1.0f));
    target.point = Vec3{DVec3{a} + s * (DVec3{b} - DVec3{a})};
    return target;
}

Vec3 aim(Vec3 origin, Vec3 target) {
    return Vec3{glm::normalize(DVec3{target} - DVec3{origin})};
}

/// Shoots at borders and counts the rays that hit no triangle around their target.
int count_leaks(const World& world, Random& random, int ray_count, Vec3 origin) {
    const auto rings = rings_of(world);
    int leaks = 0;
    for (int i = 0; i < ray_count; ++i) {
        const Target target = random_target(world, random);
        const PreparedRay ray = prepare({origin, aim(origin, target.point)});
        if (!is_hit(world, rings[target.a], ray) && !is_hit(world, rings[target.b], ray)) ++leaks;
    }
    return leaks;
}

TEST(Watertight, IcosphereFromInsideLeaksNothing) {
    constexpr std::uint64_t kSeed = 2013;
    Random random(kSeed);
    const IndexedMesh mesh = make_icosphere(3);
    for (const double scale : {1e-6, 1.0, 1e6}) {
        for (int i = 0; i < 200; ++i) {
            const World world =
                world_of(mesh, random.rotation() * scale, DVec3{random.in_cube(1.0f)} * scale);
            Vec3 center{0.0f};
            for (const Vec3 v : world.vertices) {
                center += v / static_cast<float>(world.vertices.size());
            }
            const Vec3 origin = center + random.in_cube(static_cast<float>(0.4 * scale));
            ASSERT_EQ(count_leaks(world, random, 1000, origin), 0)
                << "seed " << kSeed << " scale " << scale << " i " << i;
        }
    }
}

TEST(Watertight, FlattenedIcosphereFromInsideLeaksNothing) {
    constexpr std::uint64_t kSeed = 2014;
    Random random(kSeed);
    const IndexedMesh mesh = make_icosphere(3);
    for (int i = 0; i < 200; ++i) {
        DMat3 flat{1.0};
        flat[1][1] = 1e-3;
        const World world = world_of(mesh, random.rotation() * flat, DVec3{3.0, -4.0, 5.0});
        ASSERT_EQ(count_leaks(world, random, 1000, Vec3{3.0f, -4.0f, 5.0f}), 0)
            << "seed " << kSeed << " i " << i;
    }
}

// From outside only fronts are aimed at: past a silhouette a ray may rightly go on.
TEST(Watertight, FrontsFromOutsideLeakNothing) {
    constexpr std::uint64_t kSeed = 2015;
    Random random(kSeed);
    for (const IndexedMesh& mesh : {make_icosphere(3), make_torus(48, 24)}) {
        const World world = world_of(mesh, random.rotation(), DVec3{0.1, 0.2, 0.3});
        const auto rings = rings_of(world);
        int shot = 0;
        while (shot < 200000) {
            const Vec3 origin = 10.0f * random.direction();
            const Target target = random_target(world, random);
            const Vec3 dir = aim(origin, target.point);
            bool is_front = true;
            for (const std::uint32_t vertex : {target.a, target.b}) {
                for (const std::uint32_t i : rings[vertex]) {
                    const auto& [a, b, c] = world.triangles[i].vertices;
                    const Vec3 n = cross(world.vertices[b] - world.vertices[a],
                                         world.vertices[c] - world.vertices[a]);
                    is_front = is_front && dot(n, dir) < -1e-3f * glm::length(n);
                }
            }
            if (!is_front) continue;
            ++shot;
            const PreparedRay ray = prepare({origin, dir});
            ASSERT_TRUE(is_hit(world, rings[target.a], ray) || is_hit(world, rings[target.b], ray))
                << "seed " << kSeed;
        }
    }
}

// In the tube of a torus many triangles are seen edge-on, and something is hit in any direction.
TEST(Watertight, TorusFromInsideTheTubeLeaksNothing) {
    constexpr std::uint64_t kSeed = 2016;
    Random random(kSeed);
    const IndexedMesh mesh = make_torus(12, 8);
    std::vector<std::uint32_t> all(mesh.triangles.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    for (int i = 0; i < 40000; ++i) {
        const double a = static_cast<double>(random.uniform(0.0f, 6.2831853f));
        const World world = world_of(mesh, DMat3{1.0}, DVec3{0.0});
        const Vec3 origin = Vec3{std::cos(a), 0.0, std::sin(a)} * 0.99f;
        const Target target = random_target(world, random);
        ASSERT_TRUE(is_hit(world, all, prepare({origin, aim(origin, target.point)})))
            << "seed " << kSeed << " i " << i;
    }
}

bool is_any_rectangle_hit(const World& world, const PreparedRay& ray) {
    for (std::size_t i = 0; i < world.rectangles.size(); ++i) {
        if (!intersect(world, {PrimitiveKind::rectangle, i}, ray, {}).is_none()) return true;
    }
    return false;
}

TEST(Watertight, BoxOfRectanglesFromInsideLeaksNothing) {
    constexpr std::uint64_t kSeed = 2017;
    Random random(kSeed);
    // Corners by bits: x, y, z. Counter-clockwise from outside.
    constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (int i = 0; i < 300; ++i) {
        const DMat3 rotation = random.rotation();
        const DVec3 offset{random.in_cube(10.0f)};
        std::array<Vec3, 8> corners{};
        for (int c = 0; c < 8; ++c) {
            const DVec3 unit{c & 1 ? 1.0 : -1.0, c & 2 ? 1.0 : -1.0, c & 4 ? 1.0 : -1.0};
            corners[static_cast<std::size_t>(c)] = Vec3{rotation * unit + offset};
        }
        World world;
        for (const auto& face : kFaces) {
            scene::Rectangle rectangle;
            for (std::size_t c = 0; c < 4; ++c) {
                rectangle.corners[c] = corners[static_cast<std::size_t>(face[c])];
            }
            world.rectangles.push_back(rectangle);
        }
        const Vec3 origin = Vec3{offset} + random.in_cube(0.5f);
        for (int j = 0; j < 1000; ++j) {
            const auto& face = world.rectangles[static_cast<std::size_t>(random.below(6))].corners;
            const Vec3 a = face[static_cast<std::size_t>(random.below(4))];
            const Vec3 b = face[static_cast<std::size_t>(random.below(4))];  // edge or diagonal
            const double s = static_cast<double>(random.uniform(0.0f, 1.0f));
            const Vec3 target{DVec3{a} + s * (DVec3{b} - DVec3{a})};
            ASSERT_TRUE(is_any_rectangle_hit(world, prepare({origin, aim(origin, target)})))
                << "seed " << kSeed << " i " << i;
            ASSERT_TRUE(is_any_rectangle_hit(world, prepare({origin, aim(origin, a)})))
                << "seed " << kSeed << " i " << i;
        }
    }
}

TEST(Watertight, TiledFloorLeaksNothing) {
    constexpr std::uint64_t kSeed = 2018;
    Random random(kSeed);
    constexpr int kTiles = 6;
    for (int i = 0; i < 200; ++i) {
        const DMat3 axes = random.rotation();
        const double tile = static_cast<double>(random.uniform(0.05f, 3.0f));
        const auto corner = [&](int u, int v) {
            return Vec3{axes[0] * (tile * u) + axes[1] * (tile * v) + DVec3{1.0, 2.0, 3.0}};
        };
        World world;
        for (int u = 0; u < kTiles; ++u) {
            for (int v = 0; v < kTiles; ++v) {
                world.rectangles.push_back(
                    {{corner(u, v), corner(u + 1, v), corner(u + 1, v + 1), corner(u, v + 1)}});
            }
        }
        for (int j = 0; j < 500; ++j) {
            const int u = 1 + random.below(kTiles - 2);
            const int v = 1 + random.below(kTiles - 2);
            const Vec3 a = corner(u, v);
            const Vec3 b = random.below(2) == 0 ? corner(u + 1, v) : corner(u, v + 1);
            const double s = static_cast<double>(random.uniform(0.0f, 1.0f));
            const Vec3 target{DVec3{a} + (j % 2 == 0 ? s : 0.0) * (DVec3{b} - DVec3{a})};
            const DVec3 sideways{random.in_cube(5.0f)};
            const Vec3 origin{DVec3{target} +
                              axes[2] * static_cast<double>(random.uniform(0.5f, 9)) + sideways -
                              axes[2] * dot(axes[2], sideways)};
            ASSERT_TRUE(is_any_rectangle_hit(world, prepare({origin, aim(origin, target)})))
                << "seed " << kSeed << " i " << i;
        }
    }
}

}  // namespace
}  // namespace lray::bvh
