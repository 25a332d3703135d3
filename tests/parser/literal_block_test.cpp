// The short cut for blocks of literals changes nothing: with it and without it a scene and all that
// is said about it are the same.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic_printer.h"
#include "tests/parser/loaded.h"
#include "tests/parser/syntax_tree.h"
#include "tests/support/random.h"

namespace lray::test {
namespace {

/// What a scene holds, as text: equal for equal scenes.
std::string dump(const scene::Scene& scene, const Sources& sources) {
    std::string text;
    const auto add = [&](auto... numbers) {
        (fmt::format_to(std::back_inserter(text), " {}", numbers), ...);
    };
    const auto add3 = [&](DVec3 v) { add(v.x, v.y, v.z); };
    const auto node = [&](const auto& self, scene::NodeId id) -> void {
        const scene::Node& n = scene.node(id);
        text += fmt::format("\n{}:", static_cast<int>(n.kind));
        if (!n.span.is_nowhere())
            text += place_of(sources, n.span) + fmt::format("+{}", n.span.length);
        add(n.visible, n.casts_shadow);
        if (!n.material_id.is_none()) {
            const Color diffuse = scene.materials[n.material_id.index()].diffuse.constant;
            add(n.material_id.index(), diffuse.r, diffuse.g, diffuse.b);
        }
        if (!n.transform_id.is_none()) add3(scene.transforms[n.transform_id.index()].offset());
        if (!n.label_id.is_none()) text += scene.labels[n.label_id.index()];
        switch (n.kind) {
            case scene::NodeKind::group:
                for (const scene::NodeId child : scene.groups[n.index].children) self(self, child);
                break;
            case scene::NodeKind::instance:
                self(self, scene.instances[n.index].target);
                break;
            case scene::NodeKind::sphere:
                add3(scene.spheres[n.index].center);
                add(scene.spheres[n.index].radius);
                break;
            case scene::NodeKind::rectangle:
                add3(scene.rectangles[n.index].corner);
                add3(scene.rectangles[n.index].edge_u);
                add3(scene.rectangles[n.index].edge_v);
                break;
            case scene::NodeKind::triangle:
                add3(scene.triangles[n.index].a);
                add3(scene.triangles[n.index].b);
                add3(scene.triangles[n.index].c);
                break;
            case scene::NodeKind::cylinder:
                add3(scene.cylinders[n.index].from);
                add3(scene.cylinders[n.index].to);
                add(scene.cylinders[n.index].radius, scene.cylinders[n.index].radius_to);
                add(scene.cylinders[n.index].caps);
                break;
            case scene::NodeKind::disk:
                add3(scene.disks[n.index].center);
                add3(scene.disks[n.index].normal);
                add(scene.disks[n.index].radius, scene.disks[n.index].hole);
                break;
            case scene::NodeKind::box:
                add3(scene.boxes[n.index].min);
                add3(scene.boxes[n.index].max);
                break;
            case scene::NodeKind::plane:
                add3(scene.planes[n.index].point);
                add3(scene.planes[n.index].normal);
                break;
            case scene::NodeKind::torus:
                add(scene.tori[n.index].radius, scene.tori[n.index].tube);
                break;
            case scene::NodeKind::light:
                add(scene.lights[n.index].shape.index(), scene.lights[n.index].intensity);
                break;
            case scene::NodeKind::mesh:
                add(scene.mesh_uses[n.index].z_is_up);
                break;
        }
    };
    node(node, scene.root);
    return text;
}

std::string outcome(const Loaded& loaded) {
    PrintOptions all;
    all.max_errors = 0;
    std::string text = format_diagnostics(loaded.diagnostics, loaded.sources, all) +
                       (loaded.scene ? dump(*loaded.scene, loaded.sources) : "no scene");
    const std::string_view path = loaded.sources[0].path;  // in a directory of its own
    const std::string_view directory = path.substr(0, path.rfind('/') + 1);
    for (std::size_t at = 0; (at = text.find(directory, at)) != text.npos;) {
        text.erase(at, directory.size());
    }
    return text;
}

parser::LoadSettings without_short_cut(parser::LoadSettings settings = {}) {
    settings.use_literal_fast_path = false;
    return settings;
}

void expect_same(std::string_view text, const parser::LoadSettings& settings = {},
                 const std::vector<Companion>& companions = {}) {
    EXPECT_EQ(outcome(load_text(text, settings, companions)),
              outcome(load_text(text, without_short_cut(settings), companions)))
        << text;
}

/// Blocks of literals, mostly right; now and then one is not for the short cut. They name
/// materials.
std::string literal_shapes(Random& random, std::span<const std::string_view> materials) {
    const auto number = [&] {
        switch (random.below(8)) {
            case 0:
                return fmt::format("{}", static_cast<int>(random.below(7)) - 2);
            case 1:
                return fmt::format("{}e{}", random.uniform(-1, 1),
                                   static_cast<int>(random.below(9)) - 4);
            case 2:
                return fmt::format("{}cm", random.below(100));
            case 3:
                return std::string(random.below(4) == 0 ? "1 / 2" : ".5");
            default:
                return fmt::format("{:.3f}", random.uniform(-3, 9));
        }
    };
    const auto boolean = [&] {
        constexpr std::array kBooleans = {"true", "false", "1 < 2", "truer", "1"};
        return std::string(kBooleans[random.below(8) == 0 ? random.below(5) : random.below(2)]);
    };
    const auto vector = [&](std::uint64_t size) {
        if (size == 0) return boolean();
        std::string text = "[";
        for (std::uint64_t i = 0; i < size; ++i) text += (i == 0 ? "" : ", ") + number();
        return text + "]";
    };
    struct Property {
        const char* name;
        std::uint64_t size;
    };
    struct Shape {
        const char* name;
        std::vector<Property> properties;
    };
    static const std::vector<Shape> kShapes = {
        {"sphere", {{"center", 3}, {"radius", 1}}},
        {"rectangle", {{"center", 3}, {"size", 2}, {"normal", 3}}},
        {"rectangle", {{"corner", 3}, {"edge_u", 3}, {"edge_v", 3}}},
        {"triangle", {{"a", 3}, {"b", 3}, {"c", 3}}},
        {"cylinder", {{"from", 3}, {"to", 3}, {"radius", 1}, {"radius_to", 1}, {"caps", 0}}},
        {"disk", {{"center", 3}, {"normal", 3}, {"radius", 1}, {"hole", 1}}},
        {"box", {{"min", 3}, {"max", 3}}},
        {"box", {{"center", 3}, {"size", 3}, {"translate", 3}}},
        {"plane", {{"point", 3}, {"normal", 3}}},
        {"torus", {{"radius", 1}, {"tube", 1}}},
    };
    std::string scene;
    const std::uint64_t count = 1 + random.below(6);
    std::string_view material = materials[random.below(materials.size())];
    for (std::uint64_t i = 0; i < count; ++i) {
        const Shape& shape = kShapes[random.below(kShapes.size())];
        scene += std::string(shape.name) + (random.below(9) == 0 ? " \"label\" {" : " {");
        for (const Property& property : shape.properties) {
            if (random.below(7) == 0) continue;
            const std::uint64_t size = random.below(40) == 0 ? 2 : property.size;
            scene += fmt::format("{}{}: {}", random.below(2) == 0 ? "\n  " : ", ", property.name,
                                 size == 1 ? number() : vector(size));
        }
        if (random.below(3) == 0) material = materials[random.below(materials.size())];
        if (random.below(4) != 0) {
            scene += random.below(2) == 0 ? "\n  " : ", ";
            scene += fmt::format("material{} {}", random.below(9) == 0 ? " :" : ":", material);
        }
        scene += random.below(5) == 0 ? "\n} // end\n" : " }\n";
    }
    return scene;
}

constexpr std::array<std::string_view, 5> kDefined = {"red", "blue", "_white", "red", "blue"};
constexpr std::array<std::string_view, 16> kAnyName = {
    "red",  "blue", "_white", "wood",   "pi", "ball", "reds", "number",
    "time", "sin",  "later",  "sphere", "if", "true", "lib",  "tower"};

// Nothing can be named after a built-in block; what is told then of the blocks that are hidden
// is noise.
constexpr std::array<std::string_view, 8> kNewNames = {"red",  "blue", "_white", "wood",
                                                       "ball", "pi",   "number", "later"};

constexpr std::string_view kMaterials =
    "let red = material { diffuse: [1, 0, 0] }\n"
    "var blue = material { diffuse: [0, 0, 1] }\n"
    "let _white = material { diffuse: 1 }\n";

TEST(LiteralShortCut, GeneratedShapesAreTheSameWithoutIt) {
    const std::uint64_t seed = 3;
    LRAY_TRACE_SEED(seed);
    Random random(seed);
    int scenes = 0;
    for (int i = 0; i < 2000; ++i) {
        std::string text = std::string(kMaterials) + literal_shapes(random, kDefined);
        if (random.below(4) == 0) text += literal_shapes(random, kAnyName);
        const Loaded fast = load_text(text);
        scenes += fast.scene ? 1 : 0;
        ASSERT_EQ(outcome(fast), outcome(load_text(text, without_short_cut()))) << text;
    }
    EXPECT_GT(scenes, 200) << "too few of the scenes are right to compare anything";
}

/// Statements around literal shapes that give the names of their materials a meaning, or another
/// one.
class Programs {
 public:
    explicit Programs(Random& random) : random_(random) {}

