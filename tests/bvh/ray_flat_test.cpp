// Disks, boxes and planes against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/bvh/worlds.h"

namespace lray::bvh {
namespace {

using scene::PrimitiveId;
using scene::World;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

class RayDisk : public testing::Test {
 protected:
    World world{};
    PrimitiveId full = add_disk(world, scaled_frame({2, 2, 2}, {0, 1, 0}), 0.0f);
    PrimitiveId ring = add_disk(world, scaled_frame({2, 2, 2}, {0, 1, 0}), 0.5f);
};

TEST_F(RayDisk, InsideHitsFromBothSides) {
    EXPECT_EQ(meet(world, full, {{1.5f, 4, 0}, {0, -1, 0}}).t, 3.0f);
    EXPECT_EQ(meet(world, full, {{1.5f, -4, 0}, {0, 1, 0}}).t, 5.0f);
    EXPECT_EQ(meet(world, full, {{0, 4, 0}, {0, -1, 0}}).t, 3.0f);
}

TEST_F(RayDisk, RimBelongsToItAndBeyondMisses) {
    EXPECT_FALSE(meet(world, full, {{2, 4, 0}, {0, -1, 0}}).is_none());
    EXPECT_TRUE(meet(world, full, {{next_up(2.0f), 4, 0}, {0, -1, 0}}).is_none());
}

TEST_F(RayDisk, HoleIsOpen) {
    EXPECT_TRUE(meet(world, ring, {{0.99f, 4, 0}, {0, -1, 0}}).is_none());
    EXPECT_FALSE(meet(world, ring, {{1.0f, 4, 0}, {0, -1, 0}}).is_none());
    EXPECT_FALSE(meet(world, ring, {{0, 4, 1.01f}, {0, -1, 0}}).is_none());
}

TEST_F(RayDisk, BehindInPlaneEndsAndNaNMiss) {
    EXPECT_TRUE(meet(world, full, {{0, 4, 0}, {0, 1, 0}}).is_none());
    EXPECT_TRUE(meet(world, full, {{-5, 1, 0}, {1, 0, 0}}).is_none());
    EXPECT_TRUE(meet(world, full, {{-5, 1.5f, 0}, {1, 0, 0}}).is_none());
    EXPECT_TRUE(meet(world, full, {{0, 4, 0}, {0, -1, 0}}, {0.0f, 3.0f}).is_none());
    EXPECT_TRUE(meet(world, full, {{0, 4, 0}, {0, -1, 0}}, {3.0f, 4.0f}).is_none());
    EXPECT_TRUE(meet(world, full, {{0, 1, 0}, {0, -1, 0}}).is_none());  // begins on it
    EXPECT_TRUE(meet(world, full, {{0, kNaN, 0}, {0, -1, 0}}).is_none());
    EXPECT_TRUE(meet(world, full, {{0, 4, 0}, {kNaN, -1, 0}}).is_none());
    EXPECT_TRUE(meet(world, full, {{0, 4, 0}, {0, 0, 0}}).is_none());
}

class RayBox : public testing::Test {
 protected:
    World world{};
    // [0, 2] x [0, 4] x [0, 6]
    PrimitiveId id = add_box(world, scaled_frame({1, 2, 3}, {1, 2, 3}));
    Hit shoot(Vec3 origin, Vec3 dir, Interval interval = {}) const {
        return meet(world, id, {origin, dir}, interval);
    }
};

TEST_F(RayBox, OutsideHitsEachFace) {
    const Vec3 center{1, 2, 3};
    for (int face = 0; face < 6; ++face) {
        Vec3 dir{0.0f};
        dir[face / 2] = face % 2 == 0 ? 1.0f : -1.0f;
        const Hit hit = shoot(center - 10.0f * dir, dir);
        EXPECT_NEAR(hit.t, 10.0f - static_cast<float>(face / 2 + 1), 1e-6f);
        EXPECT_EQ(hit.u, static_cast<float>(face));
    }
}

TEST_F(RayBox, InsideHitsFarFace) {
    const Hit hit = shoot({1, 2, 3}, {0, 0, 1});
    EXPECT_EQ(hit.t, 3.0f);
    EXPECT_EQ(hit.u, 5.0f);
    EXPECT_EQ(shoot({1, 2, 3}, {-1, 0, 0}).u, 0.0f);
}

TEST_F(RayBox, BesideAndBehindMiss) {
    EXPECT_TRUE(shoot({2.01f, 2, -5}, {0, 0, 1}).is_none());
    EXPECT_TRUE(shoot({1, 2, -5}, {0, 0, -1}).is_none());
    EXPECT_TRUE(shoot({-1, 5, 3}, {0.70710678f, 0.70710678f, 0}).is_none());
}

TEST_F(RayBox, AlongFacesAndEdgesHits) {
    EXPECT_EQ(shoot({2, 2, -5}, {0, 0, 1}).t, 5.0f);  // in a face
    EXPECT_EQ(shoot({2, 4, -5}, {0, 0, 1}).t, 5.0f);  // along an edge
}

TEST_F(RayBox, ThroughEdgesAlwaysHits) {
    constexpr std::uint64_t kSeed = 17;
    Random random(kSeed);
    for (int i = 0; i < 100000; ++i) {
        // Exactly on the edge x = 0, y = 0: origins with exact opposites.
        const Vec3 d{std::ldexp(1.0f, random.below(8)), -std::ldexp(1.0f, random.below(8)),
                     random.uniform(-1.0f, 1.0f)};
        const Vec3 on_edge{0.0f, 0.0f, random.uniform(0.5f, 5.5f)};
        const Vec3 origin{-d.x, -d.y, on_edge.z};
        ASSERT_FALSE(shoot(origin, {d.x, d.y, 0.0f}).is_none()) << "seed " << kSeed;
    }
}

TEST_F(RayBox, EndsOfTheIntervalAreOpen) {
    EXPECT_EQ(shoot({1, 2, -5}, {0, 0, 1}, {5.0f, kInfinity}).t, 11.0f);
    EXPECT_TRUE(shoot({1, 2, -5}, {0, 0, 1}, {5.0f, 11.0f}).is_none());
    EXPECT_TRUE(shoot({1, 2, -5}, {0, 0, 1}, {0.0f, 5.0f}).is_none());
}

TEST_F(RayBox, NaNAndZeroDirectionMiss) {
    EXPECT_TRUE(shoot({kNaN, 2, -5}, {0, 0, 1}).is_none());
    EXPECT_TRUE(shoot({1, 2, kNaN}, {0, 0, 1}).is_none());
    EXPECT_TRUE(shoot({1, 2, -5}, {kNaN, 0, 1}).is_none());
    EXPECT_TRUE(shoot({1, 2, -5}, {0, 0, kNaN}).is_none());
    EXPECT_TRUE(shoot({1, 2, 3}, {0, 0, 0}).is_none());
}

TEST(RayPlane, HitsFromBothSidesAndMissesInPlaneBehindAtEndsAndNaN) {
    World world;
    const PrimitiveId id = add_plane(world, {7, 1, -3}, {0, 1, 0});
    EXPECT_EQ(meet(world, id, {{1e6f, 3, 0}, {0, -1, 0}}).t, 2.0f);
    EXPECT_EQ(meet(world, id, {{0, -3, 0}, {0, 1, 0}}).t, 4.0f);
    EXPECT_NEAR(meet(world, id, {{0, 2, 0}, {0.6f, -0.8f, 0}}).t, 1.25f, 1e-6f);
    EXPECT_TRUE(meet(world, id, {{0, 3, 0}, {0, 1, 0}}).is_none());
    EXPECT_TRUE(meet(world, id, {{0, 3, 0}, {1, 0, 0}}).is_none());
    EXPECT_TRUE(meet(world, id, {{0, 1, 0}, {1, 0, 0}}).is_none());
    EXPECT_TRUE(meet(world, id, {{0, 3, 0}, {0, -1, 0}}, {0.0f, 2.0f}).is_none());
    EXPECT_TRUE(meet(world, id, {{0, 3, 0}, {0, -1, 0}}, {2.0f, 4.0f}).is_none());
    EXPECT_TRUE(meet(world, id, {{kNaN, 3, 0}, {0, -1, 0}}).is_none());
    EXPECT_TRUE(meet(world, id, {{0, 3, 0}, {0, kNaN, 0}}).is_none());
}

}  // namespace
}  // namespace lray::bvh
