// Every hierarchy finds what testing everything finds, to the bit: t, u, v, primitive and place;
// and a shadow exactly where there is a hit. On random worlds that are hard on trees.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "bvh/accel.h"
#include "tests/bvh/worlds.h"

namespace lray::bvh {
namespace {

using scene::PrimitiveKind;
using scene::World;

/// A kind of world; `scale` multiplies all lengths.
struct WorldForm {
    const char* name;
    std::function<void(World&, Random&, float scale)> fill;
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
    {"Uniform", fill_uniform},   {"Triangles", fill_with_triangles}, {"Grid", fill_grid},
    {"Coplanar", fill_coplanar}, {"Duplicates", fill_duplicates},    {"Nested", fill_nested},
    {"Slivers", fill_slivers},   {"Instances", fill_with_instances},
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
        case 2:  // at a vertex
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

class SameHits : public testing::TestWithParam<std::tuple<AccelKind, WorldForm, float>> {};

TEST_P(SameHits, AsTestingEverything) {
    const auto& [kind, form, scale] = GetParam();
    constexpr int kWorlds = 60;
    constexpr int kRays = 150;
    int hit_count = 0;
    for (int i = 0; i < kWorlds; ++i) {
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
        const auto accel = build(world, {.kind = kind});
        for (int k = 0; k < kRays; ++k) {
            const Ray ray = random_ray(world, random, scale);
            Interval interval;
            if (k % 3 == 0) {
                interval = {random.uniform(0.0f, 3.0f) * scale, random.uniform(3.0f, 9.0f) * scale};
            }
            TraceCounts counts;
            const Hit a = expected->nearest_hit(ray, interval, counts);
            const Hit b = accel->nearest_hit(ray, interval, counts);
            ASSERT_EQ(a.primitive_id, b.primitive_id) << "world " << seed << ", ray " << k;
            ASSERT_EQ(a.place, b.place) << "world " << seed << ", ray " << k;
            ASSERT_EQ(a.t, b.t) << "world " << seed << ", ray " << k;
            ASSERT_EQ(a.u, b.u) << "world " << seed << ", ray " << k;
            ASSERT_EQ(a.v, b.v) << "world " << seed << ", ray " << k;
            const bool is_shadowed = expected->any_hit(ray, interval, counts);
            ASSERT_EQ(accel->any_hit(ray, interval, counts), is_shadowed)
                << "world " << seed << ", ray " << k;
            if (i % 3 != 0) {
                ASSERT_EQ(is_shadowed, !a.is_none());
            }
            hit_count += a.is_none() ? 0 : 1;
        }
    }
    EXPECT_GT(hit_count, kWorlds * kRays / 50);
}

std::string name_of(const testing::TestParamInfo<SameHits::ParamType>& info) {
    const auto& [kind, form, scale] = info.param;
    const char* const name = kind == AccelKind::spheres ? "Spheres" : "Boxes";
    return std::string(name) + form.name + (scale < 1.0f ? "Tiny" : scale > 1.0f ? "Huge" : "");
}

INSTANTIATE_TEST_SUITE_P(Forms, SameHits,
                         testing::Combine(testing::Values(AccelKind::spheres, AccelKind::boxes),
                                          testing::ValuesIn(kForms),
                                          testing::Values(1.0f, 1e-6f, 1e6f)),
                         name_of);

}  // namespace
}  // namespace lray::bvh
