// read_ply: every way in which correct files are written.
#include "scene/formats/ply_reader.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "image/srgb.h"
#include "tests/scene/formats/ply_reading.h"

namespace lray::scene::ply {
namespace {

using Triangles = std::vector<IndexTriple>;
using Points = std::vector<Vec3>;

const Points kCorners = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};

/// A file with three vertices and a triangle in binary.
std::string binary_triangle(bool is_big_endian) {
    Bytes body(is_big_endian);
    body.add_all(0.0f, 0, 0, 1, 0, 0, 0, 1, 0);
    body.add(std::uint8_t{3}).add_all(std::int32_t{0}, 1, 2);
    return header(is_big_endian ? "binary_big_endian" : "binary_little_endian",
                  fmt::format("element vertex 3\n{}element face 1\n"
                              "property list uchar int vertex_indices\n",
                              kXyz)) +
           body.text();
}

TEST(ReadPly, ATriangleInEachCoding) {
    for (const std::string& file :
         {ascii_face("3 0 1 2"), binary_triangle(false), binary_triangle(true)}) {
        const Mesh mesh = mesh_of(file);
        EXPECT_EQ(mesh.positions, kCorners);
        EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}}));
        EXPECT_TRUE(mesh.normals.empty());
        EXPECT_TRUE(mesh.normal_indices.empty());
        EXPECT_TRUE(mesh.uvs.empty());
        EXPECT_TRUE(mesh.uv_indices.empty());
        EXPECT_TRUE(mesh.colors.empty());
    }
}

TEST(ReadPly, EveryPrefixOfABinaryFileIsTold) {
    for (const bool is_big_endian : {false, true}) {
        const std::string file = binary_triangle(is_big_endian);
        for (std::size_t size = 0; size < file.size(); ++size) {
            EXPECT_NE(error_of(file.substr(0, size)), "not one error") << size;
        }
    }
}

TEST(ReadPly, EveryTypeOfCoordinate) {
    const auto read_type = [](std::string_view type, auto zero, bool is_big_endian) {
        using T = decltype(zero);
        Bytes body(is_big_endian);
        body.add_all(T{0}, 0, 0, 100, 0, 0, 0, 3, 0);
        body.add(std::uint8_t{3}).add_all(std::int32_t{0}, 1, 2);
        const std::string lines = fmt::format(
            "element vertex 3\nproperty {0} x\nproperty {0} y\nproperty {0} z\n"
            "element face 1\nproperty list uchar int vertex_indices\n",
            type);
        const Mesh mesh =
            mesh_of(header(is_big_endian ? "binary_big_endian" : "binary_little_endian", lines) +
                    body.text());
        EXPECT_EQ(mesh.positions, (Points{Vec3(0), Vec3(100, 0, 0), Vec3(0, 3, 0)})) << type;
    };
    for (const bool big : {false, true}) {
        for (const char* type : {"char", "int8"}) read_type(type, std::int8_t{}, big);
        for (const char* type : {"uchar", "uint8"}) read_type(type, std::uint8_t{}, big);
        for (const char* type : {"short", "int16"}) read_type(type, std::int16_t{}, big);
        for (const char* type : {"ushort", "uint16"}) read_type(type, std::uint16_t{}, big);
        for (const char* type : {"int", "int32"}) read_type(type, std::int32_t{}, big);
        for (const char* type : {"uint", "uint32"}) read_type(type, std::uint32_t{}, big);
        for (const char* type : {"float", "float32"}) read_type(type, float{}, big);
        for (const char* type : {"double", "float64"}) read_type(type, double{}, big);
    }
}

template <class Count, class Index>
void read_list(std::string_view count_type, std::string_view index_type) {
    for (const bool is_big_endian : {false, true}) {
        Bytes body(is_big_endian);
        body.add_all(0.0f, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0);
        body.add(Count{3}).add_all(Index{0}, 1, 2);
        body.add(Count{4}).add_all(Index{0}, 1, 2, 3);
        body.add(Count{3}).add_all(Index{3}, 2, 1);
        const std::string lines =
            fmt::format("element vertex 4\n{}element face 3\nproperty list {} {} vertex_index\n",
                        kXyz, count_type, index_type);
        const Mesh mesh =
            mesh_of(header(is_big_endian ? "binary_big_endian" : "binary_little_endian", lines) +
                    body.text());
        EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}, {3, 2, 1}}))
            << count_type << ' ' << index_type;
    }
}

TEST(ReadPly, EveryTypeOfListAndAPolygonAmongTriangles) {
    read_list<std::int8_t, std::int8_t>("char", "int8");
    read_list<std::uint8_t, std::uint8_t>("uchar", "uint8");
    read_list<std::uint8_t, std::int32_t>("uchar", "int");
    read_list<std::uint8_t, std::uint32_t>("uint8", "uint");
    read_list<std::int16_t, std::uint16_t>("short", "ushort");
    read_list<std::uint16_t, std::int16_t>("ushort", "short");
    read_list<std::int32_t, std::int32_t>("int", "int32");
    read_list<std::uint32_t, std::uint32_t>("uint32", "uint32");
    read_list<std::uint32_t, std::uint8_t>("uint", "uchar");
}