    std::string file() {
        std::string text(kMaterials);
        text += statements(2 + random_.below(5), 0);
        return text;
    }

 private:
    std::string statements(std::uint64_t count, int depth) {
        std::string text;
        for (std::uint64_t i = 0; i < count; ++i) text += statement(depth);
        return text;
    }

    std::string statement(int depth) {
        const std::uint64_t id = ++count_;
        const std::string_view name = random_.below(12) == 0 ? pick(kAnyName) : pick(kDefined);
        const auto inside = [&] {
            return depth < 3 ? statements(1 + random_.below(3), depth + 1) : shapes();
        };
        switch (random_.below(26)) {
            case 0:
                return fmt::format("let own{} = material {{ diffuse: 0.5 }}\n", id) +
                       fmt::format("sphere {{ material: own{} }}\n", id - random_.below(12) / 11);
            case 1:
                return "blue = material { diffuse: [0, 1, 1] }\n";
            case 2:
                return random_.below(4) == 0 ? fmt::format("let {} = 3\n", pick(kNewNames))
                                             : shapes();
            case 3:
                return fmt::format("group {{ let {} = material {{ }}\n{}}}\n", pick(kNewNames),
                                   inside());
            case 4:
            case 5:
                return fmt::format("group {{\n{}}}\n", inside());
            case 6:
                return fmt::format("for i in range(2) {{\n{}}}\n", inside());
            case 7:
                return fmt::format("if 1 < {} {{\n{}}}\n", random_.below(3), inside());
            case 8:
                return fmt::format("let made{} = group {{\n{}}}\nmade{} {{ }}\n", id, inside(),
                                   count_);
            case 9:
                return fmt::format("for m in [red, blue, {}] {{ sphere {{ material: m }} }}\n",
                                   name);
            case 10:
                return fmt::format(
                    "let all{0} = [for m in [red, {1}]: group {{ sphere {{ "
                    "material: m }} }}]\nall{0}[0] {{ }}\n",
                    id, name);
            case 11:
                return fmt::format(
                    "component part{0}(m = red) {{\n sphere {{ material: m }}\n{1}"
                    "}}\npart{0} {{ m: {2} }}\n",
                    id, inside(), name);
            case 12:
                return fmt::format(
                    "fn make{0}(m) {{\nreturn group {{ sphere {{ material: m }}\n "
                    "box {{ material: {1} }} }}\n}}\nmake{0}(red) {{ }}\n",
                    id, name);
            case 13:
                return "include \"part.lrs\"\n";
            case 14:
                return "group { include \"part.lrs\"\n }\n";
            case 15:
                return random_.below(4) == 0 ? fmt::format("sphere {{ {} }}\n", shapes())
                                             : shapes();
            case 16:
                return "import \"part.lrs\" as lib\nsphere { material: lib.red }\n";
            case 17:
                return fmt::format("let ball = sphere {{ material: {} }}\n", name);
            default:
                return shapes();
        }
    }

