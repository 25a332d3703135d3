// Testing everything: the same hit as an independent reference, ties, visibility, counts.
#include <gtest/gtest.h>

#include <cmath>

#include "bvh/accel.h"
#include "tests/bvh/reference.h"
#include "tests/bvh/worlds.h"

namespace lray::bvh {
namespace {

using scene::PrimitiveId;
using scene::World;

TEST(BruteForce, FindsWhatTheReferenceFinds) {
    constexpr std::uint64_t kSeed = 41;
    Random random(kSeed);
    int hit_count = 0;
    for (int scene = 0; scene < 200; ++scene) {
        World world;
        const int count = 1 + random.below(40);
        for (int i = 0; i < count; ++i) {
            add_random(world, random, random.in_cube(4.0f), random.uniform(0.1f, 2.0f));
        }
        const auto accel = build(world, {.kind = AccelKind::none});
        for (int i = 0; i < 100; ++i) {
            const Ray ray{random.in_cube(6.0f), random.direction()};
            Interval interval;
            if (i % 3 == 0) interval = {random.uniform(0.0f, 3.0f), random.uniform(3.0f, 9.0f)};
            TraceCounts counts;
            const Hit hit = accel->nearest_hit(ray, interval, counts);
            const auto expected = reference_nearest(world, ray, interval);
            ASSERT_EQ(hit.is_none(), !expected.has_value()) << "seed " << kSeed;
            ASSERT_EQ(accel->any_hit(ray, interval, counts), expected.has_value())
                << "seed " << kSeed;
            if (!expected) continue;
            ++hit_count;
            ASSERT_EQ(hit.primitive_id, expected->id) << "seed " << kSeed;
            ASSERT_NEAR(static_cast<double>(hit.t), static_cast<double>(expected->t),
                        1e-6 * static_cast<double>(expected->t))
                << "seed " << kSeed;
        }
    }
    EXPECT_GT(hit_count, 5000);
}

TEST(BruteForce, EmptyWorldHasNoHits) {
    const World world;
    TraceCounts counts;
    const auto accel = build(world, {.kind = AccelKind::none});
    EXPECT_TRUE(accel->nearest_hit({{0, 0, 5}, {0, 0, -1}}, {}, counts).is_none());
    EXPECT_FALSE(accel->any_hit({{0, 0, 5}, {0, 0, -1}}, {}, counts));
    EXPECT_EQ(counts.rays, 2u);
    EXPECT_EQ(counts.primitive_tests, 0u);
}

TEST(BruteForce, AtEqualTTheLesserIdWins) {
    World world;
    // Four surfaces meet z = 1; ids order by kind first.
    add_plane(world, {0, 0, 1}, {0, 0, 1});
    add_sphere(world, {0, 0, 0}, 1.0f);
    const PrimitiveId second = add_triangle(world, {-9, -9, 1}, {9, -9, 1}, {0, 9, 1});
    add_triangle(world, {-9, -9, 1}, {9, -9, 1}, {0, 9, 1});
    TraceCounts counts;
    const auto accel = build(world, {.kind = AccelKind::none});
    const Hit hit = accel->nearest_hit({{0, 0, 5}, {0, 0, -1}}, {}, counts);
    EXPECT_EQ(hit.t, 4.0f);
    EXPECT_EQ(hit.primitive_id, second);
}

TEST(BruteForce, HiddenObjectsAreNotThere) {
    World world;
    const PrimitiveId near = add_sphere(world, {0, 0, 0}, 1.0f);
    const PrimitiveId middle = add_sphere(world, {0, 0, -5}, 1.0f);
    const PrimitiveId far = add_sphere(world, {0, 0, -10}, 1.0f);
    world.objects[world.object_of(middle).index()].visible = false;
    TraceCounts counts;
    const Ray ray{{0, 0, 5}, {0, 0, -1}};
    EXPECT_EQ(build(world, {.kind = AccelKind::none})->nearest_hit(ray, {}, counts).primitive_id,
              near);
    EXPECT_EQ(build(world, {.kind = AccelKind::none})
                  ->nearest_hit(ray, {6.0f, kInfinity}, counts)
                  .primitive_id,
              far);
    EXPECT_FALSE(build(world, {.kind = AccelKind::none})->any_hit(ray, {6.5f, 13.5f}, counts));
}

TEST(BruteForce, WhatCastsNoShadowIsSeenButDoesNotBlock) {
    World world;
    const PrimitiveId id = add_sphere(world, {0, 0, 0}, 1.0f);
    world.objects[world.object_of(id).index()].casts_shadow = false;
    TraceCounts counts;
    const auto accel = build(world, {.kind = AccelKind::none});
    EXPECT_EQ(accel->nearest_hit({{0, 0, 5}, {0, 0, -1}}, {}, counts).primitive_id, id);
    EXPECT_FALSE(accel->any_hit({{0, 0, 5}, {0, 0, -1}}, {}, counts));
}

TEST(BruteForce, CountsRaysAndTests) {
    World world;
    for (int i = 0; i < 10; ++i) {
        add_sphere(world, {0, 0, static_cast<float>(-3 * i)}, 1.0f);
    }
    const PrimitiveId hidden = add_box(world, scaled_frame({1, 1, 1}, {0, 0, 0}));
    world.objects[world.object_of(hidden).index()].visible = false;
    const auto accel = build(world, {.kind = AccelKind::none});
    TraceCounts nearest;
    accel->nearest_hit({{0, 0, 5}, {0, 0, -1}}, {}, nearest);
    EXPECT_EQ(nearest.rays, 1u);
    EXPECT_EQ(nearest.primitive_tests, 10u);
    TraceCounts any;
    EXPECT_TRUE(accel->any_hit({{0, 0, 5}, {0, 0, -1}}, {}, any));
    EXPECT_EQ(any.rays, 1u);
    EXPECT_EQ(any.primitive_tests, 1u);  // the first one is hit
}

}  // namespace
}  // namespace lray::bvh
