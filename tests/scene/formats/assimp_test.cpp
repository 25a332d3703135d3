// import_mesh with the importer that lray has: each format, made here.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tests/scene/formats/import.h"

namespace lray::scene {
namespace {

Import import(std::string_view name, std::string_view bytes) {
    ImportSettings settings;
    settings.program = std::filesystem::path(LRAY_BINARY).parent_path() / "lray-import";
    return {name, bytes, settings};
}

Mesh mesh(std::string_view name, std::string_view bytes) {
    Import result = import(name, bytes);
    EXPECT_TRUE(result.mesh.has_value()) << result.error();
    return result.mesh.value_or(Mesh{});
}

/// The corners of the triangles, each triangle from its least corner on; sorted.
std::vector<std::array<float, 9>> corners_of(const Mesh& mesh) {
    std::vector<std::array<float, 9>> all;
    for (const IndexTriple& triple : mesh.triangles) {
        std::array<std::array<float, 3>, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 p = mesh.positions[triple[i]];
            corners[i] = {p.x, p.y, p.z};
        }
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()),
                    corners.end());
        std::array<float, 9> flat{};
        for (std::size_t i = 0; i < 9; ++i) flat[i] = corners[i / 3][i % 3];
        all.push_back(flat);
    }
    std::sort(all.begin(), all.end());
    return all;
}

constexpr std::array<std::array<int, 3>, 4> kPoints = {
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr std::array<std::array<std::size_t, 3>, 4> kFaces = {
    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};

/// A tetrahedron whose corners were scaled, moved and, if Z was up, turned: as corners_of() tells
/// them.
std::vector<std::array<float, 9>> tetrahedron(float scale = 1.0f, float x = 0.0f,
                                              bool z_was_up = false) {
    Mesh mesh;
    for (const auto& p : kPoints) {
        const Vec3 q(scale * static_cast<float>(p[0]) + x, scale * static_cast<float>(p[1]),
                     scale * static_cast<float>(p[2]));
        mesh.positions.push_back(z_was_up ? Vec3(q.x, q.z, 0.0f - q.y) : q);
    }
    for (const auto& [a, b, c] : kFaces) {
        mesh.triangles.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                                  static_cast<std::uint32_t>(c)});
    }
    return corners_of(mesh);
}

template <class T>
void append(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

TEST(Assimp, StlInText) {
    std::string text = "solid tetrahedron\n";
    for (const auto& face : kFaces) {
        text += "facet normal 0 0 0\n outer loop\n";
        for (const std::size_t i : face) {
            text += fmt::format("  vertex {} {} {}\n", kPoints[i][0], kPoints[i][1], kPoints[i][2]);
        }
        text += " endloop\nendfacet\n";
    }
    const Mesh result = mesh("a.stl", text + "endsolid tetrahedron\n");
    EXPECT_EQ(corners_of(result), tetrahedron());
    EXPECT_EQ(result.positions.size(), 4u);  // corners that are the same are one
    EXPECT_TRUE(result.normal_indices.empty());
}

std::string binary_stl(std::string_view header) {
    std::string bytes(header);
    bytes.resize(80);
    append(bytes, std::uint32_t{4});
    for (const auto& face : kFaces) {
        bytes.append(12, '\0');
        for (const std::size_t i : face) {
            for (const int x : kPoints[i]) append(bytes, static_cast<float>(x));
        }
        bytes.append(2, '\0');
    }
    return bytes;
}

TEST(Assimp, StlInBinary) {
    EXPECT_EQ(corners_of(mesh("a.stl", binary_stl("made by a scanner"))), tetrahedron());
    // Some tools begin binary files like text.
    EXPECT_EQ(corners_of(mesh("b.STL", binary_stl("solid of a slicer"))), tetrahedron());
}

TEST(Assimp, EveryPrefixOfAFileIsReadOrTold) {
    const std::string whole = binary_stl("made by a scanner");
    for (std::size_t size = 0; size < whole.size(); size += 29) {
        const Import result = import("a.stl", whole.substr(0, size));
        EXPECT_TRUE(result.mesh || result.error() != "not one error") << size;
    }
}

TEST(Assimp, Off) {
    std::string text = "OFF\n4 4 6\n";
    for (const auto& [x, y, z] : kPoints) text += fmt::format("{} {} {}\n", x, y, z);
    for (const auto& [a, b, c] : kFaces) text += fmt::format("3 {} {} {}\n", a, b, c);
    EXPECT_EQ(corners_of(mesh("a.off", text)), tetrahedron());
}

std::string gltf_buffer() {
    std::string bytes;
    for (const auto& point : kPoints) {
        for (const int x : point) append(bytes, static_cast<float>(x));
    }
    for (const auto& face : kFaces) {
        for (const std::size_t i : face) append(bytes, static_cast<std::uint16_t>(i));
    }
    return bytes;
}

/// A tetrahedron twice as large, in a node that is moved; `uri` is of its buffer.
std::string gltf(std::string_view uri) {
    return fmt::format(
        R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],)"
        R"("nodes":[{{"name":"top","children":[1],"translation":[10,0,0]}},)"
        R"({{"name":"body","mesh":0,"scale":[2,2,2]}}],)"
        R"("meshes":[{{"name":"m","primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],)"
        R"("buffers":[{{"byteLength":72{}}}],)"
        R"("bufferViews":[{{"buffer":0,"byteOffset":0,"byteLength":48}},)"
        R"({{"buffer":0,"byteOffset":48,"byteLength":24}}],)"
        R"("accessors":[{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3",)"
        R"("min":[0,0,0],"max":[1,1,1]}},)"
        R"({{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}}]}})",
        uri);
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i + 2 < bytes.size(); i += 3) {  // a multiple of three bytes
        const auto byte = [&](std::size_t k) {
            return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i + k]));
        };
        const std::uint32_t word = byte(0) << 16 | byte(1) << 8 | byte(2);
        for (const unsigned shift : {18u, 12u, 6u, 0u}) text += kDigits[word >> shift & 63];
    }
    return text;
}