    /// Right, but for a name now and then.
    std::string shapes() {
        constexpr std::array<std::string_view, 6> kShapes = {
            "sphere { radius: 2, material: $ }",
            "box {\n  min: [0, 0, 0]\n  material: $\n  max: [1, 2, 3]\n}",
            "cylinder { material: $, caps: false }",
            "torus { material :$; } // a ring",
            "disk { material: $, radius: 1 / 2 }",
            "triangle { a: [0, 0, 0], b: [1, 0, 0], c: [0, 1, 0] }"};
        std::string text;
        std::string_view material = pick(kDefined);
        for (std::uint64_t i = 1 + random_.below(5); i > 0; --i) {
            if (random_.below(3) == 0) material = pick(kDefined);
            const std::string_view name = random_.below(60) == 0 ? pick(kAnyName) : material;
            std::string shape(pick(kShapes));
            const std::size_t at = shape.find('$');
            if (at != shape.npos) shape.replace(at, 1, name);
            text += shape + "\n";
        }
        return text;
    }

    template <class Names>
    std::string_view pick(const Names& names) {
        return names[random_.below(names.size())];
    }

    Random& random_;
    std::uint64_t count_ = 0;
};

TEST(LiteralShortCut, GeneratedProgramsAreTheSameWithoutIt) {
    const std::uint64_t seed = 5;
    LRAY_TRACE_SEED(seed);
    Random random(seed);
    int scenes = 0;
    for (int i = 0; i < 2000; ++i) {
        const std::string text = Programs(random).file();
        const std::string part = random.below(2) == 0 ? "let red = material { diffuse: 0.25 }\n"
                                                      : literal_shapes(random, kDefined);
        const std::vector<Companion> companions = {{"part.lrs", part}};
        const Loaded fast = load_text(text, parser::LoadSettings{}, companions);
        scenes += fast.scene ? 1 : 0;
        ASSERT_EQ(outcome(fast), outcome(load_text(text, without_short_cut(), companions)))
            << text << "\npart.lrs:\n"
            << part;
    }
    EXPECT_GT(scenes, 200) << "too few of the programs are right to compare anything";
}

/// What a hasty hand does to a text.
void mutate(std::string& text, Random& random) {
    constexpr std::array kPieces = {
        "red", "blue", "x",        "material: red", "sphere { }", "{",       "}",       ",", "\n",
        ":",   "1",    "let ",     "true",          " ",          "// no\n", "group {", ".", "[",
        "]",   "(",    "material", "caps: true",    "=",          "if "};
    const std::size_t at = random.below(text.size());
    const std::size_t size = 1 + random.below(12);
    switch (random.below(4)) {
        case 0:
            text.erase(at, size);
            break;
        case 1:
            text.insert(at, kPieces[random.below(kPieces.size())]);
            break;
        case 2:
            text.replace(at, size, kPieces[random.below(kPieces.size())]);
            break;
        default:
            text.insert(at, text.substr(random.below(text.size()), 3 * size));
            break;
    }
}

bool has_syntax_errors(const Loaded& loaded) {
    for (const Diagnostic* diagnostic : loaded.diagnostics.sorted()) {
        const std::string_view id = code_info(diagnostic->code).id;
        if (id.starts_with("E00") || id.starts_with("E01")) return true;
    }
    return false;
}

// How the parser goes on behind a mistake may differ, not that there is one.
TEST(LiteralShortCut, MutatedProgramsAreTheSameWithoutIt) {
    const std::uint64_t seed = 9;
    LRAY_TRACE_SEED(seed);
    Random random(seed);
    int scenes = 0;
    int mistakes = 0;
    for (int i = 0; i < 4000; ++i) {
        std::string text = Programs(random).file();
        for (std::uint64_t k = random.below(4); k > 0; --k) mutate(text, random);
        const std::vector<Companion> companions = {{"part.lrs", "box { }\n"}};
        const Loaded fast = load_text(text, parser::LoadSettings{}, companions);
        const Loaded whole = load_text(text, without_short_cut(), companions);
        ASSERT_EQ(has_syntax_errors(fast), has_syntax_errors(whole)) << text;
        if (has_syntax_errors(fast)) continue;
        scenes += fast.scene ? 1 : 0;
        mistakes += fast.scene ? 0 : 1;
        ASSERT_EQ(outcome(fast), outcome(whole)) << text;
    }
    EXPECT_GT(scenes, 200) << "too few of the programs are right to compare anything";
    EXPECT_GT(mistakes, 300) << "too few of the programs are wrong to compare messages";
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
