// The volumes of hierarchies, level by level: each cut covers all there is, and no scene makes it
// large or slow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "bvh/accel.h"
#include "bvh/surface.h"
#include "tests/bvh/worlds.h"
#include "tests/support/random.h"

namespace lray::bvh {
namespace {

using scene::World;
using Shape = BoundingVolume::Shape;

constexpr std::size_t kAll = std::size_t{1} << 20;
constexpr std::uint32_t kDeep = 1u << 20;

const BuildOptions kTrees[] = {{AccelKind::spheres, BuildQuality::medium},
                               {AccelKind::boxes, BuildQuality::medium},
                               {AccelKind::boxes, BuildQuality::high}};

std::string name_of(const BuildOptions& options) {
    if (options.kind == AccelKind::spheres) return "spheres";
    return options.quality == BuildQuality::high ? "boxes, high" : "boxes";
}

/// Frames that turn, stretch and mirror.
scene::AffineFrame random_frame(Random& random, float reach) {
    DMat3 scale{1.0};
    for (int axis = 0; axis < 3; ++axis) {
        const double size = static_cast<double>(random.uniform(0.2f, 0.9f));
        scale[axis][axis] = random.below(4) == 0 ? -size : size;
    }
    return make_frame(random.rotation() * scale * random.rotation(), random.in_cube(reach));
}

void add_some(scene::Geometry& geometry, Random& random, int count) {
    for (int i = 0; i < count; ++i) {
        auto kind = static_cast<scene::PrimitiveKind>(random.below(scene::kSurfaceKindCount));
        if (kind == scene::PrimitiveKind::plane) kind = scene::PrimitiveKind::sphere;
        add_random(geometry, random, kind, random.in_cube(3.0f), random.uniform(0.1f, 0.8f));
    }
}

/// Things, or things and instances within instances.
World random_world(Random& random, bool has_instances) {
    World world;
    add_some(world, random, 1 + random.below(200));
    if (random.below(3) == 0) add_plane(world, Vec3{0, -3, 0}, random.direction());
    if (!has_instances) return world;
    for (int depth = 0; depth < 3; ++depth) {
        scene::Geometry prototype;
        add_some(prototype, random, 1 + random.below(30));
        for (int i = 0; depth > 0 && i < 1 + random.below(6); ++i) {
            const auto inner = static_cast<std::uint32_t>(random.below(depth));
            add_instance(world, prototype, inner, random_frame(random, 2.0f));
        }
        add_prototype(world, std::move(prototype));
    }
    for (int i = 0; i < 10; ++i) {
        add_instance(world, world, static_cast<std::uint32_t>(random.below(3)),
                     random_frame(random, 4.0f));
    }
    return world;
}

/// Within a ten-thousandth of the unit that worlds here are measured in.
bool holds(const BoundingVolume& volume, DVec3 point) {
    constexpr double kMargin = 1e-4;
    const auto& [x, y, z] = volume.half_axes;
    const DVec3 at = glm::inverse(DMat3{x, y, z}) * (point - volume.center);
    if (volume.shape == Shape::ellipsoid) return std::sqrt(dot(at, at)) <= 1.0 + kMargin;
    for (int axis = 0; axis < 3; ++axis) {
        const DVec3 half = volume.half_axes[static_cast<std::size_t>(axis)];
        if (std::fabs(at[axis]) > 1.0 + kMargin / std::sqrt(dot(half, half))) return false;
    }
    return true;
}

bool holds(const BoundingVolumes& cut, DVec3 point) {
    return std::ranges::any_of(cut.volumes,
                               [&](const auto& volume) { return holds(volume, point); });
}

/// Where random rays hit anything but planes, found without a hierarchy.
std::vector<DVec3> random_hits(const World& world, Random& random, int ray_count) {
    const auto accel = build(world, {.kind = AccelKind::none});
    std::vector<DVec3> points;
    for (int i = 0; i < ray_count; ++i) {
        const Vec3 origin = random.in_cube(8.0f);
        const Vec3 way = random.in_cube(3.0f) - origin;
        const Ray ray{origin, way / std::sqrt(dot(way, way))};
        TraceCounts counts;
        const Hit hit = accel->nearest_hit(ray, {}, counts);
        if (hit.is_none() || hit.primitive_id.kind() == scene::PrimitiveKind::plane) continue;
        points.emplace_back(surface_at(world, ray, hit).position);
    }
    return points;
}

std::size_t count_leaves(const BoundingVolumes& cut) {
    return static_cast<std::size_t>(std::ranges::count_if(cut.volumes, &BoundingVolume::is_leaf));
}

/// Calls check(world, accel, random) for worlds in all hierarchies.
template <class Check>
void for_each_world(bool has_instances, int world_count, Check check) {
    for (int i = 0; i < world_count; ++i) {
        const auto seed = static_cast<std::uint64_t>(i);
        LRAY_TRACE_SEED(seed);
        for (const BuildOptions& options : kTrees) {
            SCOPED_TRACE(name_of(options));
            Random random(seed);
            const World world = random_world(random, has_instances);
            const auto accel = build(world, options);
            check(world, *accel, random);
        }
    }
}

TEST(Volumes, EveryHitIsInAVolumeOfEachLevel) {
    std::size_t hit_count = 0;
    for (const bool has_instances : {false, true}) {
        for_each_world(has_instances, 12,
                       [&](const World& world, const Accel& accel, Random& random) {
                           const std::vector<DVec3> points = random_hits(world, random, 200);
                           hit_count += points.size();
                           const std::uint32_t level_count = accel.volumes(0, kAll).level_count;
                           EXPECT_GT(level_count, 0u);
                           for (std::uint32_t level = 0; level <= level_count; ++level) {
                               const BoundingVolumes cut = accel.volumes(level, kAll);
                               EXPECT_FALSE(cut.is_cut_short);
                               for (const DVec3 point : points)
                                   EXPECT_TRUE(holds(cut, point)) << level;
                           }
                       });
    }
    EXPECT_GT(hit_count, 3000u);
}

TEST(Volumes, LevelsAreOfTheirDepthOrLeavesAboveIt) {
    for_each_world(true, 12, [](const World&, const Accel& accel, Random&) {
        const std::uint32_t level_count = accel.volumes(0, kAll).level_count;
        for (std::uint32_t level = 0; level < level_count; ++level) {
            const BoundingVolumes cut = accel.volumes(level, kAll);
            EXPECT_EQ(cut.level_count, level_count);
            std::uint32_t deepest = 0;
            for (const BoundingVolume& volume : cut.volumes) {
                EXPECT_TRUE(volume.depth == level || (volume.depth < level && volume.is_leaf));
                deepest = std::max(deepest, volume.depth);
            }
            EXPECT_EQ(deepest, level);
            EXPECT_EQ(count_leaves(cut) == cut.volumes.size(), level + 1 == level_count);
        }
        const BoundingVolumes last = accel.volumes(level_count - 1, kAll);
        EXPECT_EQ(accel.volumes(kDeep, kAll).volumes.size(), last.volumes.size());
    });
}

TEST(Volumes, WithoutInstancesTheLastLevelIsTheLeavesOfTheTree) {
    for_each_world(false, 20, [](const World& world, const Accel& accel, Random&) {
        const BoundingVolumes cut = accel.volumes(kDeep, kAll);
        EXPECT_EQ(cut.volumes.size(), accel.stats().leaves);
        EXPECT_EQ(count_leaves(cut), accel.stats().leaves);
        EXPECT_EQ(cut.level_count, accel.stats().depth);
        EXPECT_EQ(cut.volumes.empty(), world.planes.size() == world.primitive_count());
    });
}

TEST(Volumes, BoxesOfALevelLieInBoxesOfTheLevelAbove) {
    for_each_world(false, 12, [](const World&, const Accel& accel, Random&) {
        BoundingVolumes above = accel.volumes(0, kAll);
        if (above.volumes.empty() || above.volumes[0].shape == Shape::ellipsoid) return;
        ASSERT_EQ(above.volumes.size(), 1u);
        for (std::uint32_t level = 1; level < above.level_count; ++level) {
            BoundingVolumes cut = accel.volumes(level, kAll);
            for (const BoundingVolume& inner : cut.volumes) {
                EXPECT_TRUE(std::ranges::any_of(above.volumes, [&](const BoundingVolume& outer) {
                    for (std::size_t i = 0; i < 3; ++i) {
                        const auto axis = static_cast<int>(i);
                        const double reach = std::fabs(inner.center[axis] - outer.center[axis]) +
                                             inner.half_axes[i][axis];
                        if (reach > outer.half_axes[i][axis] * (1.0 + 1e-14) + 1e-14) return false;
                    }
                    return true;
                }));
            }
            above = std::move(cut);
        }
    });
}

TEST(Volumes, NoMoreThanAskedForStillCoverEverything) {
    int short_count = 0;
    for_each_world(true, 8, [&](const World& world, const Accel& accel, Random& random) {
        const std::vector<DVec3> points = random_hits(world, random, 100);
        for (const std::uint32_t level : {0u, 1u, 3u, 6u, kDeep}) {
            const BoundingVolumes whole = accel.volumes(level, kAll);
            for (const std::size_t max_count : {std::size_t{1}, std::size_t{2}, std::size_t{10},
                                                std::size_t{100}, whole.volumes.size()}) {
                const BoundingVolumes cut = accel.volumes(level, max_count);
                EXPECT_LE(cut.volumes.size(), max_count);
                EXPECT_EQ(cut.is_cut_short, whole.volumes.size() > max_count);
                EXPECT_EQ(cut.level_count, whole.level_count);
                if (!cut.is_cut_short) {
                    EXPECT_EQ(cut.volumes.size(), whole.volumes.size());
                } else {
                    ++short_count;
                    // The widest step down is to the eight children of a node.
                    EXPECT_GT(cut.volumes.size() + 8, max_count);
                }
                for (const DVec3 point : points) EXPECT_TRUE(holds(cut, point));
            }
            EXPECT_TRUE(accel.volumes(level, 0).volumes.empty());
            EXPECT_TRUE(accel.volumes(level, 0).is_cut_short);
        }
    });
    EXPECT_GT(short_count, 100);
}

DMat3 columns(const BoundingVolume& volume) {
    return {volume.half_axes[0], volume.half_axes[1], volume.half_axes[2]};
}

void expect_near(const DMat3& a, const DMat3& b) {
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) EXPECT_NEAR(a[column][row], b[column][row], 1e-5);
    }
}

