// read_mtl and material_of: every statement, every mistake, and what each means.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <unordered_set>

#include "scene/formats/mtl_material.h"
#include "scene/formats/mtl_reader.h"

namespace lray::scene {
namespace {

struct MtlReading {
    explicit MtlReading(std::string_view mtl,
                        const std::unordered_set<std::string>& wanted = {"m", "my oak"}) {
        file = sources.add("a.mtl", Text(mtl));
        materials = read_mtl(sources, file, Span{}, wanted, diagnostics);
    }
    std::string told() const {
        std::string all;
        for (const Diagnostic* diagnostic : diagnostics.sorted()) {
            const Position position = sources.position(diagnostic->span);
            all += fmt::format("{}:{} `{}` {}\n", position.line, position.column,
                               sources.text(diagnostic->span), diagnostic->message);
        }
        return all;
    }
    Sources sources;
    Diagnostics diagnostics;
    SourceId file = kNoSource;
    std::optional<std::vector<MtlMaterial>> materials;
};

MtlMaterial read(std::string_view statements) {
    const MtlReading reading(fmt::format("newmtl m\n{}\n", statements));
    EXPECT_EQ(reading.told(), "");
    if (!reading.materials || reading.materials->size() != 1) {
        ADD_FAILURE() << statements;
        return {};
    }
    return reading.materials->front();
}

Material material(std::string_view statements) {
    return material_of(read(statements), {}, {});
}

TEST(ReadMtl, EveryStatementIsRead) {
    const MtlMaterial m = read(
        "Ka 1 1 1\nKd 0.1 0.2 0.3 # matt\r\n\tKS 0.5\nKe 2 0 0\nTf 1 1 0.5\nNs 250\nNi 1.45\n"
        "d -halo 0.25\nTr 2\nillum 7\n");
    EXPECT_EQ(m.diffuse, (Color{0.1f, 0.2f, 0.3f}));
    EXPECT_EQ(m.specular, Color{0.5f});
    EXPECT_EQ(m.emission, (Color{2.0f, 0.0f, 0.0f}));
    EXPECT_EQ(m.filter, (Color{1.0f, 1.0f, 0.5f}));
    EXPECT_EQ(m.exponent, 250.0f);
    EXPECT_EQ(m.ior, 1.45f);
    EXPECT_EQ(m.dissolve, 0.25f);
    EXPECT_EQ(m.transparency, 1.0f);
    EXPECT_EQ(m.model, 7u);
}

TEST(ReadMtl, OnlyWantedMaterialsAreKeptAtTheirFirstDefinition) {
    const MtlReading reading(
        "\xEF\xBB\xBFnewmtl other\nKd 1\nnewmtl my   oak\nKd 0.5\nnewmtl my oak\nKd 0.25\n");
    ASSERT_TRUE(reading.materials);
    ASSERT_EQ(reading.materials->size(), 1u);
    EXPECT_EQ(reading.materials->front().name, "my oak");
    EXPECT_EQ(reading.materials->front().diffuse, Color{0.5f});
}

TEST(ReadMtl, MapsHaveOptionsAndNamesWithBlanks) {
    const MtlMaterial m = read(
        "map_Kd -blendu on -s 2 4 1 -o 0.5 -0.25 -clamp on -mm 0 1 -texres 64 my  wood.png \n"
        "map_d 1.png\nmap_Ks -s 3 -x.png\nnorm n.png\nBUMP -s 2 -bm -0.5 b.png\nmap_Ke -imfchan r "
        "e#1.png");
    ASSERT_TRUE(m.diffuse_map && m.specular_map && m.emission_map && m.opacity_map && m.normal_map);
    EXPECT_EQ(m.diffuse_map->file, "my  wood.png");
    EXPECT_EQ(m.diffuse_map->scale, DVec2(2, 4));
    EXPECT_EQ(m.diffuse_map->offset, DVec2(0.5, -0.25));
    EXPECT_TRUE(m.diffuse_map->is_clamped);
    EXPECT_EQ(m.opacity_map->file, "1.png");
    EXPECT_EQ(m.specular_map->file, "-x.png");
    EXPECT_EQ(m.specular_map->scale, DVec2(3, 1));
    EXPECT_EQ(m.emission_map->file, "e#1.png");
    ASSERT_TRUE(m.bump_map);
    EXPECT_EQ(m.bump_map->file, "b.png");
    EXPECT_EQ(m.bump_map->scale, DVec2(2, 1));
    EXPECT_EQ(m.bump_map->bump_multiplier, -0.5);
    EXPECT_EQ(read("map_bump b.png").bump_map->bump_multiplier, 1.0);
    // uv of the middle of the picture.
    const DVec3 uv = uv_from_picture(*m.diffuse_map).point(DVec3(0.5, 0.5, 0));
    EXPECT_EQ(uv, DVec3(0, 0.1875, 0));
}

TEST(ReadMtl, WhatIsNotReadIsToldOnce) {
    const MtlReading reading(
        "newmtl m\nmap_Ns b.png\nPr 0.5\nPr 0.6\nKd xyz 1 1 1\nmap_Ka a.png\nsharpness 60\n");
    ASSERT_TRUE(reading.materials);
    EXPECT_EQ(reading.told(), "2:1 `map_Ns` not read of this file: `map_Ns`, `Pr`, `Kd`\n");
}

TEST(ReadMtl, MistakesAreToldAtTheirPlace) {
    const std::vector<std::pair<std::string_view, std::string_view>> cases = {
        {"newmtl m\nKd 1 x 0", "2:6 `x` expected a number, found `x`\n"},
        {"newmtl m\nKd 1 1", "2:1 `Kd 1 1` `Kd` needs 1 or 3 numbers, this has 2\n"},
        {"newmtl m\nKs 0 -1 0", "2:6 `-1` `Ks` must be 0 or more, this is -1\n"},
        {"newmtl m\nNs", "2:1 `Ns` `Ns` needs a number, this has 0\n"},
        {"newmtl m\nd nan", "2:3 `nan` expected a finite number, found `nan`\n"},
        {"newmtl m\nNi 1e39", "2:4 `1e39` `1e39` is too large: numbers go up to 3.4e38\n"},
        {"newmtl\n", "1:1 `newmtl` `newmtl` needs a name\n"},
        {"Kd 1 1 1\n", "1:1 `Kd` `Kd` comes before the first `newmtl`\n"},
        {"newmtl m\nmap_Kd -s 1 1 1\n", "2:1 `map_Kd` `map_Kd` needs the name of a picture\n"},
        {"newmtl m\nmap_Kd -s 0 a.png\n",
         "2:8 `-s 0` the scale of a picture must be from 1e-9 to 1e9\n"},
        {"newmtl m\nmap_Kd -o a.png\n", "2:11 `a.png` expected a number, found `a.png`\n"},
        {"newmtl m\nbump -bm a.png\n", "2:10 `a.png` expected a number, found `a.png`\n"},
    };
    for (const auto& [text, expected] : cases) {
        const MtlReading reading(text);
        EXPECT_FALSE(reading.materials) << text;
        EXPECT_EQ(reading.told(), expected);
    }
    const MtlReading binary(std::string_view("newmtl m\nKd \0", 13));
    EXPECT_FALSE(binary.materials);
    EXPECT_EQ(binary.diagnostics.sorted()[0]->code, Code::E0003);
}

TEST(MaterialOfMtl, ColoursAndExponentAreThoseOfBlinnAndPhong) {
    const Material m = material("Kd 0.1 0.2 0.3\nKs 0.5\nNs 20000\nKe 1 2 3");
    EXPECT_EQ(m.model, ReflectionModel::blinn_phong);
    EXPECT_EQ(m.diffuse, Coefficient(Color{0.1f, 0.2f, 0.3f}));
    EXPECT_EQ(m.specular, Coefficient(Color{0.5f}));
    EXPECT_EQ(m.shininess, ScalarCoefficient(10000.0f));
    EXPECT_EQ(m.emission, Coefficient(Color{1.0f, 2.0f, 3.0f}));
    EXPECT_FALSE(m.ambient);
    EXPECT_EQ(material("Ks 0.5\nillum 1").specular, Coefficient(Color{0.0f}));
    EXPECT_EQ(material("").specular, Coefficient(Color{0.0f}));
}

TEST(MaterialOfMtl, DissolveIsOpacityOrGlass) {
    const Material thin = material("d 0.25\nTf 1 0 0\nNi 1.3");
    EXPECT_EQ(thin.opacity, ScalarCoefficient(0.25f));
    EXPECT_EQ(thin.transmit, Coefficient(Color{0.0f}));
    EXPECT_EQ(material("Tr 0.25").opacity, ScalarCoefficient(0.75f));
    EXPECT_EQ(material("Tr 1\nd 1").opacity, ScalarCoefficient(1.0f));
    for (const int model : {4, 6, 7, 9}) {
        const Material glass =
            material(fmt::format("Kd 0.8\nd 0.25\nTf 1 0.5 0\nNi 1.3\nillum {}", model));
        EXPECT_EQ(glass.opacity, ScalarCoefficient(1.0f));
        EXPECT_EQ(glass.transmit, Coefficient((Color{0.75f, 0.375f, 0.0f})));
        EXPECT_EQ(glass.diffuse, Coefficient(Color{0.2f}));
        EXPECT_EQ(glass.ior, 1.3f);
    }
    EXPECT_EQ(material("Tf 1\nillum 4").transmit, Coefficient(Color{0.0f}));
    EXPECT_EQ(material("Ni 0").ior, 1.5f);
}

TEST(MaterialOfMtl, MirrorsReflectTheSpecularColour) {
    for (const int model : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}) {
        const bool is_mirror = model == 3 || model == 5;
        EXPECT_EQ(material(fmt::format("Ks 0.5\nillum {}", model)).reflect,
                  Coefficient(Color{is_mirror ? 0.5f : 0.0f}));
    }
}

TEST(MaterialOfMtl, PicturesTakeThePlaceOfNumbers) {
    const std::vector<Texture> textures(2, Texture{.average = Color{0.5f, 0.25f, 0.75f}});
    MtlTextures ids;
    ids.diffuse_id = TextureId(0u);
    ids.opacity_id = TextureId(1u);
    const Material m = material_of(read("Kd 0.1\nd 0.5"), ids, textures);
    EXPECT_EQ(m.diffuse, Coefficient((Color{0.5f, 0.25f, 0.75f}), TextureId(0u)));
    EXPECT_EQ(m.opacity, ScalarCoefficient(0.5f, TextureId(1u)));
    EXPECT_TRUE(m.bump_id.is_none());
}

TEST(MaterialOfMtl, BumpsAreInPartsOfTheirPicture) {
    const std::vector<Texture> textures(1);
    MtlTextures ids;
    ids.bump_id = TextureId(0u);
    const Material m = material_of(read("bump -bm 2.5 b.png"), ids, textures);
    EXPECT_EQ(m.bump_id, TextureId(0u));
    EXPECT_EQ(m.bump_height, 0.025);
    EXPECT_EQ(m.bump_unit, BumpUnit::uv);
}

}  // namespace
}  // namespace lray::scene
