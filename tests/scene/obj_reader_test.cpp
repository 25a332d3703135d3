// read_obj: every statement it knows, every spelling, every mistake at its place.
#include "scene/obj_reader.h"

#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace lray::scene {
namespace {

constexpr std::uint32_t kNone = Mesh::kNone;
constexpr IndexTriple kNoTriple = {kNone, kNone, kNone};
using Triples = std::vector<IndexTriple>;

/// An OBJ file that was loaded by a scene.
struct Reading {
    explicit Reading(std::string_view obj) {
        const SourceId scene = sources.add("scene.lrs", Text("mesh { file: \"a.obj\" }"));
        loaded_at = Span::make(scene, 13, 20);
        file = sources.add("a.obj", Text(obj));
        mesh = read_obj(sources, file, loaded_at, diagnostics);
    }

    /// "line:column code `spanned text` message", one line for each.
    std::string errors() const {
        std::string all;
        for (const Diagnostic* diagnostic : diagnostics.sorted()) {
            const Position position = sources.position(diagnostic->span);
            all += fmt::format("{}:{} {} `{}` {}\n", position.line, position.column,
                               name(diagnostic->code), sources.text(diagnostic->span),
                               diagnostic->message);
        }
        return all;
    }

    static std::string_view name(Code code) {
        if (code == Code::E0003) return "E0003";
        if (code == Code::E0701) return "E0701";
        if (code == Code::E0702) return "E0702";
        if (code == Code::E0704) return "E0704";
        if (code == Code::E0705) return "E0705";
        return "?";
    }

