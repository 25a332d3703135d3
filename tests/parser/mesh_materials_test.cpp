// Meshes with the materials and the smoothness that a scene asks for.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <string>
#include <vector>

#include "parser/tools/dump.h"
#include "tests/parser/loaded.h"
#include "tests/parser/same_world.h"

namespace lray::test {
namespace {

constexpr std::string_view kObj =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\n"
    "f 1 2 3\nusemtl red\ng side\nf 1//1 2//1 4//1\nusemtl blue\nf 1 3 4\nusemtl red\nf 2 3 4\n";
constexpr std::string_view kMtl = "newmtl blue\nKd 0 0 1\nnewmtl unused\nnewmtl red\nKd 1 0 0\n";
const std::vector<Companion> kFiles = {{"a.obj", kObj}, {"a.mtl", kMtl}};

/// The diffuse colours of the world's triangles, in the order of the file: "-" the default.
std::string colors_of(Loaded& loaded) {
    const auto world = flatten_and_lint(loaded);
    if (!world) return loaded.text();
    std::string colors;
    const auto add = [&](const scene::Geometry& geometry, std::uint32_t inherited) {
        for (const scene::ObjectId id :
             geometry.object_ids[static_cast<std::size_t>(scene::PrimitiveKind::triangle)]) {
            std::uint32_t material = geometry.objects[id.index()].material;
            if (material == scene::Object::kInherited) material = inherited;
            const Color c = world->materials[material].diffuse.constant;
            colors += material == 0 ? '-' : c.g > 0.0f ? 'g' : c.r > 0.0f ? 'r' : 'b';
        }
        colors += ' ';
    };
    add(*world, 0);
    for (const scene::WorldInstance& instance : world->instances) {
        const auto index = static_cast<std::size_t>(&instance - world->instances.data());
        const scene::ObjectId object =
            world->object_ids[static_cast<std::size_t>(scene::PrimitiveKind::instance)][index];
        add(world->prototypes[instance.prototype], world->objects[object.index()].material);
    }
    return colors;
}

std::string colors_of(std::string_view scene, const std::vector<Companion>& files = kFiles) {
    Loaded loaded = load_text(std::string(scene), parser::LoadSettings{}, files);
    if (!loaded.scene) return loaded.text();
    return colors_of(loaded);
}

TEST(MeshMaterials, EachTriangleShowsThatOfItsFile) {
    EXPECT_EQ(colors_of("mesh { file: \"a.obj\" }"), "-rbr ");
    EXPECT_EQ(colors_of("group { material { diffuse: lime }, mesh { file: \"a.obj\" } }"), "grbr ");
    EXPECT_EQ(colors_of("mesh { file: \"a.obj\", part: \"side\" }"), "rbr ");
}

TEST(MeshMaterials, OneOfTheBlockTakesTheirPlace) {
    EXPECT_EQ(colors_of("mesh { file: \"a.obj\", material { diffuse: lime } }"), "gggg ");
    EXPECT_EQ(colors_of("mesh { file: \"a.obj\", use_mtl: false }"), "---- ");
    EXPECT_EQ(colors_of("let m = mesh { file: \"a.obj\" }\nlet n = m { material { diffuse: lime } "
                        "}\nm { }\nn { }"),
              "-rbrgggg ");
    // Of an instance it is what is inherited.
    EXPECT_EQ(colors_of("let m = mesh { file: \"a.obj\" }\nm { material { diffuse: lime } }"),
              "grbr ");
}

TEST(MeshMaterials, DifferentUsesAreNotShared) {
    std::string scene;
    for (int i = 0; i < 4; ++i) {
        scene += fmt::format(
            "mesh {{ file: \"a.obj\", translate: [{0}, 0, 0] }}\n"
            "mesh {{ file: \"a.obj\", translate: [{0}, 2, 0], use_mtl: false }}\n",
            2 * i);
    }
    std::string many(kObj);
    for (int i = 0; i < 200; ++i) many += "f 1 2 4\n";
    Loaded loaded = load_text(scene, parser::LoadSettings{}, {{"a.obj", many}, {"a.mtl", kMtl}});
    ASSERT_TRUE(loaded.scene) << loaded.text();
    const std::string colors = colors_of(loaded);
    std::size_t red = 0;
    for (const char c : colors) red += c == 'r' ? 1u : 0u;
    EXPECT_EQ(red, 4u * 202u) << colors.substr(0, 100);
}

TEST(MeshMaterials, DumpGivesTheSameWorld) {
    const std::string scene =
        "mesh { file: \"a.obj\", smooth: 33.3 }\nmesh { file: \"a.obj\", use_mtl: false, "
        "translate: [2, 0, 0] }\nmesh { file: \"a.obj\", material { diffuse: lime }, translate: "
        "[4, "
        "0, 0] }\nmesh { positions: [[0, 0, 9], [1, 0, 9], [0, 1, 9], [1, 1, 9.5]]\ntriangles: "
        "[[0, "
        "1, 2], [1, 3, 2]], smooth: 80 }\n";
    const Loaded loaded = load_text(scene, parser::LoadSettings{}, kFiles);
    ASSERT_TRUE(loaded.scene) << loaded.text();
    const std::string text = parser::dump(*loaded.scene);
    const Loaded again = load_text(text, parser::LoadSettings{}, kFiles);
    ASSERT_TRUE(again.scene) << again.text();
    EXPECT_EQ(parser::dump(*again.scene), text);
    EXPECT_EQ(world_text(*again.scene), world_text(*loaded.scene));
    EXPECT_NE(text.find("smooth: 33.3"), text.npos);
    EXPECT_NE(text.find("use_mtl: false"), text.npos);
    EXPECT_EQ(text.find("normals:"), text.npos);
}

TEST(MeshSmooth, OneFileIsOneMeshForEachAngle) {
    const std::string scene =
        "mesh { file: \"a.obj\", smooth: 60 }\nmesh { file: \"a.obj\" }\nmesh { file: \"a.obj\", "
        "smooth: 60 }\nmesh { file: \"a.obj\", smooth: 0 }\nmesh { file: \"./a.obj\" }\n";
    const Loaded loaded = load_text(scene, parser::LoadSettings{}, kFiles);
    ASSERT_TRUE(loaded.scene) << loaded.text();
    ASSERT_EQ(loaded.scene->meshes.size(), 3u);
    EXPECT_EQ(loaded.scene->meshes[1].normals.size(), 1u);  // the file's
    EXPECT_TRUE(loaded.scene->meshes[2].normals.empty());
    EXPECT_EQ(loaded.scene->materials.size(), 2u);
    // Each counts as the file once more.
    parser::LoadLimits limits;
    limits.mesh_bytes = 2 * (kObj.size() + kMtl.size());
    EXPECT_EQ(load_text(scene, with_limits(limits), kFiles).codes(), "E0516");
}

TEST(MeshSmooth, NormalsExcludeIt) {
    EXPECT_EQ(load_text("mesh { positions: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles: [[0, 1, "
                        "2]]\nnormals: [[0, 0, 1], [0, 0, 1], [0, 0, 1]], smooth: 30 }")
                  .codes(),
              "E0411");
}

TEST(MeshMaterials, WhatIsMissingIsAWarning) {
    const Loaded missing =
        load_text("mesh { file: \"a.obj\" }\nmesh { file: \"a.obj\", smooth: 3 }",
                  parser::LoadSettings{}, {{"a.obj", kObj}, {"b.mtl", kMtl}});
    EXPECT_TRUE(missing.scene);
    EXPECT_EQ(missing.codes(), "W1501 W1701");
    const Loaded undefined = load_text("mesh { file: \"a.obj\" }", parser::LoadSettings{},
                                       {{"a.obj", kObj}, {"a.mtl", "newmtl red\n"}});
    EXPECT_NE(undefined.text().find("the material `blue` of `a.obj` is defined in no file"),
              std::string::npos)
        << undefined.text();
    const Loaded pictures =
        load_text("mesh { file: \"a.obj\" }", parser::LoadSettings{},
                  {{"a.obj", kObj},
                   {"a.mtl",
                    "newmtl red\nmap_Kd gone.png\nmap_Ks gone.png\nmap_Ke x.tga\n"
                    "norm ../../../etc/passwd\nnewmtl blue\n"}});
    EXPECT_TRUE(pictures.scene);
    EXPECT_EQ(pictures.codes(), "W1501 W1701 W1701 W1701") << pictures.text();
}

TEST(MeshMaterials, AMistakeInTheirFileIsAnError) {
    const Loaded loaded =
        load_text("mesh { file: \"a.obj\" }\nmesh { file: \"a.obj\" }", parser::LoadSettings{},
                  {{"a.obj", kObj}, {"a.mtl", "newmtl red\nKd x\n"}});
    EXPECT_TRUE(loaded.has_errors());
    EXPECT_EQ(loaded.diagnostics.error_count(), 1u) << loaded.text();
}

}  // namespace
}  // namespace lray::test
