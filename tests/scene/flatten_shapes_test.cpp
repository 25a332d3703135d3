// Each shape becomes the right primitive in the right place, outward side kept.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/scene/scene_maker.h"

namespace lray::scene {
namespace {

const Transform kStretch = Transform::scaling(DVec3{1, 2, 3});
const Transform kMirror = Transform::scaling(DVec3{-1, 1, 1});

/// Where the frame puts a point of the canonical shape.
DVec3 place(const AffineFrame& frame, DVec3 q) {
    return glm::inverse(DMat3{frame.object_from_world}) * q + DVec3{frame.origin};
}

void expect_near(DVec3 actual, DVec3 expected, double tolerance = 1e-6) {
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(actual[axis], expected[axis], tolerance) << "axis " << axis;
    }
}

template <class Shape>
World flatten_one(const Shape& shape, const Transform& transform = {}) {
    SceneMaker maker;
    maker.place(maker.add(shape, {.transform = transform}));
    return maker.flatten_cleanly();
}

TEST(FlattenSphere, SimilarityKeepsASphere) {
    const World world =
        flatten_one(SphereShape{{1, 0, 0}, 0.5}, Transform::scaling(-4.0)
                                                     .then(Transform::rotation_y(90))
                                                     .then(Transform::translation({0, 7, 0})));
    ASSERT_EQ(world.spheres.size(), 1u);
    EXPECT_TRUE(world.ellipsoids.empty());
    EXPECT_EQ(world.spheres[0].radius, 2.0f);
    EXPECT_EQ(world.spheres[0].center, (Vec3{0, 7, 4}));
}

TEST(FlattenSphere, AnyOtherMapMakesAnEllipsoid) {
    const World world = flatten_one(SphereShape{{1, 1, 1}, 2}, kStretch);
    EXPECT_TRUE(world.spheres.empty());
    ASSERT_EQ(world.ellipsoids.size(), 1u);
    expect_near(place(world.ellipsoids[0].frame, {0, 0, 0}), {1, 2, 3});
    expect_near(place(world.ellipsoids[0].frame, {0, 1, 0}), {1, 6, 3});
    // By the kinds of its steps, not by its numbers.
    EXPECT_EQ(flatten_one(SphereShape{}, Transform::scaling(DVec3{2, 2, 2})).ellipsoids.size(), 1u);
}

TEST(FlattenRectangle, CornersRunByUAndV) {
    const World world = flatten_one(RectangleShape{}, kStretch);
    ASSERT_EQ(world.rectangles.size(), 1u);
    const auto& [p00, p10, p11, p01] = world.rectangles[0].corners;
    EXPECT_EQ(p00, (Vec3{-0.5f, 0, 1.5f}));
    EXPECT_EQ(p10, (Vec3{0.5f, 0, 1.5f}));
    EXPECT_EQ(p11, (Vec3{0.5f, 0, -1.5f}));
    EXPECT_EQ(p01, (Vec3{-0.5f, 0, -1.5f}));
    EXPECT_FALSE(world.rectangles[0].is_mirrored);
    EXPECT_TRUE(flatten_one(RectangleShape{}, kMirror).rectangles[0].is_mirrored);
}

class FlattenTriangle : public testing::Test {
 protected:
    World flatten_with_attributes(const Transform& transform) {
        SceneMaker maker;
        const DVec3 up{0, 0, 2};
        maker.scene.triangle_attributes.push_back(
            {std::array{up, DVec3{0, 1, 1}, DVec3{1, 0, 1}},
             std::array{DVec2{0, 0}, DVec2{1, 0}, DVec2{0, 1}}});
        maker.place(maker.add(TriangleShape{{9, 9, 9}, {8, 9, 9}, {9, 8, 9}}));
        maker.place(
            maker.add(TriangleShape{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0}, {.transform = transform}));
        maker.place(maker.add(TriangleShape{{7, 9, 9}, {8, 9, 9}, {9, 8, 9}}));
        return maker.flatten_cleanly();
    }
    static DVec3 normal(const World& world, std::size_t i) {
        const auto& [a, b, c] = world.triangles[i].vertices;
        return glm::normalize(cross(DVec3{world.vertices[b]} - DVec3{world.vertices[a]},
                                    DVec3{world.vertices[c]} - DVec3{world.vertices[a]}));
    }
};

TEST_F(FlattenTriangle, KeepsOrderNormalsAndUvs) {
    const World world = flatten_with_attributes({});
    ASSERT_EQ(world.triangles.size(), 3u);
    expect_near(normal(world, 1), {0, 0, 1});
    ASSERT_EQ(world.triangle_normals.size(), 3u);
    ASSERT_EQ(world.triangle_uvs.size(), 3u);
    EXPECT_EQ(world.triangle_normals[0][0], Mesh::kNone);
    EXPECT_EQ(world.triangle_normals[2][0], Mesh::kNone);
    EXPECT_EQ(world.triangle_uvs[2][0], Mesh::kNone);
    const auto& n = world.triangle_normals[1];
    EXPECT_EQ(world.normals[n[0]], (Vec3{0, 0, 1}));
    expect_near(DVec3{world.normals[n[1]]}, {0, std::sqrt(0.5), std::sqrt(0.5)});
    EXPECT_EQ(world.uvs[world.triangle_uvs[1][1]], (Vec2{1, 0}));
}

TEST_F(FlattenTriangle, MirroringSwapsVerticesNormalsAndUvsSoThatOutwardStays) {
    const World world = flatten_with_attributes(kMirror);
    expect_near(normal(world, 1), {0, 0, 1});
    const auto& v = world.triangles[1].vertices;
    EXPECT_EQ(world.vertices[v[1]], (Vec3{0, 1, 0}));
    EXPECT_EQ(world.vertices[v[2]], (Vec3{-1, 0, 0}));
    const auto& n = world.triangle_normals[1];
    expect_near(DVec3{world.normals[n[2]]}, {0, std::sqrt(0.5), std::sqrt(0.5)});
    expect_near(DVec3{world.normals[n[1]]}, {-std::sqrt(0.5), 0, std::sqrt(0.5)});
    EXPECT_EQ(world.uvs[world.triangle_uvs[1][2]], (Vec2{1, 0}));
    EXPECT_EQ(world.uvs[world.triangle_uvs[1][1]], (Vec2{0, 1}));
}

TEST_F(FlattenTriangle, NormalsGoByTheInverseTranspose) {
    const World world = flatten_with_attributes(kStretch);
    // (0, 1, 1) under a scale by (1, 2, 3).
    const double length = std::hypot(1.0 / 2.0, 1.0 / 3.0);
    expect_near(DVec3{world.normals[world.triangle_normals[1][1]]},
                {0, 0.5 / length, 1.0 / 3.0 / length});
}

TEST_F(FlattenTriangle, WithoutAreaIsDroppedWithAWarning) {
    SceneMaker maker;
    const NodeId id = maker.add(TriangleShape{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}});
    maker.place(id);
    Diagnostics diagnostics;
    const auto world = flatten(maker.scene, {}, diagnostics);
    ASSERT_TRUE(world.has_value());
    EXPECT_EQ(world->triangles.size(), 0u);
    ASSERT_EQ(diagnostics.warning_count(), 1u);
    EXPECT_EQ(diagnostics.sorted()[0]->code, Code::W1201);
    EXPECT_EQ(diagnostics.sorted()[0]->span, maker.scene.node(id).span);
    EXPECT_EQ(diagnostics.sorted()[0]->message, "this triangle has no area");
}

