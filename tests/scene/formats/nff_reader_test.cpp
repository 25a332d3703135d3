// read_nff: what each statement means, however it is laid out.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "base/angle.h"
#include "scene/formats/nff_nodes.h"
#include "tests/scene/formats/nff_reading.h"

namespace lray::scene {
namespace {

TEST(ReadNff, ViewAndBackground) {
    const NffScene nff = read_nff_text(
        "b 0.1 0.2 0.3\n"
        "v\nfrom 1 2 3\nat 4 5 6\nup 0 0 1\nangle 30\nhither 0\nresolution 512 256\n");
    EXPECT_EQ(nff.background, DVec3(0.1, 0.2, 0.3));
    ASSERT_TRUE(nff.view);
    EXPECT_EQ(nff.view->from, DVec3(1, 2, 3));
    EXPECT_EQ(nff.view->at, DVec3(4, 5, 6));
    EXPECT_EQ(nff.view->up, DVec3(0, 0, 1));
    EXPECT_EQ(nff.view->angle, 30.0);
    EXPECT_EQ(nff.view->resolution, (Resolution{512, 256}));
}

TEST(ReadNff, ViewMayLackWhatRayTracersDoNotNeed) {
    const NffScene nff = read_nff_text("v angle 30 up 0 1 0 at 0 0 0 from 0 0 1 yon 100 l 1 2 3");
    ASSERT_TRUE(nff.view);
    EXPECT_FALSE(nff.view->resolution);
    EXPECT_EQ(nff.lights.size(), 1u);
}

TEST(ReadNff, LightsMayHaveAColor) {
    const NffScene nff = read_nff_text("l 1 2 3\nl 4 5 6 0.5 0.25 0\nl 7 8 9\n");
    ASSERT_EQ(nff.lights.size(), 3u);
    EXPECT_EQ(nff.lights[0].position, DVec3(1, 2, 3));
    EXPECT_FALSE(nff.lights[0].color);
    EXPECT_EQ(nff.lights[1].color, DVec3(0.5, 0.25, 0));
    EXPECT_EQ(nff.lights[2].position, DVec3(7, 8, 9));
}

TEST(ReadNff, ShapesHaveTheLastSurfaceAndEachIsThereOnce) {
    const NffScene nff = read_nff_text(
        "f 1 0.5 0.25 0.75 0.5 20 0.125 1.5\ns 1 2 3 4\n"
        "f 0 0 1 1 0 1 0 1\n"  // no shape has it
        "f 0 1 0 1 0 1 0 1\nc 0 0 0 2 0 0 5 1\n"
        "f 1 0.5 0.25 0.75 0.5 20 0.125 1.5\np 3 0 0 0 1 0 0 0 1 0\n");
    ASSERT_EQ(nff.surfaces.size(), 2u);
    EXPECT_EQ(nff.surfaces[0], (NffSurface{{1, 0.5, 0.25}, 0.75, 0.5, 20, 0.125, 1.5}));
    ASSERT_EQ(nff.shapes.size(), 3u);
    EXPECT_EQ(nff.shapes[0].surface, 0u);
    EXPECT_EQ(nff.shapes[1].surface, 1u);
    EXPECT_EQ(nff.shapes[2].surface, 0u);
    EXPECT_EQ(nff.shapes[0].kind, NodeKind::sphere);
    EXPECT_EQ(nff.spheres.at(0).center, DVec3(1, 2, 3));
    EXPECT_EQ(nff.spheres.at(0).radius, 4.0);
    EXPECT_EQ(nff.shapes[1].kind, NodeKind::cylinder);
    const CylinderShape& cone = nff.cylinders.at(0);
    EXPECT_EQ(cone.from, DVec3(0, 0, 0));
    EXPECT_EQ(cone.radius, 2.0);
    EXPECT_EQ(cone.to, DVec3(0, 0, 5));
    EXPECT_EQ(cone.radius_to, 1.0);
    EXPECT_FALSE(cone.caps);
    EXPECT_EQ(nff.shapes[2].kind, NodeKind::triangle);
    EXPECT_EQ(nff.triangles.at(0).b, DVec3(1, 0, 0));
}

TEST(ReadNff, SpansAreTheStatements) {
    const NffReading reading("f 1 1 1 1 0 1 0 1 # white\n s 0 0\t0\n 1  # a ball\n");
    ASSERT_TRUE(reading.scene) << reading.errors();
    EXPECT_EQ(reading.sources.text(reading.scene->shapes.at(0).span), "s 0 0\t0\n 1");
}

TEST(ReadNff, ConesEndInATip) {
    EXPECT_EQ(read_nff_text(on_line_2("c 0 0 0 1 0 1 0 0")).cylinders.at(0).radius_to, 0.0);
}

double area_of(const TriangleShape& t) {
    return 0.5 * glm::length(cross(t.b - t.a, t.c - t.a));
}

TEST(ReadNff, ConcavePolygonsKeepTheirForm) {
    // An arrow head: a fan from its first corner would cover its notch.
    const NffScene nff = read_nff_text(on_line_2("p 4  2 0 0  0 2 0  1 0 0  0 -2 0"));
    ASSERT_EQ(nff.triangles.size(), 2u);
    EXPECT_EQ(area_of(nff.triangles[0]) + area_of(nff.triangles[1]), 2.0);
    EXPECT_EQ(nff.shapes[0].span, nff.shapes[1].span);
}

TEST(ReadNff, CornersOnALineMakeNoTriangles) {
    const NffScene nff = read_nff_text(on_line_2("p 5  0 0 0  1 0 0  2 0 0  2 2 0  0 2 0"));
    double area = 0.0;
    for (const TriangleShape& triangle : nff.triangles) {
        EXPECT_GT(area_of(triangle), 0.0);
        area += area_of(triangle);
    }
    EXPECT_EQ(area, 4.0);
    EXPECT_EQ(read_nff_text(on_line_2("p 4 0 0 0 1 0 0 2 0 0 3 0 0")).triangles.size(), 1u)
        << "of a polygon without area one is left, so that it can be told of";
}

TEST(ReadNff, PatchesHaveTheNormalsOfTheirCorners) {
    const NffScene nff =
        read_nff_text(on_line_2("pp 4  0 0 0 0 0 1  1 0 0 0 1 1  1 1 0 1 1 1  0 1 0 1 0 1"));
    ASSERT_EQ(nff.triangles.size(), 2u);
    for (const TriangleShape& triangle : nff.triangles) {
        ASSERT_LT(triangle.attributes, nff.triangle_attributes.size());
        const auto& normals = *nff.triangle_attributes[triangle.attributes].normals;
        // Each normal is told by its corner here.
        for (const auto& [corner, normal] : {std::pair{triangle.a, normals[0]},
                                             {triangle.b, normals[1]},
                                             {triangle.c, normals[2]}}) {
            EXPECT_EQ(normal, DVec3(corner.y, corner.x, 1)) << corner.x << corner.y;
        }
    }
}

TEST(ReadNff, ANormalOfNoLengthMakesAFlatTriangle) {
    const NffScene nff = read_nff_text(on_line_2("pp 3 0 0 0 0 0 0  1 0 0 0 0 1  0 1 0 0 0 1"));
    EXPECT_EQ(nff.triangles.at(0).attributes, TriangleShape::kNoAttributes);
}

TEST(ReadNff, LayoutDoesNotMatter) {
    const std::string text =
        "b 0.5 0 0\nl 1 2 3\nf 1 .5 0.25 1e-1 0 1E+1 0 1\ns 1 -2 +3 40e-1\n"
        "p 3\n0 0 0\n1 0 0\n0 1 0\n";
    const NffScene plain = read_nff_text(text);
    std::string crlf = "\xEF\xBB\xBF# a comment\r\n";
    std::string spread;
    for (const char c : text) {
        crlf += c == '\n' ? " \t# b 1 1 1\r\n\r\n" : std::string(1, c);
        spread += c == ' ' ? "\r\v\f\n" : std::string(1, c);
    }
    for (const std::string& other : {crlf, spread, text.substr(0, text.size() - 1)}) {
        const NffScene nff = read_nff_text(other);
        EXPECT_EQ(nff.background, plain.background) << other;
        EXPECT_EQ(nff.surfaces, plain.surfaces) << other;
        ASSERT_EQ(nff.shapes.size(), 2u) << other;
        EXPECT_EQ(nff.spheres.at(0).center, DVec3(1, -2, 3)) << other;
        EXPECT_EQ(nff.spheres.at(0).radius, 4.0) << other;
        EXPECT_EQ(nff.triangles.at(0).c, DVec3(0, 1, 0)) << other;
    }
}

TEST(ReadNff, AnEmptyFileIsAnEmptyScene) {
    EXPECT_EQ(read_nff_text("").shapes.size(), 0u);
    EXPECT_EQ(read_nff_text("# nothing").shapes.size(), 0u);
}

TEST(AddNff, SurfacesBecomeMaterials) {
    Scene scene;
    scene.materials.emplace_back();
    NffScene nff = read_nff_text(
        "f 1 0.5 0.25 0.5 0 7 0 0\ns 0 0 0 1\n"
        "f 1 1 1 0.5 0.25 100000 0 1\ns 0 0 0 1\n"
        "f 1 1 1 0 0.25 20 0.75 1.25\ns 0 0 0 1\n"
        "f 1 1 1 0 0 0 0.5 0\ns 0 0 0 1\n");
    const NffNodes nodes = add_nff(std::move(nff), scene);
    EXPECT_EQ(nodes.shape_count, 4u);
    const auto material_of = [&](std::uint32_t i) {
        return scene.materials[scene.nodes[nodes.first + i].material_id.index()];
    };
    EXPECT_EQ(material_of(0).model, ReflectionModel::lambert);
    EXPECT_EQ(material_of(0).diffuse, Coefficient(Color(0.5f, 0.25f, 0.125f)));
    EXPECT_EQ(material_of(0).reflect, Coefficient(Color(0.0f)));
    EXPECT_EQ(material_of(1).model, ReflectionModel::phong);
    EXPECT_EQ(material_of(1).specular, Coefficient(Color(0.25f)));
    EXPECT_EQ(material_of(1).reflect, Coefficient(Color(0.25f)));
    EXPECT_EQ(material_of(1).shininess.constant, 10000.0f);
    EXPECT_EQ(material_of(2).shininess.constant, 20.0f);
    EXPECT_EQ(material_of(2).transmit, Coefficient(Color(0.75f)));
    EXPECT_EQ(material_of(2).ior, 1.25f);
    EXPECT_EQ(material_of(3).ior, 1.0f) << "0 is written where nothing is bent";
}

TEST(AddNff, LightsShineByTheirNumberOrTheirColor) {
    Scene scene;
    const NffNodes nodes =
        add_nff(read_nff_text("l 1 2 3\nl 0 0 0 0.5 0.25 1\nl 0 0 0\nl 0 0 0\n"), scene);
    ASSERT_EQ(nodes.light_count, 4u);
    const Light& plain = scene.lights.at(scene.nodes.at(nodes.first).index);
    const PointLight& point = std::get<PointLight>(plain.shape);
    EXPECT_EQ(point.position, DVec3(1, 2, 3));
    EXPECT_EQ(point.falloff, Falloff::none);
    EXPECT_EQ(plain.color, Color(1.0f));
    EXPECT_EQ(plain.intensity, 4.0 * std::numbers::pi * 0.5);
    const Light& colored = scene.lights.at(scene.nodes.at(nodes.first + 1).index);
    EXPECT_EQ(colored.color, Color(0.5f, 0.25f, 1.0f));
    EXPECT_EQ(colored.intensity, 4.0 * std::numbers::pi);
}

TEST(AddNff, ASecondFileGoesBehindTheFirst) {
    const std::string text =
        on_line_2("s 1 1 1 1\npp 3 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1\nc 0 0 0 1 0 0 1 1");
    Scene scene;
    add_nff(read_nff_text(text), scene);
    const NffNodes second = add_nff(read_nff_text(text), scene);
    ASSERT_EQ(second.first, 3u);
    for (std::uint32_t i = 0; i < 3; ++i) {
        EXPECT_EQ(scene.nodes[second.first + i].index, 1u) << i;
        EXPECT_EQ(scene.nodes[second.first + i].material_id, MaterialId(1)) << i;
    }
    EXPECT_EQ(scene.triangles[1].attributes, 1u);
}

TEST(CameraOfNff, AngleIsThatOfTheSmallerSide) {
    NffView view;
    view.from = {0, 0, 5};
    view.angle = 40.0;
    EXPECT_EQ(camera_of(view).fov, radians(40.0));
    EXPECT_FALSE(camera_of(view).resolution);
    view.resolution = Resolution{400, 300};
    EXPECT_EQ(camera_of(view).fov, radians(40.0));
    view.resolution = Resolution{300, 400};
    const double expected = 2.0 * std::atan(std::tan(radians(20.0)) * 4.0 / 3.0);
    EXPECT_NEAR(camera_of(view).fov, expected, 1e-14);
    EXPECT_EQ(camera_of(view).resolution, (Resolution{300, 400}));
}

}  // namespace
}  // namespace lray::scene
