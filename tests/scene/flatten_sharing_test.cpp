// What is placed often is stored once: what that is, and what instances carry.
#include <gtest/gtest.h>

#include <string>

#include "scene/object_path.h"
#include "scene/place.h"
#include "tests/scene/scene_maker.h"

namespace lray::scene {
namespace {

Transform move(double x, double y, double z) {
    return Transform::translation({x, y, z});
}

/// A group of so many unit spheres in a row along x.
NodeId add_row(SceneMaker& maker, int count, const NodeSettings& settings = {}) {
    std::vector<NodeId> spheres;
    for (int i = 0; i < count; ++i) {
        spheres.push_back(maker.add(SphereShape{{3.0 * i, 0, 0}, 1.0}));
    }
    return maker.add_group(spheres, settings);
}

/// Places a node so often, along y.
void place_often(SceneMaker& maker, NodeId node, int count) {
    for (int i = 0; i < count; ++i) {
        maker.place(maker.add_instance(node, {.transform = move(0, 3.0 * i, 0)}));
    }
}

Mesh make_strip(std::uint32_t triangle_count) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < triangle_count + 2; ++i) {
        mesh.positions.push_back({static_cast<float>(i), static_cast<float>(i % 2), 0.0f});
    }
    for (std::uint32_t i = 0; i < triangle_count; ++i) mesh.triangles.push_back({i, i + 1, i + 2});
    return mesh;
}

World flatten_with(const Scene& scene, const SharingRule& rule) {
    Diagnostics diagnostics;
    auto world = flatten(scene, {.sharing = rule}, diagnostics);
    EXPECT_TRUE(world.has_value());
    return world ? std::move(*world) : World{};
}

constexpr SharingRule kEager{2, 0};

TEST(FlattenSharing, FewUsesStayInTheWorldAndManyAreInstances) {
    for (const int uses : {256, 257, 258}) {  // (257 - 1) * 16 = 4096
        SceneMaker maker;
        place_often(maker, add_row(maker, 16), uses);
        const World world = maker.flatten_cleanly();
        const bool is_shared = uses >= 257;
        EXPECT_EQ(world.prototypes.size(), is_shared ? 1u : 0u) << uses;
        EXPECT_EQ(world.instances.size(), is_shared ? static_cast<std::size_t>(uses) : 0u);
        EXPECT_EQ(world.spheres.size(), is_shared ? 0u : static_cast<std::size_t>(16 * uses));
    }
}

TEST(FlattenSharing, FewPrimitivesAreNeverShared) {
    SceneMaker maker;
    place_often(maker, add_row(maker, 15), 2000);
    const World world = maker.flatten_cleanly();
    EXPECT_EQ(world.spheres.size(), 30000u);
    EXPECT_TRUE(world.prototypes.empty());
}

TEST(FlattenSharing, AnInstanceHoldsTheMapAndTheBoundsOfItsPlace) {
    SceneMaker maker;
    const NodeId row = add_row(maker, 16, {.transform = Transform::scaling(2.0)});
    place_often(maker, row, 300);
    const World world = maker.flatten_cleanly();
    ASSERT_EQ(world.instances.size(), 300u);
    ASSERT_EQ(world.prototypes.size(), 1u);
    EXPECT_EQ(world.prototypes[0].spheres.size(), 16u);
    EXPECT_EQ(world.prototypes[0].spheres[0].radius, 1.0f);  // before its own steps
    const WorldInstance& third = world.instances[2];
    EXPECT_EQ(third.frame.object_from_world, Mat3{0.5f});
    EXPECT_EQ(third.frame.origin, (Vec3{0, 6, 0}));
    EXPECT_NEAR(third.bounds.min.x, -2.0f, 1e-5f);
    EXPECT_NEAR(third.bounds.max.x, 92.0f, 1e-4f);
    EXPECT_NEAR(third.bounds.max.y, 8.0f, 1e-5f);
    EXPECT_EQ(third.first_place, 3u);
    EXPECT_EQ(world.place_count, 301u);
    const Bounds bounds = finite_bounds(world);
    EXPECT_NEAR(bounds.max.y, 299.0f * 3.0f + 2.0f, 1e-3f);
}

