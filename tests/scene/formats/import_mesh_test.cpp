// import_mesh: what Assimp reads, and that nothing an importer does is more than one error.
#include "scene/formats/import_mesh.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/formats/read_mesh.h"
#include "tests/scene/formats/obj_reading.h"

namespace lray::scene {
namespace {

/// A file of that name that was read by a program.
struct Import {
    Import(std::string_view name, std::string_view bytes, ImportSettings settings) {
        const SourceId scene = sources.add("scene.lrs", Text("mesh { file: \"a\" }"));
        loaded_at = Span::make(scene, 13, 16);
        const SourceId file = sources.add(std::string(name), Text(bytes));
        mesh = read_mesh(MeshFormat::imported, sources, file, loaded_at, settings, diagnostics);
    }

    /// The one error, at the name of the file: "code message", and "; help" if it has one.
    std::string error() const {
        const auto all = diagnostics.sorted();
        if (mesh || all.size() != 1 || all[0]->severity != Severity::error) return "not one error";
        if (all[0]->span != loaded_at) return "elsewhere";
        const std::string_view code =
            all[0]->code == Code::E0516 ? "E0516" : Reading::name(all[0]->code);
        std::string text = fmt::format("{} {}", code, all[0]->message);
        if (!all[0]->helps.empty()) text += "; " + all[0]->helps[0];
        return text;
    }

    Sources sources;
    Diagnostics diagnostics;
    Span loaded_at{};
    std::optional<Mesh> mesh;
};

std::string hostile(std::string_view what, ImportSettings settings = {}) {
    settings.program = LRAY_HOSTILE_IMPORTER;
    return Import("a.fbx", what, settings).error();
}

TEST(ImportMesh, WhatAnImporterMayDoWrongIsOneError) {
    EXPECT_EQ(hostile("crash"), "E0701 the importer of .fbx files crashed on `a.fbx`");
    EXPECT_EQ(hostile("abort"), "E0701 the importer of .fbx files crashed on `a.fbx`");
    EXPECT_EQ(hostile("exit"), "E0701 the importer of .fbx files has failed on `a.fbx`");
    const std::string nonsense =
        "E0701 the importer of .fbx files has answered what makes no sense on `a.fbx`";
    EXPECT_EQ(hostile("silence"), nonsense);
    EXPECT_EQ(hostile("garbage"), nonsense);
    EXPECT_EQ(hostile("anything"), "E0701 `a.fbx` is not understood: \x1b[2J");
}

TEST(ImportMesh, AnImporterThatHangsIsStopped) {
    for (const char* how : {"hang", "close and hang"}) {
        EXPECT_EQ(hostile(how, {.seconds = 1}),
                  "E0516 `a.fbx` is not imported after 1 seconds; raise the limit with "
                  "`--max-import-seconds N`");
    }
}

TEST(ImportMesh, AnImporterThatWritesWithoutEndIsStopped) {
    EXPECT_EQ(hostile("endless", {.bytes = std::uint64_t{256} << 20}),
              "E0516 `a.fbx` needs more than 268435456 bytes to be imported; raise the limit with "
              "`--max-import-bytes N`");
}

TEST(ImportMesh, AnImporterReachesNothing) {
    EXPECT_EQ(hostile("files"), "E0701 `a.fbx` is not understood: reaches nothing");
    EXPECT_EQ(hostile("descriptors"), "E0701 `a.fbx` is not understood: has none");
    const std::string stopped =
        "E0701 the importer of .fbx files was stopped: it did what an "
        "importer has no need of on `a.fbx`";
    EXPECT_EQ(hostile("socket"), stopped);
    EXPECT_EQ(hostile("process"), stopped);
    EXPECT_EQ(hostile("code"), stopped);
}

TEST(ImportMesh, AnImporterHasAMemoryLimit) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer reserves terabytes";
#endif
    EXPECT_EQ(hostile("memory"), "E0701 `a.fbx` is not understood: has a limit");
}

TEST(ImportMesh, ProgramsThatAreNotThere) {
    EXPECT_EQ(Import("a.STL", "x", {}).error(),
              "E0705 `.stl` files are read by a program that this lray was built without; save the "
              "mesh as OBJ or PLY; or install Assimp and build lray again");
    ImportSettings missing;
    missing.program = "/nowhere/lray-import";
    EXPECT_EQ(Import("a.stl", "x", missing).error(),
              "E0701 the importer of .stl files could not be started on `a.stl`");
}

/// With the program that lray has, where it was built with it.
class Assimp : public testing::Test {
 protected:
    void SetUp() override {
        program_ = std::filesystem::path(LRAY_BINARY).parent_path() / "lray-import";
        if (access(program_.c_str(), X_OK) != 0) GTEST_SKIP() << "built without Assimp";
    }

    Import import(std::string_view name, std::string_view bytes) const {
        ImportSettings settings;
        settings.program = program_;
        return Import(name, bytes, settings);
    }
    Mesh mesh(std::string_view name, std::string_view bytes) const {
        Import result = import(name, bytes);
        EXPECT_TRUE(result.mesh.has_value()) << result.error();
        return result.mesh.value_or(Mesh{});
    }

 private:
    std::string program_;
};

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

/// A tetrahedron whose corners were scaled and moved, as corners_of() tells them.
std::vector<std::array<float, 9>> tetrahedron(float scale = 1.0f, float x = 0.0f) {
    Mesh mesh;
    for (const auto& p : kPoints) {
        mesh.positions.emplace_back(scale * static_cast<float>(p[0]) + x,
                                    scale * static_cast<float>(p[1]),
                                    scale * static_cast<float>(p[2]));
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

TEST_F(Assimp, StlInText) {
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

TEST_F(Assimp, StlInBinary) {
    EXPECT_EQ(corners_of(mesh("a.stl", binary_stl("made by a scanner"))), tetrahedron());
    // Some tools begin binary files like text.
    EXPECT_EQ(corners_of(mesh("b.STL", binary_stl("solid of a slicer"))), tetrahedron());
}

TEST_F(Assimp, EveryPrefixOfAFileIsReadOrTold) {
    const std::string whole = binary_stl("made by a scanner");
    for (std::size_t size = 0; size < whole.size(); size += 29) {
        const Import result = import("a.stl", whole.substr(0, size));
        EXPECT_TRUE(result.mesh || result.error() != "not one error") << size;
    }
}

TEST_F(Assimp, Off) {
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

TEST_F(Assimp, GltfWithItsDataInItAndNodesInTheirPlaces) {
    const Mesh result = mesh("a.gltf", gltf(",\"uri\":\"data:application/octet-stream;base64," +
                                            base64(gltf_buffer()) + "\""));
    EXPECT_EQ(corners_of(result), tetrahedron(2.0f, 10.0f));
    ASSERT_EQ(result.parts.size(), 1u);
    EXPECT_EQ(result.parts[0].name, "body");
    EXPECT_EQ(result.parts[0].triangle_count, 4u);
    EXPECT_EQ(parts_named(result, "body").size(), 1u);
}

TEST_F(Assimp, Glb) {
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

TEST_F(Assimp, GltfWithItsDataElsewhereIsTold) {
    const std::string error = import("a.gltf", gltf(",\"uri\":\"a.bin\"")).error();
    EXPECT_TRUE(error.starts_with("E0701 `a.gltf` is not understood: ")) << error;
    EXPECT_TRUE(error.ends_with(
        "; a .gltf is read alone, without files it names; save it as .glb, which holds all"))
        << error;
}

TEST_F(Assimp, FilesThatAreNone) {
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