TEST(FlattenCylinder, FrameRunsFromTheWiderEnd) {
    for (const bool is_turned : {false, true}) {
        CylinderShape shape{{1, 2, 3}, {4, 2, 3}, 2, 1, false};
        if (is_turned) shape = {{4, 2, 3}, {1, 2, 3}, 1, 2, false};
        const World world = flatten_one(shape, Transform::translation({0, 0, 1}));
        ASSERT_EQ(world.cylinders.size(), 1u);
        const Cylinder& cylinder = world.cylinders[0];
        EXPECT_EQ(cylinder.top_radius, 0.5f);
        EXPECT_FALSE(cylinder.caps);
        expect_near(place(cylinder.frame, {0, 0, 0}), {1, 2, 4});
        expect_near(place(cylinder.frame, {0, 1, 0}), {4, 2, 4});
        for (const DVec3 q : {DVec3{1, 0, 0}, DVec3{0, 0, 1}}) {
            const DVec3 rim = place(cylinder.frame, q) - DVec3{1, 2, 4};
            EXPECT_NEAR(glm::length(rim), 2.0, 1e-6);
            EXPECT_NEAR(rim.x, 0.0, 1e-6);
        }
    }
}

TEST(FlattenCylinder, AxesNearMinusYKeepTheirFrame) {
    for (const double tilt : {0.0, 1e-15, 1e-8, 1e-4}) {
        const World world = flatten_one(CylinderShape{{0, 0, 0}, {tilt, -1, 0}, 1, 1, true});
        ASSERT_EQ(world.cylinders.size(), 1u);
        const AffineFrame& frame = world.cylinders[0].frame;
        expect_near(place(frame, {0, 1, 0}), {tilt, -1, 0});
        const DVec3 x = place(frame, {1, 0, 0});
        const DVec3 z = place(frame, {0, 0, 1});
        EXPECT_NEAR(glm::length(x), 1.0, 1e-6);
        EXPECT_NEAR(glm::length(z), 1.0, 1e-6);
        EXPECT_NEAR(dot(x, z), 0.0, 1e-6);
        EXPECT_NEAR(dot(x, DVec3{tilt, -1, 0}), 0.0, 1e-6);
        EXPECT_NEAR(dot(z, DVec3{tilt, -1, 0}), 0.0, 1e-6);
        if (tilt == 0.0) expect_near(x, {1, 0, 0});  // half a turn about X
    }
}