TEST(FlattenSharing, UsesOfOneFileAreOneMeshWhereverTheyAreWritten) {
    SceneMaker maker;
    const MeshId mesh = maker.add_mesh(make_strip(5000));
    const NodeId first = maker.add(MeshUse{mesh}, {.transform = move(0, 1, 0)});
    const NodeId second = maker.add(MeshUse{mesh}, {.transform = move(0, 2, 0)});
    const NodeId turned = maker.add(MeshUse{mesh, MeshUse::kAllParts, true});
    maker.place(first);
    maker.place(second);
    maker.place(turned);
    const World world = maker.flatten_cleanly();
    ASSERT_EQ(world.prototypes.size(), 1u);
    EXPECT_EQ(world.prototypes[0].triangles.size(), 5000u);
    EXPECT_EQ(world.triangles.size(), 5000u);  // of the one that stands otherwise
    ASSERT_EQ(world.instances.size(), 2u);
    EXPECT_EQ(world.object(world.object_of({PrimitiveKind::instance, 0})).node_id, first);
    EXPECT_EQ(world.object(world.object_of({PrimitiveKind::instance, 1})).node_id, second);
    EXPECT_EQ(path_of(maker.scene, world, 2, ObjectId{std::size_t{0}}), (ObjectPath{second}));
}

TEST(FlattenSharing, WhatIsMetOnceInASharedThingIsPartOfIt) {
    SceneMaker maker;
    const NodeId mesh = maker.add(MeshUse{maker.add_mesh(make_strip(100))});
    const NodeId tree = maker.add_group({mesh, add_row(maker, 20)});
    place_often(maker, tree, 1000);
    const World world = maker.flatten_cleanly();
    ASSERT_EQ(world.prototypes.size(), 1u);
    EXPECT_EQ(world.prototypes[0].triangles.size(), 100u);
    EXPECT_EQ(world.prototypes[0].spheres.size(), 20u);
    EXPECT_EQ(world.prototypes[0].node_id, tree);
}

TEST(FlattenSharing, SharedThingsNest) {
    SceneMaker maker;
    const NodeId row = add_row(maker, 2);
    const NodeId pair = maker.add_group({maker.add_instance(row, {.transform = move(0, 0, 0)}),
                                         maker.add_instance(row, {.transform = move(0, 3, 0)})});
    maker.place(maker.add_instance(pair, {.transform = move(0, 0, 5)}));
    maker.place(maker.add_instance(pair, {.transform = move(0, 0, 10)}));
    const World world = flatten_with(maker.scene, kEager);
    ASSERT_EQ(world.prototypes.size(), 2u);
    EXPECT_EQ(world.prototypes[0].spheres.size(), 2u);
    EXPECT_EQ(world.prototypes[1].instances.size(), 2u);
    EXPECT_EQ(world.instances.size(), 2u);
    EXPECT_EQ(world.prototypes[1].place_count, 3u);
    EXPECT_EQ(world.place_count, 7u);
    const PlacePath path = path_to(world, 6);
    ASSERT_EQ(path.steps.size(), 2u);
    EXPECT_EQ(path.steps[0].instance, &world.instances[1]);
    EXPECT_EQ(path.steps[1].instance, &world.prototypes[1].instances[1]);
}