    Sources sources;
    Diagnostics diagnostics;
    Span loaded_at{};
    SourceId file = kNoSource;
    std::optional<Mesh> mesh;
};

/// Returns the mesh of a correct file.
Mesh read(std::string_view obj) {
    Reading reading(obj);
    EXPECT_TRUE(reading.mesh.has_value()) << reading.errors();
    EXPECT_EQ(reading.diagnostics.error_count(), 0u);
    EXPECT_EQ(reading.diagnostics.warning_count(), 0u);
    return reading.mesh.value_or(Mesh{});
}

std::string errors(std::string_view obj) {
    const Reading reading(obj);
    EXPECT_FALSE(reading.mesh.has_value());
    EXPECT_GT(reading.diagnostics.error_count(), 0u);
    for (const Diagnostic* diagnostic : reading.diagnostics.sorted()) {
        EXPECT_EQ(diagnostic->span.source, reading.file);
        if (diagnostic->labels.size() != 1) {
            ADD_FAILURE() << "no label";
            continue;
        }
        EXPECT_EQ(diagnostic->labels[0].span, reading.loaded_at);
        EXPECT_EQ(diagnostic->labels[0].message, "loaded here");
    }
    return reading.errors();
}

constexpr std::string_view kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";  // lines 1 to 3

std::string on_line_4(std::string_view text) {
    return fmt::format("{}{}\nf 1 2 3\n", kTriangle, text);
}

// What is read

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

// Mistakes

TEST(ReadObjMistakes, NumbersThatAreNone) {
    EXPECT_EQ(errors(on_line_4("v 1 x2 3")), "4:5 E0701 `x2` expected a number, found `x2`\n");
    EXPECT_EQ(errors(on_line_4("v 1 2.5.1 3")),
              "4:5 E0701 `2.5.1` expected a number, found `2.5.1`\n");
    EXPECT_EQ(errors(on_line_4("vn 1 -- 3")), "4:6 E0701 `--` expected a number, found `--`\n");
    EXPECT_EQ(errors(on_line_4("vt é")), "4:4 E0701 `é` expected a number, found `é`\n");
    EXPECT_EQ(errors(on_line_4("v 1 2e 3")), "4:5 E0701 `2e` expected a number, found `2e`\n");
    EXPECT_EQ(errors(on_line_4("v 1 2 3\\4")),
              "4:7 E0701 `3\\4` expected a number, found `3\\4`\n");
    EXPECT_EQ(
        errors(on_line_4("v 1 2,5 3")),
        "4:5 E0701 `2,5` expected a number, found `2,5`; decimals are written with a point\n");
    const std::string long_token = std::string(31, 'x') + "\xC3\xA9" + std::string(10, 'x');
    EXPECT_EQ(errors(on_line_4("v 1 2 " + long_token)),
              fmt::format("4:7 E0701 `{}` expected a number, found `{}...`\n", long_token,
                          std::string(31, 'x')));
}

TEST(ReadObjMistakes, TooFewNumbers) {
    EXPECT_EQ(errors(on_line_4("v 1 2 ")), "4:1 E0701 `v 1 2` `v` needs 3 numbers, this has 2\n");
    EXPECT_EQ(errors(on_line_4("v # 1 2 3")), "4:1 E0701 `v` `v` needs 3 numbers, this has 0\n");
    EXPECT_EQ(errors("v 1 2 3\nf 1 1 1\nv 1 \\\n\n"),
              "3:1 E0701 `v 1` `v` needs 3 numbers, this has 1\n");
}

TEST(ReadObjMistakes, TooFewNumbersInOtherStatements) {
    EXPECT_EQ(errors(on_line_4("\tvn 1")), "4:2 E0701 `vn 1` `vn` needs 3 numbers, this has 1\n");
    EXPECT_EQ(errors(on_line_4("vt")), "4:1 E0701 `vt` `vt` needs 1 to 3 numbers, this has 0\n");
}

TEST(ReadObjMistakes, NumbersThatAreNotFiniteOrTooLarge) {
    EXPECT_EQ(errors(on_line_4("v nan 2 3")),
              "4:3 E0701 `nan` expected a finite number, found `nan`\n");
    EXPECT_EQ(errors(on_line_4("v 1 -Inf 3")),
              "4:5 E0701 `-Inf` expected a finite number, found `-Inf`\n");
    EXPECT_EQ(errors(on_line_4("vt -nan(ind)")),
              "4:4 E0701 `-nan(ind)` expected a finite number, found `-nan(ind)`\n");
    EXPECT_EQ(errors(on_line_4("v 1 2 1e999")),
              "4:7 E0701 `1e999` `1e999` is too large: numbers go up to 3.4e38\n");
    EXPECT_EQ(errors(on_line_4("vn 1 -3.5e38 3")),
              "4:6 E0701 `-3.5e38` `-3.5e38` is too large: numbers go up to 3.4e38\n");
    const Mesh mesh = read(on_line_4("v 3.4028234e38 -3.4028234e38 1e-60"));
    EXPECT_EQ(mesh.positions[3],
              Vec3(std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest(), 0.0f));
}

TEST(ReadObjMistakes, CornersThatAreNone) {
    const std::string expected = "expected a corner like `1`, `1/2`, `1//3` or `1/2/3`, found";
    for (const char* corner :
         {"x", "2x", "2.5", "+2", "/2", "2/x", "2//x", "2/2/2/2", "2/-", "-", "1,", "1/2/x"}) {
        const std::string text =
            fmt::format("{0}vt 0 0\nvt 0 0\nvn 0 0 1\nvn 0 0 1\nf 1 {1} 3\n", kTriangle, corner);
        EXPECT_EQ(errors(text), fmt::format("8:5 E0701 `{0}` {1} `{0}`\n", corner, expected));
    }
}

TEST(ReadObjMistakes, FacesWithTooFewCorners) {
    EXPECT_EQ(errors(on_line_4("f 1 2  # 3")),
              "4:1 E0701 `f 1 2` a face needs at least 3 corners, this has 2\n");
    EXPECT_EQ(errors(on_line_4("f")),
              "4:1 E0701 `f` a face needs at least 3 corners, this has 0\n");
}

TEST(ReadObjMistakes, IndicesOutOfRangeOfTheWholeFile) {
    EXPECT_EQ(errors(on_line_4("f 1 2 9999")), "4:7 E0702 `9999` vertex 9999 of 3\n");
    EXPECT_EQ(errors(on_line_4("f 4 2 1\nv 1 1 1\nf 1 5 2")), "6:5 E0702 `5` vertex 5 of 4\n");
    EXPECT_EQ(errors(on_line_4("vt 0 0\nf 1/1 2/2 3/1")),
              "5:9 E0702 `2` texture coordinate 2 of 1\n");
    EXPECT_EQ(errors(on_line_4("vn 0 0 1\nf 1//1 2//1 3//7")), "5:16 E0702 `7` normal 7 of 1\n");
    EXPECT_EQ(errors(on_line_4("f 1/1 2/1 3/1")),
              "4:5 E0702 `1` texture coordinate 1, but this file has no texture coordinates\n");
}

TEST(ReadObjMistakes, IndicesAtTheEdgesOfTheirTypes) {
    for (const char* index : {"4294967294", "4294967295", "4294967296", "4294967297",
                              "18446744073709551617", "99999999999999999999999999999999"}) {
        EXPECT_EQ(errors(on_line_4(fmt::format("f 1 2 {}", index))),
                  fmt::format("4:7 E0702 `{0}` vertex {0} of 3\n", index));
    }
    EXPECT_EQ(read(on_line_4("f 0000000000000000000000003 1 2")).triangles[0],
              (IndexTriple{2, 0, 1}));
}

TEST(ReadObjMistakes, IndexZero) {
    EXPECT_EQ(errors(on_line_4("f 0 1 2")), "4:3 E0702 `0` vertex 0: indices start at 1\n");
    EXPECT_EQ(errors(on_line_4("vn 0 0 1\nf 1//1 2//00 3//1")),
              "5:11 E0702 `00` normal 00: indices start at 1\n");
}

TEST(ReadObjMistakes, NegativeIndicesBeforeTheFirst) {
    EXPECT_EQ(errors(on_line_4("f -1 -2 -4\nv 1 1 1")),
              "4:9 E0702 `-4` vertex -4, but only 3 come before this statement\n");
    EXPECT_EQ(errors(fmt::format("f -1 1 2\n{}f 1 2 3", kTriangle)),
              "1:3 E0702 `-1` vertex -1, but none comes before this statement\n");
    EXPECT_EQ(
        errors("v 0 0 0\nf 1 1 -4294967297\nv 0 0 0"),
        "2:7 E0702 `-4294967297` vertex -4294967297, but only 1 comes before this statement\n");
}

TEST(ReadObjMistakes, NoFaces) {
    EXPECT_EQ(errors(kTriangle), "1:1 E0704 `` this file has no faces (`f` statements)\n");
    EXPECT_EQ(errors(""), "1:1 E0704 `` this file has no faces (`f` statements)\n");
    EXPECT_EQ(errors("f\\"), "1:1 E0704 `` this file has no faces (`f` statements)\n");
}

TEST(ReadObjMistakes, AWrongFileWithoutFacesIsOnlyWrong) {
    EXPECT_EQ(errors("v 1 2\n"), "1:1 E0701 `v 1 2` `v` needs 3 numbers, this has 2\n");
}

TEST(ReadObjMistakes, BinaryFiles) {
    using namespace std::string_view_literals;
    EXPECT_EQ(errors("v 0 0 0\n# a\0b\nf 1 1 1\n"sv),
              "2:4 E0003 `\0` this is not OBJ text but a binary file: here is a NUL byte\n"sv);
    EXPECT_EQ(errors("v 0 0 0\nf 1 1 1\n\0"sv),
              "3:1 E0003 `\0` this is not OBJ text but a binary file: here is a NUL byte\n"sv);
    EXPECT_EQ(errors("\xFF\xFEv\0 \0"sv),
              "1:1 E0003 `\xFF\xFE` this file is UTF-16; save it as UTF-8\n");
}

TEST(ReadObjMistakes, SeveralAreToldInOneRunEachOnItsLine) {
    EXPECT_EQ(errors(on_line_4("v a b c\nf 1 2 4\nf 1 2 5\nvn 1 0\nf 1//1 2//1 3//x")),
              "4:3 E0701 `a` expected a number, found `a`\n"
              "6:7 E0702 `5` vertex 5 of 4\n"
              "7:1 E0701 `vn 1 0` `vn` needs 3 numbers, this has 2\n"
              "8:13 E0701 `3//x` expected a corner like `1`, `1/2`, `1//3` or `1/2/3`, found "
              "`3//x`\n");
}

TEST(ReadObjMistakes, AfterTwentyTheRestIsNotRead) {
    std::string text(kTriangle);
    for (int i = 0; i < 50; ++i) text += "f 1 2 7\n";
    const Reading reading(text);
    const auto sorted = reading.diagnostics.sorted();
    ASSERT_EQ(sorted.size(), 20u);
    EXPECT_TRUE(sorted[18]->notes.empty());
    ASSERT_EQ(sorted[19]->notes.size(), 1u);
    EXPECT_EQ(sorted[19]->notes[0], "after 20 errors the rest of this file is not read");
}

TEST(ReadObjMistakes, AnywhereLoadedHasNoLabel) {
    Sources sources;
    const SourceId file = sources.add("a.obj", Text("v 1 2\n"));
    Diagnostics diagnostics;
    EXPECT_FALSE(read_obj(sources, file, {}, diagnostics));
    ASSERT_EQ(diagnostics.error_count(), 1u);
    EXPECT_TRUE(diagnostics.sorted()[0]->labels.empty());
}

TEST(ReadObjMistakes, AFaceOfTooManyCorners) {
    constexpr std::size_t kMost = std::size_t{1} << 20;
    std::string text = "v 0 0 0\nf";
    for (std::size_t i = 0; i < kMost; ++i) text += " 1";
    EXPECT_EQ(read(text).triangles.size(), kMost - 2);
    text += " 1\n";
    EXPECT_EQ(errors(text),
              "2:2097155 E0705 `1` a face can have 1048576 corners; this is one more\n");
}

// One mesh in many spellings

enum class IndexStyle { absolute, relative, mixed };

/// A random mesh that is written in the order that makes relative indices interesting.
std::string write_random_mesh(std::uint32_t seed, IndexStyle style, std::string_view line_end,
                              bool has_uvs, bool has_normals, Mesh& expected) {
    std::mt19937 random(seed);
    std::mt19937 style_random(seed + 1);
    std::string text;
    const auto below = [&](std::uint32_t bound) {
        return static_cast<std::uint32_t>(random() % bound);
    };
    // Eighths: exact in a float and in four decimals.
    const auto number = [&] { return static_cast<float>(below(16001)) / 8.0f - 1000.0f; };
    const auto index = [&](std::uint32_t value, std::size_t count) {
        const bool is_relative = style == IndexStyle::relative ||
                                 (style == IndexStyle::mixed && style_random() % 2 == 0);
        return is_relative ? static_cast<long>(value) - static_cast<long>(count)
                           : static_cast<long>(value) + 1;
    };
    for (int block = 0; block < 30; ++block) {
        for (std::uint32_t i = 0, count = 3 + below(5); i < count; ++i) {
            const Vec3 p(number(), number(), number());
            expected.positions.push_back(p);
            text += fmt::format("v {} {:.4f} {:e}{}", p.x, p.y, p.z, line_end);
            if (has_uvs) {
                const Vec2 uv(number(), number());
                expected.uvs.push_back(uv);
                text += fmt::format("vt\t{} {}{}", uv.x, uv.y, line_end);
            }
            if (has_normals) {
                const int axis = static_cast<int>(below(3));
                Vec3 n(0.0f);
                n[axis] = 1.0f;
                expected.normals.push_back(n);
                text += fmt::format("vn {} {} {}{}", n.x * 7, n.y * 7, n.z * 7, line_end);
            }
        }
        for (std::uint32_t i = 0, count = below(9); i < count; ++i) {
            const auto total = static_cast<std::uint32_t>(expected.positions.size());
            IndexTriple triangle{}, uv{}, normal{};
            text += "f";
            for (std::size_t k = 0; k < 3; ++k) {
                triangle[k] = below(total);
                uv[k] = below(total);
                normal[k] = below(total);
                text += fmt::format(" {}", index(triangle[k], total));
                if (has_uvs || has_normals) text += "/";
                if (has_uvs) text += fmt::format("{}", index(uv[k], total));
                if (has_normals) text += fmt::format("/{}", index(normal[k], total));
            }
            text += line_end;
            expected.triangles.push_back(triangle);
            if (has_uvs) expected.uv_indices.push_back(uv);
            if (has_normals) expected.normal_indices.push_back(normal);
        }
    }
    return text;
}

TEST(ReadObj, RandomMeshIsTheSameInEverySpelling) {
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        for (int form = 0; form < 4; ++form) {
            for (const IndexStyle style :
                 {IndexStyle::absolute, IndexStyle::relative, IndexStyle::mixed}) {
                const char* line_end = seed % 3 == 0 ? "\r\n" : seed % 3 == 1 ? "\n" : " \r";
                SCOPED_TRACE(fmt::format("seed {}, form {}", seed, form));
                Mesh expected;
                const Mesh mesh = read(write_random_mesh(seed, style, line_end, (form & 1) != 0,
                                                         (form & 2) != 0, expected));
                ASSERT_EQ(mesh.positions, expected.positions);
                EXPECT_EQ(mesh.uvs, expected.uvs);
                EXPECT_EQ(mesh.normals, expected.normals);
                EXPECT_EQ(mesh.triangles, expected.triangles);
                EXPECT_EQ(mesh.uv_indices, expected.uv_indices);
                EXPECT_EQ(mesh.normal_indices, expected.normal_indices);
            }
        }
    }
}

