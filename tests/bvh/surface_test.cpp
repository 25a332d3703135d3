// A ray that leaves a surface must not meet it again, at any scale and place (after pbrt's
// shapes_test); positions lie on the surface within their error.
#include "bvh/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/bvh/reference.h"
#include "tests/bvh/worlds.h"

namespace lray::bvh {
namespace {

using scene::PrimitiveId;
using scene::PrimitiveKind;
using scene::World;

constexpr PrimitiveKind kKinds[] = {
    PrimitiveKind::triangle,  PrimitiveKind::rectangle, PrimitiveKind::sphere,
    PrimitiveKind::ellipsoid, PrimitiveKind::cylinder,  PrimitiveKind::disk,
    PrimitiveKind::box,       PrimitiveKind::plane,     PrimitiveKind::torus};

bool is_flat(PrimitiveKind kind) {
    return kind == PrimitiveKind::triangle || kind == PrimitiveKind::rectangle ||
           kind == PrimitiveKind::disk || kind == PrimitiveKind::plane;
}

struct Sample {
    Ray ray{};
    Hit hit{};
};

/// Shoots at the primitive until it is hit.
Sample find_hit(const World& world, PrimitiveId id, Random& random, Vec3 center, float scale) {
    while (true) {
        const float far = std::pow(10.0f, random.uniform(-1.0f, 2.0f));
        const Vec3 origin = center + far * scale * random.direction();
        const Vec3 aim = center + random.in_cube(scale);
        const Vec3 dir{glm::normalize(DVec3{aim} - DVec3{origin})};
        if (!(dot(dir, dir) > 0.5f)) continue;  // origin and aim fell together
        const Ray ray{origin, dir};
        const Hit hit = meet(world, id, ray);
        if (!hit.is_none()) return {ray, hit};
    }
}

class SurfaceOfKind : public testing::TestWithParam<PrimitiveKind> {};

TEST_P(SurfaceOfKind, LeavingRayDoesNotMeetItAgain) {
    const PrimitiveKind kind = GetParam();
    if (kind == PrimitiveKind::torus) return;  // it may, further on: ray_torus_test.cpp
    constexpr std::uint64_t kSeed = 688;
    Random random(kSeed);
    for (const float scale : {1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f}) {
        for (const float offset : {0.0f, 1.0f, 1e4f}) {
            // Below this the primitive is smaller than the spacing of floats around it.
            if (scale < 1e-5f * offset) continue;
            for (int i = 0; i < 100; ++i) {
                World world;
                const Vec3 center = random.in_cube(offset);
                const PrimitiveId id = add_random(world, random, kind, center, scale);
                for (int j = 0; j < 3; ++j) {
                    const Sample sample = find_hit(world, id, random, center, scale);
                    const SurfacePoint p = surface_at(world, sample.ray, sample.hit);
                    for (int k = 0; k < 20; ++k) {
                        Vec3 dir = random.direction();
                        // A third of them grazing.
                        if (k % 3 == 0) {
                            dir = glm::normalize(dir - 0.9999f * dot(dir, p.normal) * p.normal);
                        }
                        const float slope = dot(dir, p.normal);
                        if (std::fabs(slope) < 4.0f * 0x1p-23f) continue;
                        if (!is_flat(kind) && slope < 0.0f) dir = -dir;
                        const Vec3 origin = offset_origin(p.position, p.error, p.normal, dir);
                        const Hit again = meet(world, id, {origin, dir});
                        ASSERT_TRUE(again.is_none())
                            << "seed " << kSeed << " scale " << scale << " offset " << offset
                            << " i " << i << " t " << again.t << " slope " << slope;
                    }
                }
            }
        }
    }
}

TEST_P(SurfaceOfKind, RayIntoASolidMeetsOnlyTheFarSide) {
    const PrimitiveKind kind = GetParam();
    if (is_flat(kind)) return;                 // both sides are tested above
    if (kind == PrimitiveKind::torus) return;  // nor is it convex
    constexpr std::uint64_t kSeed = 689;
    Random random(kSeed);
    for (const float scale : {1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f}) {
        for (const float offset : {0.0f, 1.0f, 1e4f}) {
            if (scale < 1e-3f * offset) continue;
            for (int i = 0; i < 300; ++i) {
                World world;
                const Vec3 center = random.in_cube(offset);
                const PrimitiveId id = add_random(world, random, kind, center, scale);
                const Sample sample = find_hit(world, id, random, center, scale);
                const SurfacePoint p = surface_at(world, sample.ray, sample.hit);
                for (int k = 0; k < 20; ++k) {
                    Vec3 dir = random.direction();
                    if (dot(dir, p.normal) > 0.0f) dir = -dir;
                    const Vec3 origin = offset_origin(p.position, p.error, p.normal, dir);
                    const Hit far = meet(world, id, {origin, dir});
                    const auto crossings = reference_crossings(world, id, {origin, dir});
                    // The last crossing is the far side; what lies before is where it came from.
                    // Only an open cylinder has a way out.
                    if (far.is_none()) {
                        const Long exit = crossings.empty() ? 0 : crossings.back();
                        ASSERT_LE(exit, 1e-5L * static_cast<Long>(scale)) << "seed " << kSeed;
                        continue;
                    }
                    ASSERT_FALSE(crossings.empty());
                    ASSERT_GE(static_cast<Long>(far.t), crossings.back() * (1 - 1e-6L))
                        << "seed " << kSeed << " scale " << scale << " offset " << offset << " i "
                        << i;
                }
            }
        }
    }
}

TEST_P(SurfaceOfKind, PositionIsOnTheSurfaceWithinItsError) {
    const PrimitiveKind kind = GetParam();
    constexpr std::uint64_t kSeed = 690;
    Random random(kSeed);
    for (const float scale : {1e-6f, 1.0f, 1e6f}) {
        for (const float offset : {0.0f, 1e4f}) {
            if (scale < 1e-3f * offset) continue;
            int checked = 0;
            for (int i = 0; i < 300; ++i) {
                World world;
                const Vec3 center = random.in_cube(offset);
                const PrimitiveId id = add_random(world, random, kind, center, scale);
                const Sample sample = find_hit(world, id, random, center, scale);
                const SurfacePoint p = surface_at(world, sample.ray, sample.hit);
                ASSERT_NEAR(dot(DVec3{p.normal}, DVec3{p.normal}), 1.0, 3e-7);

                // Along the normal the surface is within the error (beside an edge there is none).
                const auto found = reference_crossings(world, id, {p.position, p.normal});
                if (found.empty()) continue;
                Long nearest = std::fabs(found[0]);
                for (const Long t : found) nearest = std::min(nearest, std::fabs(t));
                const DVec3 n = glm::abs(DVec3{p.normal});
                const auto bound = static_cast<Long>(dot(n, DVec3{p.error}));
                if (nearest > 100 * bound) continue;  // another side of it
                ++checked;
                ASSERT_LE(nearest, bound * (1 + 1e-6L)) << "seed " << kSeed << " scale " << scale;

                // And the position is where the ray is, to a few roundings.
                const LVec3 on_ray = LVec3{sample.ray.origin} +
                                     static_cast<Long>(sample.hit.t) * LVec3{sample.ray.dir};
                const Long extent = static_cast<Long>(glm::length(DVec3{sample.ray.origin}) +
                                                      static_cast<double>(sample.hit.t));
                ASSERT_LE(glm::length(on_ray - LVec3{p.position}), 3e-7L * extent);
            }
            EXPECT_GT(checked, 250);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(AllKinds, SurfaceOfKind, testing::ValuesIn(kKinds));

Vec3 normal_at(const World& world, PrimitiveId id, const Ray& ray) {
    return surface_at(world, ray, meet(world, id, ray)).normal;
}

TEST(SurfaceNormal, IsOutwardWhereverTheRayComesFrom) {
    World world;
    const PrimitiveId sphere = add_sphere(world, {0, 0, 0}, 2.0f);
    EXPECT_EQ(normal_at(world, sphere, {{0, 0, 5}, {0, 0, -1}}), (Vec3{0, 0, 1}));
    EXPECT_EQ(normal_at(world, sphere, {{0, 0, 0}, {0, 0, -1}}), (Vec3{0, 0, -1}));
    const PrimitiveId box = add_box(world, scaled_frame({1, 2, 3}, {0, 0, 0}));
    EXPECT_EQ(normal_at(world, box, {{0, 5, 0}, {0, -1, 0}}), (Vec3{0, 1, 0}));
    EXPECT_EQ(normal_at(world, box, {{0, 0, 0}, {-1, 0, 0}}), (Vec3{-1, 0, 0}));
    const PrimitiveId cylinder =
        add_cylinder(world, scaled_frame({1, 1, 1}, {0, 0, 0}), 1.0f, true);
    EXPECT_EQ(normal_at(world, cylinder, {{5, 0.5f, 0}, {-1, 0, 0}}), (Vec3{1, 0, 0}));
    EXPECT_EQ(normal_at(world, cylinder, {{0.2f, 5, 0}, {0, -1, 0}}), (Vec3{0, 1, 0}));
    EXPECT_EQ(normal_at(world, cylinder, {{0.2f, -5, 0}, {0, 1, 0}}), (Vec3{0, -1, 0}));
    const PrimitiveId cone = add_cylinder(world, scaled_frame({1, 1, 1}, {0, 0, 0}), 0.0f, true);
    const Vec3 slant = normal_at(world, cone, {{5, 0.5f, 0}, {-1, 0, 0}});
    EXPECT_NEAR(slant.x, std::sqrt(0.5f), 1e-6f);
    EXPECT_NEAR(slant.y, std::sqrt(0.5f), 1e-6f);
    const PrimitiveId disk = add_disk(world, scaled_frame({1, 1, 1}, {0, 0, 0}), 0.0f);
    EXPECT_EQ(normal_at(world, disk, {{0.2f, -5, 0}, {0, 1, 0}}), (Vec3{0, 1, 0}));
}

TEST(SurfaceNormal, OfAnEllipsoidIsItsGradient) {
    World world;
    const PrimitiveId id = add_ellipsoid(world, scaled_frame({1, 2, 1}, {0, 0, 0}));
    const float h = std::sqrt(0.5f);
    const Vec3 n = normal_at(world, id, {{h, 10, 0}, {0, -1, 0}});  // at (h, 2 h, 0)
    EXPECT_NEAR(n.x, 2.0f / std::sqrt(5.0f), 1e-5f);
    EXPECT_NEAR(n.y, 1.0f / std::sqrt(5.0f), 1e-5f);
}

TEST(SurfaceNormal, OfTrianglesAndRectanglesIsTheCounterClockwiseSide) {
    World world;
    const PrimitiveId triangle = add_triangle(world, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    EXPECT_EQ(normal_at(world, triangle, {{0.2f, 0.2f, 5}, {0, 0, -1}}), (Vec3{0, 0, 1}));
    EXPECT_EQ(normal_at(world, triangle, {{0.2f, 0.2f, -5}, {0, 0, 1}}), (Vec3{0, 0, 1}));
    const PrimitiveId rectangle = add_rectangle(world, {0, 0, 0}, {1, 0, 0}, {0, 0, -1});
    for (const float x : {0.2f, 0.8f}) {  // both halves
        EXPECT_EQ(normal_at(world, rectangle, {{x, 5, -0.5f}, {0, -1, 0}}), (Vec3{0, 1, 0}));
    }
    world.rectangles[rectangle.index()].is_mirrored = true;
    EXPECT_EQ(normal_at(world, rectangle, {{0.2f, 5, -0.5f}, {0, -1, 0}}), (Vec3{0, -1, 0}));
}

TEST(SurfaceNormal, AtTheApexOfAConeIsFinite) {
    World world;
    const PrimitiveId cone = add_cylinder(world, scaled_frame({1, 1, 1}, {0, 0, 0}), 0.0f, true);
    const Ray ray{{0, 3, 0}, {0, -1, 0}};
    const SurfacePoint p = surface_at(world, ray, meet(world, cone, ray));
    EXPECT_NEAR(p.position.y, 1.0f, 1e-6f);
    EXPECT_NEAR(glm::length(p.normal), 1.0f, 1e-6f);
    EXPECT_TRUE(std::isfinite(p.error.x) && std::isfinite(p.error.y) && std::isfinite(p.error.z));
}

TEST(OffsetOrigin, MovesToTheSideOfTheDirectionByAtLeastTheError) {
    const Vec3 position{1.0f, -3.0f, 1e-20f};
    const Vec3 error{1e-7f, 2e-7f, 3e-7f};
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 normal = random.direction();
        const Vec3 dir = random.direction();
        const DVec3 moved = DVec3{offset_origin(position, error, normal, dir)} - DVec3{position};
        const double side = dot(dir, normal) < 0.0f ? -1.0 : 1.0;
        EXPECT_GE(side * dot(moved, DVec3{normal}), dot(glm::abs(DVec3{normal}), DVec3{error}));
    }
}

}  // namespace
}  // namespace lray::bvh