TEST(Volumes, AnInstanceCarriesTheVolumesOfItsPrototypeOut) {
    Random random(3);
    const DMat3 turned = random.rotation();
    const DMat3 inner_linear = random.rotation() * DMat3{2.0};
    const DMat3 outer_linear = turned * DMat3{{1, 0, 0}, {0, 3, 0}, {0, 0, -0.5}};
    const DVec3 inner_origin{1, 2, 3};
    const DVec3 outer_origin{-4, 0, 5};
    World world;
    scene::Geometry ball;
    add_sphere(ball, Vec3{0.25f, 0.5f, 0.75f}, 0.5f);
    const std::uint32_t ball_index = add_prototype(world, std::move(ball));
    scene::Geometry holder;
    add_instance(world, holder, ball_index, make_frame(inner_linear, Vec3{inner_origin}));
    const std::uint32_t holder_index = add_prototype(world, std::move(holder));
    add_instance(world, world, holder_index, make_frame(outer_linear, Vec3{outer_origin}));
    for (const BuildOptions& options : kTrees) {
        SCOPED_TRACE(name_of(options));
        const auto accel = build(world, options);
        EXPECT_EQ(accel->volumes(0, kAll).level_count, 3u);
        for (const std::uint32_t level : {0u, 1u, 2u}) {
            const BoundingVolumes cut = accel->volumes(level, kAll);
            ASSERT_EQ(cut.volumes.size(), 1u);
            EXPECT_EQ(cut.volumes[0].depth, level);
            EXPECT_EQ(cut.volumes[0].is_leaf, level == 2);
            EXPECT_EQ(cut.volumes[0].is_instance, level > 0);
        }
        const BoundingVolume volume = accel->volumes(2, kAll).volumes[0];
        const DVec3 center = inner_linear * DVec3{0.25, 0.5, 0.75} + inner_origin;
        const DVec3 expected = outer_linear * center + outer_origin;
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(volume.center[axis], expected[axis], 1e-5);
        }
        // Of the sphere, its box and its bounding sphere all have the half axes 1/2.
        expect_near(columns(volume), outer_linear * inner_linear * 0.5);
    }
}

