// Triangles and rectangles against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/bvh/reference.h"
#include "tests/bvh/worlds.h"

namespace lray::bvh {
namespace {

using scene::PrimitiveId;
using scene::World;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

class RayTriangle : public testing::Test {
 protected:
    World world{};
    // In the plane z = 0, front to +z.
    PrimitiveId id = add_triangle(world, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    Hit shoot(Vec3 origin, Vec3 dir, Interval interval = {}) const {
        return meet(world, id, {origin, dir}, interval);
    }
};

TEST_F(RayTriangle, InsideHitsWithBarycentricsOfBAndC) {
    const Hit hit = shoot({0.25f, 0.5f, 2.0f}, {0, 0, -1});
    EXPECT_EQ(hit.t, 2.0f);
    EXPECT_FLOAT_EQ(hit.u, 0.25f);
    EXPECT_FLOAT_EQ(hit.v, 0.5f);
    EXPECT_EQ(hit.primitive_id, id);
}

TEST_F(RayTriangle, BackSideHits) {
    EXPECT_EQ(shoot({0.25f, 0.5f, -2.0f}, {0, 0, 1}).t, 2.0f);
}

TEST_F(RayTriangle, OutsideEachEdgeMisses) {
    EXPECT_TRUE(shoot({-0.01f, 0.5f, 2}, {0, 0, -1}).is_none());
    EXPECT_TRUE(shoot({0.5f, -0.01f, 2}, {0, 0, -1}).is_none());
    EXPECT_TRUE(shoot({0.51f, 0.51f, 2}, {0, 0, -1}).is_none());
}

TEST_F(RayTriangle, BehindMisses) {
    EXPECT_TRUE(shoot({0.25f, 0.25f, 2}, {0, 0, 1}).is_none());
}

TEST_F(RayTriangle, EndsOfTheIntervalAreOpen) {
    EXPECT_TRUE(shoot({0.25f, 0.25f, 2}, {0, 0, -1}, {0.0f, 2.0f}).is_none());
    EXPECT_FALSE(shoot({0.25f, 0.25f, 2}, {0, 0, -1}, {0.0f, next_up(2.0f)}).is_none());
    EXPECT_TRUE(shoot({0.25f, 0.25f, 2}, {0, 0, -1}, {2.0f, 3.0f}).is_none());
    EXPECT_FALSE(shoot({0.25f, 0.25f, 2}, {0, 0, -1}, {next_down(2.0f), 3.0f}).is_none());
    EXPECT_TRUE(shoot({0.25f, 0.25f, 0}, {0, 0, -1}).is_none());  // begins on it
}

TEST_F(RayTriangle, EdgeAndVertexBelongToIt) {
    EXPECT_EQ(shoot({0.5f, 0.0f, 1}, {0, 0, -1}).t, 1.0f);
    EXPECT_EQ(shoot({0.5f, 0.5f, 1}, {0, 0, -1}).t, 1.0f);
    EXPECT_EQ(shoot({0.0f, 0.0f, 1}, {0, 0, -1}).t, 1.0f);
    EXPECT_EQ(shoot({0.0f, 1.0f, 1}, {0, 0, -1}).t, 1.0f);
}

TEST_F(RayTriangle, RayInItsPlaneMisses) {
    EXPECT_TRUE(shoot({-1, 0.25f, 0}, {1, 0, 0}).is_none());
    EXPECT_TRUE(shoot({-1, 0, 0}, {1, 0, 0}).is_none());
}

TEST_F(RayTriangle, GrazingRayHitsAtTheDepthOfThePlane) {
    const float slope = 1e-3f;
    const Hit hit = shoot({-1.0f, 0.25f, 1.25f * slope}, {1.0f, 0.0f, -slope});
    EXPECT_NEAR(hit.t, 1.25f, 1e-4f);
}

TEST_F(RayTriangle, NaNAndZeroDirectionMiss) {
    EXPECT_TRUE(shoot({kNaN, 0.25f, 2}, {0, 0, -1}).is_none());
    EXPECT_TRUE(shoot({0.25f, 0.25f, kNaN}, {0, 0, -1}).is_none());
    EXPECT_TRUE(shoot({0.25f, 0.25f, 2}, {kNaN, 0, -1}).is_none());
    EXPECT_TRUE(shoot({0.25f, 0.25f, 2}, {0, 0, kNaN}).is_none());
    EXPECT_TRUE(shoot({0.25f, 0.25f, 2}, {0, 0, 0}).is_none());
    EXPECT_TRUE(shoot({0.25f, 0.25f, 2}, {0, 0, -1}, {kNaN, 3.0f}).is_none());
    EXPECT_TRUE(shoot({0.25f, 0.25f, 2}, {0, 0, -1}, {0.0f, kNaN}).is_none());
}

TEST(RayTriangleDegenerate, PointAndLineAreNeverHit) {
    World world;
    const PrimitiveId point = add_triangle(world, {1, 1, 1}, {1, 1, 1}, {1, 1, 1});
    const PrimitiveId line = add_triangle(world, {0, 0, 0}, {1, 1, 1}, {3, 3, 3});
    const PrimitiveId nan = add_triangle(world, {0, 0, 0}, {kNaN, 1, 0}, {0, 1, 0});
    Random random(11);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 origin = random.in_cube(5.0f);
        for (const Vec3 target : {Vec3{1, 1, 1}, Vec3{random.uniform(0.0f, 3.0f)}}) {
            const Vec3 dir = glm::normalize(target - origin);
            EXPECT_TRUE(meet(world, point, {origin, dir}).is_none());
            EXPECT_TRUE(meet(world, line, {origin, dir}).is_none());
            EXPECT_TRUE(meet(world, nan, {origin, dir}).is_none());
        }
    }
}

// Triangles from a millionth to a million units, near and far: t to float precision of its
// position, and the barycentrics meet the point.
TEST(RayTriangleScale, TAgreesWithLongDouble) {
    constexpr std::uint64_t kSeed = 7;
    Random random(kSeed);
    for (const float scale : {1e-15f, 1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f, 1e15f}) {
        int hit_count = 0;
        for (int i = 0; i < 5000; ++i) {
            World world;
            const PrimitiveId id = add_triangle(world, random.in_cube(scale), random.in_cube(scale),
                                                random.in_cube(scale));
            const Vec3 origin = random.in_cube(3.0f * scale);
            const Vec3 aim = (world.vertices[0] + world.vertices[1] + world.vertices[2]) / 3.0f;
            const Ray ray{origin, glm::normalize(DVec3{aim - origin})};
            const auto expected = reference_crossings(world, id, ray);
            const Hit hit = meet(world, id, ray);
            ASSERT_EQ(expected.size(), 1u) << "seed " << kSeed << " scale " << scale;
            ASSERT_FALSE(hit.is_none()) << "seed " << kSeed << " scale " << scale;
            EXPECT_NEAR(static_cast<double>(hit.t / expected[0]), 1.0, 1e-7)
                << "seed " << kSeed << " scale " << scale;
            ++hit_count;
        }
        EXPECT_EQ(hit_count, 5000);
    }
}

class RayRectangle : public testing::Test {
 protected:
    World world{};
    // Lies on the floor, u along +x, v along -z: front up.
    PrimitiveId id = add_rectangle(world, {0, 0, 0}, {4, 0, 0}, {0, 0, -2});
    Hit shoot(Vec3 origin, Vec3 dir, Interval interval = {}) const {
        return meet(world, id, {origin, dir}, interval);
    }
};

TEST_F(RayRectangle, UAndVAreThoseOfTheParallelogram) {
    for (const float u : {0.1f, 0.5f, 0.9f}) {
        for (const float v : {0.2f, 0.5f, 0.8f}) {
            const Hit hit = shoot({4 * u, 3, -2 * v}, {0, -1, 0});
            EXPECT_EQ(hit.t, 3.0f);
            EXPECT_NEAR(hit.u, u, 1e-6f);
            EXPECT_NEAR(hit.v, v, 1e-6f);
        }
    }
}

TEST_F(RayRectangle, BordersDiagonalAndCornersBelongToIt) {
    for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{4, 0, -2}, Vec3{0, 0, -2},
                         Vec3{2, 0, -1}, Vec3{4, 0, -1}, Vec3{1, 0, 0}}) {
        EXPECT_EQ(shoot(p + Vec3{0, 1, 0}, {0, -1, 0}).t, 1.0f) << p.x << " " << p.z;
        EXPECT_EQ(shoot(p + Vec3{0, -1, 0}, {0, 1, 0}).t, 1.0f) << p.x << " " << p.z;
    }
}

TEST_F(RayRectangle, OutsideBehindInPlaneAndEndsMiss) {
    EXPECT_TRUE(shoot({4.01f, 1, -1}, {0, -1, 0}).is_none());
    EXPECT_TRUE(shoot({1, 1, 0.01f}, {0, -1, 0}).is_none());
    EXPECT_TRUE(shoot({1, 1, -1}, {0, 1, 0}).is_none());
    EXPECT_TRUE(shoot({-1, 0, -1}, {1, 0, 0}).is_none());
    EXPECT_TRUE(shoot({1, 1, -1}, {0, -1, 0}, {0.0f, 1.0f}).is_none());
    EXPECT_TRUE(shoot({1, 1, -1}, {0, -1, 0}, {1.0f, 2.0f}).is_none());
    EXPECT_TRUE(shoot({kNaN, 1, -1}, {0, -1, 0}).is_none());
}

TEST(RayRectangleDegenerate, LineMisses) {
    World world;
    const PrimitiveId id = add_rectangle(world, {0, 0, 0}, {1, 0, 0}, {2, 0, 0});
    EXPECT_TRUE(meet(world, id, {{0.5f, 1, 0}, {0, -1, 0}}).is_none());
}

}  // namespace
}  // namespace lray::bvh