TEST(Assimp, GltfWithItsDataInItAndNodesInTheirPlaces) {
    const Mesh result = mesh("a.gltf", gltf(",\"uri\":\"data:application/octet-stream;base64," +
                                            base64(gltf_buffer()) + "\""));
    EXPECT_EQ(corners_of(result), tetrahedron(2.0f, 10.0f));
    ASSERT_EQ(result.parts.size(), 1u);
    EXPECT_EQ(result.parts[0].name, "body");
    EXPECT_EQ(result.parts[0].triangle_count, 4u);
    EXPECT_EQ(parts_named(result, "body").size(), 1u);
}

TEST(Assimp, Glb) {
    std::string json = gltf("");
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::string buffer = gltf_buffer();
    std::string bytes = "glTF";
    append(bytes, std::uint32_t{2});
    append(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + buffer.size()));
    append(bytes, static_cast<std::uint32_t>(json.size()));
    bytes += "JSON" + json;
    append(bytes, static_cast<std::uint32_t>(buffer.size()));
    bytes += std::string("BIN\0", 4) + buffer;
    EXPECT_EQ(corners_of(mesh("a.glb", bytes)), tetrahedron(2.0f, 10.0f));
}

TEST(Assimp, GltfWithItsDataElsewhereIsTold) {
    const std::string error = import("a.gltf", gltf(",\"uri\":\"a.bin\"")).error();
    EXPECT_TRUE(error.starts_with("E0701 `a.gltf` is not understood: ")) << error;
    EXPECT_TRUE(error.ends_with(
        "; a .gltf is read alone, without files it names; save it as .glb, which holds all"))
        << error;
}

void append_chunk(std::string& bytes, std::uint16_t id, std::string_view content) {
    append(bytes, id);
    append(bytes, static_cast<std::uint32_t>(6 + content.size()));
    bytes += content;
}

TEST(Assimp, ThreeDs) {
    std::string positions;
    append(positions, static_cast<std::uint16_t>(kPoints.size()));
    for (const auto& point : kPoints) {
        for (const int x : point) append(positions, static_cast<float>(x));
    }
    std::string faces;
    append(faces, static_cast<std::uint16_t>(kFaces.size()));
    for (const auto& face : kFaces) {
        for (const std::size_t i : face) append(faces, static_cast<std::uint16_t>(i));
        append(faces, std::uint16_t{0});
    }
    std::string content;
    append_chunk(content, 0x4110, positions);
    append_chunk(content, 0x4120, faces);
    std::string object("body\0", 5);
    append_chunk(object, 0x4100, content);
    std::string objects;
    append_chunk(objects, 0x4000, object);
    std::string node("body\0", 5);
    for (const int x : {0, 0, 0xffff}) append(node, static_cast<std::uint16_t>(x));  // no parent
    std::string track;
    append_chunk(track, 0xb010, node);
    std::string tracks;
    append_chunk(tracks, 0xb002, track);
    std::string main;
    append_chunk(main, 0x3d3d, objects);
    append_chunk(main, 0xb000, tracks);
    std::string file;
    append_chunk(file, 0x4d4d, main);
    const Mesh result = mesh("a.3ds", file);
    EXPECT_EQ(corners_of(result), tetrahedron(1.0f, 0.0f, true));
    ASSERT_EQ(result.parts.size(), 1u);
    EXPECT_EQ(result.parts[0].name, "body");
}