TEST(Volumes, ALeafWithInstancesBesidePrimitivesStaysAsTheLeafOfThese) {
    World world;
    scene::Geometry ball;
    add_sphere(ball, Vec3{0.0f}, 1.0f);
    add_prototype(world, std::move(ball));
    add_instance(world, world, 0, scaled_frame(Vec3{1.0f}, Vec3{0.0f}));
    add_sphere(world, Vec3{0.01f, 0, 0}, 1.0f);  // no split keeps them apart
    const auto accel = build(world, {.kind = AccelKind::spheres});
    ASSERT_EQ(accel->stats().depth, 1u);
    const BoundingVolumes root = accel->volumes(0, kAll);
    ASSERT_EQ(root.volumes.size(), 1u);
    EXPECT_FALSE(root.volumes[0].is_leaf);
    const BoundingVolumes cut = accel->volumes(1, kAll);
    EXPECT_EQ(cut.level_count, 2u);
    ASSERT_EQ(cut.volumes.size(), 2u);
    EXPECT_EQ(count_leaves(cut), 2u);
    EXPECT_EQ(cut.volumes[0].depth, 0u);
    EXPECT_FALSE(cut.volumes[0].is_instance);
    EXPECT_TRUE(cut.volumes[1].is_instance);
    EXPECT_EQ(cut.volumes[1].depth, 1u);
    // Two would be too many for one.
    EXPECT_EQ(accel->volumes(1, 1).volumes.size(), 1u);
    EXPECT_TRUE(accel->volumes(1, 1).is_cut_short);
}

