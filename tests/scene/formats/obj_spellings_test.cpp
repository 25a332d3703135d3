// read_obj: random meshes in many spellings, and random text.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <string_view>

#include "tests/scene/formats/obj_reading.h"

namespace lray::scene {
namespace {

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
            if (triple == IndexTriple{Mesh::kNone, Mesh::kNone, Mesh::kNone}) continue;
            for (const auto index : triple) ASSERT_LT(index, reading.mesh->normals.size()) << text;
        }
    }
    EXPECT_GT(mesh_count, 5'000);
    EXPECT_LT(mesh_count, 45'000);
}

}  // namespace
}  // namespace lray::scene