/// The tetrahedron as whole numbers with something between them.
std::string positions_text(char between) {
    std::string text;
    for (const auto& point : kPoints) {
        for (const int x : point) text += std::to_string(x) + between;
    }
    text.pop_back();
    return text;
}

/// A tetrahedron twice as large, moved by 10 along X.
std::string collada(std::string_view up, std::string_view unit) {
    std::string indices;
    for (const auto& [a, b, c] : kFaces) indices += fmt::format("{} {} {} ", a, b, c);
    return fmt::format(
        R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="u" meter="{}"/><up_axis>{}</up_axis></asset>
<library_geometries><geometry id="g" name="g"><mesh>
<source id="p"><float_array id="pa" count="12">{}</float_array>
<technique_common><accessor source="#pa" count="4" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>{}</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="body" name="body">
<translate>10 0 0</translate><scale>2 2 2</scale><instance_geometry url="#g"/>
</node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>
)",
        unit, up, positions_text(' '), indices);
}

TEST(Assimp, ColladaInItsPlaceAndUnit) {
    const Mesh result = mesh("a.dae", collada("Y_UP", "1"));
    EXPECT_EQ(corners_of(result), tetrahedron(2.0f, 10.0f));
    EXPECT_EQ(parts_named(result, "body").size(), 1u);
    EXPECT_EQ(corners_of(mesh("b.dae", collada("Z_UP", "1"))), tetrahedron(2.0f, 10.0f, true))
        << "Z";
    EXPECT_EQ(corners_of(mesh("c.dae", collada("Y_UP", "0.5"))), tetrahedron(1.0f, 5.0f)) << "unit";
}

/// The same, of ASCII FBX; the axis that is up, 1 for Y, and centimetres in a unit.
std::string fbx(int up, int unit) {
    std::string indices;
    for (const auto& [a, b, c] : kFaces) {
        indices += fmt::format("{},{},{},", a, b, -static_cast<int>(c) - 1);
    }
    indices.pop_back();
    return fmt::format(
        R"(; FBX 7.3.0 project file
FBXHeaderExtension:  {{
	FBXHeaderVersion: 1003
	FBXVersion: 7300
}}
GlobalSettings:  {{
	Version: 1000
	Properties70:  {{
		P: "UpAxis", "int", "Integer", "",{}
		P: "UpAxisSign", "int", "Integer", "",1
		P: "FrontAxis", "int", "Integer", "",{}
		P: "FrontAxisSign", "int", "Integer", "",{}
		P: "CoordAxis", "int", "Integer", "",0
		P: "CoordAxisSign", "int", "Integer", "",1
		P: "UnitScaleFactor", "double", "Number", "",{}
	}}
}}
Objects:  {{
	Geometry: 1000, "Geometry::g", "Mesh" {{
		Vertices: *12 {{
			a: {}
		}}
		PolygonVertexIndex: *12 {{
			a: {}
		}}
		GeometryVersion: 124
	}}
	Model: 2000, "Model::body", "Mesh" {{
		Version: 232
		Properties70:  {{
			P: "Lcl Translation", "Lcl Translation", "", "A",10,0,0
			P: "Lcl Scaling", "Lcl Scaling", "", "A",2,2,2
		}}
	}}
}}
Connections:  {{
	C: "OO",2000,0
	C: "OO",1000,2000
}}
)",
        up, up == 1 ? 2 : 1, up == 1 ? 1 : -1, unit, positions_text(','), indices);
}

TEST(Assimp, FbxInItsPlaceWithoutItsAxisAndUnit) {
    const Mesh result = mesh("a.fbx", fbx(1, 1));
    EXPECT_EQ(corners_of(result), tetrahedron(2.0f, 10.0f));
    EXPECT_EQ(parts_named(result, "body").size(), 1u);
    EXPECT_EQ(corners_of(mesh("b.fbx", fbx(2, 1))), tetrahedron(2.0f, 10.0f)) << "Z";
    EXPECT_EQ(corners_of(mesh("c.fbx", fbx(1, 100))), tetrahedron(2.0f, 10.0f)) << "unit";
}

TEST(Assimp, FilesThatAreNone) {
    for (const std::string_view name :
         {"a.3ds", "a.dae", "a.fbx", "a.glb", "a.gltf", "a.off", "a.stl"}) {
        for (const std::string_view bytes : {"", "nonsense", "solid\n", "OFF\n9 9 9\n"}) {
            const std::string error = import(name, bytes).error();
            EXPECT_TRUE(error.starts_with("E07")) << name << ": " << error;
        }
    }
}

}  // namespace
}  // namespace lray::scene