TEST(Volumes, InstancesOfWhatIsHiddenLeadNowhere) {
    World world;
    scene::Geometry ball;
    add_sphere(ball, Vec3{0.0f}, 1.0f);
    ball.objects[0].visible = false;
    add_prototype(world, std::move(ball));
    add_instance(world, world, 0, scaled_frame(Vec3{1.0f}, Vec3{0.0f}));
    for (const BuildOptions& options : kTrees) {
        const BoundingVolumes cut = build(world, options)->volumes(5, kAll);
        ASSERT_EQ(cut.volumes.size(), 1u);
        EXPECT_TRUE(cut.volumes[0].is_leaf);
        EXPECT_EQ(cut.level_count, 1u);
    }
}

TEST(Volumes, NothingPlanesAloneAndNoHierarchyHaveNone) {
    World empty;
    World planes;
    add_plane(planes, Vec3{0.0f}, Vec3{0, 1, 0});
    World ball;
    add_sphere(ball, Vec3{0.0f}, 1.0f);
    const auto expect_none = [](const World& world, AccelKind kind) {
        const BoundingVolumes cut = build(world, {.kind = kind})->volumes(3, kAll);
        EXPECT_TRUE(cut.volumes.empty());
        EXPECT_EQ(cut.level_count, 0u);
        EXPECT_FALSE(cut.is_cut_short);
    };
    for (const AccelKind kind : {AccelKind::none, AccelKind::spheres, AccelKind::boxes}) {
        expect_none(empty, kind);
        expect_none(planes, kind);
    }
    expect_none(ball, AccelKind::none);
}

/// Prototypes of so many uses of the one before, the first of them a ball.
World nested_uses(int levels, int uses) {
    World world;
    scene::Geometry ball;
    add_sphere(ball, Vec3{0.0f}, 1.0f);
    std::uint32_t inner = add_prototype(world, std::move(ball));
    for (int level = 0; level < levels; ++level) {
        scene::Geometry next;
        for (int i = 0; i < uses; ++i) {
            add_instance(world, next, inner,
                         scaled_frame(Vec3{0.99f}, Vec3{0.01f * static_cast<float>(i), 0, 0}));
        }
        inner = add_prototype(world, std::move(next));
    }
    add_instance(world, world, inner, scaled_frame(Vec3{1.0f}, Vec3{0.0f}));
    return world;
}

TEST(Volumes, MorePlacesThanCanBeCountedTakeNoLonger) {
    const World world = nested_uses(60, 2);
    ASSERT_GT(world.place_count, scene::PlaceOffset{1} << 60);
    for (const BuildOptions& options : kTrees) {
        SCOPED_TRACE(name_of(options));
        const auto accel = build(world, options);
        const std::uint32_t level_count = accel->volumes(0, 1).level_count;
        EXPECT_GT(level_count, 60u);
        EXPECT_LE(level_count, 62u * 2u);
        for (const std::uint32_t level : {20u, 100u, 0xffffffffu}) {
            const BoundingVolumes cut = accel->volumes(level, 1000);
            EXPECT_TRUE(cut.is_cut_short);
            EXPECT_LE(cut.volumes.size(), 1000u);
            EXPECT_GT(cut.volumes.size(), 990u);
            EXPECT_EQ(cut.level_count, level_count);
        }
    }
}

TEST(Volumes, AChainOfInstancesHasALevelForEach) {
    const World world = nested_uses(63, 1);
    for (const BuildOptions& options : kTrees) {
        SCOPED_TRACE(name_of(options));
        const auto accel = build(world, options);
        const BoundingVolumes cut = accel->volumes(kDeep, 1);
        EXPECT_FALSE(cut.is_cut_short);
        EXPECT_EQ(cut.level_count, 65u);
        ASSERT_EQ(cut.volumes.size(), 1u);
        EXPECT_EQ(cut.volumes[0].depth, 64u);
        EXPECT_NEAR(cut.volumes[0].half_axes[1].y, std::pow(0.99, 63), 1e-4);
    }
}

TEST(Volumes, AreTheSameAskedForByManyThreadsAtOnce) {
    Random random(5);
    const World world = random_world(random, true);
    const auto accel = build(world, {.kind = AccelKind::boxes});
    std::vector<std::uint32_t> counts(8);
    std::vector<std::thread> threads;
    for (std::uint32_t& count : counts) {
        threads.emplace_back([&] { count = accel->volumes(2, kAll).level_count; });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_GT(counts[0], 2u);
    EXPECT_EQ(std::ranges::count(counts, counts[0]), 8);
}

}  // namespace
}  // namespace lray::bvh
