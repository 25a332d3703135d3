// The program with meshes that lray-import reads, found beside it.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/cli/lray_test.h"

namespace lray {
namespace {

namespace fs = std::filesystem;

class ImportTest : public LrayTest {};

/// Two triangles that share an edge, as STL text and as a mesh of the language.
constexpr const char* kRoofStl =
    "solid roof\n"
    "facet normal 0 0 1\nouter loop\nvertex -1 -1 0\nvertex 1 -1 0\nvertex 0 1 0.5\nendloop\n"
    "endfacet\n"
    "facet normal 0 0 1\nouter loop\nvertex 1 -1 0\nvertex 2 1 -1\nvertex 0 1 0.5\nendloop\n"
    "endfacet\n"
    "endsolid roof\n";
constexpr const char* kRoof =
    "mesh {\n"
    "  positions: [[-1, -1, 0], [1, -1, 0], [0, 1, 0.5], [2, 1, -1]]\n"
    "  triangles: [[0, 1, 2], [1, 3, 2]]\n"
    "}\n";
constexpr const char* kRoofView =
    "render { resolution: [64, 48] }; point_light { position: [2, 5, 5] }\n"
    "camera { position: [0, 0, 5], look_at: [0, 0, 0] }\n";

TEST_F(ImportTest, ImporterIsFoundBesideTheProgramHoweverItIsCalled) {
    const fs::path program = LRAY_BINARY;
    directory_.write("far/roof.stl", kRoofStl);
    directory_.write("far/imported.lrs", std::string(kRoofView) + "mesh { file: \"roof.stl\" }\n");
    directory_.write("far/same.lrs", std::string(kRoofView) + kRoof);
    directory_.write("elsewhere/a.txt", "");
    fs::create_directory_symlink(program.parent_path(), directory_.path("programs"));
    fs::create_symlink(program, directory_.path("linked"));
    const auto rendered = [&](const std::string& called, const std::string& scene) {
        const auto result = test::run_process(
            {called, "-n", "2", "-i", directory_.path(scene), "-o", directory_.path("a.ppm")}, {},
            directory_.path("elsewhere"));
        EXPECT_EQ(result.exit_code, 0) << called << "\n" << result.err;
        return result.exit_code == 0 ? directory_.read("a.ppm") : std::string();
    };
    const std::string expected = rendered(LRAY_BINARY, "far/same.lrs");
    const image::Image shown = picture("a.ppm");
    EXPECT_GT(shown.at(32, 24).r, shown.at(0, 0).r + 0.1f) << "the mesh is in the picture";
    EXPECT_EQ(rendered(LRAY_BINARY, "far/imported.lrs"), expected);
    EXPECT_EQ(rendered(directory_.path("linked"), "far/imported.lrs"), expected);
    EXPECT_EQ(rendered("../linked", "far/imported.lrs"), expected);
    EXPECT_EQ(rendered("../programs/lray", "far/imported.lrs"), expected);
}

TEST_F(ImportTest, MistakeInAnImportedMeshIsToldWhereItIsLoaded) {
    directory_.write("scene.lrs", std::string(kScene) + "mesh { file: \"roof.stl\" }\n");
    directory_.write("roof.stl", "no mesh\n");
    const auto result = run({"scene.lrs", "-o", "a.ppm"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(contains(result.err, "scene.lrs:4:14: error[E0701]: `roof.stl` is not understood"))
        << result.err;
}

}  // namespace
}  // namespace lray
