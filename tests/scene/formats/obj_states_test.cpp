// read_obj: colours, materials, smoothing groups, and that a file may be cut anywhere.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "image/srgb.h"
#include "tests/scene/formats/obj_reading.h"

namespace lray::scene {

static bool operator==(const MaterialRun& a, const MaterialRun& b) {
    return a.first_triangle == b.first_triangle && a.material == b.material;
}
static bool operator==(const MeshPart& a, const MeshPart& b) {
    return a.name == b.name && a.first_triangle == b.first_triangle &&
           a.triangle_count == b.triangle_count;
}

namespace {

using Names = std::vector<std::string>;

TEST(ReadObj, ColoursAreDecodedAndWhiteWhereThereIsNone) {
    const Mesh mesh =
        read("v 0 0 0 1.0\nv 1 0 0 0.5 0 2 # c\nv 0 1 0 -1 1 1 0.5\nv 1 1 1\nf 1 2 3");
    ASSERT_EQ(mesh.colors.size(), 4u);
    EXPECT_EQ(mesh.colors[0], Color{1.0f});
    EXPECT_EQ(mesh.colors[1], (Color{static_cast<float>(image::srgb_decode(0.5)), 0.0f, 1.0f}));
    EXPECT_EQ(mesh.colors[2], (Color{0.0f, 1.0f, 1.0f}));
    EXPECT_EQ(mesh.colors[3], Color{1.0f});
    EXPECT_TRUE(read(on_line_4("v 1 1 1 0.5\nv 1 1 1 a b c")).colors.empty());
}

TEST(ReadObj, MaterialsAreRunsOfTriangles) {
    const Mesh mesh = read(fmt::format(
        "mtllib a.mtl b c.MTL\nmtllib a.mtl\n{}f 1 2 3\nusemtl  red  oak \nusemtl blue\n"
        "f 1 2 3\nf 1 2 3\nusemtl red\tstone # 2\nf 1 2 3\nusemtl blue\nf 1 2 3\nusemtl\nf 1 2 3\n"
        "usemtl last",
        kTriangle));
    EXPECT_EQ(mesh.material_files, (Names{"a.mtl", "b c.MTL"}));
    EXPECT_EQ(mesh.material_names, (Names{"blue", "red stone # 2"}));
    const std::vector<MaterialRun> runs = {{1, 0}, {3, 1}, {4, 0}, {5, MaterialRun::kNone}};
    EXPECT_EQ(mesh.material_runs, runs);
    EXPECT_FALSE(material_run_at(mesh, 0));
    EXPECT_EQ(material_run_at(mesh, 1), 0u);
    EXPECT_EQ(material_run_at(mesh, 2), 0u);
    EXPECT_EQ(material_run_at(mesh, 9), 3u);
}

TEST(ReadObj, FilesWithMaterialsMayHaveNamesOfOtherEndingsAlone) {
    EXPECT_EQ(read(on_line_4("mtllib my materials.lib\nmtllib")).material_files,
              Names{"my materials.lib"});
    EXPECT_EQ(read(on_line_4("mtllib a  b.mtl  c.mtl\td")).material_files,
              (Names{"a  b.mtl", "c.mtl", "d"}));
}

TEST(ReadObj, OnlySomeFilesWithMaterialsAreKept) {
    std::string many(kTriangle);
    for (int i = 0; i < 1000; ++i) many += fmt::format("mtllib {}.mtl\n", i);
    EXPECT_EQ(read(many + "f 1 2 3\n").material_files.size(), 65u);
}

TEST(ReadObj, SmoothingGroupsShareNormals) {
    // A roof: two sides that meet along an edge.
    const std::string roof = "v 0 0 0\nv 0 0 1\nv -1 -1 0\nv 1 -1 0\nvn 0 0 1\n";
    const Mesh smooth = read(roof + "s 3\nf 1 3 2\nf 1 2 4\n");
    ASSERT_EQ(smooth.normal_indices.size(), 2u);
    EXPECT_EQ(smooth.normals[smooth.normal_indices[0][0]], Vec3(0, 1, 0));
    EXPECT_EQ(smooth.normal_indices[0][0], smooth.normal_indices[1][0]);
    for (const char* const off : {"s off", "s 0", "s", "# none"}) {
        EXPECT_TRUE(read(fmt::format("{}{}\nf 1 3 2\nf 1 2 4\n", roof, off)).normal_indices.empty())
            << off;
    }
    const Mesh two = read(roof + "s 1\nf 1 3 2\ns 4294967297\nf 1 2 4\n");
    EXPECT_EQ(two.normals.size(), 1u);
    const Mesh given = read(roof + "s 1\nf 1//1 3//1 2//1\nf 1 2 4\n");
    EXPECT_EQ(given.normals.size(), 1u);
    EXPECT_EQ(given.normal_indices[0], (IndexTriple{0, 0, 0}));
}

TEST(ReadObj, ElementsAreSkippedAndFreeFormsAreCounted) {
    EXPECT_EQ(read(on_line_4("p 1\nl 1 2\nvp 1\ncstype bezier\nend\ncurves")).triangles.size(), 1u);
    const Reading reading(on_line_4("curv 0 1 1 2\nsurf 0 1 0 1 1 2 3\ncurv2 1"));
    ASSERT_TRUE(reading.mesh);
    ASSERT_EQ(reading.diagnostics.warning_count(), 1u);
    const Diagnostic& warning = *reading.diagnostics.sorted()[0];
    EXPECT_EQ(warning.code, Code::W1704);
    EXPECT_EQ(warning.message, "3 free-form curves or surfaces of this file are not read");
    EXPECT_EQ(reading.sources.position(warning.span).line, 4u);
}

TEST(ReadObj, AByteOrderMarkDoesNotHideAVertex) {
    EXPECT_EQ(errors("\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\n"),
              "5:7 E0702 `4` vertex 4 of 3\n");
}

TEST(ReadObj, APolygonOfManyCornersIsCut) {
    constexpr int kCount = 100'000;
    std::string text;
    std::string face = "f";
    for (int i = 0; i < kCount; ++i) {
        const double turn = 6.283185307179586 * i / kCount;
        text += fmt::format("v {:.6f} {:.6f} 0\n", std::cos(turn), std::sin(turn));
        face += fmt::format(" {}", i + 1);
    }
    EXPECT_EQ(read(text + face + "\n").triangles.size(), std::size_t{kCount - 2});
}

/// Text with all that may reach from one piece of a file into another.
std::string random_obj(std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
    std::string text = "\xEF\xBB\xBFmtllib a.mtl\n";
    std::uint32_t count = 0;
    const auto vertex = [&] {
        text += fmt::format("v {} {} {}{}\n", below(100), below(100), below(100),
                            below(3) == 0 ? " 0.5 0.25 1" : "");
        text += fmt::format("vt 0.{} 0.5\nvn {} 1 0\n", below(9), below(5));
        ++count;
    };
    for (int i = 0; i < 8; ++i) vertex();
    for (int i = 0; i < 300; ++i) {
        switch (below(9)) {
            case 0:
                text += fmt::format("g group {}\n", below(3));
                break;
            case 1:
                text += fmt::format("o object{}\r\n", below(3));
                break;
            case 2:
                text += fmt::format("usemtl m{}\n", below(4));
                break;
            case 3:
                text += fmt::format("s {}\n", below(3));
                break;
            case 4:
                vertex();
                break;
            case 5:
                text += below(2) == 0 ? "# a comment \\\n" : "mtllib b.mtl\ncurv 1\n";
                break;
            default: {
                text += 'f';
                const bool is_negative = below(2) == 0;
                const bool has_all = below(3) == 0;
                for (std::uint32_t k = 0, corners = 3 + below(4); k < corners; ++k) {
                    const std::uint32_t element = 1 + below(count);
                    const std::string index = fmt::format("{}{}", is_negative ? "-" : "", element);
                    text += k == 2 && below(4) == 0 ? " \\\n " : " ";
                    text += has_all ? fmt::format("{0}/{0}/{0}", index) : index;
                }
                text += '\n';
            }
        }
    }
    // Forward references.
    return text + fmt::format("f 1 2 {}\nv 1 2 3\n", count + 1) + "f 1 2 3 4\n";
}

TEST(ReadObj, AFileReadInPiecesIsTheSame) {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        const std::string text = random_obj(seed);
        Sources sources;
        Diagnostics diagnostics;
        const SourceId file = sources.add("a.obj", Text(text));
        const auto whole = read_obj(sources, file, Span{}, diagnostics, text.size());
        ASSERT_TRUE(whole) << seed;
        for (const std::size_t size : {1u, 7u, 64u, 500u, 3000u}) {
            const auto pieces = read_obj(sources, file, Span{}, diagnostics, size);
            ASSERT_TRUE(pieces) << seed;
            EXPECT_EQ(pieces->positions, whole->positions) << seed;
            EXPECT_EQ(pieces->normals, whole->normals) << seed;
            EXPECT_EQ(pieces->uvs, whole->uvs) << seed;
            EXPECT_EQ(pieces->colors, whole->colors) << seed;
            EXPECT_EQ(pieces->triangles, whole->triangles) << seed;
            EXPECT_EQ(pieces->normal_indices, whole->normal_indices) << seed;
            EXPECT_EQ(pieces->uv_indices, whole->uv_indices) << seed;
            EXPECT_EQ(pieces->parts, whole->parts) << seed << " " << size;
            EXPECT_EQ(pieces->material_runs, whole->material_runs) << seed;
            EXPECT_EQ(pieces->material_names, whole->material_names) << seed;
            EXPECT_EQ(pieces->material_files, whole->material_files) << seed;
        }
    }
}

TEST(ReadObj, MistakesInPiecesAreToldAsInOne) {
    const std::string text = random_obj(1) + "f 1 2 99999\nv x 0 0\n";
    Reading reading("");
    const SourceId file = reading.sources.add("b.obj", Text(text));
    Diagnostics diagnostics;
    EXPECT_FALSE(read_obj(reading.sources, file, Span{}, diagnostics, 64));
    EXPECT_EQ(diagnostics.error_count(), 2u);
}

}  // namespace
}  // namespace lray::scene
