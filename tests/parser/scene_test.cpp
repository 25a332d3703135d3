// Blocks to scenes: shapes, materials, transforms, groups, instances, cameras, settings, meshes.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/angle.h"
#include "tests/parser/loaded.h"

namespace lray::test {
namespace {

/// A scene that must be right.
scene::Scene right(std::string_view text, const std::vector<Companion>& companions = {}) {
    Loaded loaded = load_text(text, parser::LoadSettings{}, companions);
    EXPECT_FALSE(loaded.has_errors()) << text << "\n" << loaded.text();
    return loaded.scene ? std::move(*loaded.scene) : scene::Scene{};
}

const std::vector<scene::NodeId>& children(const scene::Scene& scene, scene::NodeId group) {
    const scene::Node& node = scene.node(group);
    EXPECT_EQ(node.kind, scene::NodeKind::group);
    return scene.groups[node.index].children;
}

const scene::Node& child(const scene::Scene& scene, std::size_t i) {
    return scene.node(children(scene, scene.root).at(i));
}

Transform transform_of(const scene::Scene& scene, const scene::Node& node) {
    return node.transform_id.is_none() ? Transform{} : scene.transforms[node.transform_id.index()];
}

void expect_same(const Transform& a, const Transform& b) {
    EXPECT_EQ(a.linear(), b.linear());
    EXPECT_EQ(a.offset(), b.offset());
    EXPECT_EQ(a.is_similarity(), b.is_similarity());
}

TEST(Shapes, DefaultsAreThoseOfTheScene) {
    const scene::Scene scene =
        right("sphere { }\nrectangle { }\ncylinder { }\ndisk { }\nbox { }\nplane { }\ntorus { }");
    EXPECT_EQ(scene.spheres[0].center, scene::SphereShape{}.center);
    EXPECT_EQ(scene.spheres[0].radius, scene::SphereShape{}.radius);
    EXPECT_EQ(scene.rectangles[0].corner, scene::RectangleShape{}.corner);
    EXPECT_EQ(scene.rectangles[0].edge_u, scene::RectangleShape{}.edge_u);
    EXPECT_EQ(scene.rectangles[0].edge_v, scene::RectangleShape{}.edge_v);
    EXPECT_EQ(scene.cylinders[0].to, scene::CylinderShape{}.to);
    EXPECT_EQ(scene.cylinders[0].radius, scene::CylinderShape{}.radius);
    EXPECT_EQ(scene.cylinders[0].radius_to, scene::CylinderShape{}.radius_to);
    EXPECT_EQ(scene.disks[0].normal, scene::DiskShape{}.normal);
    EXPECT_EQ(scene.disks[0].radius, scene::DiskShape{}.radius);
    EXPECT_EQ(scene.boxes[0].min, scene::BoxShape{}.min);
    EXPECT_EQ(scene.boxes[0].max, scene::BoxShape{}.max);
    EXPECT_EQ(scene.planes[0].normal, scene::PlaneShape{}.normal);
    EXPECT_EQ(scene.tori[0].radius, scene::TorusShape{}.radius);
    EXPECT_EQ(scene.tori[0].tube, scene::TorusShape{}.tube);
}

TEST(Shapes, TwoFormsOfOneRectangleAgree) {
    const scene::Scene scene = right(
        "rectangle { center: [1, 2, 3], size: [4, 6] }\n"
        "rectangle { corner: [-1, 2, 6], edge_u: [4, 0, 0], edge_v: [0, 0, -6] }\n"
        "box { center: [1, 2, 3], size: [2, 4, 6] }\nbox { min: [0, 0, 0], max: [2, 4, 6] }");
    EXPECT_EQ(scene.rectangles[0].corner, scene.rectangles[1].corner);
    EXPECT_EQ(scene.rectangles[0].edge_u, scene.rectangles[1].edge_u);
    EXPECT_EQ(scene.rectangles[0].edge_v, scene.rectangles[1].edge_v);
    EXPECT_EQ(scene.boxes[0].min, scene.boxes[1].min);
    EXPECT_EQ(scene.boxes[0].max, scene.boxes[1].max);
}

TEST(Shapes, ARectangleFacesItsNormal) {
    for (const std::string normal :
         {"[0, 1, 0]", "[0, -1, 0]", "[1, 0, 0]", "[0, 0, -2]", "[1, 2, 3]", "[1e-9, -1, 0]"}) {
        const scene::Scene scene = right("rectangle { size: [2, 3], normal: " + normal +
                                         " }\ndisk { normal: " + normal + " }");
        const scene::RectangleShape& shape = scene.rectangles[0];
        const DVec3 facing = glm::normalize(cross(shape.edge_u, shape.edge_v));
        EXPECT_LT(glm::length(facing - scene.disks[0].normal), 1e-14) << normal;
        EXPECT_NEAR(glm::length(shape.edge_u), 2.0, 1e-14) << normal;
        EXPECT_NEAR(glm::length(shape.edge_v), 3.0, 1e-14) << normal;
        EXPECT_NEAR(dot(shape.edge_u, shape.edge_v), 0.0, 1e-14) << normal;
    }
}

TEST(Shapes, ATriangleKeepsItsCornersAndAttributes) {
    const scene::Scene scene = right(
        "triangle { a: [0, 0, 0], b: [1, 0, 0], c: [0, 1, 0]\n"
        "  uvs: [[0, 0], [1, 0], [0, 1]], normals: [[0, 0, 1], [0, 0, 2], [0, 1, 1]] }");
    ASSERT_EQ(scene.triangle_attributes.size(), 1u);
    EXPECT_EQ(scene.triangles[0].b, DVec3(1, 0, 0));
    EXPECT_EQ((*scene.triangle_attributes[0].uvs)[2], DVec2(0, 1));
    EXPECT_EQ((*scene.triangle_attributes[0].normals)[1], DVec3(0, 0, 2));
}

TEST(Transforms, StepsAreDoneInTheOrderWritten) {
    const scene::Scene scene = right(
        "box { scale: 2, rotate_y: 45, translate: [3, 0, 0] }\n"
        "box { translate: [3, 0, 0], rotate_y: 45 }\n"
        "box { rotate: [10, 20, 30] }\n"
        "box { transform: [scaling([1, 2, 3]), rotation([1, 1, 0], 30)] }\n"
        "box { rotate: rotation([0, 0, 1], 90, about: [1, 0, 0]) }\n"
        "box { matrix: [[1, 2, 0, 4], [0, 1, 0, 5], [0, 0, 1, 6], [0, 0, 0, 1]] }\n"
        "sphere { scale: -1, rotate_x: 1, rotate_z: 2 }");
    using T = Transform;
    const auto at = [&](std::size_t i) { return transform_of(scene, child(scene, i)); };
    expect_same(at(0), T::scaling(2).then(T::rotation_y(45)).then(T::translation({3, 0, 0})));
    expect_same(at(1), T::translation({3, 0, 0}).then(T::rotation_y(45)));
    expect_same(at(2), T::rotation_x(10).then(T::rotation_y(20)).then(T::rotation_z(30)));
    expect_same(at(3), T::scaling(DVec3{1, 2, 3}).then(T::rotation({1, 1, 0}, 30)));
    EXPECT_LT(glm::length(at(4).point({0, 0, 0}) - DVec3(1, -1, 0)), 1e-15);
    EXPECT_EQ(at(5).point({1, 1, 1}), DVec3(7, 6, 7));
    EXPECT_FALSE(at(5).is_similarity());
    expect_same(at(6), T::scaling(-1).then(T::rotation_x(1)).then(T::rotation_z(2)));
    EXPECT_TRUE(at(6).is_similarity());
}

TEST(Transforms, LookAtTurnsTheMinusZAxisToThePoint) {
    const scene::Scene scene = right(
        "group { translate: [1, 2, 3], look_at: [4, 6, 3], sphere { } }\n"
        "group { look_at: [0, 0, 5], sphere { } }");
    const Transform first = transform_of(scene, child(scene, 0));
    EXPECT_EQ(first.point(DVec3{0.0}), DVec3(1, 2, 3));
    EXPECT_LT(glm::length(first.vector({0, 0, -1}) - DVec3(0.6, 0.8, 0)), 1e-15);
    EXPECT_GT(first.vector({0, 1, 0}).y, 0.0);
    const Transform second = transform_of(scene, child(scene, 1));
    EXPECT_LT(glm::length(second.vector({0, 0, -1}) - DVec3(0, 0, 1)), 1e-15);
}

TEST(Materials, FieldsAreThoseWritten) {
    const scene::Scene scene = right(
        "let m = material {\n"
        "  model: \"ward\", ambient: 0.1, diffuse: #ff0000, specular: [0.1, 0.2, 0.3], roughness: "
        "[0.1, 0.2]\n  reflect: 0.25, transmit: 0.125, ior: 1.25, absorption: [1, 2, 3], emission: "
        "4\n"
        "  opacity: 0.5, two_sided: false }\n"
        "let p = material { model: \"cook_torrance\", fresnel: gray(0.5), roughness: 0.7 }\n"
        "let q = material { }");
    const scene::Material& m = scene.materials[0];
    EXPECT_EQ(m.model, scene::ReflectionModel::ward);
    EXPECT_EQ(m.ambient, Color(0.1f));
    EXPECT_EQ(m.diffuse, Color(1, 0, 0));
    EXPECT_EQ(m.specular, Color(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(m.roughness, Vec2(0.1f, 0.2f));
    EXPECT_EQ(m.reflect, Color(0.25f));
    EXPECT_EQ(m.transmit, Color(0.125f));
    EXPECT_EQ(m.ior, 1.25f);
    EXPECT_EQ(m.absorption, Color(1, 2, 3));
    EXPECT_EQ(m.emission, Color(4.0f));
    EXPECT_EQ(m.opacity, 0.5f);
    EXPECT_FALSE(m.two_sided);
    EXPECT_EQ(scene.materials[1].fresnel, Color(0.5f));
    EXPECT_EQ(scene.materials[1].roughness, Vec2(0.7f));
    const scene::Material& q = scene.materials[2];
    const scene::Material standard;
    EXPECT_EQ(q.model, standard.model);
    EXPECT_EQ(q.diffuse, standard.diffuse);
    EXPECT_EQ(q.ambient, standard.ambient);
    EXPECT_EQ(q.specular, standard.specular);
    EXPECT_EQ(q.shininess, standard.shininess);
    EXPECT_EQ(q.roughness, standard.roughness);
    EXPECT_EQ(q.fresnel, standard.fresnel);
    EXPECT_EQ(q.ior, standard.ior);
}

TEST(Materials, ADerivedOneOverridesAndKeepsTheOriginal) {
    const scene::Scene scene = right(
        "let a = material { diffuse: red, shininess: 7 }\nlet b = a { diffuse: blue }\n"
        "sphere { material: b { shininess: 9 } }\nsphere { material: a }");
    ASSERT_EQ(scene.materials.size(), 3u);
    EXPECT_EQ(scene.materials[0].diffuse, Color(1, 0, 0));
    EXPECT_EQ(scene.materials[1].diffuse, Color(0, 0, 1));
    EXPECT_EQ(scene.materials[1].shininess, 7.0f);
    EXPECT_EQ(scene.materials[2].diffuse, Color(0, 0, 1));
    EXPECT_EQ(scene.materials[2].shininess, 9.0f);
    EXPECT_EQ(child(scene, 0).material_id.index(), 2u);
    EXPECT_EQ(child(scene, 1).material_id.index(), 0u);
}

TEST(Materials, WithoutOneItIsTheParents) {
    const scene::Scene scene =
        right("let m = material { }\ngroup { material: m, sphere { }, sphere { material { } } }");
    const auto& inner = children(scene, children(scene, scene.root)[0]);
    EXPECT_FALSE(child(scene, 0).material_id.is_none());
    EXPECT_TRUE(scene.node(inner[0]).material_id.is_none());
    EXPECT_FALSE(scene.node(inner[1]).material_id.is_none());
}

TEST(Groups, KeepOrderLabelsAndFlags) {
    const scene::Scene scene = right(
        "group \"all\" {\n  box \"first\" { visible: false }\n  sphere { casts_shadow: false }\n"
        "  group \"inner\" { disk { } }\n}\nplane { }");
    const scene::Node& all = child(scene, 0);
    EXPECT_EQ(scene.labels[all.label_id.index()], "all");
    const auto& inner = children(scene, children(scene, scene.root)[0]);
    ASSERT_EQ(inner.size(), 3u);
    EXPECT_EQ(scene.node(inner[0]).kind, scene::NodeKind::box);
    EXPECT_FALSE(scene.node(inner[0]).visible);
    EXPECT_EQ(scene.node(inner[1]).kind, scene::NodeKind::sphere);
    EXPECT_FALSE(scene.node(inner[1]).casts_shadow);
    EXPECT_TRUE(scene.node(inner[1]).visible);
    EXPECT_EQ(scene.labels[scene.node(inner[2]).label_id.index()], "inner");
    EXPECT_EQ(child(scene, 1).kind, scene::NodeKind::plane);
}

TEST(Instances, AValueIsPlacedByItsBracesAndStoredOnce) {
    const scene::Scene scene = right(
        "let ball = sphere { radius: 3, translate: [0, 1, 0] }\n"
        "ball { }\nball \"b\" { translate: [2, 0, 0], material { } }\n"
        "group { ball { } }");
    EXPECT_EQ(scene.spheres.size(), 1u);
    ASSERT_EQ(scene.instances.size(), 3u);
    EXPECT_EQ(child(scene, 0).kind, scene::NodeKind::instance);
    EXPECT_EQ(scene.instances[0].target, scene.instances[1].target);
    EXPECT_EQ(scene.instances[0].target, scene.instances[2].target);
    EXPECT_EQ(transform_of(scene, child(scene, 1)).offset(), DVec3(2, 0, 0));
    EXPECT_FALSE(child(scene, 1).material_id.is_none());
    EXPECT_EQ(scene.labels[child(scene, 1).label_id.index()], "b");
    const scene::Node& target = scene.node(scene.instances[0].target);
    EXPECT_EQ(transform_of(scene, target).offset(), DVec3(0, 1, 0));
}

TEST(Instances, ACopyInAnExpressionOverridesAndKeepsTheRest) {
    const scene::Scene scene = right(
        "let ball = sphere { radius: 3, center: [1, 2, 3], scale: 2, casts_shadow: false }\n"
        "let big = ball { radius: 5, translate: [1, 0, 0] }\nbig { }\n"
        "let pair = group { ball { }, big { } }\nlet three = pair { ball { } }\nthree { }");
    EXPECT_EQ(scene.spheres[1].radius, 5.0);
    EXPECT_EQ(scene.spheres[1].center, DVec3(1, 2, 3));
    const scene::Node& big = scene.node(scene.instances[0].target);
    EXPECT_FALSE(big.casts_shadow);
    expect_same(transform_of(scene, big),
                Transform::scaling(2).then(Transform::translation({1, 0, 0})));
    EXPECT_EQ(scene.groups[1].children.size(), 3u);
    EXPECT_EQ(scene.groups[0].children.size(), 2u);
}

TEST(Cameras, AllAreKeptInOrder) {
    const scene::Scene scene = right(
        "camera \"front\" { position: [0, 0, 9], fov: 40, resolution: [64, 48], samples: 9, "
        "background: red "
        "}\n"
        "camera { position: [1, 2, 3], look_at: [1, 0, 0], up: [0, 0, -1], projection: "
        "\"orthographic\", height: 7 }\ncamera { }\nsphere { }");
    ASSERT_EQ(scene.cameras.size(), 3u);
    EXPECT_EQ(scene.cameras[0].name, "front");
    EXPECT_EQ(scene.cameras[0].position, DVec3(0, 0, 9));
    EXPECT_DOUBLE_EQ(scene.cameras[0].fov, radians(40.0));
    EXPECT_EQ(scene.cameras[0].resolution, (scene::Resolution{64, 48}));
    EXPECT_EQ(scene.cameras[0].samples, 9u);
    EXPECT_EQ(scene.cameras[0].background, Color(1, 0, 0));
    EXPECT_EQ(scene.cameras[1].projection, scene::Projection::orthographic);
    EXPECT_EQ(scene.cameras[1].height, 7.0);
    EXPECT_EQ(scene.cameras[1].up, DVec3(0, 0, -1));
    const scene::Camera standard;
    EXPECT_EQ(scene.cameras[2].position, standard.position);
    EXPECT_EQ(scene.cameras[2].look_at, standard.look_at);
    EXPECT_DOUBLE_EQ(scene.cameras[2].fov, standard.fov);
    EXPECT_FALSE(scene.cameras[2].resolution);
    EXPECT_FALSE(scene.cameras[2].samples);
}

TEST(Settings, RenderAndInfoAreTaken) {
    const scene::Scene scene = right(
        "lrs 1.0\nrender { resolution: [320, 200], background: [0.25, 0.5, 1] }\n"
        "info { title: \"A\", anything_else: \"B\" }\nsphere { }");
    EXPECT_EQ(scene.render.resolution, (scene::Resolution{320, 200}));
    EXPECT_EQ(scene.render.background, Color(0.25f, 0.5f, 1.0f));
    ASSERT_EQ(scene.info.size(), 2u);
    EXPECT_EQ(scene.info[0], (std::pair<std::string, std::string>{"title", "A"}));
    EXPECT_EQ(scene.info[1], (std::pair<std::string, std::string>{"anything_else", "B"}));
    EXPECT_EQ(right("sphere { }").render.resolution, scene::Resolution{});
    right("lrs 1\nsphere { }");
    right("lrs 1.10, sphere { }");
}

constexpr std::string_view kParts =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng lid\nf 1 2 3\ng base\nf 1 2 4\nf 1 3 4\n";

TEST(Meshes, OfListsHoldWhatWasWritten) {
    const scene::Scene scene = right(
        "let points = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\n"
        "mesh { positions: points, triangles: [[0, 1, 2]], normals: [[0, 0, 2], [0, 0, 1], [0, 3, "
        "4]]\n  uvs: [[0, 0], [1, 0], [0, 1]], up: \"z\" }");
    ASSERT_EQ(scene.meshes.size(), 1u);
    const scene::Mesh& mesh = scene.meshes[0];
    EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.triangles, (std::vector<scene::IndexTriple>{{0, 1, 2}}));
    EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[2], Vec3(0, 0.6f, 0.8f));
    EXPECT_EQ(mesh.uvs[2], Vec2(0, 1));
    EXPECT_EQ(mesh.normal_indices, mesh.triangles);
    EXPECT_EQ(mesh.uv_indices, mesh.triangles);
    EXPECT_TRUE(scene.mesh_uses[0].z_is_up);
}

TEST(Meshes, OfOneFileAreReadOnce) {
    const scene::Scene scene = right(
        "mesh { file: \"m/parts.obj\" }\nmesh { file: \"m/parts.obj\", up: \"z\" }\n"
        "let base = mesh { file: \"m/parts.obj\", part: \"base\" }\nbase { }",
        {{"m/parts.obj", kParts}});
    EXPECT_EQ(scene.meshes.size(), 1u);
    ASSERT_EQ(scene.mesh_uses.size(), 3u);
    EXPECT_EQ(scene.meshes[0].triangles.size(), 3u);
    EXPECT_FALSE(scene.mesh_uses[0].z_is_up);
    EXPECT_TRUE(scene.mesh_uses[1].z_is_up);
}

TEST(Includes, AreRelativeToTheFileTheyStandIn) {
    const scene::Scene scene =
        right("include \"lib/all.lrs\"\nsphere { radius: size, material: gold_leaf }",
              {{"lib/all.lrs",
                "include \"parts/sizes.lrs\"\nlet gold_leaf = material { diffuse: gold }\n"
                "mesh { file: \"parts/m.obj\" }"},
               {"lib/parts/sizes.lrs", "let size = 4\nbox { }"},
               {"lib/parts/m.obj", kParts}});
    EXPECT_EQ(scene.spheres[0].radius, 4.0);
    ASSERT_EQ(children(scene, scene.root).size(), 3u);
    EXPECT_EQ(child(scene, 0).kind, scene::NodeKind::box);
    EXPECT_EQ(child(scene, 1).kind, scene::NodeKind::mesh);
}

TEST(Includes, AFileNameKeepsTheDirectoryItWasWrittenIn) {
    right("include \"lib/names.lrs\"\nmesh { file: model }",
          {{"lib/names.lrs", "let model = \"m.obj\""}, {"lib/m.obj", kParts}});
}

TEST(Includes, InAGroupAddTheirThingsToIt) {
    const scene::Scene scene = right(
        "let outer = 2\ngroup { include \"a.lrs\", translate: [1, 0, 0] }\ngroup { include "
        "\"a.lrs\" }",
        {{"a.lrs", "let r = outer\nsphere { radius: r }"}});
    ASSERT_EQ(children(scene, scene.root).size(), 2u);
    EXPECT_EQ(children(scene, children(scene, scene.root)[0]).size(), 1u);
    EXPECT_EQ(scene.spheres.size(), 2u);
    EXPECT_EQ(scene.spheres[1].radius, 2.0);
}

TEST(Includes, TwiceInOnePlaceDefinesNamesTwice) {
    EXPECT_EQ(load_text("include \"a.lrs\"\ninclude \"a.lrs\"", parser::LoadSettings{},
                        {{"a.lrs", "let r = 1"}})
                  .codes(),
              "E0203");
    EXPECT_EQ(load_text("include \"a.lrs\"\ninclude \"a.lrs\"", parser::LoadSettings{},
                        {{"a.lrs", "sphere { }"}})
                  .codes(),
              "W1501");
}

TEST(Files, AnAbsolutePathWarns) {
    const TempDirectory directory;
    directory.write("m.obj", kParts);
    const std::string main = directory.write(
        "main.lrs", "camera { }\nmesh { file: \"" + directory.path("m.obj") + "\" }");
    const Loaded loaded = load_file(main);
    EXPECT_EQ(loaded.text(), "W1605 2:14 an absolute path works on this machine only\n");
    EXPECT_TRUE(loaded.scene.has_value());
}

TEST(Files, TheMainFileMustBeThere) {
    const TempDirectory directory;
    EXPECT_EQ(load_file(directory.path("nowhere.lrs")).codes(), "E0601");
    EXPECT_EQ(load_file(directory.path()).codes(), "E0604");
}

}  // namespace
}  // namespace lray::test
