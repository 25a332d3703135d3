// read_obj: every statement it knows, and the ways to write it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "tests/scene/formats/obj_reading.h"

namespace lray::scene {
namespace {

constexpr std::uint32_t kNone = Mesh::kNone;
constexpr IndexTriple kNoTriple = {kNone, kNone, kNone};
using Triples = std::vector<IndexTriple>;

TEST(ReadObj, TriangleIsReadExactly) {
    const Mesh mesh = read("v 1 -2.5 3e2\nv +.5 1. -0\nv 1e-3 16777217 0.1\nf 1 2 3\n");
    const std::vector<Vec3> positions = {
        {1.0f, -2.5f, 300.0f}, {0.5f, 1.0f, -0.0f}, {1e-3f, 16777216.0f, 0.1f}};
    EXPECT_EQ(mesh.positions, positions);
    EXPECT_TRUE(std::signbit(mesh.positions[1].z));
    EXPECT_EQ(mesh.triangles, (Triples{{0, 1, 2}}));
    EXPECT_TRUE(mesh.normals.empty());
    EXPECT_TRUE(mesh.uvs.empty());
    EXPECT_TRUE(mesh.normal_indices.empty());
    EXPECT_TRUE(mesh.uv_indices.empty());
    EXPECT_TRUE(mesh.parts.empty());
}

TEST(ReadObj, WeightsAndColoursAfterPositionsAreSkipped) {
    const Mesh mesh = read("v 0 0 0 1.0\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0 # up\nf 1 2 3 # all\n");
    EXPECT_EQ(mesh.positions[1], Vec3(1, 0, 0));
    EXPECT_EQ(mesh.positions[2], Vec3(0, 1, 0));
}

TEST(ReadObj, TextureCoordinatesHaveOneToThreeNumbers) {
    const Mesh mesh = read(on_line_4("vt 0.5\nvt 0.25 0.75 # two\nvt 1 2 3"));
    EXPECT_EQ(mesh.uvs, (std::vector<Vec2>{{0.5f, 0.0f}, {0.25f, 0.75f}, {1.0f, 2.0f}}));
    EXPECT_TRUE(mesh.uv_indices.empty());
}

TEST(ReadObj, NormalsBecomeUnitWhateverTheirLength) {
    const Mesh mesh = read(on_line_4("vn 0 0 5\nvn 3e-30 0 -4e-30\nvn 3e30 4e30 0\nvn 1 1 1"));
    ASSERT_EQ(mesh.normals.size(), 4u);
    EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[1], Vec3(0.6f, 0, -0.8f));
    EXPECT_EQ(mesh.normals[2], Vec3(0.6f, 0.8f, 0));
    EXPECT_EQ(mesh.normals[3], Vec3(static_cast<float>(1 / std::sqrt(3.0))));
}

TEST(ReadObj, FacesThatUseAZeroNormalHaveNone) {
    const Mesh mesh =
        read(fmt::format("{}vn 0 0 1\nvn 0 0 0\nf 1//1 2//1 3//1\nf 1//1 2//2 3//1\n", kTriangle));
    EXPECT_EQ(mesh.normal_indices, (Triples{{0, 0, 0}, kNoTriple}));
    EXPECT_EQ(mesh.normals.size(), 2u);
}

TEST(ReadObj, CornersAreReadInEveryForm) {
    const std::string head = fmt::format("{}vt 0 0\nvt 1 0\nvn 0 0 1\nvn 0 1 0\n", kTriangle);
    const Mesh plain = read(head + "f 1 2 3\n");
    EXPECT_TRUE(plain.uv_indices.empty());
    EXPECT_TRUE(plain.normal_indices.empty());
    const Mesh with_uvs = read(head + "f 1/2 2/1 3/2\n");
    EXPECT_EQ(with_uvs.uv_indices, (Triples{{1, 0, 1}}));
    EXPECT_TRUE(with_uvs.normal_indices.empty());
    const Mesh with_normals = read(head + "f 1//2 2//1 3//2\n");
    EXPECT_TRUE(with_normals.uv_indices.empty());
    EXPECT_EQ(with_normals.normal_indices, (Triples{{1, 0, 1}}));
    const Mesh with_both = read(head + "f 1/1/2 2/2/1 3/1/2\n");
    EXPECT_EQ(with_both.uv_indices, (Triples{{0, 1, 0}}));
    EXPECT_EQ(with_both.normal_indices, (Triples{{1, 0, 1}}));
    const Mesh left_out = read(head + "f 1/ 2// 3/1/\n");
    EXPECT_TRUE(left_out.uv_indices.empty());
    EXPECT_TRUE(left_out.normal_indices.empty());
}

TEST(ReadObj, FacesThatLackWhatOthersHaveGetNone) {
    const Mesh mesh = read(fmt::format(
        "{}vt 0 0\nvn 0 0 1\nf 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 3/1\n",
        kTriangle));
    EXPECT_EQ(mesh.triangles.size(), 4u);
    EXPECT_EQ(mesh.uv_indices, (Triples{kNoTriple, {0, 0, 0}, kNoTriple, {0, 0, 0}}));
    EXPECT_EQ(mesh.normal_indices, (Triples{kNoTriple, kNoTriple, {0, 0, 0}, kNoTriple}));
}

TEST(ReadObj, NegativeIndicesCountBackFromTheirStatement) {
    const Mesh mesh = read(fmt::format(
        "{}vt 0 0\nvn 0 0 1\nf -3/-1/-1 -2/-1/-1 -1/-1/-1\nv 5 5 5\nf -1 -2 -4\n", kTriangle));
    EXPECT_EQ(mesh.triangles, (Triples{{0, 1, 2}, {3, 2, 0}}));
    EXPECT_EQ(mesh.uv_indices, (Triples{{0, 0, 0}, kNoTriple}));
}

TEST(ReadObj, IndicesMayReferToWhatComesLater) {
    const Mesh mesh = read(fmt::format("f 1//1 2//1 3//1\n{}vn 0 0 1\n", kTriangle));
    EXPECT_EQ(mesh.triangles, (Triples{{0, 1, 2}}));
    EXPECT_EQ(mesh.normal_indices, (Triples{{0, 0, 0}}));
}

constexpr std::string_view kArrowhead =  // concave at its third corner of the face below
    "v 0 0 0\nv 2 -1 0\nv 1 0 0\nv 2 1 0\nvt 0 0\nvt 2 -1\nvt 1 0\nvt 2 1\n";

TEST(ReadObj, ConcavePolygonsAreCutInsideWithTheirUvs) {
    const Mesh mesh = read(fmt::format("{}f 2/2 3/3 4/4 1/1\n", kArrowhead));
    EXPECT_EQ(mesh.triangles, (Triples{{2, 3, 0}, {2, 0, 1}}));
    EXPECT_EQ(mesh.uv_indices, mesh.triangles);
}

TEST(ReadObj, ConcavePolygonsBeforeTheirPositionsAreCutTheSame) {
    const std::string face = "f 2/2 3/3 4/4 1/1\n";
    const Mesh early = read(face + std::string(kArrowhead));
    const Mesh late = read(std::string(kArrowhead) + face);
    EXPECT_EQ(early.triangles, late.triangles);
    EXPECT_EQ(early.uv_indices, late.uv_indices);
}

TEST(ReadObj, ConvexPolygonIsAFan) {
    const Mesh mesh = read("v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5\n");
    EXPECT_EQ(mesh.triangles, (Triples{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

std::string parts_of(const Mesh& mesh) {
    std::string all;
    for (const MeshPart& part : mesh.parts) {
        all += fmt::format("{}:{}+{} ", part.name, part.first_triangle, part.triangle_count);
    }
    return all;
}

TEST(ReadObj, GroupsAreParts) {
    const std::string f = "f 1 2 3\n";
    const std::string head(kTriangle);
    EXPECT_EQ(parts_of(read(head + f + "g a\n" + f + f + "g b\n" + f)), "a:1+2 b:3+1 ");
    EXPECT_EQ(parts_of(read(head + "g left  arm\tskin \n" + f)), "left arm skin:0+1 ");
    EXPECT_EQ(parts_of(read(head + "g Object #1\n" + f)), "Object #1:0+1 ");
    EXPECT_EQ(parts_of(read(head + "g\n" + f)), "default:0+1 ");
    EXPECT_EQ(parts_of(read(head + "g a\ng b\n" + f + "g c\n")), "b:0+1 ");
    EXPECT_EQ(parts_of(read(head + "g a\n" + f + "usemtl red\ng a\n" + f)), "a:0+2 ");
}

TEST(ReadObj, ObjectsContainTheirGroups) {
    const std::string f = "f 1 2 3\n";
    const std::string head(kTriangle);
    EXPECT_EQ(parts_of(read(head + "o car\ng body\n" + f + "g wheels\n" + f + "o road\n" + f)),
              "car:0+2 body:0+1 wheels:1+1 road:2+1 ");
    EXPECT_EQ(parts_of(read(head + "g a\no empty\no b\n" + f)), "b:0+1 ");
    EXPECT_EQ(parts_of(read(head + "g a\n" + f + "o b\n" + f)), "a:0+1 b:1+1 ");
}

TEST(ReadObj, OtherStatementsAreSkipped) {
    const Mesh mesh = read(
        "mtllib a.mtl\nusemtl red\ns off\ns 1\nvp 0.5\nl 1 2 3\np 1\nfo 1 2\nvtx\nvnn 1\nfoo\n"
        "group x\nobject y\ncstype bezier\n#v 9 9 9\n\t# f 9 9 9\n" +
        on_line_4(""));
    EXPECT_EQ(mesh.positions.size(), 3u);
    EXPECT_EQ(mesh.triangles.size(), 1u);
    EXPECT_TRUE(mesh.parts.empty());
}

TEST(ReadObj, ByteOrderMarkIsSkipped) {
    EXPECT_EQ(read("\xEF\xBB\xBF" + on_line_4("")).positions.size(), 3u);
}

TEST(ReadObj, LinesMayBeJoinedByABackslash) {
    const Mesh mesh = read(
        "v 0 \\\n 0 0\nv\\\r\n1 0 0 \\\n 0.5\nv 0 1\\\r0\nf 1 2\\\n\\\n 3\ng a\\\nb\nf 1 \\\n2 3 "
        "\\\n");
    EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.triangles, (Triples{{0, 1, 2}, {0, 1, 2}}));
    EXPECT_EQ(parts_of(mesh), "a b:1+1 ");
}

TEST(ReadObj, BackslashInACommentOrPathJoinsNothing) {
    const Mesh mesh = read("# C:\\meshes\\\nv 0 0 0\nmtllib C:\\\nv 1 0 0\nv 0 1 0\nf 1 2 3");
    EXPECT_EQ(mesh.positions.size(), 3u);
}

/// The same lines with other line ends and blanks are the same mesh.
TEST(ReadObj, LineEndsAndBlanksDoNotMatter) {
    const std::string plain = fmt::format(
        "# a comment\n{}vt 0.5 0.25\nvn 0 0 1\n\ng a b\nf 1/1/1 2/1/1 3/1/1\n", kTriangle);
    const Mesh expected = read(plain);
    const auto replaced = [&](std::string_view from, std::string_view to) {
        std::string text;
        for (const char c : plain) {
            if (std::string_view(&c, 1) == from) {
                text += to;
            } else {
                text += c;
            }
        }
        return text;
    };
    const std::string spellings[] = {
        replaced("\n", "\r\n"),
        replaced("\n", "\r"),
        replaced("\n", " \t\n\n  \t"),
        replaced(" ", "\t"),
        replaced(" ", " \\\r\n \\\n"),
        plain.substr(0, plain.size() - 1),
        plain + " ",
        plain + "#",
        replaced("\n", "\t\r\n\r\n "),
    };
    for (const std::string& spelling : spellings) {
        const Mesh mesh = read(spelling);
        EXPECT_EQ(mesh.positions, expected.positions) << spelling;
        EXPECT_EQ(mesh.triangles, expected.triangles) << spelling;
        EXPECT_EQ(mesh.uv_indices, expected.uv_indices) << spelling;
        EXPECT_EQ(mesh.normal_indices, expected.normal_indices) << spelling;
        EXPECT_EQ(parts_of(mesh), parts_of(expected)) << spelling;
    }
}

}  // namespace
}  // namespace lray::scene
