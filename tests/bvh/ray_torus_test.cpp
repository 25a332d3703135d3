// Tori, thin, fat and overlapping themselves, against a quartic in long double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "bvh/kernels/torus.h"
#include "bvh/surface.h"
#include "tests/bvh/reference.h"
#include "tests/bvh/worlds.h"

namespace lray::bvh {
namespace {

using scene::PrimitiveId;
using scene::World;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

const scene::AffineFrame kUnit = scaled_frame({1, 1, 1}, {0, 0, 0});

/// Radius 0.75, tube 0.25: the tube is met along x at 1, 0.5, -0.5 and -1.
class RayTorus : public testing::Test {
 protected:
    World world{};
    PrimitiveId ring = add_torus(world, kUnit, 0.25f);
    PrimitiveId apple = add_torus(world, kUnit, 0.75f);  // overlaps: poles at y = 1 / sqrt(2)
    PrimitiveId horn = add_torus(world, kUnit, 0.5f);    // no hole left
    Hit shoot(Vec3 origin, Vec3 dir, Interval interval = {}) const {
        return meet(world, ring, {origin, dir}, interval);
    }
};

TEST_F(RayTorus, InTheEquatorialPlaneFourWallsAreMetInTurn) {
    EXPECT_EQ(shoot({3, 0, 0}, {-1, 0, 0}).t, 2.0f);
    EXPECT_EQ(shoot({3, 0, 0}, {-1, 0, 0}, {2.0f, kInfinity}).t, 2.5f);
    EXPECT_EQ(shoot({3, 0, 0}, {-1, 0, 0}, {2.5f, kInfinity}).t, 3.5f);
    EXPECT_EQ(shoot({3, 0, 0}, {-1, 0, 0}, {3.5f, kInfinity}).t, 4.0f);
    EXPECT_TRUE(shoot({3, 0, 0}, {-1, 0, 0}, {4.0f, kInfinity}).is_none());
}

TEST_F(RayTorus, InsideTheTubeHitsItsFarWall) {
    EXPECT_EQ(shoot({0.75f, 0, 0}, {1, 0, 0}).t, 0.25f);
    EXPECT_EQ(shoot({0.75f, 0, 0}, {0, 1, 0}).t, 0.25f);
    EXPECT_EQ(shoot({0.75f, 0, 0}, {0, -1, 0}).t, 0.25f);
    EXPECT_EQ(shoot({0.75f, 0, 0}, {-1, 0, 0}).t, 0.25f);
    // Along the tube, to the wall outside.
    EXPECT_NEAR(shoot({0.75f, 0, 0}, {0, 0, 1}).t, std::sqrt(1.0 - 0.5625), 1e-7);
}

TEST_F(RayTorus, InTheHoleHitsTheInnerWall) {
    EXPECT_EQ(shoot({0, 0, 0}, {1, 0, 0}).t, 0.5f);
    EXPECT_EQ(shoot({0, 0, 0}, {0, 0, -1}).t, 0.5f);
    EXPECT_TRUE(shoot({0, 0, 0}, {0, 1, 0}).is_none());
}

TEST_F(RayTorus, ThroughTheHoleMisses) {
    EXPECT_TRUE(shoot({0, 5, 0}, {0, -1, 0}).is_none());  // along the axis
    EXPECT_TRUE(shoot({0.49f, 5, 0}, {0, -1, 0}).is_none());
    EXPECT_TRUE(shoot({0, 1, 0.1f}, {0.1961161f, -0.9805807f, 0}).is_none());
    EXPECT_FALSE(shoot({0.51f, 5, 0}, {0, -1, 0}).is_none());
}

TEST_F(RayTorus, ParallelToTheAxisHitsTopAndBottom) {
    EXPECT_EQ(shoot({0.75f, 5, 0}, {0, -1, 0}).t, 4.75f);
    EXPECT_EQ(shoot({0.75f, 5, 0}, {0, -1, 0}, {4.75f, kInfinity}).t, 5.25f);
    EXPECT_TRUE(shoot({1.01f, 5, 0}, {0, -1, 0}).is_none());
}

TEST_F(RayTorus, BehindMisses) {
    EXPECT_TRUE(shoot({3, 0, 0}, {1, 0, 0}).is_none());
    EXPECT_TRUE(shoot({0.75f, 2, 0}, {0, 1, 0}).is_none());
}

TEST_F(RayTorus, TangentHitsAndJustBesideMisses) {
    EXPECT_EQ(shoot({1, 5, 0}, {0, -1, 0}).t, 5.0f);  // outside
    EXPECT_TRUE(shoot({next_up(1.0f), 5, 0}, {0, -1, 0}).is_none());
    EXPECT_FALSE(shoot({next_down(1.0f), 5, 0}, {0, -1, 0}).is_none());
    EXPECT_EQ(shoot({0.5f, 5, 0}, {0, -1, 0}).t, 5.0f);  // in the hole
    EXPECT_TRUE(shoot({next_down(0.5f), 5, 0}, {0, -1, 0}).is_none());
    EXPECT_FALSE(shoot({next_up(0.5f), 5, 0}, {0, -1, 0}).is_none());
    EXPECT_NEAR(shoot({3, 0.25f, 0}, {-1, 0, 0}).t, 2.25f, 1e-6f);  // on top, twice
    EXPECT_NEAR(shoot({3, 0.25f, 0}, {-1, 0, 0}, {2.5f, kInfinity}).t, 3.75f, 1e-6f);
    EXPECT_TRUE(shoot({3, next_up(0.25f), 0}, {-1, 0, 0}).is_none());
    EXPECT_EQ(shoot({3, 0, 1}, {-1, 0, 0}).t, 3.0f);  // at the equator
    EXPECT_TRUE(shoot({3, 0, next_up(1.0f)}, {-1, 0, 0}).is_none());
    // In the tube, along a line that touches the inner wall from within the solid.
    EXPECT_NEAR(shoot({3, 0, 0.5f}, {-1, 0, 0}).t, 3.0 - std::sqrt(0.75), 1e-6);
}

TEST_F(RayTorus, EndsOfTheIntervalAreOpen) {
    EXPECT_EQ(shoot({3, 0, 0}, {-1, 0, 0}, {next_down(2.0f), kInfinity}).t, 2.0f);
    EXPECT_TRUE(shoot({3, 0, 0}, {-1, 0, 0}, {0.0f, 2.0f}).is_none());
    EXPECT_EQ(shoot({3, 0, 0}, {-1, 0, 0}, {0.0f, next_up(2.0f)}).t, 2.0f);
    EXPECT_TRUE(shoot({3, 0, 0}, {-1, 0, 0}, {2.5f, 3.5f}).is_none());
    EXPECT_EQ(shoot({1, 0, 0}, {-1, 0, 0}).t, 0.5f);  // begins on it
}

TEST_F(RayTorus, DirectionNeedNotBeUnit) {
    EXPECT_EQ(shoot({3, 0, 0}, {-0.5f, 0, 0}).t, 4.0f);
}

TEST_F(RayTorus, NaNAndZeroDirectionMiss) {
    EXPECT_TRUE(shoot({kNaN, 0, 0}, {-1, 0, 0}).is_none());
    EXPECT_TRUE(shoot({3, 0, 0}, {-1, kNaN, 0}).is_none());
    EXPECT_TRUE(shoot({3, 0, 0}, {0, 0, 0}).is_none());
    EXPECT_TRUE(shoot({3, 0, 0}, {-1, 0, 0}, {kNaN, kInfinity}).is_none());
    EXPECT_TRUE(meet(world, add_torus(world, kUnit, kNaN), {{3, 0, 0}, {-1, 0, 0}}).is_none());
}

TEST_F(RayTorus, ThatOverlapsItselfHasNoInnerSurface) {
    const float pole = std::sqrt(0.5f);
    EXPECT_NEAR(meet(world, apple, {{0, 5, 0}, {0, -1, 0}}).t, 5.0f - pole, 1e-6f);
    EXPECT_NEAR(meet(world, apple, {{0, 0, 0}, {0, 1, 0}}).t, pole, 1e-6f);
    EXPECT_EQ(meet(world, apple, {{0, 0, 0}, {1, 0, 0}}).t, 1.0f);
    // The inner surface would be at x = 0.5.
    EXPECT_EQ(meet(world, apple, {{3, 0, 0}, {-1, 0, 0}}, {2.0f, kInfinity}).t, 4.0f);
    // Over the dimple: in, out, in, out.
    const float y = 0.73f;
    const auto found = reference_crossings(world, apple, {{3, y, 0}, {-1, 0, 0}});
    ASSERT_EQ(found.size(), 4u);
    float t = 0.0f;
    for (const Long expected : found) {
        t = meet(world, apple, {{3, y, 0}, {-1, 0, 0}}, {t, kInfinity}).t;
        EXPECT_NEAR(t, static_cast<float>(expected), 1e-6f);
    }
}

TEST_F(RayTorus, WithoutAHoleIsMetAtItsCentre) {
    // The tube touches itself at the centre: a line through it crosses there or is inside.
    EXPECT_NEAR(meet(world, horn, {{0, 5, 0}, {0, -1, 0}}).t, 5.0f, 1e-6f);
    EXPECT_EQ(meet(world, horn, {{3, 0, 0}, {-1, 0, 0}}).t, 2.0f);
}

TEST(RayTorusShape, WithRadiusNoneIsASphere) {
    World world;
    const PrimitiveId ball = add_torus(world, kUnit, 1.0f);
    EXPECT_EQ(meet(world, ball, {{0, 5, 0}, {0, -1, 0}}).t, 4.0f);
    EXPECT_EQ(meet(world, ball, {{0.6f, 0, 5}, {0, 0, -1}}).t, 4.2f);
}

/// Lines that meet the axis, run in planes through it, or parallel to it: G has corners and double
/// inflections there.
Ray structured_ray(Random& random) {
    const float s = std::sqrt(0.5f);
    const Vec3 dirs[] = {{1, 0, 0},  {0, 1, 0},       {0, 0, -1},    {s, s, 0},    {0, -s, s},
                         {s, 0, -s}, {0.6f, 0.8f, 0}, {1, 1e-6f, 0}, {1e-6f, 1, 0}};
    const float steps[] = {0.0f, 0.25f, 0.5f, 0.75f, 1e-7f, 0.3f, 1e-20f};
    const auto coordinate = [&] {
        const float sign = random.below(2) == 0 ? -1.0f : 1.0f;
        return sign * steps[random.below(7)];
    };
    const Vec3 through{coordinate(), coordinate(), coordinate()};
    const Vec3 dir = dirs[random.below(9)];
    return {through - 4.0f * dir, dir};
}

/// All crossings by the kernel, one after the other.
std::vector<float> all_crossings(const World& world, PrimitiveId id, const Ray& ray) {
    std::vector<float> result;
    float lo = -kInfinity;
    while (true) {
        const Hit hit = meet(world, id, ray, {lo, kInfinity});
        if (hit.is_none()) return result;
        result.push_back(hit.t);
        lo = hit.t;
    }
}

/// Where a point is relative to the surface of a torus in the unit frame, and how steeply a ray
/// crosses there.
struct Place {
    double distance = 0.0;  // positive outside
    double slope = 0.0;
};

Place place_on(const scene::Torus& torus, const Ray& ray, float t) {
    const LVec3 p = LVec3{ray.origin} + static_cast<Long>(t) * LVec3{ray.dir};
    const LVec3 d{ray.dir};
    const Long rho = std::hypot(p.x, p.z);
    const Long over = rho - (1 - static_cast<Long>(torus.tube));
    const Long from_core = std::hypot(over, p.y);
    const Long rho_slope = rho > 0 ? (p.x * d.x + p.z * d.z) / rho : 0;
    return {static_cast<double>(from_core - static_cast<Long>(torus.tube)),
            static_cast<double>((over * rho_slope + p.y * d.y) / from_core)};
}

/// Expects that the kernel finds all crossings of the reference and no others, on a ray at whose
/// crossings t is known to the tolerance. Whether and where a ray touches may depend on the last
/// digit, but what is found is on the surface.
void expect_crossings(const World& world, PrimitiveId id, const Ray& ray, double tolerance,
                      const std::string& where) {
    constexpr double kTouching = 0.01;
    const scene::Torus& torus = world.tori[id.index()];
    const auto expected = reference_crossings(world, id, ray);
    const auto found = all_crossings(world, id, ray);
    bool is_touching = false;
    for (const float t : found) {
        const Place place = place_on(torus, ray, t);
        is_touching = is_touching || std::fabs(place.slope) < kTouching;
        EXPECT_LE(std::fabs(place.distance), tolerance) << where << " at " << t;
    }
    for (const Long t : expected) {
        if (std::fabs(place_on(torus, ray, static_cast<float>(t)).slope) < kTouching) {
            is_touching = true;
            continue;
        }
        const bool is_found = std::any_of(found.begin(), found.end(), [&](float other) {
            return std::fabs(static_cast<Long>(other) - t) <= static_cast<Long>(tolerance);
        });
        EXPECT_TRUE(is_found) << where << " misses " << t;
    }
    // Two at the same t: at a tip, where the tube touches itself.
    for (std::size_t i = 1; i < expected.size(); ++i) {
        if (expected[i] - expected[i - 1] <= static_cast<Long>(tolerance)) is_touching = true;
    }
    if (is_touching) return;
    EXPECT_EQ(found.size(), expected.size()) << where;
}

TEST(RayTorusCrossings, AreAllThereIsOnStructuredLines) {
    constexpr std::uint64_t kSeed = 41;
    Random random(kSeed);
    for (const float tube : {0.01f, 0.25f, 0.3f, 0.5f, 0.6f, 0.75f, 0.99f}) {
        World world;
        const PrimitiveId id = add_torus(world, kUnit, tube);
        for (int i = 0; i < 2000 && !testing::Test::HasFailure(); ++i) {
            expect_crossings(world, id, structured_ray(random), 2e-6,
                             "seed " + std::to_string(kSeed) + " tube " + std::to_string(tube) +
                                 " i " + std::to_string(i));
        }
    }
}

TEST(RayTorusCrossings, AreAllThereIsOnRandomLines) {
    constexpr std::uint64_t kSeed = 42;
    Random random(kSeed);
    std::size_t fours = 0;
    for (const float tube : {1e-4f, 0.02f, 0.2f, 0.45f, 0.5f, 0.55f, 0.9f}) {
        World world;
        const PrimitiveId id = add_torus(world, kUnit, tube);
        for (int i = 0; i < 4000 && !testing::Test::HasFailure(); ++i) {
            // Through a point of the tube, so that thin ones are met.
            const double u = random.uniform(0.0f, 2.0f * std::numbers::pi_v<float>);
            const double rho = 1.0 - static_cast<double>(tube);
            const DVec3 core{rho * std::cos(u), 0.0, rho * std::sin(u)};
            const DVec3 aim = core + static_cast<double>(tube) * DVec3{random.in_cube(1.0f)};
            Vec3 dir = random.direction();
            if (i % 3 == 0) dir = Vec3{glm::normalize(DVec3{dir.x, 0.05 * dir.y, dir.z})};
            const Ray ray{Vec3{aim - 3.0 * DVec3{dir}}, dir};
            fours += reference_crossings(world, id, ray).size() == 4 ? 1u : 0u;
            expect_crossings(world, id, ray, 2e-6,
                             "seed " + std::to_string(kSeed) + " tube " + std::to_string(tube) +
                                 " i " + std::to_string(i));
        }
    }
    EXPECT_GT(fours, 1000u);
}

// Doubles tell on which side of a tangent a ray passes, down to 1e-12 of the size.
TEST(RayTorusGrazing, RaysPastTheTangentByLittleAreDecidedRight) {
    constexpr std::uint64_t kSeed = 43;
    Random random(kSeed);
    for (const float tube : {0.05f, 0.25f, 0.5f, 0.7f}) {
        const scene::Torus torus{kUnit, tube};
        const double r = static_cast<double>(tube);
        for (int i = 0; i < 2000; ++i) {
            // A point on the outer half of the surface and a tangent there: the line touches.
            const double u = random.uniform(-3.14f, 3.14f);
            const double v = random.uniform(-1.5f, 1.5f);
            const DVec3 out{std::cos(u) * std::cos(v), std::sin(v), std::sin(u) * std::cos(v)};
            const DVec3 p = torus.radius() * DVec3{std::cos(u), 0.0, std::sin(u)} + r * out;
            const DVec3 across = DVec3{random.direction()};
            const DVec3 tangent = glm::normalize(across - dot(across, out) * out);
            for (const double beside : {-1e-6, -1e-9, -1e-12, 1e-12, 1e-9, 1e-6}) {
                PreparedRay ray;
                ray.origin = p + beside * out - 2.0 * tangent;
                ray.dir = tangent;
                const auto t = torus_crossing(torus, ray, {});
                ASSERT_EQ(t.has_value(), beside < 0.0)
                    << "seed " << kSeed << " tube " << tube << " i " << i << " beside " << beside;
                if (!t) continue;
                ASSERT_NEAR(*t, 2.0, 8.0 * std::sqrt(-beside / r)) << i;
            }
        }
    }
}

TEST(RayTorusFar, KeepsItsSilhouetteFromAMillionRadii) {
    World world;
    const PrimitiveId id = add_torus(world, kUnit, 0.25f);
    for (const float y : {0.2499f, 0.1f, 0.001f}) {
        const Hit hit = meet(world, id, {{0, y, 1e6f}, {0, 0, -1}});
        ASSERT_FALSE(hit.is_none()) << y;
        const double half = std::sqrt(0.0625 - double{y} * double{y});
        EXPECT_NEAR(hit.t, 1e6 - 0.75 - half, 0.07);
    }
    EXPECT_TRUE(meet(world, id, {{0, 0.2501f, 1e6f}, {0, 0, -1}}).is_none());
    EXPECT_TRUE(meet(world, id, {{0.4999f, 1e6f, 0}, {0, -1, 0}}).is_none());
    EXPECT_FALSE(meet(world, id, {{0.5001f, 1e6f, 0}, {0, -1, 0}}).is_none());
}

TEST(RayTorusScale, VeryUnequalByAxisAgreesWithLongDouble) {
    constexpr std::uint64_t kSeed = 46;
    Random random(kSeed);
    int hits = 0;
    for (int i = 0; i < 4000; ++i) {
        DMat3 scale{1.0};
        for (int axis = 0; axis < 3; ++axis) {
            scale[axis][axis] = std::pow(10.0, static_cast<double>(random.uniform(-4.0f, 0.0f)));
        }
        const DMat3 linear = random.rotation() * scale;
        World world;
        const PrimitiveId id = add_torus(world, make_frame(linear, {0, 0, 0}), 0.3f);
        const Vec3 aim{linear * DVec3{random.in_cube(0.9f)}};
        const Vec3 origin = 2.0f * random.direction();
        const Ray ray{origin, Vec3{glm::normalize(DVec3{aim} - DVec3{origin})}};
        const auto expected = reference_nearest(world, ray, {});
        const Hit hit = meet(world, id, ray);
        ASSERT_EQ(hit.is_none(), !expected.has_value()) << "seed " << kSeed << " i " << i;
        if (!expected) continue;
        ++hits;
        ASSERT_NEAR(hit.t, static_cast<double>(expected->t), 3e-7)
            << "seed " << kSeed << " i " << i;
        const SurfacePoint p = surface_at(world, ray, hit);
        ASSERT_NEAR(glm::length(DVec3{p.normal}), 1.0, 1e-6) << "seed " << kSeed << " i " << i;
    }
    EXPECT_GT(hits, 1000);
}

TEST(RayTorusBounds, HoldAllHits) {
    constexpr std::uint64_t kSeed = 44;
    Random random(kSeed);
    int hits = 0;
    for (const float scale : {1e-6f, 1.0f, 1e6f}) {
        for (int i = 0; i < 300; ++i) {
            World world;
            const Vec3 center = random.in_cube(10.0f * scale);
            const PrimitiveId id =
                add_random(world, random, scene::PrimitiveKind::torus, center, scale);
            const Bounds bounds = scene::primitive_bounds(world, id);
            for (int k = 0; k < 20; ++k) {
                const Vec3 origin = center + 3.0f * scale * random.direction();
                const Vec3 aim = center + random.in_cube(scale);
                const Ray ray{origin, Vec3{glm::normalize(DVec3{aim} - DVec3{origin})}};
                for (const Long t : reference_crossings(world, id, ray)) {
                    ++hits;
                    const LVec3 p = LVec3{ray.origin} + t * LVec3{ray.dir};
                    for (int axis = 0; axis < 3; ++axis) {
                        ASSERT_GE(p[axis], static_cast<Long>(bounds.min[axis])) << kSeed;
                        ASSERT_LE(p[axis], static_cast<Long>(bounds.max[axis])) << kSeed;
                    }
                }
            }
        }
    }
    EXPECT_GT(hits, 5000);
}

/// How far, at least, a ray that leaves the surface goes before it can meet it again. With g the
/// distance from the tube's middle, g'' is at most |d|^2 (1 / r + R / (r rho)); until 2 g' / g''
/// the ray is outside. Half of that, for what the offset adds to the slope.
double free_path(const scene::Torus& torus, const Vec3 position, const Vec3 dir) {
    const DVec3 p = point_object(torus.frame, DVec3{position});
    const DVec3 d = DMat3{torus.frame.object_from_world} * DVec3{dir};
    const double r = static_cast<double>(torus.tube);
    const double rho = std::hypot(p.x, p.z);
    const DVec3 out =
        DVec3{(rho - torus.radius()) * p.x / rho, p.y, (rho - torus.radius()) * p.z / rho} / r;
    const double slope = dot(out, d);
    const double least_rho = std::max(0.5 * rho, 1e-9);
    const double bend = dot(d, d) * (1.0 / (0.5 * r) + torus.radius() / (0.5 * r * least_rho));
    const double within = 0.5 * std::min(r, rho) / std::sqrt(dot(d, d));  // where the bound holds
    return std::min(std::fabs(slope) / bend, within);
}

TEST(RayTorusSurface, LeavingRayMeetsItAgainOnlyWhereItBends) {
    constexpr std::uint64_t kSeed = 688;
    Random random(kSeed);
    int again_count = 0;
    for (const float scale : {1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f}) {
        for (const float offset : {0.0f, 1.0f, 1e4f}) {
            if (scale < 1e-3f * offset) continue;
            for (int i = 0; i < 400; ++i) {
                World world;
                const Vec3 center = random.in_cube(offset);
                const PrimitiveId id =
                    add_random(world, random, scene::PrimitiveKind::torus, center, scale);
                const Vec3 from = center + 3.0f * scale * random.direction();
                const Vec3 aim = center + random.in_cube(scale);
                const Ray ray{from, Vec3{glm::normalize(DVec3{aim} - DVec3{from})}};
                const Hit hit = meet(world, id, ray);
                if (hit.is_none()) continue;
                const SurfacePoint p = surface_at(world, ray, hit);
                for (int k = 0; k < 20; ++k) {
                    Vec3 dir = random.direction();
                    if (k % 3 == 0) {
                        dir = glm::normalize(dir - 0.999f * dot(dir, p.normal) * p.normal);
                    }
                    const float slope = dot(dir, p.normal);
                    if (std::fabs(slope) < 4.0f * 0x1p-23f) continue;
                    const Vec3 origin = offset_origin(p.position, p.error, p.normal, dir);
                    const auto expected = reference_nearest(world, {origin, dir}, {});
                    const Hit again = meet(world, id, {origin, dir});
                    // A ray into the solid always meets its wall.
                    if (slope < -1e-3f) {
                        ASSERT_FALSE(again.is_none()) << kSeed << " i " << i;
                    }
                    if (again.is_none()) continue;
                    ++again_count;
                    ASSERT_TRUE(expected.has_value());
                    ASSERT_GE(again.t, free_path(world.tori[0], p.position, dir))
                        << "seed " << kSeed << " scale " << scale << " offset " << offset << " i "
                        << i << " slope " << slope << " tube " << world.tori[0].tube;
                }
            }
        }
    }
    EXPECT_GT(again_count, 10000);
}

Vec3 normal_at(const World& world, PrimitiveId id, const Ray& ray) {
    return surface_at(world, ray, meet(world, id, ray)).normal;
}

TEST_F(RayTorus, NormalIsOutwardWhereverTheRayComesFrom) {
    EXPECT_EQ(normal_at(world, ring, {{3, 0, 0}, {-1, 0, 0}}), (Vec3{1, 0, 0}));
    EXPECT_EQ(normal_at(world, ring, {{0, 0, 0}, {1, 0, 0}}), (Vec3{-1, 0, 0}));
    EXPECT_EQ(normal_at(world, ring, {{0.75f, 0, 0}, {1, 0, 0}}), (Vec3{1, 0, 0}));
    EXPECT_EQ(normal_at(world, ring, {{0.75f, 0, 0}, {0, 1, 0}}), (Vec3{0, 1, 0}));
    EXPECT_EQ(normal_at(world, ring, {{0, -5, 0.75f}, {0, 1, 0}}), (Vec3{0, -1, 0}));
    // 45 degrees up the tube.
    const float h = 0.25f * std::sqrt(0.5f);
    const Vec3 n = normal_at(world, ring, {{0.75f + h, 5, 0}, {0, -1, 0}});
    EXPECT_NEAR(n.x, std::sqrt(0.5f), 1e-6f);
    EXPECT_NEAR(n.y, std::sqrt(0.5f), 1e-6f);
}

TEST_F(RayTorus, NormalUnderANonUniformScaleIsItsGradient) {
    const PrimitiveId id = add_torus(world, scaled_frame({1, 2, 1}, {0, 0, 0}), 0.25f);
    const float h = 0.25f * std::sqrt(0.5f);
    const Vec3 n = normal_at(world, id, {{0.75f + h, 10, 0}, {0, -1, 0}});
    EXPECT_NEAR(n.x, 2.0f / std::sqrt(5.0f), 1e-5f);
    EXPECT_NEAR(n.y, 1.0f / std::sqrt(5.0f), 1e-5f);
}

TEST_F(RayTorus, NormalAtTheTipsOfAnOverlapIsFinite) {
    for (const PrimitiveId id : {apple, horn}) {
        for (const float side : {1.0f, -1.0f}) {
            const Ray ray{{0, 5 * side, 0}, {0, -side, 0}};
            const SurfacePoint p = surface_at(world, ray, meet(world, id, ray));
            EXPECT_NEAR(glm::length(p.normal), 1.0f, 1e-6f);
            EXPECT_TRUE(std::isfinite(p.error.x) && std::isfinite(p.error.y) &&
                        std::isfinite(p.error.z));
        }
    }
}

TEST(CubeRoot, IsRightToAFewRoundings) {
    Random random(45);
    EXPECT_EQ(cube_root(0.0), 0.0);
    EXPECT_EQ(cube_root(1.0), 1.0);
    for (int i = 0; i < 10000; ++i) {
        const double x = std::pow(10.0, static_cast<double>(random.uniform(-300.0f, 0.0f)));
        EXPECT_NEAR(cube_root(x) / std::cbrt(x), 1.0, 8.0 * kUnitRoundoff<double>) << x;
    }
}

}  // namespace
}  // namespace lray::bvh
