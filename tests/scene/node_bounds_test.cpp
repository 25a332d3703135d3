// Boxes around nodes: against closed forms, and against points sampled on the shapes.
#include "scene/node_bounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "tests/scene/scene_maker.h"

namespace lray::scene {
namespace {

constexpr std::uint64_t kPlenty = 1'000'000;

void expect_box(const NodeBounds& bounds, DVec3 min, DVec3 max, double tolerance = 1e-12) {
    ASSERT_EQ(bounds.outcome, NodeBounds::Outcome::box);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(bounds.min[axis], min[axis], tolerance) << axis;
        EXPECT_NEAR(bounds.max[axis], max[axis], tolerance) << axis;
    }
}

NodeSettings with(const Transform& transform) {
    NodeSettings settings;
    settings.transform = transform;
    return settings;
}

/// Turns, shears, mirrors and moves.
Transform skewed() {
    return Transform::affine(
        DMat3{DVec3{1.0, 0.3, -0.2}, DVec3{0.5, -2.0, 0.1}, DVec3{-0.7, 0.4, 1.5}},
        DVec3{3.0, -4.0, 5.0});
}

TEST(NodeBounds, OfPlainShapesAreExact) {
    SceneMaker maker;
    expect_box(node_bounds(maker.scene, maker.add(SphereShape{{1, 2, 3}, 2}), kPlenty), {-1, 0, 1},
               {3, 4, 5}, 0);
    expect_box(node_bounds(maker.scene, maker.add(BoxShape{{-1, 0, 2}, {3, 1, 2.5}}), kPlenty),
               {-1, 0, 2}, {3, 1, 2.5}, 0);
    expect_box(node_bounds(maker.scene, maker.add(RectangleShape{}), kPlenty), {-0.5, 0, -0.5},
               {0.5, 0, 0.5}, 0);
    expect_box(
        node_bounds(maker.scene, maker.add(CylinderShape{{0, 0, 0}, {0, 2, 0}, 1, 0.25}), kPlenty),
        {-1, 0, -1}, {1, 2, 1}, 0);
    expect_box(node_bounds(maker.scene, maker.add(DiskShape{{0, 1, 0}, {0, 3, 0}, 2}), kPlenty),
               {-2, 1, -2}, {2, 1, 2}, 0);
    TriangleShape triangle;
    triangle.b = {1, 5, 0};
    triangle.c = {0, 2, -3};
    expect_box(node_bounds(maker.scene, maker.add(triangle), kPlenty), {0, 0, -3}, {1, 5, 0}, 0);
}

TEST(NodeBounds, OfATurnedSphereAreNoLarger) {
    SceneMaker maker;
    const NodeId ball = maker.add(SphereShape{}, with(Transform::rotation({1, 2, 3}, 40)));
    expect_box(node_bounds(maker.scene, ball, kPlenty), DVec3{-1}, DVec3{1});
}

TEST(NodeBounds, OfASlantedConeFollowItsRims) {
    SceneMaker maker;
    const double slant = 1.0 / std::numbers::sqrt2;  // of the disks of an axis at 45 degrees
    const NodeId cone = maker.add(CylinderShape{{0, 0, 0}, {3, 3, 0}, 1, 0});
    expect_box(node_bounds(maker.scene, cone, kPlenty), {-slant, -slant, -1}, {3, 3, 1});
}

/// Points of the surface at u and v in [0, 1).
template <class Shape, class Surface>
void expect_tight(const Shape& shape, Surface surface) {
    SceneMaker maker;
    const NodeId id = maker.add(shape, with(skewed()));
    const NodeBounds bounds = node_bounds(maker.scene, id, kPlenty);
    DVec3 min{std::numeric_limits<double>::infinity()};
    DVec3 max{-std::numeric_limits<double>::infinity()};
    constexpr int kCount = 1000;
    for (int i = 0; i <= kCount; ++i) {
        for (int k = 0; k <= kCount; ++k) {
            const DVec3 p = skewed().point(surface(double{1} * i / kCount, double{1} * k / kCount));
            min = glm::min(min, p);
            max = glm::max(max, p);
        }
    }
    expect_box(bounds, min, max, 1e-4);
    for (int axis = 0; axis < 3; ++axis) {  // nothing sticks out
        EXPECT_LE(bounds.min[axis], min[axis] + 1e-12);
        EXPECT_GE(bounds.max[axis], max[axis] - 1e-12);
    }
}

TEST(NodeBounds, OfSkewedShapesAreTight) {
    constexpr double kTurn = 2 * std::numbers::pi;
    expect_tight(SphereShape{{1, 2, 3}, 2}, [](double u, double v) {
        const double ring = std::sin(v * kTurn / 2);
        return DVec3{1, 2, 3} + 2.0 * DVec3{ring * std::cos(u * kTurn), std::cos(v * kTurn / 2),
                                            ring * std::sin(u * kTurn)};
    });
    expect_tight(CylinderShape{{0, 1, 0}, {0, 3, 0}, 1, 0.5}, [](double u, double v) {
        const double radius = 1.0 - 0.5 * v;
        return DVec3{radius * std::cos(u * kTurn), 1 + 2 * v, radius * std::sin(u * kTurn)};
    });
    expect_tight(DiskShape{{0, 0, 1}, {1, 0, 0}, 3}, [](double u, double v) {
        return DVec3{0, 3 * v * std::cos(u * kTurn), 1 + 3 * v * std::sin(u * kTurn)};
    });
    expect_tight(RectangleShape{}, [](double u, double v) { return DVec3{u - 0.5, 0, v - 0.5}; });
    expect_tight(BoxShape{{0, 0, 0}, {1, 2, 0}}, [](double u, double v) {
        return DVec3{u, 2 * v, 0};
    });
}

Mesh tetrahedron() {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {100, 100, 100}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.parts = {{"flat", 0, 1}, {"upright", 1, 1}};
    index_parts(mesh);
    return mesh;
}

TEST(NodeBounds, OfMeshesAreThoseOfTheirTriangles) {
    SceneMaker maker;
    const MeshId mesh = maker.add_mesh(tetrahedron());
    expect_box(node_bounds(maker.scene, maker.add(MeshUse{mesh}), kPlenty), {0, 0, 0}, {1, 2, 3},
               0);
    expect_box(node_bounds(maker.scene, maker.add(MeshUse{mesh, 0}), kPlenty), {0, 0, 0}, {1, 2, 0},
               0);
    MeshUse z_up{mesh};
    z_up.z_is_up = true;
    expect_box(node_bounds(maker.scene, maker.add(z_up), kPlenty), {0, 0, -2}, {1, 3, 0}, 0);
    expect_box(node_bounds(maker.scene, maker.add(z_up, with(Transform::rotation_x(90))), kPlenty),
               {0, 0, 0}, {1, 2, 3}, 1e-15);
}

TEST(NodeBounds, OfTurnedGroupsAreNotBoxesOfBoxes) {
    SceneMaker maker;
    // A square turned by 45 degrees twice is a square again.
    const NodeId square = maker.add(BoxShape{DVec3{-1}, DVec3{1}}, with(Transform::rotation_y(45)));
    const NodeId group = maker.add_group({square}, with(Transform::rotation_y(45)));
    expect_box(node_bounds(maker.scene, group, kPlenty), DVec3{-1}, DVec3{1});
    const NodeId moved = maker.add_instance(group, with(Transform::translation(DVec3{10, 0, 0})));
    expect_box(node_bounds(maker.scene, moved, kPlenty), {9, -1, -1}, {11, 1, 1});
}

TEST(NodeBounds, AddStepsOfGroupsFromTheInside) {
    SceneMaker maker;
    const Transform inner = Transform::scaling(2).then(Transform::translation(DVec3{1, 0, 0}));
    const Transform outer = Transform::rotation_z(90).then(Transform::translation(DVec3{0, 0, 5}));
    const NodeId ball = maker.add(SphereShape{}, with(inner));  // x from -1 to 3
    const NodeId empty = maker.add_group({}, with(outer));
    const NodeId group = maker.add_group({empty, ball}, with(outer));  // y from -1 to 3
    expect_box(node_bounds(maker.scene, group, kPlenty), {-2, -1, 3}, {2, 3, 7});
}

TEST(NodeBounds, AgreeWithTheSceneLaidFlat) {
    std::mt19937 random(20);
    std::uniform_real_distribution<double> any(-2.0, 2.0);
    SceneMaker maker;
    std::vector<NodeId> nodes;
    std::vector<DVec3> expected_corners;
    for (int i = 0; i < 50; ++i) {
        const auto vector = [&] { return DVec3{any(random), any(random), any(random)}; };
        const DVec3 axis = vector();
        const Transform a = Transform::rotation(axis, 90 * any(random));
        const Transform b = Transform::translation(vector()).then(Transform::scaling(vector()));
        TriangleShape triangle;
        triangle.a = vector();
        triangle.b = vector();
        triangle.c = vector();
        nodes.push_back(maker.add_group({maker.add(triangle, with(a))}, with(b)));
        for (const DVec3 corner : {triangle.a, triangle.b, triangle.c}) {
            expected_corners.push_back(skewed().point(b.point(a.point(corner))));
        }
    }
    DVec3 min = expected_corners[0];
    DVec3 max = expected_corners[0];
    for (const DVec3 corner : expected_corners) {
        min = glm::min(min, corner);
        max = glm::max(max, corner);
    }
    const NodeId all = maker.add_group(nodes, with(skewed()));
    expect_box(node_bounds(maker.scene, all, kPlenty), min, max);
}

TEST(NodeBounds, OfNothingAndOfPlanesAreNone) {
    SceneMaker maker;
    const NodeId empty = maker.add_group({});
    EXPECT_EQ(node_bounds(maker.scene, empty, kPlenty).outcome, NodeBounds::Outcome::empty);
    const NodeId holder = maker.add_group({empty, maker.add_instance(empty)});
    EXPECT_EQ(node_bounds(maker.scene, holder, kPlenty).outcome, NodeBounds::Outcome::empty);
    const NodeId plane = maker.add(PlaneShape{});
    const NodeId group = maker.add_group({maker.add(SphereShape{}), plane});
    EXPECT_EQ(node_bounds(maker.scene, group, kPlenty).outcome, NodeBounds::Outcome::infinite);
}

TEST(NodeBounds, TooLargeForNumbersAreInfinite) {
    SceneMaker maker;
    NodeId id = maker.add(SphereShape{DVec3{0.0}, 1e200});
    id = maker.add_group({id}, with(Transform::scaling(1e200)));
    EXPECT_EQ(node_bounds(maker.scene, id, kPlenty).outcome, NodeBounds::Outcome::infinite);
}

TEST(NodeBounds, SharedNodesAreMeasuredOnce) {
    SceneMaker maker;
    NodeId id = maker.add(SphereShape{});
    for (int i = 0; i < 200; ++i) {  // 2^200 spheres
        const NodeId left = maker.add_instance(id, with(Transform::translation(DVec3{1, 0, 0})));
        const NodeId right = maker.add_instance(
            id, with(Transform::rotation_y(90).then(Transform::scaling(DVec3{1, -1, 0.5}))));
        id = maker.add_group({left, right});
    }
    const NodeBounds bounds = node_bounds(maker.scene, id, kPlenty);
    EXPECT_EQ(bounds.outcome, NodeBounds::Outcome::box);
    EXPECT_EQ(bounds.max.x, 201.0);
    EXPECT_LT(bounds.work, 10'000u);
}

TEST(NodeBounds, ManyTurnsOfASharedNodeAreBounded) {
    SceneMaker maker;
    NodeId id = maker.add(SphereShape{{1, 0, 0}, 1});
    for (int i = 0; i < 40; ++i) {
        const NodeId turned = maker.add_instance(id, with(Transform::rotation({1, 2, 3}, 7 + i)));
        id = maker.add_group({id, turned});
    }
    const NodeBounds bounds = node_bounds(maker.scene, id, 10'000);
    EXPECT_EQ(bounds.outcome, NodeBounds::Outcome::too_large);
    EXPECT_EQ(bounds.work, 10'000u);
}

TEST(NodeBounds, WorkIsAllowedExactly) {
    SceneMaker maker;
    const NodeId id = maker.add_group({maker.add(SphereShape{}), maker.add(BoxShape{})});
    const std::uint64_t work = node_bounds(maker.scene, id, kPlenty).work;
    EXPECT_EQ(work, 9u);
    EXPECT_EQ(node_bounds(maker.scene, id, work).outcome, NodeBounds::Outcome::box);
    EXPECT_EQ(node_bounds(maker.scene, id, work - 1).outcome, NodeBounds::Outcome::too_large);
}

TEST(NodeBounds, DeepGraphsNeedNoStack) {
    SceneMaker maker;
    NodeId id = maker.add(SphereShape{});
    for (int i = 0; i < 100'000; ++i) id = maker.add_group({id});
    expect_box(node_bounds(maker.scene, id, kPlenty), DVec3{-1}, DVec3{1}, 0);
}

}  // namespace
}  // namespace lray::scene
