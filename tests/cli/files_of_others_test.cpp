// The program with files of other formats: OBJ with MTL, and NFF.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <fmt/format.h>

#include "tests/cli/lray_test.h"

namespace lray {
namespace {

class FilesOfOthers : public LrayTest {};

TEST_F(FilesOfOthers, MistakeInAMeshIsToldAtItsLineAndWhereItIsLoaded) {
    directory_.write("scene.lrs", std::string(kScene) + "mesh { file: \"models/bunny.obj\" }\n");
    std::string obj = "# a bunny\n";
    for (int i = 0; i < 810; ++i) obj += "v 0 0 " + std::to_string(i) + "\n";
    directory_.write("models/bunny.obj", obj + "f 1 2 9999\n");
    const auto result = run({"scene.lrs", "-o", "a.ppm"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(contains(result.err, "models/bunny.obj:812:7: error[E0702]: vertex 9999 of 810\n"))
        << result.err;
    EXPECT_TRUE(contains(result.err, "scene.lrs:4:14")) << result.err;
    EXPECT_TRUE(contains(result.err, "1 error; nothing rendered")) << result.err;
    directory_.write("models/bunny.obj", obj + "f 1 2 zebra\n");
    const auto syntax = run({"scene.lrs", "-o", "a.ppm"});
    EXPECT_EQ(syntax.exit_code, 1);
    EXPECT_TRUE(contains(syntax.err, "models/bunny.obj:812:7: error[E0701]")) << syntax.err;
}

/// A square with dents, in light from the side.
std::string bump_scene(const std::string& mesh, double scale) {
    return fmt::format(
        "render {{ resolution: [64, 48], samples: 4 }}\n"
        "camera {{ position: [0, {0}, {1}], look_at: [0, 0, 0] }}\n"
        "point_light {{ position: [{1}, {0}, {0}], falloff: \"none\", intensity: 9 }}\n"
        "group {{ scale: {2}, {3} }}\n",
        scale, 3 * scale, scale, mesh);
}

TEST_F(FilesOfOthers, BumpsOfMtlAreThoseOfTheLanguage) {
    directory_.write("dents.ppm",
                     "P3 4 2 255\n0 0 0 255 255 255 90 90 90 255 255 255\n"
                     "200 200 200 0 0 0 255 255 255 10 10 10\n");
    directory_.write("flat.mtl", "newmtl wall\nKd 0.8\nillum 1\n");
    directory_.write("dents.mtl", "newmtl wall\nKd 0.8\nillum 1\nmap_Bump -bm 2 dents.ppm\n");
    const std::string square =
        "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
        "usemtl wall\nf 1/1 2/2 3/3 4/4\n";
    for (const std::string name : {"flat", "dents"}) {
        directory_.write(name + ".obj", "mtllib " + name + ".mtl\n" + square);
    }
    const std::string by_hand =
        "mesh { file: \"flat.obj\", material { model: \"blinn_phong\", specular: 0, diffuse: 0.8,\n"
        "  bump: image { file: \"dents.ppm\", srgb: false }\n"
        "  bump_height: 0.02, bump_unit: \"uv\" } }";
    const auto rendered = [&](const std::string& mesh, double scale) {
        directory_.write("scene.lrs", bump_scene(mesh, scale));
        const auto result = run({"scene.lrs", "-o", "a.ppm"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return directory_.read("a.ppm");
    };
    const std::string bumped = rendered("mesh { file: \"dents.obj\" }", 1.0);
    EXPECT_EQ(bumped, rendered(by_hand, 1.0));
    EXPECT_NE(bumped, rendered("mesh { file: \"flat.obj\" }", 1.0));
    // As deep as before beside its size.
    EXPECT_EQ(bumped, rendered("mesh { file: \"dents.obj\" }", 0x1p-10));
    EXPECT_EQ(bumped, rendered("mesh { file: \"dents.obj\" }", 0x1p10));
    EXPECT_EQ(run({"--dump", "scene.lrs", "-o", "dumped.lrs"}).exit_code, 0);
    EXPECT_EQ(run({"dumped.lrs", "-o", "dumped.ppm"}).exit_code, 0);
    EXPECT_EQ(directory_.read("dumped.ppm"), bumped);
}

TEST_F(FilesOfOthers, NffIsAScene) {
    directory_.write(
        "ball.nff",
        "b 0 0 1\nv from 0 0 5 at 0 0 0 up 0 1 0 angle 45 hither 0.1 resolution 64 48\n"
        "l 0 0 9\nf 1 0.5 0.5 1 0 1 0 1\ns 0 0 0 1\n");
    for (const char* level : {"1", "2"}) {
        const auto result = run({"-n", level, "-i", "ball.nff", "-o", "ball.ppm"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        const image::Image image = picture("ball.ppm");
        ASSERT_EQ(image.width, 64u);
        ASSERT_EQ(image.height, 48u);
        EXPECT_EQ(image.at(0, 0), Color(0, 0, 1));
        EXPECT_GT(image.at(32, 24).r, 0.8f) << level;
        EXPECT_LT(image.at(32, 24).g, 0.6f) << level;
    }
    EXPECT_EQ(run({"--dump", "ball.nff", "-o", "ball.lrs"}).exit_code, 0);
    const std::vector<std::string> lit{"-n", "2", "--shading", "full", "-ps", "2"};
    const auto picture_of = [&](const std::string& scene) {
        std::vector<std::string> options = lit;
        options.insert(options.end(), {"-i", scene, "-o", "-"});
        const auto result = run(options);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return result.out;
    };
    EXPECT_EQ(picture_of("ball.lrs"), picture_of("ball.nff"));
    directory_.write("all.lrs", "include \"ball.nff\"\n");
    EXPECT_EQ(picture_of("all.lrs"), picture_of("ball.nff"));
    EXPECT_EQ(run({"--deps", "all.lrs"}).out, "all.lrs\nball.nff\n");
    EXPECT_EQ(run({"ball.nff", "-o", "small.ppm", "--size", "8x6"}).exit_code, 0);
    EXPECT_EQ(picture("small.ppm").width, 8u);
}

TEST_F(FilesOfOthers, MistakeInNffIsToldAtItsLine) {
    directory_.write("ball.nff", "f 1 1 1 1 0 1 0 1\ns 0 0 0\n");
    const auto result = run({"--check", "ball.nff"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("ball.nff:2:1: error[E0706]: `s` needs 4 numbers, this has 3\n"),
              std::string::npos)
        << result.err;
}

}  // namespace
}  // namespace lray
