// Colours of vertices: from lists and files, in the material a mesh has or in its own.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <variant>

#include "parser/tools/dump.h"
#include "tests/parser/loaded.h"
#include "tests/parser/same_world.h"

namespace lray::test {
namespace {

constexpr std::string_view kLists =
    "positions: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles: [[0, 1, 2]]";

const Companion kPly = {"a.ply",
                        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                        "property float y\nproperty float z\nproperty uchar red\n"
                        "property uchar green\nproperty uchar blue\nelement face 1\n"
                        "property list uchar int vertex_indices\nend_header\n"
                        "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n"};

std::string camera_and(std::string_view text) {
    return "camera { position: [0, 0, 5], look_at: [0, 0, 0] }\n" + std::string(text);
}

/// What shows the first object's diffuse part: "vertex colours", or a colour.
std::string diffuse_of(const scene::World& world) {
    const auto& diffuse = world.materials[world.objects[0].material].diffuse;
    if (!diffuse.is_textured()) return diffuse.constant == Color{0.8f} ? "default" : "own";
    const auto& texture = world.textures[diffuse.texture_id.index()];
    const bool is_it = std::holds_alternative<scene::VertexColorsTexture>(texture.pattern) &&
                       texture.space == scene::TextureSpace::vertex_colors;
    return is_it ? "vertex colours" : "another texture";
}

struct Shown {
    std::string diffuse{};
    scene::World world{};
};

Shown show(std::string_view text) {
    Loaded loaded = load_text(camera_and(text), parser::LoadSettings{}, {kPly});
    EXPECT_FALSE(loaded.has_errors()) << loaded.text();
    if (!loaded.scene) return {};
    auto world = scene::flatten(*loaded.scene, {}, loaded.diagnostics);
    if (!world) return {};
    world->pictures = {};
    return {diffuse_of(*world), std::move(*world)};
}

TEST(VertexColors, AMeshWithoutMaterialShowsItsOwn) {
    for (const std::string& mesh :
         {std::string("mesh { file: \"a.ply\" }"),
          "mesh { " + std::string(kLists) + ", colors: [red, [0, 1, 0], #0000ff] }"}) {
        const Shown shown = show(mesh);
        EXPECT_EQ(shown.diffuse, "vertex colours");
        EXPECT_EQ(shown.world.colors, (std::vector<Color>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
        const Color mean = shown.world.mean_color(scene::ObjectId(std::size_t{0}));
        EXPECT_EQ(mean, Color(1.0f / 3.0f));
    }
}

TEST(VertexColors, TheyWinOverWhatIsInheritedAndNotOverTheMaterialOfTheMesh) {
    EXPECT_EQ(show("group { material { diffuse: navy }\n mesh { file: \"a.ply\" } }").diffuse,
              "vertex colours");
    const Shown own = show("mesh { file: \"a.ply\", material { diffuse: navy } }");
    EXPECT_EQ(own.diffuse, "own");
    EXPECT_TRUE(own.world.colors.empty());  // nothing shows them, so nothing is kept
    EXPECT_EQ(show("mesh { file: \"a.ply\", material { diffuse: vertex_colors { } } }").diffuse,
              "vertex colours");
    EXPECT_EQ(show("mesh { " + std::string(kLists) + " }").diffuse, "default");
}

TEST(VertexColors, WhatHasNoneIsWhite) {
    const Shown shown = show(
        "let m = material { diffuse: vertex_colors { } }\n"
        "mesh { " +
        std::string(kLists) +
        ", material: m }\n"
        "mesh { file: \"a.ply\", material: m }\n"
        "triangle { a: [0, 0, 3], b: [1, 0, 3], c: [0, 1, 3] }\n");
    ASSERT_EQ(shown.world.colors.size(), shown.world.vertices.size());
    ASSERT_EQ(shown.world.colors.size(), 9u);
    EXPECT_EQ(shown.world.colors[2], Color(1.0f));
    EXPECT_EQ(shown.world.colors[3], Color(1, 0, 0));
    EXPECT_EQ(shown.world.colors[8], Color(1.0f));
    EXPECT_EQ(shown.world.mean_color(scene::ObjectId(std::size_t{0})), Color(1.0f));
    EXPECT_EQ(shown.world.mean_color(scene::ObjectId(std::size_t{2})), Color(1.0f));
}

TEST(VertexColors, AMirroredMeshKeepsThemAtItsCorners) {
    const Shown shown = show("mesh { file: \"a.ply\", scale: [-1, 1, 1] }");
    ASSERT_EQ(shown.world.triangles.size(), 1u);
    for (const std::uint32_t vertex : shown.world.triangles[0].vertices) {
        const Color expected = shown.world.vertices[vertex].x < 0.0f   ? Color(0, 1, 0)
                               : shown.world.vertices[vertex].y > 0.0f ? Color(0, 0, 1)
                                                                       : Color(1, 0, 0);
        EXPECT_EQ(shown.world.colors[vertex], expected);
    }
}

TEST(VertexColors, WrongListsAreTold) {
    const auto error = [](std::string_view colors) {
        return load_text(camera_and("mesh { " + std::string(kLists) +
                                    ", colors: " + std::string(colors) + " }"))
            .text();
    };
    EXPECT_NE(error("[red]").find("E0303 2:86 `colors` needs 3 rows, one for each vertex; this has "
                                  "1"),
              std::string::npos)
        << error("[red]");
    EXPECT_NE(error("[red, \"blue\", red]").find("E0301"), std::string::npos);
    EXPECT_NE(error("[[0, 0, 0], [0, 2, 0], [0, 0, 0]]")
                  .find("E0304 2:86 `colors` must be from 0 to 1, element 1 has 2"),
              std::string::npos)
        << error("[[0, 0, 0], [0, 2, 0], [0, 0, 0]]");
    EXPECT_NE(load_text(camera_and("let t = vertex_colors { scale: 2 }\nsphere { }"))
                  .text()
                  .find("E0401"),
              std::string::npos);
}

TEST(VertexColors, ADumpHasThem) {
    const Loaded loaded =
        load_text(camera_and("mesh { " + std::string(kLists) + ", colors: [0.1, crimson, 1] }"));
    ASSERT_TRUE(loaded.scene) << loaded.text();
    const std::string text = parser::dump(*loaded.scene);
    EXPECT_NE(text.find("vertex_colors { }"), std::string::npos) << text;
    const Loaded again = load_text(text);
    ASSERT_TRUE(again.scene) << again.text() << text;
    EXPECT_EQ(parser::dump(*again.scene), text);
    EXPECT_EQ(world_text(*again.scene), world_text(*loaded.scene));
}

}  // namespace
}  // namespace lray::test