TEST(FlattenSharing, PlanesStayInTheWorldAndWhatIsBesideThemIsShared) {
    SceneMaker maker;
    const NodeId row = add_row(maker, 4);
    const NodeId with_plane = maker.add_group({row, maker.add(PlaneShape{})});
    maker.place(maker.add_instance(with_plane));
    maker.place(maker.add_instance(with_plane, {.transform = move(0, 5, 0)}));
    const World world = flatten_with(maker.scene, kEager);
    EXPECT_EQ(world.planes.size(), 2u);
    EXPECT_EQ(world.planes[1].point.y, 5.0f);
    ASSERT_EQ(world.prototypes.size(), 1u);
    EXPECT_EQ(world.prototypes[0].node_id, row);
    EXPECT_TRUE(world.prototypes[0].planes.empty());
    EXPECT_EQ(world.instances.size(), 2u);
}

TEST(FlattenSharing, LightsAreInTheWorldOnEveryPath) {
    SceneMaker maker;
    maker.scene.lights.push_back({PointLight{}});
    const NodeId lamp = maker.add_light(0, {.transform = move(1, 0, 0)});
    const NodeId post = maker.add_group({add_row(maker, 3), lamp});
    const NodeId street = maker.add_group({maker.add_instance(post, {.transform = move(0, 1, 0)}),
                                           maker.add_instance(post, {.transform = move(0, 2, 0)})});
    maker.place(maker.add_instance(street, {.transform = move(0, 0, 1)}));
    maker.place(maker.add_instance(street, {.transform = move(0, 0, 2), .visible = false}));
    const World world = flatten_with(maker.scene, kEager);
    EXPECT_EQ(world.prototypes.size(), 2u);
    ASSERT_EQ(world.lights.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& light = std::get<PointLight>(world.lights[i].light.shape);
        EXPECT_EQ(light.position, DVec3(1, i % 2 == 0 ? 1 : 2, i < 2 ? 1 : 2));
        EXPECT_EQ(world.lights[i].visible, i < 2);
        EXPECT_EQ(world.lights[i].node_id, lamp);
    }
}

TEST(FlattenSharing, MaterialsAreInheritedThroughInstances) {
    SceneMaker maker;
    const MaterialId red = maker.add_material({1, 0, 0});
    const MaterialId blue = maker.add_material({0, 0, 1});
    const MaterialId green = maker.add_material({0, 1, 0});
    const NodeId plain = maker.add(SphereShape{});
    const NodeId painted = maker.add(SphereShape{}, {.material = blue});
    const NodeId pair = maker.add_group({plain, painted});
    const NodeId own =
        maker.add_group({maker.add_instance(pair), add_row(maker, 2)}, {.material = green});
    maker.place(maker.add_instance(pair, {.material = red}));
    maker.place(maker.add_instance(pair));
    maker.place(maker.add_instance(own, {.material = red}));
    maker.place(maker.add_instance(own, {.material = red}));
    const World world = flatten_with(maker.scene, kEager);
    ASSERT_EQ(world.prototypes.size(), 2u);
    const auto diffuse = [&](PlaceOffset place, std::size_t sphere) {
        return world.materials[material_at(world, place, {PrimitiveKind::sphere, sphere})]
            .diffuse.constant;
    };
    EXPECT_EQ(diffuse(1, 0), (Color{1, 0, 0}));
    EXPECT_EQ(diffuse(1, 1), (Color{0, 0, 1}));
    EXPECT_EQ(diffuse(2, 0), Color{0.8f});
    EXPECT_EQ(diffuse(2, 1), (Color{0, 0, 1}));
    EXPECT_EQ(diffuse(3, 0), (Color{0, 1, 0}));  // its own goes before the instance's
    EXPECT_EQ(diffuse(4, 0), (Color{0, 1, 0}));
}