TEST(ReadPly, PropertiesInAnyOrderAndUnknownOnesBetween) {
    const Mesh mesh = mesh_of(header("ascii",
                                     "comment any words: element vertex 9\n"
                                     "obj_info scanned\n"
                                     "element camera 1\n"
                                     "property float view\n"
                                     "property list uchar float matrix\n"
                                     "element vertex 3\n"
                                     "property float confidence\n"
                                     "property float z\n"
                                     "property list uchar int neighbours\n"
                                     "property float y\n"
                                     "comment between\n"
                                     "property float x\n"
                                     "element nothing 3\n"
                                     "element edge 2\n"
                                     "property int vertex1\n"
                                     "element face 1\n"
                                     "property uchar red\n"
                                     "property list uchar float texcoord\n"
                                     "property list uchar int vertex_indices\n"
                                     "property int flags\n") +
                              "0.5 2 1.5 -2.5\n"
                              "9 3 2 7 7 2 1\n"
                              "\n"
                              "9 6 0 5 4\n"
                              "  9 10 1 7 8 7\n"
                              "1\n2\n"
                              "255 6 0 0 1 0 1 1 3 2 0 1 -5\n");
    EXPECT_EQ(mesh.positions, (Points{Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(7, 8, 10)}));
    EXPECT_EQ(mesh.triangles, (Triangles{{2, 0, 1}}));
}

TEST(ReadPly, UnknownPropertiesAndListsInBinary) {
    Bytes body(false);
    body.add(std::int16_t{2}).add_all(1.0, 2.0);  // camera
    for (int i = 0; i < 3; ++i) {
        body.add(std::uint8_t{7});
        body.add(std::uint32_t{2}).add_all(std::uint16_t{5}, 5);
        body.add_all(static_cast<float>(i == 1), static_cast<float>(i == 2), 0);
    }
    body.add_all(std::uint8_t{1}, 2, 3);  // the colour of the face
    body.add(std::uint8_t{3}).add_all(std::int32_t{0}, 1, 2);
    body.add(std::uint8_t{2}).add_all(0.5f, 0.5f);
    const Mesh mesh = mesh_of(header("binary_little_endian",
                                     fmt::format("element camera 1\nproperty list short double m\n"
                                                 "element vertex 3\nproperty uchar quality\n"
                                                 "property list uint ushort neighbours\n{}"
                                                 "element face 1\nproperty uchar red\n"
                                                 "property uchar green\nproperty uchar blue\n"
                                                 "property list uchar int vertex_indices\n"
                                                 "property list uchar float texcoord\n",
                                                 kXyz)) +
                              body.text());
    EXPECT_EQ(mesh.positions, kCorners);
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}}));
    EXPECT_TRUE(mesh.colors.empty());
}

TEST(ReadPly, FacesBeforeVertices) {
    const std::string lines = fmt::format(
        "element face 2\nproperty list uchar int vertex_indices\nelement vertex 4\n{}", kXyz);
    const Triangles expected = {{0, 1, 2}, {1, 3, 2}, {1, 0, 3}};
    const Mesh ascii =
        mesh_of(header("ascii", lines) + "3 0 1 2\n4 1 0 3 2\n0 0 0\n1 0 0\n0.2 0.2 0\n0 1 0\n");
    Bytes body(true);
    body.add(std::uint8_t{3}).add_all(std::int32_t{0}, 1, 2);
    body.add(std::uint8_t{4}).add_all(std::int32_t{1}, 0, 3, 2);
    body.add_all(0.0f, 0, 0, 1, 0, 0, 0.2f, 0.2f, 0, 0, 1, 0);
    const Mesh binary = mesh_of(header("binary_big_endian", lines) + body.text());
    EXPECT_EQ(ascii.triangles.size(), 3u);
    EXPECT_EQ(ascii.triangles, binary.triangles);
    EXPECT_EQ(ascii.positions.size(), 4u);
    EXPECT_EQ(ascii.triangles[0], expected[0]);
}

TEST(ReadPly, AConcavePolygonIsCutByItsShape) {
    // An arrow head whose notch is the third corner: a fan from the first would cover the notch.
    const Mesh mesh = mesh_of(header("ascii", fmt::format("element vertex 4\n{}element face 1\n"
                                                          "property list uchar int vertex_index\n",
                                                          kXyz)) +
                              "-1 0 0\n0 0.2 0\n1 0 0\n0 1 0\n4 0 1 2 3\n");
    EXPECT_EQ(mesh.triangles, (Triangles{{1, 2, 3}, {1, 3, 0}}));
}