TEST(FlattenDisk, RimNormalAndHole) {
    const World world = flatten_one(DiskShape{{1, 1, 1}, {0, 0, 5}, 2, 0.5}, kMirror);
    ASSERT_EQ(world.disks.size(), 1u);
    const Disk& disk = world.disks[0];
    EXPECT_EQ(disk.hole, 0.25f);
    const DVec3 center{-1, 1, 1};
    expect_near(place(disk.frame, {0, 0, 0}), center);
    // +Y of the frame is on the side of the normal.
    EXPECT_GT(place(disk.frame, {0, 1, 0}).z, 1.0);
    for (const DVec3 q : {DVec3{1, 0, 0}, DVec3{0, 0, 1}, DVec3{-0.6, 0, 0.8}}) {
        const DVec3 rim = place(disk.frame, q) - center;
        EXPECT_NEAR(glm::length(rim), 2.0, 1e-6);
        EXPECT_NEAR(rim.z, 0.0, 1e-6);
    }
}

TEST(FlattenBox, CornersAreThoseOfTheShape) {
    const World world = flatten_one(BoxShape{{0, 1, 2}, {1, 3, 5}}, kStretch);
    ASSERT_EQ(world.boxes.size(), 1u);
    expect_near(place(world.boxes[0].frame, {-1, -1, -1}), {0, 2, 6});
    expect_near(place(world.boxes[0].frame, {1, 1, 1}), {1, 6, 15});
}

TEST(FlattenPlane, NormalIsUnitAndGoesByTheInverseTranspose) {
    const World world = flatten_one(PlaneShape{{1, 1, 1}, {0, 2, 2}}, kStretch);
    ASSERT_EQ(world.planes.size(), 1u);
    EXPECT_EQ(world.planes[0].point, (Vec3{1, 2, 3}));
    const double length = std::hypot(1.0 / 2.0, 1.0 / 3.0);
    expect_near(DVec3{world.planes[0].normal}, {0, 0.5 / length, 1.0 / 3.0 / length});
}

TEST(FlattenTorus, FitsIntoTheUnitSphereOfItsFrame) {
    const World world = flatten_one(TorusShape{3, 1}, kStretch);
    ASSERT_EQ(world.tori.size(), 1u);
    EXPECT_EQ(world.tori[0].tube, 0.25f);
    EXPECT_EQ(world.tori[0].radius(), 0.75);
    expect_near(place(world.tori[0].frame, {0, 0, 0}), {0, 0, 0});
    expect_near(place(world.tori[0].frame, {1, 0, 0}), {4, 0, 0});
    expect_near(place(world.tori[0].frame, {0, 0.25, 0.75}), {0, 2, 9}, 1e-5);
    // A tube that overlaps itself.
    EXPECT_EQ(flatten_one(TorusShape{1, 3}).tori[0].tube, 0.75f);
}

class FlattenMesh : public testing::Test {
 protected:
    FlattenMesh() {
        mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
        mesh.normals = {{0, 0, 1}, {0, 1, 0}};
        mesh.normal_indices = {{Mesh::kNone, Mesh::kNone, Mesh::kNone}, {0, 1, 1}};
        mesh.uvs = {{0, 0}, {1, 0}, {1, 1}};
        mesh.uv_indices = {{0, 1, 2}, {Mesh::kNone, Mesh::kNone, Mesh::kNone}};
        mesh.parts = {{"lower", 0, 1}, {"upper", 1, 1}};
    }
    World flatten_mesh(MeshUse use, const Transform& transform = {}) {
        SceneMaker maker;
        use.mesh_id = maker.add_mesh(mesh);
        maker.place(maker.add(use, {.transform = transform}));
        return maker.flatten_cleanly();
    }
    Mesh mesh{};
};

