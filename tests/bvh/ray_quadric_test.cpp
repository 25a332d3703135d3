// Spheres, ellipsoids, cylinders and cones against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "bvh/kernels/cylinder.h"
#include "tests/bvh/reference.h"
#include "tests/bvh/worlds.h"

namespace lray::bvh {
namespace {

using scene::PrimitiveId;
using scene::PrimitiveKind;
using scene::World;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

class RaySphere : public testing::Test {
 protected:
    World world{};
    PrimitiveId id = add_sphere(world, {1, 2, 3}, 2.0f);
    Hit shoot(Vec3 origin, Vec3 dir, Interval interval = {}) const {
        return meet(world, id, {origin, dir}, interval);
    }
};

TEST_F(RaySphere, OriginOutsideHitsNearRoot) {
    EXPECT_EQ(shoot({1, 2, 10}, {0, 0, -1}).t, 5.0f);
}

TEST_F(RaySphere, OriginInsideHitsFarRoot) {
    EXPECT_EQ(shoot({1, 2, 3}, {0, 0, -1}).t, 2.0f);
    EXPECT_EQ(shoot({1, 2, 4}, {0, 0, -1}).t, 3.0f);
}

TEST_F(RaySphere, BehindAndBesideMiss) {
    EXPECT_TRUE(shoot({1, 2, 10}, {0, 0, 1}).is_none());
    EXPECT_TRUE(shoot({1, 4.0001f, 10}, {0, 0, -1}).is_none());
}

TEST_F(RaySphere, TangentHitsAndJustBesideMisses) {
    EXPECT_EQ(shoot({1, 4, 10}, {0, 0, -1}).t, 7.0f);
    EXPECT_TRUE(shoot({1, next_up(4.0f), 10}, {0, 0, -1}).is_none());
    EXPECT_FALSE(shoot({1, next_down(4.0f), 10}, {0, 0, -1}).is_none());
}

TEST_F(RaySphere, EndsOfTheIntervalAreOpenAndTheSecondRootIsTried) {
    EXPECT_EQ(shoot({1, 2, 10}, {0, 0, -1}, {5.0f, kInfinity}).t, 9.0f);
    EXPECT_EQ(shoot({1, 2, 10}, {0, 0, -1}, {next_down(5.0f), kInfinity}).t, 5.0f);
    EXPECT_TRUE(shoot({1, 2, 10}, {0, 0, -1}, {5.0f, 9.0f}).is_none());
    EXPECT_TRUE(shoot({1, 2, 10}, {0, 0, -1}, {0.0f, 5.0f}).is_none());
    EXPECT_EQ(shoot({1, 2, 5}, {0, 0, -1}).t, 4.0f);  // begins on it
}

TEST_F(RaySphere, DirectionNeedNotBeUnit) {
    EXPECT_EQ(shoot({1, 2, 10}, {0, 0, -0.5f}).t, 10.0f);
}

TEST_F(RaySphere, NaNAndZeroDirectionMiss) {
    EXPECT_TRUE(shoot({kNaN, 2, 10}, {0, 0, -1}).is_none());
    EXPECT_TRUE(shoot({1, 2, 10}, {0, kNaN, -1}).is_none());
    EXPECT_TRUE(shoot({1, 2, 10}, {0, 0, 0}).is_none());
    World degenerate;
    EXPECT_TRUE(meet(degenerate, add_sphere(degenerate, {0, 0, kNaN}, 1), {{0, 0, 5}, {0, 0, -1}})
                    .is_none());
    EXPECT_TRUE(meet(degenerate, add_sphere(degenerate, {0, 0, 0}, kNaN), {{0, 0, 5}, {0, 0, -1}})
                    .is_none());
}

// A small sphere seen from a million radii: float loses it entirely.
TEST(RaySphereFar, KeepsItsSilhouette) {
    World world;
    const PrimitiveId id = add_sphere(world, {0, 0, 0}, 1.0f);
    for (const float y : {0.9999f, 0.5f, 0.01f}) {
        const Hit hit = meet(world, id, {{0, y, 1e6f}, {0, 0, -1}});
        ASSERT_FALSE(hit.is_none());
        EXPECT_NEAR(hit.t, 1e6 - std::sqrt(1.0 - double{y} * double{y}), 0.07);
    }
    EXPECT_TRUE(meet(world, id, {{0, 1.0001f, 1e6f}, {0, 0, -1}}).is_none());
}

class RayCylinder : public testing::Test {
 protected:
    World world{};
    PrimitiveId closed = add_cylinder(world, scaled_frame({1, 1, 1}, {0, 0, 0}), 1.0f, true);
    PrimitiveId open = add_cylinder(world, scaled_frame({1, 1, 1}, {0, 0, 0}), 1.0f, false);
    PrimitiveId cone = add_cylinder(world, scaled_frame({1, 1, 1}, {0, 0, 0}), 0.0f, true);
    PrimitiveId open_cone = add_cylinder(world, scaled_frame({1, 1, 1}, {0, 0, 0}), 0.0f, false);
};

TEST_F(RayCylinder, OutsideHitsSide) {
    const Hit hit = meet(world, closed, {{5, 0.5f, 0}, {-1, 0, 0}});
    EXPECT_EQ(hit.t, 4.0f);
    EXPECT_EQ(hit.u, kCylinderSide);
}

TEST_F(RayCylinder, AlongTheAxisHitsCaps) {
    const Hit top = meet(world, closed, {{0.5f, 3, 0}, {0, -1, 0}});
    EXPECT_EQ(top.t, 2.0f);
    EXPECT_EQ(top.u, kCylinderTop);
    const Hit bottom = meet(world, closed, {{0.5f, -3, 0}, {0, 1, 0}});
    EXPECT_EQ(bottom.t, 3.0f);
    EXPECT_EQ(bottom.u, kCylinderBottom);
    EXPECT_TRUE(meet(world, closed, {{1.01f, 3, 0}, {0, -1, 0}}).is_none());
    EXPECT_EQ(meet(world, closed, {{1.0f, 3, 0}, {0, -1, 0}}).t, 2.0f);  // down the side
    EXPECT_TRUE(meet(world, open, {{0.5f, 3, 0}, {0, -1, 0}}).is_none());
}

TEST_F(RayCylinder, InsideHitsFarWallOrCap) {
    EXPECT_EQ(meet(world, closed, {{0, 0.5f, 0}, {1, 0, 0}}).t, 1.0f);
    const Hit cap = meet(world, closed, {{0, 0.25f, 0}, {0, 1, 0}});
    EXPECT_EQ(cap.t, 0.75f);
    EXPECT_EQ(cap.u, kCylinderTop);
    EXPECT_EQ(meet(world, open, {{0, 0.5f, 0}, {1, 0, 0}}).t, 1.0f);
}

TEST_F(RayCylinder, ThroughOpenEndHitsInnerWall) {
    const Hit hit = meet(world, open, {{0, 1.5f, 0}, {0.70710678f, -0.70710678f, 0}});
    EXPECT_NEAR(hit.t, std::sqrt(2.0f), 1e-6f);
    EXPECT_EQ(hit.u, kCylinderSide);
    // The closed one is met at the cap before.
    EXPECT_EQ(meet(world, closed, {{0, 1.5f, 0}, {0.70710678f, -0.70710678f, 0}}).u, kCylinderTop);
}

TEST_F(RayCylinder, BehindAboveAndTangent) {
    EXPECT_TRUE(meet(world, closed, {{5, 0.5f, 0}, {1, 0, 0}}).is_none());
    EXPECT_TRUE(meet(world, closed, {{5, 1.001f, 0}, {-1, 0, 0}}).is_none());
    EXPECT_EQ(meet(world, closed, {{5, 0.5f, 1}, {-1, 0, 0}}).t, 5.0f);
    EXPECT_TRUE(meet(world, closed, {{5, 0.5f, 1.0001f}, {-1, 0, 0}}).is_none());
    EXPECT_EQ(meet(world, closed, {{5, 1, 0}, {-1, 0, 0}}).t, 4.0f);  // in the plane of the cap
}

TEST_F(RayCylinder, EndsOfTheIntervalAreOpen) {
    EXPECT_EQ(meet(world, closed, {{5, 0.5f, 0}, {-1, 0, 0}}, {4.0f, kInfinity}).t, 6.0f);
    EXPECT_TRUE(meet(world, closed, {{5, 0.5f, 0}, {-1, 0, 0}}, {4.0f, 6.0f}).is_none());
    EXPECT_EQ(meet(world, open, {{5, 0.5f, 0}, {-1, 0, 0}}, {4.0f, kInfinity}).t, 6.0f);
}

TEST_F(RayCylinder, NaNMisses) {
    for (const PrimitiveId id : {closed, open, cone, open_cone}) {
        EXPECT_TRUE(meet(world, id, {{kNaN, 0.5f, 0}, {-1, 0, 0}}).is_none());
        EXPECT_TRUE(meet(world, id, {{5, kNaN, 0}, {-1, 0, 0}}).is_none());
        EXPECT_TRUE(meet(world, id, {{5, 0.5f, 0}, {-1, kNaN, 0}}).is_none());
        EXPECT_TRUE(meet(world, id, {{5, 0.5f, 0}, {0, 0, 0}}).is_none());
    }
}

TEST_F(RayCylinder, ConeSideApexAndBase) {
    EXPECT_EQ(meet(world, cone, {{5, 0.5f, 0}, {-1, 0, 0}}).t, 4.5f);
    EXPECT_NEAR(meet(world, cone, {{0, 3, 0}, {0, -1, 0}}).t, 2.0f, 1e-6f);  // onto the apex
    const Hit base = meet(world, cone, {{0.5f, -1, 0}, {0, 1, 0}});
    EXPECT_EQ(base.t, 1.0f);
    EXPECT_EQ(base.u, kCylinderBottom);
    EXPECT_EQ(meet(world, open_cone, {{0.5f, -1, 0}, {0, 1, 0}}).t, 1.5f);
    EXPECT_TRUE(meet(world, cone, {{5, 1.5f, 0}, {-1, 0, 0}}).is_none());  // its mirror image
}

TEST_F(RayCylinder, ConeParallelToItsSideHitsOnce) {
    // Parallel to the generator from (1, 0, 0) to (0, 1, 0), half way to the axis.
    const float s = std::sqrt(0.5f);
    const Hit hit = meet(world, open_cone, {{0.5f + 2, -2, 0}, {-s, s, 0}});
    ASSERT_FALSE(hit.is_none());
    EXPECT_NEAR(hit.t, 2.75f * std::sqrt(2.0f), 1e-5f);
    const Hit base = meet(world, cone, {{0.5f + 2, -2, 0}, {-s, s, 0}});
    EXPECT_EQ(base.u, kCylinderBottom);
}

// Every kind with a frame, and the sphere, against long double: from near and far, at all scales,
// with frames that skew.
TEST(RayQuadricScale, AgreesWithLongDouble) {
    constexpr std::uint64_t kSeed = 3;
    Random random(kSeed);
    for (const PrimitiveKind kind :
         {PrimitiveKind::sphere, PrimitiveKind::ellipsoid, PrimitiveKind::cylinder,
          PrimitiveKind::disk, PrimitiveKind::box, PrimitiveKind::plane, PrimitiveKind::torus}) {
        for (const float scale : {1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f}) {
            for (const float offset : {0.0f, 1e2f, 1e4f}) {
                int hits = 0;
                for (int i = 0; i < 1000; ++i) {
                    World world;
                    const Vec3 center = random.in_cube(offset);
                    const PrimitiveId id = add_random(world, random, kind, center, scale);
                    const float distance = random.uniform(0.0f, 20.0f) * scale;
                    const Vec3 origin = center + distance * random.direction();
                    const Vec3 aim = center + random.in_cube(0.7f * scale);
                    const Ray ray{origin, aim == origin
                                              ? Vec3{1, 0, 0}
                                              : Vec3{glm::normalize(DVec3{aim} - DVec3{origin})}};
                    const auto expected = reference_nearest(world, ray, {});
                    const Hit hit = meet(world, id, ray);
                    ASSERT_EQ(hit.is_none(), !expected.has_value())
                        << "seed " << kSeed << " kind " << static_cast<int>(kind) << " scale "
                        << scale << " offset " << offset << " i " << i;
                    if (!expected) continue;
                    ++hits;
                    ASSERT_LE(std::fabs(static_cast<Long>(hit.t) - expected->t),
                              1e-7L * expected->t + 1e-11L * static_cast<Long>(scale))
                        << "seed " << kSeed << " kind " << static_cast<int>(kind) << " scale "
                        << scale << " offset " << offset << " i " << i;
                }
                // A primitive smaller than the spacing of floats around it cannot be aimed at.
                if (scale >= 1e-5f * offset) {
                    EXPECT_GT(hits, 200) << static_cast<int>(kind);
                }
            }
        }
    }
}

}  // namespace
}  // namespace lray::bvh
