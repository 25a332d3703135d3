// Lights of the graph in the world: under transforms, in instances, and how many.
#include <gtest/gtest.h>

#include <variant>

#include "scene/flatten.h"
#include "tests/scene/scene_maker.h"

namespace lray::scene {
namespace {

constexpr double kTolerance = 1e-15;

NodeId add_light(SceneMaker& maker, const LightShape& shape, const NodeSettings& settings = {}) {
    maker.scene.lights.push_back({shape});
    return maker.add_light(maker.scene.lights.size() - 1, settings);
}

/// The one light of the world, placed under a transform.
Light placed(const LightShape& shape, const Transform& transform) {
    SceneMaker maker;
    maker.place(add_light(maker, shape, {transform}));
    const World world = maker.flatten_cleanly();
    EXPECT_EQ(world.lights.size(), 1u);
    EXPECT_EQ(world.primitive_count(), 0u);
    EXPECT_TRUE(world.objects.empty());
    return world.lights.empty() ? Light{} : world.lights[0].light;
}

TEST(FlattenLights, APointMovesAndItsRadiusGrows) {
    PointLight point;
    point.position = {1, 2, 3};
    point.radius = 0.5;
    const Light light =
        placed(point, Transform::scaling(-2.0).then(Transform::translation({10, 0, 0})));
    EXPECT_EQ(std::get<PointLight>(light.shape).position, DVec3(8, -4, -6));
    EXPECT_EQ(std::get<PointLight>(light.shape).radius, 1.0);
    EXPECT_EQ(light.intensity, Light{}.intensity);  // a scale leaves it as it is
    const Light stretched = placed(point, Transform::scaling(DVec3{1, 1, 5}));
    EXPECT_DOUBLE_EQ(std::get<PointLight>(stretched.shape).radius, 1.5);  // sqrt(27 / 3) / 2
}

TEST(FlattenLights, DirectionsTurnAndStayUnit) {
    SpotLight spot;
    spot.position = {0, 0, 1};
    const Transform turn = Transform::rotation_y(90.0).then(Transform::scaling(4.0));
    const SpotLight turned = std::get<SpotLight>(placed(spot, turn).shape);
    EXPECT_LT(glm::length(turned.direction - DVec3(-1, 0, 0)), kTolerance);
    EXPECT_LT(glm::length(turned.position - DVec3(4, 0, 0)), 4.0 * kTolerance);
    const auto sun = std::get<DirectionalLight>(
        placed(DirectionalLight{}, turn.then(Transform::translation({7, 8, 9}))).shape);
    EXPECT_LT(glm::length(sun.direction - DVec3(-1, 0, 0)), kTolerance);
}

TEST(FlattenLights, AnAreaKeepsItsFrontAlsoWhenMirrored) {
    const AreaLight area;  // faces down
    const auto front = [](const AreaLight& light) {
        return glm::normalize(cross(light.edge_u, light.edge_v));
    };
    const AreaLight scaled =
        std::get<AreaLight>(placed(area, Transform::scaling(DVec3{2, 1, 3})).shape);
    EXPECT_EQ(front(scaled), DVec3(0, -1, 0));
    EXPECT_EQ(glm::length(cross(scaled.edge_u, scaled.edge_v)), 6.0);
    const AreaLight mirrored =
        std::get<AreaLight>(placed(area, Transform::scaling(DVec3{-1, 1, 1})).shape);
    EXPECT_EQ(front(mirrored), DVec3(0, -1, 0));
    EXPECT_EQ(mirrored.corner + 0.5 * (mirrored.edge_u + mirrored.edge_v), DVec3(0.0));
    const AreaLight upside_down =
        std::get<AreaLight>(placed(area, Transform::scaling(DVec3{1, -1, 1})).shape);
    EXPECT_EQ(front(upside_down), DVec3(0, 1, 0));
}

TEST(FlattenLights, AnEnvironmentKnowsTheWayBack) {
    const auto sky =
        std::get<EnvironmentLight>(placed(EnvironmentLight{}, Transform::rotation_y(90.0)).shape);
    EXPECT_LT(glm::length(sky.light_from_world * DVec3(-1, 0, 0) - DVec3(0, 0, -1)), kTolerance);
}

TEST(FlattenLights, InstancesAndGroupsOfLightsAlonePlaceEach) {
    SceneMaker maker;
    const NodeId lamp = add_light(maker, PointLight{}, {Transform::translation({0, 1, 0})});
    const NodeId pair =
        maker.add_group({lamp, maker.add_instance(lamp, {Transform::translation({1, 0, 0})})});
    maker.place(pair);
    NodeSettings below{Transform::translation({0, 0, 5})};
    below.visible = false;
    below.casts_shadow = false;  // of what is below it; the light's own shadows stay
    maker.place(maker.add_instance(pair, below));
    const World world = maker.flatten_cleanly();
    ASSERT_EQ(world.lights.size(), 4u);
    const auto at = [&](std::size_t i) {
        return std::get<PointLight>(world.lights[i].light.shape).position;
    };
    EXPECT_EQ(at(0), DVec3(0, 1, 0));
    EXPECT_EQ(at(1), DVec3(1, 1, 0));
    EXPECT_EQ(at(2), DVec3(0, 1, 5));
    EXPECT_EQ(at(3), DVec3(1, 1, 5));
    EXPECT_TRUE(world.lights[1].visible);
    EXPECT_FALSE(world.lights[3].visible);
    EXPECT_TRUE(world.lights[3].casts_shadow);
    EXPECT_EQ(world.lights[3].node_id, lamp);
}

TEST(FlattenLights, TheLimitCountsInstancesWithoutMakingThem) {
    SceneMaker maker;
    NodeId group = add_light(maker, PointLight{});
    for (int i = 0; i < 3; ++i) {
        group = maker.add_group({group, maker.add_instance(group)});
    }
    maker.place(group);  // 8 lights
    Diagnostics diagnostics;
    EXPECT_TRUE(flatten(maker.scene, {.lights = 9}, diagnostics));
    EXPECT_TRUE(flatten(maker.scene, {.lights = 8}, diagnostics));
    const Diagnostic error = expect_refused(maker.scene, {.lights = 7});
    EXPECT_EQ(error.code, Code::E0513);
    EXPECT_EQ(error.message, "the scene has 8 lights, more than the limit of 7 (`--max-lights`)");
    for (int i = 0; i < 100; ++i) {
        group = maker.add_group({group, maker.add_instance(group)});
    }
    maker.scene.groups[0].children = {group};
    EXPECT_EQ(expect_refused(maker.scene).code, Code::E0513);
}

TEST(FlattenLights, OneEnvironmentInAllHoweverItIsPlaced) {
    SceneMaker maker;
    const NodeId sky = add_light(maker, EnvironmentLight{});
    maker.place(sky);
    maker.flatten_cleanly();
    maker.place(maker.add_group({maker.add_instance(sky)}));
    EXPECT_EQ(expect_refused(maker.scene).code, Code::E0405);
}

TEST(FlattenLights, WhatTheWorldDoesNotHoldIsRefused) {
    SceneMaker far;
    far.place(add_light(far, PointLight{}, {Transform::translation({0, 1e19, 0})}));
    EXPECT_EQ(expect_refused(far.scene).code, Code::E0304);
    SceneMaker flat;
    flat.place(add_light(flat, AreaLight{}, {Transform::scaling(1e-30)}));
    EXPECT_EQ(expect_refused(flat.scene).code, Code::E0310);
}

}  // namespace
}  // namespace lray::scene
