// The short cut for blocks of literals changes nothing: with it and without it a scene and all that
// is said about it are the same.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "tests/parser/loaded.h"
#include "tests/parser/short_cut.h"
#include "tests/parser/syntax_tree.h"

namespace lray::test {
namespace {

void expect_same(std::string_view text, const parser::LoadSettings& settings = {},
                 const std::vector<Companion>& companions = {}) {
    EXPECT_EQ(outcome(load_text(text, settings, companions)),
              outcome(load_text(text, without_short_cut(settings), companions)))
        << text;
}

TEST(LiteralShortCut, ExamplesAreTheSameWithoutIt) {
    const Examples examples;
    for (const std::string& name : examples.names()) {
        const std::string text = examples.text(name);
        EXPECT_EQ(outcome(examples.load_changed(name, text)),
                  outcome(examples.load_changed(name, text, without_short_cut())))
            << name;
    }
}

TEST(LiteralShortCut, MistakesReadTheSameWithoutIt) {
    for (const char* text :
         {"sphere { radius: -1 }", "sphere { radius: 0 }", "sphere { radius: 1, radius: 2 }",
          "sphere { center: [0, 0] }", "triangle { a: [0, 0, 0], b: [1, 1, 1], c: [2, 2, 2] }",
          "box { min: [1, 1, 1], max: [0, 0, 0] }", "rectangle { size: [1, 1], corner: [0, 0, 0] }",
          "sphere { radius: 1 center: [0, 0, 0] }", "sphere { radius: 1e999 }",
          "sphere {\n radius: 1", "group { sphere { radius: 1 } }",
          "sphere { sphere { radius: 1 } }", "let sphere = 1\nsphere { radius: 1 }",
          "disk { hole: 2 }", "plane { normal: [0, 0, 0] }"}) {
        expect_same(text);
    }
}

TEST(LiteralShortCut, NamesOfMaterialsMeanTheSameWithoutIt) {
    const std::string materials = "let red = material { diffuse: [1, 0, 0] }\n";
    for (const char* text : {
             "sphere { material: unknown }\nbox { material: unknown }",
             "sphere { material: rad }",
             "sphere { material: pi }\nbox { material: pi }",
             "sphere { material: sin }\nbox { material: sin }",
             "sphere { material: time }",
             "sphere { material: colors }",
             "sphere { material: crimson }",
             "sphere { material: sphere }",
             "sphere { material: material\n }",
             "sphere { material: true }",
             "sphere { material: red.diffuse }",
             "sphere { material: red, material: red }",
             "sphere { material: red\n radius: 2\n}\nsphere { radius: 2; material: red }",
             "sphere { material: red radius: 2 }",
             "sphere { material: red } }",
             "sphere { material: later }\nlet later = material { }",
             "group { sphere { material: later }\n let later = material { } }",
             "let n = 3\nsphere { material: n }\nbox { material: n }\nbox { material: n }",
             "let c = red\nsphere { material: c }",
             "let s = \"red\"\nsphere { material: s }",
             "let broken = 1 / 0\nsphere { material: broken }\nbox { material: broken }",
             "fn f(x) = x\nsphere { material: f }\nbox { material: f }",
             "component c() { }\nsphere { material: c }\nbox { material: c }",
             "let ball = sphere { }\nbox { material: ball }",
             "group { let own = material { }\n sphere { material: own } }",
             "group { let unused = material { }\n sphere { material: red } }",
             "group { let red = material { }\n sphere { material: red } }",
             "let forgotten = material { }\nsphere { material: red }",
             "var m = red\nsphere { material: m }\nm = material { }\nsphere { material: m }",
             "var m = red\nfn f() { return group { sphere { material: m } } }\nf() { }",
             "for m in [red, 3] { sphere { material: m } }",
             "component c(m) { sphere { material: m }\n sphere { material: red } }\nc { m: red }",
             "component c() { children }\nc { sphere { material: red } }",
             "let g = group { sphere { material: red } }\ng { }\ng { material: red }",
             "let all = [for m in [red, red]: group { sphere { material: m } }]\nall[1] { }",
             "sphere { sphere { material: red }\n sphere { material: red } }",
             "camera { sphere { material: red } }",
             "let ball = sphere { }\nball { sphere { material: red } }",
             "return 1\nsphere { material: red }",
             "triangle { a: [0, 0, 0], b: [1, 1, 1], c: [2, 2, 2], material: red }",
             "cylinder { caps: false, material: red }",
             "cylinder { caps: 0, material: red }",
             "param m = 3\nsphere { material: m }",
             "import \"part.lrs\" as part\nsphere { material: part }",
             "include \"part.lrs\"\nsphere { material: paint }\nsphere { material: unknown }",
             "include \"missing.lrs\"\nsphere { material: unknown }",
             "group { include \"part.lrs\"\n }\nsphere { material: paint }",
         }) {
        expect_same(materials + text, {},
                    {{"part.lrs",
                      "let paint = material { }\n"
                      "sphere { material: paint }\n"
                      "sphere { material: red }\n"}});
    }
    parser::LoadSettings defined;
    defined.definitions = {{"m", "4"}};
    expect_same("param m = 3\nsphere { material: m }", defined);
}

TEST(LiteralShortCut, NeighboursWithOneMaterialAreOneItem) {
    const Parsed parsed = parse_text(R"(
sphere { radius: 2, material: red }
cylinder { material: red; caps: false }

triangle { a: [0, 0, 0], b: [1, 0, 0]
  material: red
  c: [0, 1, 0] }
box { material: blue }
box { }
torus { tube: 0.1 }
group { disk { material: blue } }
plane { material: blue }
)");
    EXPECT_EQ(parsed.tree, "#3:red\n#1:blue\n#2\n(group {#1:blue})\n#1:blue");
    EXPECT_EQ(parsed.errors, "");
    EXPECT_EQ(parsed.node_count, 8u);
}

TEST(LiteralShortCut, NodesOfWhatIsDroppedForItsMistakesStandApart) {
    const Parsed parsed = parse_text(
        "sphere { material: red }\nf(group { box { material: red } } 3)\nsphere { material: red }");
    EXPECT_EQ(parsed.tree, "#1:red\n#1:red");
    EXPECT_EQ(parsed.error_count, 1u);
    EXPECT_EQ(parsed.node_count, 3u);
}

TEST(LiteralShortCut, OtherPropertiesAndRepetitionAreLeftToTheFullParser) {
    for (const char* text :
         {"sphere { material: lib.red }", "sphere { material: red, visible: true }",
          "sphere { material: material { } }", "sphere { material { } }",
          "sphere { material: if a then b else c }", "sphere { material: red // comment\n}",
          "sphere \"ball\" { material: red }", "for i in a { sphere { material: red } }",
          "if a { sphere { material: red } }", "fn f(x = group { sphere { material: x } }) = x",
          "component c() { sphere { material: red } }",
          "a = [for m in b: group { box { material: m } }]", "ball { sphere { material: red } }",
          "sphere { box { material: red } }"}) {
        EXPECT_EQ(parse_text(text).node_count, 0u) << text;
    }
}

TEST(LiteralShortCut, WhatIsWrongWithAMaterialIsToldOfEachShape) {
    EXPECT_EQ(load_text("sphere { material: rd }\nbox { }\nbox {\n  material : rd\n}\n"
                        "disk { material: rd }\ndisk { material: rd }")
                  .text(),
              "E0201 1:20 unknown name `rd`\n"
              "E0201 4:14 unknown name `rd`\n"
              "E0201 6:18 unknown name `rd`\n"
              "E0201 7:18 unknown name `rd`\n");
    EXPECT_EQ(load_text("let n = 1 + 2\nsphere { material: n }\nbox { radius: 1 }\n"
                        "sphere { material: n, radius: 2 }\n")
                  .codes(),
              "E0401");
    EXPECT_EQ(load_text("let n = 1 + 2\nsphere { material: n }\nsphere { radius: 2, material: n }")
                  .text(),
              "E0301 2:20 `material` needs a material, `n` is a number\n"
              "E0301 3:31 `material` needs a material, `n` is a number\n");
}

TEST(LiteralShortCut, AVariableHasTheValueOfItsPlace) {
    const Loaded loaded = load_text(
        "var m = material { diffuse: 0.25 }\nsphere { material: m }\nsphere { material: m }\n"
        "m = material { diffuse: 0.5 }\nsphere { material: m }\nsphere { }\n");
    ASSERT_TRUE(loaded.scene.has_value()) << loaded.text();
    const scene::Scene& scene = *loaded.scene;
    std::vector<std::uint32_t> used;
    for (const scene::NodeId child : scene.groups[scene.node(scene.root).index].children) {
        used.push_back(scene.node(child).material_id.value);
    }
    EXPECT_EQ(used, (std::vector<std::uint32_t>{0, 0, 1, scene::MaterialId{}.value}));
}

TEST(LiteralShortCut, TheFirstNodeTooManyIsToldWithoutItAndWithIt) {
    parser::LoadSettings settings;
    const std::string text =
        "let red = material { }\nsphere { }\nsphere { material: red }\nbox { material: red }\n";
    for (settings.limits.nodes = 0; settings.limits.nodes < 5; ++settings.limits.nodes) {
        expect_same(text, settings);
    }
    settings.limits.nodes = 2;
    EXPECT_EQ(load_text(text, settings).text(), "E0513 4:1 the scene has more than 2 nodes\n");
}

TEST(LiteralShortCut, NestingIsLimitedWithoutItAndWithIt) {
    for (int depth = 1; depth < 12; ++depth) {
        std::string text = "let red = material { }\n";
        for (int i = 0; i < depth; ++i) text += "group {\n";
        text += "sphere { material: red, center: [-1, 2, 3], radius: 2 }\n";
        for (int i = 0; i < depth; ++i) text += "}\n";
        parser::LoadSettings settings;
        settings.limits.nesting = 8;
        expect_same(text, settings);
    }
}

// A span of so many bytes does not know where it ends.
TEST(LiteralShortCut, AMaterialBehindALotOfNothingIsFound) {
    const std::string blanks(70'000, ' ');
    expect_same("sphere { radius: 1, " + blanks + "material: unknown }\n");
    expect_same("sphere { radius: 1, " + blanks.substr(0, 65'000) + "material: unknown }\n");
}

}  // namespace
}  // namespace lray::test