TEST_F(FlattenMesh, SharesVerticesAndMakesOneObject) {
    const World world = flatten_mesh({}, Transform::translation({0, 0, 5}));
    EXPECT_EQ(world.vertices.size(), 4u);
    ASSERT_EQ(world.triangles.size(), 2u);
    EXPECT_EQ(world.objects.size(), 1u);
    EXPECT_EQ(world.object_of({PrimitiveKind::triangle, 1}), ObjectId{0});
    EXPECT_EQ(world.vertices[world.triangles[1].vertices[2]], (Vec3{0, 1, 5}));
    ASSERT_EQ(world.triangle_normals.size(), 2u);
    EXPECT_EQ(world.triangle_normals[0][0], Mesh::kNone);
    EXPECT_EQ(world.normals[world.triangle_normals[1][1]], (Vec3{0, 1, 0}));
    ASSERT_EQ(world.triangle_uvs.size(), 2u);
    EXPECT_EQ(world.uvs[world.triangle_uvs[0][2]], (Vec2{1, 1}));
    EXPECT_EQ(world.triangle_uvs[1][0], Mesh::kNone);
}

TEST_F(FlattenMesh, PartWhoseNameReturnsTakesAllOfThem) {
    mesh.triangles.push_back({1, 2, 3});
    mesh.normal_indices.clear();
    mesh.uv_indices.clear();
    mesh.parts = {{"a", 0, 1}, {"b", 1, 1}, {"a", 2, 1}};
    MeshUse use;
    use.part = 0;
    const World world = flatten_mesh(use);
    ASSERT_EQ(world.triangles.size(), 2u);
    EXPECT_EQ(world.objects.size(), 1u);
    EXPECT_EQ(world.vertices[world.triangles[1].vertices[0]], (Vec3{1, 0, 0}));
    EXPECT_EQ(world.vertices[world.triangles[1].vertices[2]], (Vec3{0, 1, 0}));
}

TEST_F(FlattenMesh, PartTakesItsTrianglesOnly) {
    MeshUse use;
    use.part = 1;
    const World world = flatten_mesh(use);
    ASSERT_EQ(world.triangles.size(), 1u);
    const auto& [a, b, c] = world.triangles[0].vertices;
    EXPECT_EQ(world.vertices[a], (Vec3{0, 0, 0}));
    EXPECT_EQ(world.vertices[b], (Vec3{1, 1, 0}));
    EXPECT_EQ(world.vertices[c], (Vec3{0, 1, 0}));
    EXPECT_EQ(world.normals[world.triangle_normals[0][0]], (Vec3{0, 0, 1}));
}

TEST_F(FlattenMesh, ZUpIsTurnedToYUp) {
    MeshUse use;
    use.z_is_up = true;
    const World world = flatten_mesh(use);
    EXPECT_EQ(world.vertices[3], (Vec3{0, 0, -1}));  // y becomes -z
    EXPECT_EQ(world.normals[0], (Vec3{0, 1, 0}));    // z becomes y
}

TEST_F(FlattenMesh, MirroringSwapsEveryTriple) {
    const World world = flatten_mesh({}, kMirror);
    const auto& [a, b, c] = world.triangles[1].vertices;
    EXPECT_EQ(world.vertices[a], (Vec3{0, 0, 0}));
    EXPECT_EQ(world.vertices[b], (Vec3{0, 1, 0}));
    EXPECT_EQ(world.vertices[c], (Vec3{-1, 1, 0}));
    EXPECT_EQ(world.uvs[world.triangle_uvs[0][1]], (Vec2{1, 1}));
    EXPECT_EQ(world.normals[world.triangle_normals[1][0]], (Vec3{0, 0, 1}));
}

TEST_F(FlattenMesh, FacesWithoutAreaAreDroppedAndCounted) {
    mesh.triangles = {{0, 1, 2}, {1, 1, 2}, {0, 2, 3}, {3, 3, 3}};
    mesh.normal_indices = {{0, 0, 0}, {0, 0, 0}, {1, 1, 1}, {0, 0, 0}};
    mesh.uv_indices.clear();
    mesh.parts.clear();
    SceneMaker maker;
    const NodeId id = maker.add(MeshUse{maker.add_mesh(mesh)});
    maker.place(id);
    Diagnostics diagnostics;
    const auto world = flatten(maker.scene, {}, diagnostics);
    ASSERT_TRUE(world.has_value());
    ASSERT_EQ(world->triangles.size(), 2u);
    EXPECT_EQ(world->normals[world->triangle_normals[1][0]], (Vec3{0, 1, 0}));
    ASSERT_EQ(diagnostics.warning_count(), 1u);
    EXPECT_EQ(diagnostics.sorted()[0]->code, Code::W1702);
    EXPECT_EQ(diagnostics.sorted()[0]->span, maker.scene.node(id).span);
    EXPECT_EQ(diagnostics.sorted()[0]->message,
              "2 of the 4 faces of this mesh have no area and are dropped");
}