TEST(ReadPly, StripsAlternateAndBeginAnew) {
    const std::string lines = fmt::format(
        "element vertex 6\n{}element tristrips 2\nproperty list int int vertex_indices\n", kXyz);
    const std::string rows = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n";
    const Triangles expected = {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {3, 4, 5}, {1, 2, 3}};
    // After -1 a strip of four; a strip of two makes nothing.
    const Mesh ascii =
        mesh_of(header("ascii", lines) + rows + "12 0 1 2 3 4 -1 0 1 -1 3 4 5\n3 1 2 3\n");
    EXPECT_EQ(ascii.triangles, expected);
    Bytes body(false);
    body.add_all(0.0f, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0, 1, 2, 0);
    body.add_all(std::int32_t{12}, 0, 1, 2, 3, 4, -1, 0, 1, -1, 3, 4, 5);
    body.add_all(std::int32_t{3}, 1, 2, 3);
    EXPECT_EQ(mesh_of(header("binary_little_endian", lines) + body.text()).triangles, expected);
}

TEST(ReadPly, StripsKeepTheirWindingOverRepeatedVertices) {
    const std::string lines = fmt::format(
        "element vertex 6\n{}element tristrips 1\nproperty list int int vertex_indices\n", kXyz);
    const Mesh mesh = mesh_of(header("ascii", lines) +
                              "0 0 0\n1 0 0\n0 1 0\n5 0 0\n6 0 0\n5 1 0\n8 0 1 2 2 3 3 4 5\n");
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {4, 3, 5}}));
}

TEST(ReadPly, NormalsAreMadeUnitAndThoseWithoutDirectionUnused) {
    const Mesh mesh = mesh_of(
        header("ascii", fmt::format("element vertex 5\n{}property float nz\nproperty float nx\n"
                                    "property float ny\nelement face 3\n"
                                    "property list uchar int vertex_indices\n",
                                    kXyz)) +
        "0 0 0 2 0 0\n1 0 0 0 1e-30 0\n0 1 0 0 0 3e38\n2 2 2 0 0 0\n3 2 2 nan 0 inf\n"
        "3 0 1 2\n3 0 1 3\n3 4 1 2\n");
    ASSERT_EQ(mesh.normals.size(), 5u);
    EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[1], Vec3(1, 0, 0));
    EXPECT_EQ(mesh.normals[2], Vec3(0, 1, 0));
    EXPECT_EQ(mesh.normals[3], Vec3(0, 0, 0));
    EXPECT_EQ(mesh.normals[4], Vec3(0, 0, 0));
    constexpr IndexTriple kNo = {Mesh::kNone, Mesh::kNone, Mesh::kNone};
    EXPECT_EQ(mesh.normal_indices, (Triangles{{0, 1, 2}, kNo, kNo}));
}

