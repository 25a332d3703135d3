// Trees of boxes whose triangles were cut: every point of a triangle is in the boxes above one of
// the leaves that have it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "bvh/accel.h"
#include "bvh/boxes/box_tree.h"
#include "tests/bvh/worlds.h"

namespace lray::bvh {
namespace {

using scene::PrimitiveId;
using scene::PrimitiveKind;
using scene::World;

/// What of a triangle the boxes above a leaf let through.
struct Part {
    std::array<Vec3, 3> corners{};
    Bounds box{};
};
using PartsById = std::map<std::uint32_t, std::vector<Part>>;

Bounds everywhere() {
    Bounds bounds;
    bounds.add(Vec3{kInfinity});
    bounds.add(Vec3{-kInfinity});
    return bounds;
}

void collect(const BoxTreeView& tree, BoxChild child, const Bounds& box, PartsById& parts) {
    if (kind_of(child) == BoxChildKind::node) {
        const BoxNode& node = node_of(tree, child);
        for (std::size_t lane = 0; lane < kBoxWidth; ++lane) {
            if (node.planes[0][0][lane] == kInfinity) break;
            Bounds inner;
            for (int axis = 0; axis < 3; ++axis) {
                inner.min[axis] = std::max(box.min[axis], node.planes[axis][0][lane]);
                inner.max[axis] = std::min(box.max[axis], node.planes[axis][1][lane]);
            }
            collect(tree, node.children[lane], inner, parts);
        }
    } else if (kind_of(child) == BoxChildKind::triangles) {
        for (std::uint32_t i = 0; i < leaf_count(child); ++i) {
            const TriangleBlock& block = tree.triangles[leaf_first(child) + i];
            for (std::size_t lane = 0; lane < kBoxWidth; ++lane) {
                if (block.ids[lane] == kNoLane) break;
                Part part;
                for (std::size_t vertex = 0; vertex < 3; ++vertex) {
                    const auto& xyz = block.corners[vertex];
                    part.corners[vertex] = {xyz[0][lane], xyz[1][lane], xyz[2][lane]};
                }
                part.box = box;
                parts[block.ids[lane]].push_back(part);
            }
        }
    }
}

bool is_inside(const Bounds& box, DVec3 point) {
    for (int axis = 0; axis < 3; ++axis) {
        if (point[axis] < static_cast<double>(box.min[axis]) ||
            point[axis] > static_cast<double>(box.max[axis])) {
            return false;
        }
    }
    return true;
}

/// A point of a triangle, in double; often on an edge.
DVec3 point_on(const std::array<Vec3, 3>& corners, Random& random) {
    auto u = static_cast<double>(random.uniform(0.0f, 1.0f));
    auto v = static_cast<double>(random.uniform(0.0f, 1.0f));
    if (random.below(4) == 0) u = 0.0;
    if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
    }
    return (1.0 - u - v) * DVec3{corners[0]} + u * DVec3{corners[1]} + v * DVec3{corners[2]};
}

/// Returns how many references there are more than triangles.
std::size_t check_cover(const scene::Geometry& geometry, std::size_t triangle_count,
                        Random& random) {
    const BoxTree tree = build_box_tree(geometry, BuildQuality::high);
    EXPECT_LE(tree.stats.depth, kMaxBoxDepth);
    PartsById parts;
    collect(tree.view, tree.view.root, everywhere(), parts);
    std::size_t part_count = 0;
    std::size_t outside_count = 0;
    std::map<std::array<float, 9>, int> triangles;
    for (const auto& [id, some] : parts) {
        part_count += some.size();
        for (const Part& part : some) {
            const auto& [a, b, c] = part.corners;
            const std::array<float, 9> key{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z};
            if (!triangles.emplace(key, 0).second) continue;
            for (int i = 0; i < 50; ++i) {
                const DVec3 point = point_on(part.corners, random);
                outside_count += std::ranges::none_of(some, [&](const Part& other) {
                    return other.corners == part.corners && is_inside(other.box, point);
                });
            }
        }
    }
    EXPECT_EQ(triangles.size(), triangle_count);
    EXPECT_EQ(outside_count, 0u);
    EXPECT_EQ(part_count, tree.stats.references);
    EXPECT_LE(part_count, triangle_count + triangle_count / 2);
    return part_count - triangle_count;
}

TEST(BoxTreeCut, EveryPointOfATriangleIsInTheBoxesOfOneOfItsParts) {
    Random random(21);
    for (const float size : {0.3f, 3.0f, 20.0f}) {
        SCOPED_TRACE(size);
        scene::Geometry geometry;
        for (int i = 0; i < 5000; ++i) {
            add_random(geometry, random, PrimitiveKind::triangle, random.in_cube(10.0f), size);
        }
        check_cover(geometry, 5000, random);
    }
}

TEST(BoxTreeCut, LongTrianglesAtASlantAreCut) {
    Random random(22);
    scene::Geometry geometry;
    for (int i = 0; i < 3000; ++i) {
        const Vec3 from = random.in_cube(10.0f);
        const Vec3 to = random.in_cube(10.0f);
        add_triangle(geometry, from, to, to + random.in_cube(0.02f));
    }
    EXPECT_GT(check_cover(geometry, 3000, random), 300u);
}

TEST(BoxTreeCut, CuttingLowersTheCost) {
    Random random(26);
    scene::Geometry geometry;
    for (int i = 0; i < 500; ++i) {
        const Vec3 from = random.in_cube(10.0f);
        const Vec3 to = random.in_cube(10.0f);
        for (int k = 0; k < 10; ++k) {  // a bundle
            const Vec3 beside = random.in_cube(0.1f);
            add_triangle(geometry, from + beside, to + beside, to + random.in_cube(0.1f));
        }
    }
    const double medium = build_box_tree(geometry, BuildQuality::medium).stats.cost;
    const double high = build_box_tree(geometry, BuildQuality::high).stats.cost;
    EXPECT_LT(high, 0.9 * medium);
}

TEST(BoxTreeCut, HalvesOfRectanglesAreCutEachOnItsOwn) {
    Random random(23);
    scene::Geometry geometry;
    for (int i = 0; i < 1500; ++i) {
        add_rectangle(geometry, random.in_cube(10.0f), random.in_cube(10.0f),
                      random.in_cube(0.05f));
    }
    EXPECT_GT(check_cover(geometry, 3000, random), 50u);
}

TEST(BoxTreeCut, FarFromTheOriginHugeTinyAndFlatOnesAreCoveredToo) {
    Random random(24);
    for (const float scale : {1e-18f, 1e-6f, 1e6f, 1e18f}) {
        for (const float place : {0.0f, 1e3f, 1e6f}) {
            SCOPED_TRACE(scale);
            SCOPED_TRACE(place);
            scene::Geometry geometry;
            for (int i = 0; i < 1000; ++i) {
                const Vec3 offset{place * scale, -place * scale, 0.0f};
                const Vec3 a = offset + random.in_cube(scale);
                const Vec3 b = offset + random.in_cube(scale);
                add_triangle(geometry, a, b, b + random.in_cube(0.001f * scale));
                add_triangle(geometry, a, b, 0.5f * a + 0.5f * b);
            }
            check_cover(geometry, geometry.triangles.size(), random);
        }
    }
}

/// A ray in the plane of a triangle, from anywhere in it to a point of the triangle, rounded.
Ray ray_along(const World& world, Random& random) {
    const auto count = static_cast<int>(world.triangles.size());
    const auto& [a, b, c] = world.triangles[static_cast<std::size_t>(random.below(count))].vertices;
    const DVec3 corner{world.vertices[a]};
    const DVec3 side{world.vertices[b] - world.vertices[a]};
    const DVec3 other{world.vertices[c] - world.vertices[a]};
    const auto point = [&](float least, float most) {
        const auto u = static_cast<double>(random.uniform(least, most));
        const auto v = static_cast<double>(random.uniform(least, most));
        return corner + u * side + v * other;
    };
    const Vec3 origin{point(-3.0f, 4.0f)};
    return {origin, glm::normalize(point(0.0f, 0.5f) - DVec3{origin})};
}

// Of a triangle seen edge-on the plane may be met anywhere along the ray, also where the part lies
// that the ray does not pass.
TEST(BoxTreeCut, TrianglesSeenEdgeOnAreHitAsWholeOnes) {
    constexpr std::uint64_t kSeed = 27;
    Random random(kSeed);
    int hit_count = 0;
    for (int i = 0; i < 150; ++i) {
        World world;
        const DMat3 axes = random.rotation();
        for (int k = 0; k < 60; ++k) {  // in layers
            const Vec3 corner = random.in_cube(2.0f);
            add_triangle(world, corner, corner + Vec3{axes[0]} * random.uniform(1.0f, 6.0f),
                         corner + Vec3{axes[1]} * random.uniform(1.0f, 6.0f));
        }
        const auto expected = build(world, {.kind = AccelKind::none});
        const auto cut = build(world, {.kind = AccelKind::boxes, .quality = BuildQuality::high});
        for (int k = 0; k < 300; ++k) {
            const Ray ray = ray_along(world, random);
            TraceCounts counts;
            const Hit first = expected->nearest_hit(ray, {}, counts);
            if (first.is_none()) continue;
            ++hit_count;
            for (const Interval interval :
                 {Interval{}, {0.0f, next_up(first.t)}, {next_down(first.t), next_up(first.t)}}) {
                const Hit hit = expected->nearest_hit(ray, interval, counts);
                const Hit found = cut->nearest_hit(ray, interval, counts);
                ASSERT_EQ(found.primitive_id, hit.primitive_id)
                    << "seed " << kSeed << " world " << i << " ray " << k;
                ASSERT_EQ(found.t, hit.t) << "seed " << kSeed << " world " << i << " ray " << k;
            }
        }
    }
    EXPECT_GT(hit_count, 5000);
}

TEST(BoxTreeCut, OtherKindsAreNotCut) {
    Random random(25);
    scene::Geometry geometry;
    std::size_t other_count = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 from = random.in_cube(10.0f);
        const Vec3 to = random.in_cube(10.0f);
        add_triangle(geometry, from, to, to + random.in_cube(0.02f));
        if (random.below(4) == 0) {
            add_random(geometry, random, PrimitiveKind::sphere, random.in_cube(10.0f), 2.0f);
            add_torus(geometry, scaled_frame(Vec3{1.5f}, random.in_cube(10.0f)), 0.2f);
            other_count += 2;
        }
    }
    const BoxTree tree = build_box_tree(geometry, BuildQuality::high);
    PartsById parts;
    collect(tree.view, tree.view.root, everywhere(), parts);
    std::size_t part_count = 0;
    for (const auto& [id, some] : parts) part_count += some.size();
    EXPECT_EQ(parts.size(), 2000u);
    EXPECT_GT(part_count, 2500u);
    EXPECT_EQ(tree.stats.references, part_count + other_count);
}

}  // namespace
}  // namespace lray::bvh
