// A scene whose common parts are stored once shows what the same scene shows with all written out:
// within rounding, as rays are carried into instances instead of shapes into the world.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "bvh/accel.h"
#include "bvh/surface.h"
#include "scene/object_path.h"
#include "scene/place.h"
#include "tests/bvh/worlds.h"
#include "tests/scene/scene_maker.h"

namespace lray::bvh {
namespace {

using scene::NodeId;
using scene::NodeSettings;
using scene::SceneMaker;
using scene::World;

constexpr double kTolerance = 1e-4;

Transform random_transform(Random& random, double reach) {
    Transform result = Transform::scaling(static_cast<double>(random.uniform(0.5f, 1.2f)));
    if (random.below(3) == 0) {  // squashed, perhaps mirrored
        result = Transform::scaling(DVec3{0.5, random.below(2) == 0 ? -1.0 : 1.0, 1.3});
    }
    result = result.then(Transform::rotation(DVec3{random.direction()},
                                             static_cast<double>(random.uniform(0.0f, 360.0f))));
    return result.then(Transform::translation(DVec3{random.in_cube(static_cast<float>(reach))}));
}

NodeSettings random_settings(Random& random, const SceneMaker& maker, double reach) {
    NodeSettings settings;
    if (random.below(4) != 0) settings.transform = random_transform(random, reach);
    const int material = random.below(2 * static_cast<int>(maker.scene.materials.size()));
    if (material < static_cast<int>(maker.scene.materials.size())) {
        settings.material = scene::MaterialId{static_cast<std::size_t>(material)};
    }
    settings.visible = random.below(12) != 0;
    settings.casts_shadow = random.below(12) != 0;
    return settings;
}

scene::Mesh random_mesh(Random& random) {
    scene::Mesh mesh;
    for (int i = 0; i < 30; ++i) mesh.positions.push_back(random.in_cube(1.0f));
    for (std::uint32_t i = 0; i + 2 < 30; ++i) mesh.triangles.push_back({i, i + 1, i + 2});
    return mesh;
}

NodeId add_shape(SceneMaker& maker, Random& random) {
    NodeSettings settings = random_settings(random, maker, 2.0);
    settings.transform = random_transform(random, 2.0);  // no two surfaces in one plane
    switch (random.below(8)) {
        case 0:
            return maker.add(scene::SphereShape{}, settings);
        case 1:
            return maker.add(scene::RectangleShape{}, settings);
        case 2:
            return maker.add(scene::TriangleShape{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, settings);
        case 3:
            return maker.add(scene::CylinderShape{}, settings);
        case 4:
            return maker.add(scene::DiskShape{}, settings);
        case 5:
            return maker.add(scene::BoxShape{}, settings);
        case 6:
            return maker.add(scene::TorusShape{}, settings);
        default:
            return maker.add(scene::MeshUse{scene::MeshId{std::size_t{0}}}, settings);
    }
}

/// Groups of shapes and of uses of earlier groups.
SceneMaker random_scene(Random& random, bool has_plane) {
    SceneMaker maker;
    for (const Color color : {Color{1, 0, 0}, Color{0, 1, 0}, Color{0, 0, 1}}) {
        maker.add_material(color);
    }
    maker.add_mesh(random_mesh(random));
    std::vector<NodeId> groups;
    for (int i = 0; i < 5; ++i) {
        std::vector<NodeId> children;
        for (int k = 2 + random.below(3); k > 0; --k) children.push_back(add_shape(maker, random));
        for (int k = i == 0 ? 0 : 2; k > 0; --k) {
            const NodeId target = groups[static_cast<std::size_t>(random.below(i))];
            children.push_back(maker.add_instance(target, random_settings(random, maker, 3.0)));
        }
        // Groups that it is in are not shared, what is beside it in them is.
        if (has_plane && i == 3) children.push_back(maker.add(scene::PlaneShape{{0, -20, 0}}));
        groups.push_back(maker.add_group(children, random_settings(random, maker, 1.0)));
    }
    for (const NodeId group : groups) {
        maker.place(maker.add_instance(group, random_settings(random, maker, 4.0)));
        maker.place(maker.add_instance(group, random_settings(random, maker, 4.0)));
    }
    return maker;
}

World flattened(const scene::Scene& scene, const scene::SharingRule& rule) {
    Diagnostics diagnostics;
    auto world = scene::flatten(scene, {.sharing = rule}, diagnostics);
    EXPECT_TRUE(world.has_value());
    return world ? std::move(*world) : World{};
}

/// What a hit shows.
struct Seen {
    scene::ObjectPath path{};
    Color color{0.0f};
    SurfacePoint point{};
};

Seen look(const SceneMaker& maker, const World& world, const Ray& ray, const Hit& hit) {
    const scene::Geometry& geometry = *scene::path_to(world, hit.place).geometry;
    const std::uint32_t material = scene::material_at(world, hit.place, hit.primitive_id);
    return {path_of(maker.scene, world, hit.place, geometry.object_of(hit.primitive_id)),
            world.materials[material].diffuse.constant, surface_at(world, ray, hit)};
}

TEST(SharedWorld, ShowsWhatTheExpandedOneShows) {
    constexpr int kScenes = 40;
    constexpr int kRays = 400;
    int hit_count = 0;
    int shared_count = 0;
    int difference_count = 0;  // rays that pass an edge on the other side
    for (int i = 0; i < kScenes; ++i) {
        const auto seed = static_cast<std::uint64_t>(i);
        SCOPED_TRACE(seed);
        Random random(seed);
        const SceneMaker maker = random_scene(random, i % 8 == 0);
        const World shared = flattened(maker.scene, {2, 0});
        const World expanded = flattened(maker.scene, scene::SharingRule::nothing());
        ASSERT_TRUE(expanded.prototypes.empty());
        ASSERT_FALSE(shared.prototypes.empty());
        const auto accel = build(shared, {.kind = AccelKind::spheres});
        const auto reference = build(expanded, {.kind = AccelKind::none});
        for (int k = 0; k < kRays; ++k) {
            const Vec3 origin = random.in_cube(9.0f);
            const Vec3 way = random.in_cube(4.0f) - origin;
            const Ray ray{origin, way / std::sqrt(dot(way, way))};
            TraceCounts counts;
            const Hit a = reference->nearest_hit(ray, Interval{}, counts);
            const Hit b = accel->nearest_hit(ray, Interval{}, counts);
            const bool is_dark = reference->any_hit(ray, Interval{}, counts);
            bool is_same =
                a.is_none() == b.is_none() && accel->any_hit(ray, Interval{}, counts) == is_dark;
            if (is_same && !a.is_none()) {
                ++hit_count;
                shared_count += b.place > 0 ? 1 : 0;
                const Seen seen_a = look(maker, expanded, ray, a);
                const Seen seen_b = look(maker, shared, ray, b);
                const DVec3 apart = DVec3{seen_a.point.position} - DVec3{seen_b.point.position};
                const double scale = 1.0 + static_cast<double>(a.t);
                is_same = seen_a.path == seen_b.path && seen_a.color == seen_b.color &&
                          std::fabs(static_cast<double>(a.t - b.t)) <= kTolerance * scale &&
                          glm::length(apart) <= kTolerance * scale &&
                          dot(seen_a.point.normal, seen_b.point.normal) > 0.999f;
            }
            difference_count += is_same ? 0 : 1;
        }
    }
    EXPECT_GT(hit_count, kScenes * kRays / 4);
    EXPECT_GT(shared_count, hit_count / 3);
    EXPECT_LE(difference_count, kScenes * kRays / 2000);
}

/// Rows of eight rows of eight ..., of balls that are 8^-levels small.
World nested_rows(int levels) {
    World world;
    scene::Geometry row;
    add_sphere(row, Vec3{0.0f}, 1.0f);
    std::uint32_t inner = add_prototype(world, std::move(row));
    for (int level = 0; level < levels; ++level) {
        scene::Geometry next;
        for (int i = 0; i < 8; ++i) {
            const Vec3 center{-0.875f + 0.25f * static_cast<float>(i), 0, 0};
            add_instance(world, next, inner, scaled_frame(Vec3{0.125f}, center));
        }
        inner = add_prototype(world, std::move(next));
    }
    add_instance(world, world, inner, scaled_frame(Vec3{1.0f}, Vec3{0.0f}));
    return world;
}

// In the float of a box test balls so far away are all in one place: each ray would meet them all.
TEST(SharedWorld, TinyInstancesFarAwayAreToldApart) {
    constexpr int kLevels = 12;
    const World world = nested_rows(kLevels);
    Random random(1);
    int hit_count = 0;
    for (const AccelKind kind : {AccelKind::none, AccelKind::spheres, AccelKind::boxes}) {
        const auto accel = build(world, {.kind = kind});
        for (int k = 0; k < 50; ++k) {
            const Ray ray{Vec3{random.uniform(-1.0f, 1.0f), 0, 10}, Vec3{0, 0, -1}};
            TraceCounts counts;
            const Hit hit = accel->nearest_hit(ray, Interval{}, counts);
            hit_count += hit.is_none() ? 0 : 1;
            // Two neighbours on every level, of eight that are looked at.
            EXPECT_LE(counts.instance_tests, 2u * 8 * (kLevels + 1));
        }
    }
    EXPECT_GT(hit_count, 100);
}

}  // namespace
}  // namespace lray::bvh