TEST(ReadPly, TextureCoordinatesByEachName) {
    for (const auto& [u, v] : std::vector<std::array<std::string_view, 2>>{
             {"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}) {
        const Mesh mesh =
            mesh_of(header("ascii", fmt::format("element vertex 3\n{}property float {}\n"
                                                "property float {}\nelement face 1\n"
                                                "property list uchar int vertex_indices\n",
                                                kXyz, u, v)) +
                    "0 0 0 0.25 0.5\n1 0 0 1 0\n0 1 0 -2 3\n3 0 2 1\n");
        EXPECT_EQ(mesh.uvs, (std::vector<Vec2>{Vec2(0.25, 0.5), Vec2(1, 0), Vec2(-2, 3)}));
        EXPECT_EQ(mesh.uv_indices, (Triangles{{0, 2, 1}}));
    }
}

std::string colored(std::string_view type, std::string_view prefix, std::string_view rows) {
    return header("ascii", fmt::format("element vertex 3\n{0}property {1} {2}red\n"
                                       "property {1} {2}green\nproperty {1} {2}blue\n"
                                       "property {1} alpha\nelement face 1\n"
                                       "property list uchar int vertex_indices\n",
                                       kXyz, type, prefix)) +
           std::string(rows) + "3 0 1 2\n";
}

TEST(ReadPly, ColoursAreDecodedFromEachType) {
    const Color first(1.0f, 0.0f, image::srgb_decode_8(51));
    const std::string_view bytes = "0 0 0 255 0 51 9\n1 0 0 0 255 0 9\n0 1 0 300 -4 0 9\n";
    for (const std::string& file :
         {colored("uchar", "", bytes), colored("int", "", bytes),
          colored("uint8", "diffuse_", bytes),
          colored("ushort", "", "0 0 0 65535 0 13107 9\n1 0 0 0 65535 0 9\n0 1 0 65535 0 0 9\n"),
          colored("float", "", "0 0 0 1 0 0.2 9\n1 0 0 0 1 0 9\n0 1 0 1.5 -0.1 nan 9\n")}) {
        const Mesh mesh = mesh_of(file);
        ASSERT_EQ(mesh.colors.size(), 3u);
        EXPECT_EQ(mesh.colors[0].r, first.r);
        EXPECT_EQ(mesh.colors[0].g, first.g);
        EXPECT_NEAR(mesh.colors[0].b, first.b, 1e-7);
        EXPECT_EQ(mesh.colors[1], Color(0, 1, 0));
        EXPECT_EQ(mesh.colors[2], Color(1, 0, 0));
    }
}

TEST(ReadPly, ColoursOfBytesInBinary) {
    Bytes body(false);
    for (int i = 0; i < 3; ++i) {
        body.add_all(static_cast<float>(i == 1), static_cast<float>(i == 2), 0);
        body.add_all(std::uint8_t{10}, 20 + i, 250);
    }
    body.add(std::uint8_t{3}).add_all(std::int32_t{0}, 1, 2);
    const Mesh mesh =
        mesh_of(header("binary_little_endian",
                       fmt::format("element vertex 3\n{}property uchar red\nproperty uchar green\n"
                                   "property uchar blue\nelement face 1\n"
                                   "property list uchar int vertex_indices\n",
                                   kXyz)) +
                body.text());
    EXPECT_EQ(mesh.positions, kCorners);
    ASSERT_EQ(mesh.colors.size(), 3u);
    EXPECT_EQ(mesh.colors[2],
              Color(image::srgb_decode_8(10), image::srgb_decode_8(22), image::srgb_decode_8(250)));
}

TEST(ReadPly, HeadersWithOtherLineEnds) {
    const std::string lf = binary_triangle(false);
    const std::size_t body = lf.find("end_header\n") + 11;
    for (const std::string_view end : {"\r\n", "\r", " \n"}) {
        std::string file;
        for (const char c : lf.substr(0, body)) {
            if (c == '\n') {
                file += file == "ply" && end == " \n" ? "\n" : end;
            } else {
                file += c;
            }
        }
        EXPECT_EQ(mesh_of(file + lf.substr(body)).positions, kCorners);
    }
    std::string crlf;
    for (const char c : ascii_face("3 0 1 2")) {
        if (c == '\n') crlf += '\r';
        crlf += c;
    }
    EXPECT_EQ(mesh_of(crlf).triangles, (Triangles{{0, 1, 2}}));
}

TEST(ReadPly, ABodyThatBeginsWithALineFeedAfterACarriageReturn) {
    // x of the first vertex has 0x0A as its lowest byte.
    std::string file = binary_triangle(false);
    const std::size_t body = file.find("end_header\n") + 11;
    for (std::size_t i = 0; i < body; ++i) {
        if (file[i] == '\n') file[i] = '\r';
    }
    file[body] = '\n';
    EXPECT_EQ(mesh_of(file).positions[1], Vec3(1, 0, 0));
}

TEST(ReadPly, ManyBlocksOfVerticesAndBytesBehindTheEnd) {
    constexpr int kCount = 3000;
    Bytes body(false);
    for (int i = 0; i < kCount; ++i) body.add_all(static_cast<double>(i), i % 7, i % 5);
    for (int i = 0; i + 2 < kCount; ++i) {
        body.add(std::uint8_t{3}).add_all(std::uint32_t(i), i + 1, i + 2).add(std::uint8_t{9});
    }
    const Mesh mesh = mesh_of(
        header("binary_little_endian",
               fmt::format("element vertex {}\nproperty double x\nproperty double y\n"
                           "property double z\nelement face {}\n"
                           "property list uchar uint vertex_indices\nproperty uchar flags\n",
                           kCount, kCount - 2)) +
        body.text() + "\n");
    ASSERT_EQ(mesh.positions.size(), std::size_t{kCount});
    for (int i = 0; i < kCount; ++i) {
        ASSERT_EQ(mesh.positions[static_cast<std::size_t>(i)], Vec3(i, i % 7, i % 5));
    }
    ASSERT_EQ(mesh.triangles.size(), std::size_t{kCount - 2});
    EXPECT_EQ(mesh.triangles.back(), (IndexTriple{kCount - 3, kCount - 2, kCount - 1}));
    EXPECT_EQ(mesh.triangles.capacity(), mesh.triangles.size());
}

TEST(ReadPly, WordsBehindTheValuesOfALineAreSkipped) {
    EXPECT_EQ(mesh_of(ascii_face("3 0 1 2 255 what")).triangles, (Triangles{{0, 1, 2}}));
    EXPECT_EQ(mesh_of(ascii_face("3.0 0 +1 2e0")).triangles, (Triangles{{0, 1, 2}}));
}

}  // namespace
}  // namespace lray::scene::ply