template <class Shape>
Diagnostic refuse_one(const Shape& shape, const Transform& transform = {}) {
    SceneMaker maker;
    const NodeId id = maker.add(shape, {.transform = transform});
    maker.place(id);
    const Diagnostic error = expect_refused(maker.scene);
    EXPECT_EQ(error.span, maker.scene.node(id).span);
    return error;
}

TEST(FlattenRefuses, CoordinatesBeyondTheWorld) {
    const Transform far = Transform::translation({0, 0, 2e18});
    EXPECT_EQ(refuse_one(SphereShape{}, far).message,
              "this sphere reaches to 2e+18 in the world; coordinates end at 1e+18");
    EXPECT_EQ(refuse_one(SphereShape{}, far).code, Code::E0304);
    EXPECT_EQ(refuse_one(RectangleShape{}, far).code, Code::E0304);
    EXPECT_EQ(refuse_one(TriangleShape{{0, 0, 0}, {1, 0, 0}, {0, 1e300, 0}}).code, Code::E0304);
    EXPECT_EQ(refuse_one(CylinderShape{}, far).code, Code::E0304);
    EXPECT_EQ(refuse_one(DiskShape{}, far).code, Code::E0304);
    EXPECT_EQ(refuse_one(BoxShape{}, far).code, Code::E0304);
    EXPECT_EQ(refuse_one(PlaneShape{}, far).code, Code::E0304);
    EXPECT_EQ(refuse_one(TorusShape{}, far).code, Code::E0304);
    EXPECT_EQ(refuse_one(TorusShape{1e308, 1e308}).code, Code::E0304);
}

TEST(FlattenRefuses, CoordinatesThatAreNotNumbers) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refuse_one(SphereShape{{0, nan, 0}, 1}).code, Code::E0304);
    EXPECT_EQ(refuse_one(TriangleShape{{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}).code, Code::E0304);
    EXPECT_EQ(refuse_one(BoxShape{{0, 0, 0}, {1, nan, 1}}).code, Code::E0304);
}

TEST(FlattenRefuses, SizesTooSmallForTheWorld) {
    EXPECT_EQ(refuse_one(SphereShape{{0, 0, 0}, 1e-30}).message,
              "the radius of this sphere is 1e-30 in the world; the least is 1e-18");
    EXPECT_EQ(refuse_one(BoxShape{}, Transform::scaling(DVec3{1, 1e-30, 1})).code, Code::E0304);
}

TEST(FlattenRefuses, WhatTransformsFlatten) {
    EXPECT_EQ(refuse_one(CylinderShape{{0, 0, 0}, {0, 0, 0}, 1, 1}).message,
              "the transform flattens this cylinder and cannot be inverted");
    EXPECT_EQ(refuse_one(CylinderShape{{0, 0, 0}, {0, 1, 0}, 0, 0}).code, Code::E0310);
    // Flat in a skew direction: float cannot hold the inverse.
    const Transform skew = Transform::rotation({1, 2, 3}, 40)
                               .then(Transform::scaling(DVec3{1, 1e-12, 1}))
                               .then(Transform::rotation({3, 1, 2}, 70));
    EXPECT_EQ(refuse_one(SphereShape{}, skew).code, Code::E0310);
}

TEST(FlattenAccepts, AllScalesThatFloatCanHold) {
    for (const double scale : {1e-15, 1e-6, 1.0, 1e6, 1e15}) {
        SceneMaker maker;
        const NodeSettings scaled{.transform = Transform::scaling(scale)};
        maker.place(maker.add(SphereShape{}, scaled));
        maker.place(maker.add(RectangleShape{}, scaled));
        maker.place(maker.add(TriangleShape{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, scaled));
        maker.place(maker.add(CylinderShape{}, scaled));
        maker.place(maker.add(DiskShape{}, scaled));
        maker.place(maker.add(BoxShape{}, scaled));
        maker.place(maker.add(PlaneShape{}, scaled));
        maker.place(maker.add(TorusShape{}, scaled));
        EXPECT_EQ(maker.flatten_cleanly().primitive_count(), 8u);
    }
}

}  // namespace
}  // namespace lray::scene
