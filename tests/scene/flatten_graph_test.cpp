// Flattening walks the graph: order of transforms, inheritance, instances.
#include <gtest/gtest.h>

#include "tests/scene/scene_maker.h"

namespace lray::scene {
namespace {

Transform move(double x, double y, double z) {
    return Transform::translation({x, y, z});
}

TEST(FlattenTransforms, OwnFirstThenTheParents) {
    SceneMaker maker;
    // The sphere is moved, then the group scales what is moved.
    const NodeId sphere = maker.add(SphereShape{}, {.transform = move(1, 0, 0)});
    const NodeId inner =
        maker.add_group({sphere}, {.transform = Transform::rotation_z(90)});  // to (0, 1, 0)
    maker.place(maker.add_group({inner}, {.transform = Transform::scaling(2.0)}));
    const World world = maker.flatten_cleanly();
    ASSERT_EQ(world.spheres.size(), 1u);
    EXPECT_EQ(world.spheres[0].center, (Vec3{0, 2, 0}));
    EXPECT_EQ(world.spheres[0].radius, 2.0f);
}

TEST(FlattenTransforms, InstanceComesAfterItsTarget) {
    SceneMaker maker;
    const NodeId ball = maker.add(SphereShape{}, {.transform = Transform::scaling(3.0)});
    maker.place(maker.add_instance(ball, {.transform = move(1, 2, 3)}));
    maker.place(maker.add_instance(ball, {.transform = move(-1, 0, 0)}));
    const World world = maker.flatten_cleanly();
    ASSERT_EQ(world.spheres.size(), 2u);
    EXPECT_EQ(world.spheres[0].center, (Vec3{1, 2, 3}));
    EXPECT_EQ(world.spheres[1].center, (Vec3{-1, 0, 0}));
    EXPECT_EQ(world.spheres[1].radius, 3.0f);
    // Both are places of the one node.
    ASSERT_EQ(world.objects.size(), 2u);
    EXPECT_EQ(world.objects[0].node_id, ball);
    EXPECT_EQ(world.objects[1].node_id, ball);
}

TEST(FlattenTransforms, InstancesOfInstancesMultiply) {
    SceneMaker maker;
    const NodeId ball = maker.add(SphereShape{});
    const NodeId pair = maker.add_group(
        {maker.add_instance(ball), maker.add_instance(ball, {.transform = move(1, 0, 0)})});
    const NodeId quad = maker.add_group(
        {maker.add_instance(pair), maker.add_instance(pair, {.transform = move(0, 1, 0)})});
    maker.place(maker.add_instance(quad));
    maker.place(maker.add_instance(quad, {.transform = move(0, 0, 1)}));
    const World world = maker.flatten_cleanly();
    ASSERT_EQ(world.spheres.size(), 8u);
    for (int i = 0; i < 8; ++i) {  // in the order of the graph
        EXPECT_EQ(world.spheres[static_cast<std::size_t>(i)].center,
                  Vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1));
    }
}

TEST(FlattenOrder, ObjectsAndPrimitivesFollowTheGraph) {
    SceneMaker maker;
    const NodeId first = maker.add(SphereShape{{1, 0, 0}, 1});
    const NodeId second = maker.add(BoxShape{});
    const NodeId third = maker.add(SphereShape{{2, 0, 0}, 1});
    maker.place(maker.add_group({first, second}));
    maker.place(third);
    const World world = maker.flatten_cleanly();
    ASSERT_EQ(world.objects.size(), 3u);
    EXPECT_EQ(world.objects[0].node_id, first);
    EXPECT_EQ(world.objects[1].node_id, second);
    EXPECT_EQ(world.objects[2].node_id, third);
    EXPECT_EQ(world.object_of({PrimitiveKind::sphere, 1}), ObjectId{2});
    EXPECT_EQ(world.object_of({PrimitiveKind::box, 0}), ObjectId{1});
    EXPECT_EQ(world.primitive_count(), 3u);
}

TEST(FlattenMaterials, OwnThenNearestAncestorThenDefault) {
    SceneMaker maker;
    const MaterialId red = maker.add_material({1, 0, 0});
    const MaterialId blue = maker.add_material({0, 0, 1});
    maker.place(maker.add(SphereShape{}));
    const NodeId inherits = maker.add(SphereShape{});
    const NodeId own = maker.add(SphereShape{}, {.material = blue});
    const NodeId between = maker.add_group({inherits, own});
    maker.place(maker.add_group({between}, {.material = red}));
    const World world = maker.flatten_cleanly();
    ASSERT_EQ(world.objects.size(), 3u);
    ASSERT_EQ(world.materials.size(), 3u);
    EXPECT_EQ(world.objects[0].material, 0u);
    EXPECT_EQ(world.materials[0].diffuse, Color{0.8f});
    EXPECT_EQ(world.materials[world.objects[1].material].diffuse, (Color{1, 0, 0}));
    EXPECT_EQ(world.materials[world.objects[2].material].diffuse, (Color{0, 0, 1}));
}

TEST(FlattenMaterials, OfAnInstanceIsADefaultNotAnOverride) {
    SceneMaker maker;
    const MaterialId red = maker.add_material({1, 0, 0});
    const MaterialId blue = maker.add_material({0, 0, 1});
    const NodeId plain = maker.add(SphereShape{});
    const NodeId painted = maker.add(SphereShape{}, {.material = blue});
    maker.place(maker.add_instance(maker.add_group({plain, painted}), {.material = red}));
    const World world = maker.flatten_cleanly();
    ASSERT_EQ(world.objects.size(), 2u);
    EXPECT_EQ(world.materials[world.objects[0].material].diffuse, (Color{1, 0, 0}));
    EXPECT_EQ(world.materials[world.objects[1].material].diffuse, (Color{0, 0, 1}));
}

TEST(FlattenVisibility, FalseOnAGroupHidesAllBelow) {
    SceneMaker maker;
    const NodeId hidden = maker.add(SphereShape{});
    maker.place(maker.add_group({maker.add_group({hidden})}, {.visible = false}));
    const NodeId no_shadow = maker.add(SphereShape{});
    maker.place(maker.add_group({no_shadow}, {.casts_shadow = false}));
    maker.place(maker.add(SphereShape{}));
    const World world = maker.flatten_cleanly();
    ASSERT_EQ(world.objects.size(), 3u);
    EXPECT_FALSE(world.objects[0].visible);
    EXPECT_TRUE(world.objects[0].casts_shadow);
    EXPECT_TRUE(world.objects[1].visible);
    EXPECT_FALSE(world.objects[1].casts_shadow);
    EXPECT_TRUE(world.objects[2].visible && world.objects[2].casts_shadow);
}

TEST(FlattenDepth, AHundredThousandNestedGroupsAreFine) {
    SceneMaker maker;
    NodeId node = maker.add(SphereShape{});
    for (int i = 0; i < 100000; ++i) {
        node = maker.add_group({node}, {.transform = move(1, 0, 0)});
    }
    maker.place(node);
    const World world = maker.flatten_cleanly();
    ASSERT_EQ(world.spheres.size(), 1u);
    EXPECT_EQ(world.spheres[0].center.x, 100000.0f);
}

TEST(FlattenErrors, SingularTransformIsReportedAtItsNodeOnce) {
    SceneMaker maker;
    const NodeId a = maker.add(SphereShape{});
    const NodeId b = maker.add(BoxShape{});
    const NodeId flat = maker.add_group({a, b}, {.transform = Transform::scaling(DVec3{1, 0, 1})});
    maker.place(flat);
    const Diagnostic error = expect_refused(maker.scene);
    EXPECT_EQ(error.code, Code::E0310);
    EXPECT_EQ(error.span, maker.scene.node(flat).span);
    EXPECT_EQ(error.message, "the transform of this node cannot be inverted");
}

TEST(FlattenErrors, UniformScaleOfZeroIsSingularToo) {
    SceneMaker maker;
    const NodeId id = maker.add(SphereShape{}, {.transform = Transform::scaling(0.0)});
    maker.place(id);
    const Diagnostic error = expect_refused(maker.scene);
    EXPECT_EQ(error.code, Code::E0310);
    EXPECT_EQ(error.span, maker.scene.node(id).span);
}

TEST(FlattenErrors, ProductOfTransformsThatOverflowsIsReported) {
    SceneMaker maker;
    NodeId node = maker.add(SphereShape{});
    for (int i = 0; i < 4; ++i) {
        node = maker.add_group({node}, {.transform = Transform::scaling(1e100)});
    }
    maker.place(node);
    const Diagnostic error = expect_refused(maker.scene);
    EXPECT_EQ(error.code, Code::E0310);
}

TEST(FlattenErrors, SeveralBrokenNodesAreAllReported) {
    SceneMaker maker;
    for (int i = 0; i < 5; ++i) {
        maker.place(maker.add(SphereShape{}, {.transform = Transform::scaling(0.0)}));
    }
    Diagnostics diagnostics;
    EXPECT_FALSE(flatten(maker.scene, {}, diagnostics).has_value());
    EXPECT_EQ(diagnostics.error_count(), 5u);
}

}  // namespace
}  // namespace lray::scene
