// Every hierarchy finds what testing everything finds, to the bit: t, u, v, primitive and place;
// and a shadow exactly where there is a hit. On random worlds that are hard on trees.
#include <gtest/gtest.h>

#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "bvh/accel.h"
#include "bvh/boxes/box_accel.h"
#include "bvh/boxes/scalar_walk.h"
#include "tests/bvh/worlds.h"

namespace lray::bvh {
namespace {

using scene::PrimitiveKind;
using scene::World;

/// A kind of world; `scale` multiplies all lengths.
struct WorldForm {
    const char* name;
    std::function<void(World&, Random&, float scale)> fill;
    int world_count = 60;
};

void fill_uniform(World& world, Random& random, float scale) {
    const int count = 1 + random.below(150);
    for (int i = 0; i < count; ++i) {
        add_random(world, random, random.in_cube(4.0f * scale),
                   random.uniform(0.05f, 1.5f) * scale);
    }
}

void fill_with_triangles(World& world, Random& random, float scale) {
    const int count = 1 + random.below(300);
    for (int i = 0; i < count; ++i) {
        add_random(world, random, PrimitiveKind::triangle, random.in_cube(4.0f * scale),
                   random.uniform(0.05f, 1.0f) * scale);
    }
}

/// Cells of a grid in the planes of whole numbers: everything touches, much is in one plane.
void fill_grid(World& world, Random& random, float scale) {
    const int size = 2 + random.below(5);
    for (int i = 0; i < size; ++i) {
        for (int j = 0; j < size; ++j) {
            const Vec3 corner = scale * Vec3{i, j, random.below(2)};
            const Vec3 a = corner + scale * Vec3{1, 0, 0};
            const Vec3 b = corner + scale * Vec3{0, 1, 0};
            switch (random.below(4)) {
                case 0:
                    add_triangle(world, corner, a, b);
                    break;
                case 1:
                    add_rectangle(world, corner, a - corner, b - corner);
                    break;
                case 2:
                    add_box(world, scaled_frame(Vec3{0.5f * scale}, corner));
                    break;
                default:
                    add_sphere(world, corner, 0.5f * scale);
                    break;
            }
        }
    }
}

/// All in one plane, overlapping.
void fill_coplanar(World& world, Random& random, float scale) {
    for (int i = 0; i < 60; ++i) {
        const auto point = [&] {
            Vec3 p = random.in_cube(2.0f * scale);
            p.z = 0.0f;
            return p;
        };
        add_triangle(world, point(), point(), point());
    }
}

/// A few things, many times each, in the same places.
void fill_duplicates(World& world, Random& random, float scale) {
    for (int i = 0; i < 6; ++i) {
        const Vec3 center = random.in_cube(2.0f * scale);
        Random same(static_cast<std::uint64_t>(i));
        for (int copy = 0; copy < 20; ++copy) {
            add_sphere(world, center, 0.5f * scale);
            const Vec3 corner = center + Vec3{scale, 0, 0};
            add_triangle(world, corner, corner + Vec3{scale, 0, 0}, corner + Vec3{0, scale, 0});
        }
    }
}

/// Shells within shells.
void fill_nested(World& world, Random& random, float scale) {
    for (int i = 1; i <= 40; ++i) {
        const float size = scale * 0.1f * static_cast<float>(i);
        add_sphere(world, random.in_cube(0.02f * scale), size);
        add_box(world, scaled_frame(Vec3{size}, random.in_cube(0.02f * scale)));
    }
}

/// Needles up to a million times as long as wide, and tiny things beside huge ones.
void fill_slivers(World& world, Random& random, float scale) {
    for (int i = 0; i < 100; ++i) {
        const Vec3 a = random.in_cube(3.0f * scale);
        const Vec3 along = random.direction() * (scale * random.uniform(1.0f, 30.0f));
        const float width = scale * std::pow(10.0f, random.uniform(-6.0f, -1.0f));
        add_triangle(world, a, a + along, a + random.direction() * width);
        add_sphere(world, random.in_cube(3.0f * scale),
                   scale * std::pow(10.0f, random.uniform(-5.0f, 0.0f)));
    }
}

/// Of all kinds with a frame, thin, long and skewed: hard on what bounds them.
void fill_stretched(World& world, Random& random, float scale) {
    const auto any_frame = [&] {
        DMat3 stretch{1.0};
        for (int axis = 0; axis < 3; ++axis) {
            const float size = scale * std::pow(10.0f, random.uniform(-3.0f, 0.5f));
            stretch[axis][axis] = static_cast<double>(random.below(4) == 0 ? -size : size);
        }
        return make_frame(random.rotation() * stretch * random.rotation(),
                          random.in_cube(4.0f * scale));
    };
    const int count = 1 + random.below(120);
    for (int i = 0; i < count; ++i) {
        const int kind = random.below(5);
        if (kind == 0) add_ellipsoid(world, any_frame());
        if (kind == 1) {
            add_cylinder(world, any_frame(), random.uniform(0.0f, 1.0f), random.below(2) == 0);
        }
        if (kind == 2) add_disk(world, any_frame(), random.uniform(0.0f, 0.9f));
        if (kind == 3) add_box(world, any_frame());
        if (kind == 4) add_torus(world, any_frame(), random.uniform(0.01f, 1.0f));
    }
}

/// Enough for trees of several levels, and leaves of each kind.
void fill_with_many(World& world, Random& random, float scale) {
    for (int i = 0; i < 1500; ++i) {
        const bool is_common = random.below(3) != 0;
        const PrimitiveKind common =
            random.below(2) == 0 ? PrimitiveKind::triangle : PrimitiveKind::sphere;
        const Vec3 center = random.in_cube(4.0f * scale);
        const float size = random.uniform(0.02f, 0.4f) * scale;
        if (is_common) {
            add_random(world, random, common, center, size);
        } else {
            add_random(world, random, center, size);
        }
    }
}

/// Prototypes within prototypes, under any affine map, mirrored and squashed too.
void fill_with_instances(World& world, Random& random, float scale) {
    const auto any_frame = [&](float size) {
        DMat3 stretch{1.0};
        for (int axis = 0; axis < 3; ++axis) {
            stretch[axis][axis] = static_cast<double>(random.uniform(0.2f, 1.0f) *
                                                      (random.below(4) == 0 ? -1.0f : 1.0f));
        }
        return make_frame(random.rotation() * stretch * random.rotation(),
                          random.in_cube(size * scale));
    };
    const int depth = 1 + random.below(4);
    for (int i = 0; i < depth; ++i) {
        scene::Geometry prototype;
        for (int k = random.below(12); k >= 0; --k) {
            PrimitiveKind kind = PrimitiveKind::plane;
            while (kind == PrimitiveKind::plane) {
                kind = static_cast<PrimitiveKind>(random.below(scene::kSurfaceKindCount));
            }
            add_random(prototype, random, kind, random.in_cube(scale), 0.4f * scale);
        }
        for (int k = i == 0 ? 0 : 1 + random.below(3); k > 0; --k) {
            const auto inner = static_cast<std::uint32_t>(random.below(i));
            add_instance(world, prototype, inner, any_frame(1.0f));
        }
        add_prototype(world, std::move(prototype));
    }
    for (int k = 0; k < 12; ++k) {
        const auto inner = static_cast<std::uint32_t>(random.below(depth));
        const scene::AffineFrame frame = any_frame(3.0f);
        add_instance(world, world, inner, frame);
        if (k % 4 == 0) add_instance(world, world, inner, frame);  // twice in one place
    }
    add_random(world, random, random.in_cube(3.0f * scale), scale);
}

const std::vector<WorldForm> kForms = {
    {"Uniform", fill_uniform},
    {"Triangles", fill_with_triangles},
    {"Grid", fill_grid},
    {"Coplanar", fill_coplanar},
    {"Duplicates", fill_duplicates},
    {"Nested", fill_nested},
    {"Slivers", fill_slivers},
    {"Stretched", fill_stretched},
    {"Instances", fill_with_instances},
    {"Many", fill_with_many, 12},
};

/// Rays from anywhere, some along the axes and through the corners of what is there.
Ray random_ray(const World& world, Random& random, float scale) {
    const Vec3 origin = random.in_cube(6.0f * scale);
    switch (random.below(6)) {
        case 0: {  // along an axis
            Vec3 dir{0.0f};
            dir[random.below(3)] = random.below(2) == 0 ? 1.0f : -1.0f;
            return {origin, dir};
        }
        case 1: {  // along an axis in a plane of the grid
            const auto whole = [&] { return scale * static_cast<float>(random.below(7)); };
            Vec3 dir{0.0f};
            dir[random.below(3)] = random.below(2) == 0 ? 1.0f : -1.0f;
            return {Vec3{whole(), whole(), whole()} - 8.0f * scale * dir, dir};
        }
        case 2:  // at a vertex, or the origin of a frame
            if (world.vertices.empty() && !world.cylinders.empty()) {
                const int which = random.below(static_cast<int>(world.cylinders.size()));
                const Vec3 way =
                    world.cylinders[static_cast<std::size_t>(which)].frame.origin - origin;
                const float length = std::sqrt(dot(way, way));
                if (length > 0.0f) return {origin, way / length};
            }
            if (!world.vertices.empty()) {
                const Vec3 target = world.vertices[static_cast<std::size_t>(
                    random.below(static_cast<int>(world.vertices.size())))];
                const Vec3 way = target - origin;
                const float length = std::sqrt(dot(way, way));
                if (length > 0.0f) return {origin, way / length};
            }
            return {origin, random.direction()};
        case 3:  // almost along an axis
        {
            Vec3 dir = random.in_cube(1e-7f);
            dir[random.below(3)] = 1.0f;
            return {origin, dir / std::sqrt(dot(dir, dir))};
        }
        default:
            return {origin, random.direction()};
    }
}

/// A way to build a hierarchy.
struct Method {
    std::string name;
    std::function<std::unique_ptr<Accel>(const World&)> build;
};

/// Every hierarchy, and the boxes for each processor that this one can stand in for.
std::vector<Method> methods() {
    std::vector<Method> result;
    result.push_back(
        {"Spheres", [](const World& world) { return build(world, {.kind = AccelKind::spheres}); }});
    result.push_back({"BoxesScalar", [](const World& world) {
                          return make_box_accel(world, BuildQuality::medium, scalar_walks());
                      }});
    result.push_back({"BoxesHighScalar", [](const World& world) {
                          return make_box_accel(world, BuildQuality::high, scalar_walks());
                      }});
    for (std::int64_t targets = simd_targets(); targets != 0; targets &= targets - 1) {
        const std::int64_t target = targets & -targets;
        result.push_back(
            {std::string("Boxes") + hwy::TargetName(target), [target](const World& world) {
                 hwy::SetSupportedTargetsForTest(target);
                 const Walks walks = simd_walks();
                 hwy::SetSupportedTargetsForTest(0);
                 return make_box_accel(world, BuildQuality::medium, walks);
             }});
    }
    return result;
}

void expect_same(const Hit& found, const Hit& expected, const std::string& where) {
    ASSERT_EQ(found.primitive_id, expected.primitive_id) << where;
    ASSERT_EQ(found.place, expected.place) << where;
    ASSERT_EQ(found.t, expected.t) << where;
    ASSERT_EQ(found.u, expected.u) << where;
    ASSERT_EQ(found.v, expected.v) << where;
    ASSERT_EQ(found.normal.x, expected.normal.x) << where;
    ASSERT_EQ(found.normal.y, expected.normal.y) << where;
    ASSERT_EQ(found.normal.z, expected.normal.z) << where;
}

Interval random_interval(Random& random, float scale) {
    if (random.below(3) != 0) return {random.below(2) == 0 ? 0.0f : -0.0f, kInfinity};
    return {random.uniform(0.0f, 3.0f) * scale, random.uniform(3.0f, 9.0f) * scale};
}

/// Rays side by side, as a tile of pixels sends them, or to one point, as to a light; a few are
/// anything else, or no rays.
std::vector<Ray> random_tile(const World& world, Random& random, float scale) {
    const Ray middle = random_ray(world, random, scale);
    const bool is_from_one_point = random.below(2) == 0;
    const float width = random.below(4) == 0 ? 1.0f : 0.05f;
    std::vector<Ray> rays;
    for (int i = 1 + random.below(100); i > 0; --i) {
        if (random.below(40) == 0) {
            rays.push_back(random_ray(world, random, scale));
            if (random.below(2) == 0) rays.back().dir.x = std::numeric_limits<float>::quiet_NaN();
            continue;
        }
        const Vec3 target = middle.origin + middle.dir * (8.0f * scale);
        const Vec3 aside = random.in_cube(width * scale);
        const Vec3 origin = is_from_one_point ? middle.origin : middle.origin + aside;
        const Vec3 way = (is_from_one_point ? target + aside : target) - origin;
        rays.push_back({origin, way / std::sqrt(dot(way, way))});
    }
    return rays;
}

class SameHits : public testing::TestWithParam<std::tuple<Method, WorldForm, float>> {
 protected:
    /// Calls check(world, expected, accel, random, name) for many worlds.
    template <class Check>
    static void for_each_world(Check check) {
        const auto& [method, form, scale] = GetParam();
        for (int i = 0; i < form.world_count; ++i) {
            const auto seed = static_cast<std::uint64_t>(i);
            Random random(seed);
            World world;
            form.fill(world, random, scale);
            if (i % 3 == 0) {  // some are hidden, some cast no shadow
                for (scene::Object& object : world.objects) {
                    object.visible = random.below(5) != 0;
                    object.casts_shadow = random.below(5) != 0;
                }
            }
            const auto expected = build(world, {.kind = AccelKind::none});
            const auto accel = method.build(world);
            check(world, *expected, *accel, random, "world " + std::to_string(i) + ", ray ");
            if (HasFatalFailure()) return;
        }
    }
};

TEST_P(SameHits, AsTestingEverything) {
    const float scale = std::get<float>(GetParam());
    constexpr int kRays = 150;
    int hit_count = 0;
    for_each_world([&](const World& world, const Accel& expected, const Accel& accel,
                       Random& random, const std::string& name) {
        for (int k = 0; k < kRays; ++k) {
            const Ray ray = random_ray(world, random, scale);
            const Interval interval = random_interval(random, scale);
            TraceCounts counts;
            const Hit hit = expected.nearest_hit(ray, interval, counts);
            const std::string where = name + std::to_string(k);
            ASSERT_NO_FATAL_FAILURE(
                expect_same(accel.nearest_hit(ray, interval, counts), hit, where));
            const bool is_shadowed = expected.any_hit(ray, interval, counts);
            ASSERT_EQ(accel.any_hit(ray, interval, counts), is_shadowed) << where;
            if (std::ranges::all_of(world.objects, [](const scene::Object& object) {
                    return object.visible && object.casts_shadow;
                })) {
                ASSERT_EQ(is_shadowed, !hit.is_none()) << where;
            }
            hit_count += hit.is_none() ? 0 : 1;
        }
    });
    EXPECT_GT(hit_count, std::get<WorldForm>(GetParam()).world_count * kRays / 50);
}

TEST_P(SameHits, OfManyRaysAtOnce) {
    const float scale = std::get<float>(GetParam());
    constexpr int kTiles = 3;
    int hit_count = 0;
    for_each_world([&](const World& world, const Accel& expected, const Accel& accel,
                       Random& random, const std::string& name) {
        for (int k = 0; k < kTiles; ++k) {
            const std::vector<Ray> rays = random_tile(world, random, scale);
            std::vector<Interval> intervals(rays.size());
            for (Interval& interval : intervals) interval = random_interval(random, scale);
            std::vector<Hit> hits(rays.size());
            const auto are_hit = std::make_unique<bool[]>(rays.size());
            TraceCounts counts;
            accel.nearest_hits(rays, intervals, hits, counts);
            accel.any_hits(rays, intervals, {are_hit.get(), rays.size()}, counts);
            ASSERT_EQ(counts.rays, 2 * rays.size());
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const Hit hit = expected.nearest_hit(rays[i], intervals[i], counts);
                const std::string where =
                    name + std::to_string(i) + " of tile " + std::to_string(k);
                ASSERT_NO_FATAL_FAILURE(expect_same(hits[i], hit, where));
                ASSERT_EQ(are_hit[i], expected.any_hit(rays[i], intervals[i], counts)) << where;
                hit_count += hit.is_none() ? 0 : 1;
            }
        }
    });
    EXPECT_GT(hit_count, 100);
}

std::string name_of(const testing::TestParamInfo<SameHits::ParamType>& info) {
    const auto& [method, form, scale] = info.param;
    return method.name + form.name + (scale < 1.0f ? "Tiny" : scale > 1.0f ? "Huge" : "");
}

INSTANTIATE_TEST_SUITE_P(Forms, SameHits,
                         testing::Combine(testing::ValuesIn(methods()), testing::ValuesIn(kForms),
                                          testing::Values(1.0f, 1e-6f, 1e6f)),
                         name_of);

}  // namespace
}  // namespace lray::bvh