TEST(FlattenSharing, WhatIsHiddenAboveHidesTheInstanceAndBelowTheShape) {
    SceneMaker maker;
    const NodeId hidden = maker.add(SphereShape{}, {.visible = false});
    const NodeId lit = maker.add(SphereShape{}, {.casts_shadow = false});
    const NodeId pair = maker.add_group({hidden, lit});
    maker.place(maker.add_instance(pair));
    maker.place(
        maker.add_group({maker.add_instance(pair, {.casts_shadow = false})}, {.visible = false}));
    const World world = flatten_with(maker.scene, kEager);
    ASSERT_EQ(world.instances.size(), 2u);
    const auto object = [&](std::size_t i) {
        return world.object(world.object_of({PrimitiveKind::instance, i}));
    };
    EXPECT_TRUE(object(0).visible && object(0).casts_shadow);
    EXPECT_FALSE(object(1).visible || object(1).casts_shadow);
    const Geometry& prototype = world.prototypes[0];
    EXPECT_FALSE(prototype.objects[0].visible);
    EXPECT_TRUE(prototype.objects[0].casts_shadow);
    EXPECT_TRUE(prototype.objects[1].visible);
    EXPECT_FALSE(prototype.objects[1].casts_shadow);
}

TEST(FlattenSharing, WhatIsFarFromItsOriginIsStoredNearIt) {
    SceneMaker maker;
    std::vector<NodeId> spheres;
    for (int i = 0; i < 2; ++i)
        spheres.push_back(maker.add(SphereShape{{1e7 + 0.25 * i, 0, 0}, 0.01}));
    const NodeId far = maker.add_group(spheres);
    maker.place(maker.add_instance(far, {.transform = move(-1e7, 0, 0)}));
    maker.place(maker.add_instance(far, {.transform = move(-1e7, 1, 0)}));
    const World world = flatten_with(maker.scene, kEager);
    ASSERT_EQ(world.instances.size(), 2u);
    const Bounds bounds = world.instances[0].bounds;  // floats near 1e7 are 1 apart
    EXPECT_NEAR(bounds.min.x, -0.01f, 1e-6f);
    EXPECT_NEAR(bounds.max.x, 0.26f, 1e-6f);
}

TEST(FlattenSharing, WhatHasNothingLeftIsNotPlaced) {
    SceneMaker maker;
    const TriangleShape flat{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    const NodeId pair = maker.add_group({maker.add(flat), maker.add(flat)});
    maker.place(maker.add_instance(pair));
    maker.place(maker.add_instance(pair));
    maker.place(maker.add(SphereShape{}));
    Diagnostics diagnostics;
    const auto world = flatten(maker.scene, {.sharing = kEager}, diagnostics);
    ASSERT_TRUE(world.has_value());
    EXPECT_EQ(diagnostics.warning_count(), 2u);  // W1201 of each triangle, once
    EXPECT_TRUE(world->instances.empty());
    EXPECT_EQ(world->place_count, 1u);
    const ObjectId sphere = world->object_of({PrimitiveKind::sphere, 0});
    EXPECT_EQ(path_of(maker.scene, *world, 0, sphere).size(), 1u);
}

TEST(FlattenSharing, PathsLeadThroughInstances) {
    SceneMaker maker;
    maker.scene.labels = {"x"};
    const NodeId row = add_row(maker, 3);
    const NodeId inner = maker.add_instance(row, {.transform = move(0, 1, 0)});
    const NodeId other = maker.add_instance(row, {.transform = move(0, 2, 0)});
    const NodeId pair = maker.add_group({inner, maker.add(BoxShape{}), other});
    const NodeId outer = maker.add_instance(pair);
    maker.place(maker.add(SphereShape{}));
    maker.place(maker.add_instance(pair, {.transform = move(9, 0, 0)}));
    maker.place(outer);
    const World world = flatten_with(maker.scene, kEager);
    ASSERT_EQ(world.place_count, 7u);
    const NodeId third = maker.scene.groups[maker.scene.node(row).index].children[2];
    EXPECT_EQ(path_of(maker.scene, world, 6, ObjectId{std::size_t{2}}),
              (ObjectPath{outer, pair, other, row, third}));
    const NodeId box = maker.scene.groups[maker.scene.node(pair).index].children[1];
    EXPECT_EQ(path_of(maker.scene, world, 4, ObjectId{std::size_t{1}}),
              (ObjectPath{outer, pair, box}));
}

}  // namespace
}  // namespace lray::scene
