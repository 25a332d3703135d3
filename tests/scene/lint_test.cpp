#include "scene/lint.h"

#include <gtest/gtest.h>

#include <string>

#include "scene/object_path.h"
#include "tests/scene/scene_maker.h"

namespace lray::scene {
namespace {

std::string codes(const SceneMaker& maker) {
    Diagnostics diagnostics;
    const auto world = flatten(maker.scene, {}, diagnostics);
    EXPECT_TRUE(world.has_value());
    if (world) lint(maker.scene, *world, {}, diagnostics);
    std::string codes;
    for (const Diagnostic* diagnostic : diagnostics.sorted()) {
        codes += std::string(code_info(diagnostic->code).id) + " ";
    }
    return codes;
}

void add_camera(SceneMaker& maker, DVec3 position, DVec3 look_at) {
    Camera camera;
    camera.position = position;
    camera.look_at = look_at;
    camera.span = Span::make(0, 5000 + maker.scene.cameras.size(), 5001);
    maker.scene.cameras.push_back(camera);
}

void add_light(SceneMaker& maker, DVec3 position) {
    maker.scene.lights.push_back({PointLight{position}});
    maker.place(maker.add_light(maker.scene.lights.size() - 1));
}

TEST(Lint, AnEmptySceneAndOneWithoutACameraAreSilent) {
    SceneMaker maker;
    EXPECT_EQ(codes(maker), "");
    maker.place(maker.add(SphereShape{}));
    EXPECT_EQ(codes(maker), "");
    maker.scene.groups[0].children.clear();
    add_camera(maker, {0, 0, 5}, {0, 0, 9});
    EXPECT_EQ(codes(maker), "") << "an empty scene is told elsewhere";
}

TEST(Lint, EveryCameraIsAskedWhereItIsAndTheFirstWhatItSees) {
    SceneMaker maker;
    maker.place(maker.add(SphereShape{}));
    add_camera(maker, {0, 0, 5}, {0, 0, 0});
    add_camera(maker, {0, 0, 0}, {1, 0, 0});
    add_camera(maker, {0, 0, 5}, {0, 0, 9});
    EXPECT_EQ(codes(maker), "W1203 ");
    std::swap(maker.scene.cameras[0], maker.scene.cameras[2]);
    EXPECT_EQ(codes(maker), "W1203 W1205 ");
}

TEST(Lint, AThousandLightsInsideAreToldOnceForEachPlaceOfTheFirst) {
    SceneMaker maker;
    maker.place(maker.add(SphereShape{}));
    add_camera(maker, {0, 0, 5}, {0, 0, 0});
    maker.scene.lights.push_back({PointLight{}});
    const NodeId lamp = maker.add_light(0);
    for (int i = 0; i < 1000; ++i) maker.place(maker.add_instance(lamp));
    EXPECT_EQ(codes(maker), "W1204 ");
}

TEST(Lint, FarFromTheOriginInsideStaysInside) {
    SceneMaker maker;
    maker.place(maker.add(SphereShape{{1e6, 0, 0}, 2.0}));
    maker.place(maker.add(BoxShape{{-1e6 - 1, -1, -1}, {-1e6 + 1, 1, 1}}));
    add_camera(maker, {0, 0, 5}, {0, 0, 0});
    add_light(maker, {1e6, 1.9, 0});
    add_light(maker, {1e6, 2.1, 0});
    add_light(maker, {-1e6, 0.9, 0});
    add_light(maker, {-1e6, 1.1, 0});
    maker.place(maker.add(SphereShape{}));
    EXPECT_EQ(codes(maker), "W1204 W1204 ");
}

/// A wall of 17 x 300 balls, of which a row is stored once, at z = 0.
NodeId add_wall(SceneMaker& maker) {
    std::vector<NodeId> row;
    for (int i = 0; i < 17; ++i) row.push_back(maker.add(SphereShape{{3.0 * i, 0, 0}, 1.0}));
    const NodeId row_id = maker.add_group(row);
    for (int i = 0; i < 300; ++i) {
        maker.place(maker.add_instance(row_id, {Transform::translation({0, 3.0 * i, 0})}));
    }
    return row_id;
}

TEST(Lint, InstancesAreInViewOrNot) {
    SceneMaker maker;
    add_wall(maker);
    ASSERT_EQ(maker.flatten_cleanly().prototypes.size(), 1u);
    add_camera(maker, {0, 0, 50}, {0, 0, 0});
    EXPECT_EQ(codes(maker), "");
    maker.scene.cameras[0].look_at = {0, 0, 90};
    EXPECT_EQ(codes(maker), "W1205 ");
}

TEST(Lint, InstancesInOnePlaceDifferByTheMaterialThatTheyHandDown) {
    SceneMaker maker;
    const MaterialId red = maker.add_material({1, 0, 0});
    const MaterialId blue = maker.add_material({0, 0, 1});
    const NodeId row = add_wall(maker);
    const Transform there = Transform::translation({0, 0, 10});
    maker.place(maker.add_instance(row, {.transform = there, .material = red}));
    EXPECT_EQ(codes(maker), "");
    maker.place(maker.add_instance(row, {.transform = there, .material = red}));
    EXPECT_EQ(codes(maker), "") << "it makes no difference which is seen";
    maker.place(maker.add_instance(row, {.transform = there, .material = blue}));
    EXPECT_EQ(codes(maker), "W1206 ");
    for (Node& node : maker.scene.nodes) {
        if (node.kind == NodeKind::sphere) node.material_id = red;
    }
    EXPECT_EQ(codes(maker), "") << "all have a material of their own";
}

TEST(Lint, WhatAnInstancePlacesIsContentOfARoom) {
    SceneMaker maker;
    add_wall(maker);
    maker.place(maker.add(SphereShape{{0, 0, 0}, 5000.0}));
    add_camera(maker, {0, 0, 50}, {0, 0, 0});
    EXPECT_EQ(codes(maker), "");
}

TEST(ObjectPath, FollowsTheOrderOfFlattenPastMeshesLightsAndWhatIsEmpty) {
    SceneMaker maker;
    maker.scene.labels = {"part"};
    const MeshId empty = maker.add_mesh(Mesh{});
    const NodeId ball = maker.add(SphereShape{});
    maker.scene.nodes[ball.index()].label_id = LabelId{std::size_t{0}};
    const NodeId pair = maker.add_group({maker.add(MeshUse{empty}), ball, maker.add_group({})});
    maker.place(maker.add(MeshUse{empty}));
    maker.place(maker.add_group({maker.add(MeshUse{empty})}));
    add_light(maker, {0, 9, 0});
    maker.place(maker.add_instance(pair, {Transform::translation({3, 0, 0})}));
    const NodeId second = maker.add_instance(pair, {Transform::translation({6, 0, 0})});
    maker.place(second);
    const World world = maker.flatten_cleanly();
    ASSERT_EQ(world.spheres.size(), 2u);
    const ObjectId id = world.object_of({PrimitiveKind::sphere, 1});
    EXPECT_EQ(path_of(maker.scene, world, 0, id), (ObjectPath{second, pair, ball}));
}

}  // namespace
}  // namespace lray::scene