/// Whatever the bytes are, there is a mesh whose indices are in range, or an error.
TEST(ReadObj, RandomTextIsAMeshOrAnError) {
    std::mt19937 random(11);
    const char* pieces[] = {"v",   "vt", "vn", "f",    "g",         "o",         " ",
                            " ",   " ",  "\n", "\n",   "\r",        "\t",        "\\\n",
                            "#",   "1",  "2",  "-1",   "/",         "//",        ".5",
                            "1e3", "x",  "\\", "\xff", "f 1 1 1\n", "v 1 2 3\n", "vn 0 0 0\n"};
    int mesh_count = 0;
    for (int round = 0; round < 50'000; ++round) {
        std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        for (std::size_t i = 0, count = random() % 12; i < count; ++i) {
            text += pieces[random() % std::size(pieces)];
        }
        const Reading reading(text);
        ASSERT_EQ(reading.mesh.has_value(), !reading.diagnostics.has_errors()) << text;
        if (!reading.mesh) continue;
        ++mesh_count;
        for (const IndexTriple& triple : reading.mesh->triangles) {
            for (const auto index : triple)
                ASSERT_LT(index, reading.mesh->positions.size()) << text;
        }
        for (const IndexTriple& triple : reading.mesh->normal_indices) {
            if (triple == kNoTriple) continue;
            for (const auto index : triple) ASSERT_LT(index, reading.mesh->normals.size()) << text;
        }
    }
    EXPECT_GT(mesh_count, 5'000);
    EXPECT_LT(mesh_count, 45'000);
}

}  // namespace
}  // namespace lray::scene
