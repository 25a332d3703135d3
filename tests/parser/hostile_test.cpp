// Text that no one would write: whatever it is, loading ends, and gives a scene exactly when it
// reports no error. And: the short cut for literals changes nothing.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic_printer.h"
#include "tests/parser/loaded.h"
#include "tests/support/random.h"

namespace lray::test {
namespace {

constexpr std::array kWords = {"let ",        "include ",   "if ",
                               "then ",       "else ",      "and ",
                               "or ",         "not ",       "true ",
                               "false ",      "for ",       "for i in ",
                               "in ",         "while ",     "fn ",
                               "fn f(",       "component ", "component c(a = 1) {",
                               "var ",        "param ",     "import ",
                               "as ",         "return ",    "break",
                               "continue",    "match ",     "lrs ",
                               "sphere",      "group",      "material",
                               "camera",      "mesh",       "box",
                               "render",      "info",       "radius",
                               "center",      "translate",  "scale",
                               "rotate_y",    "diffuse",    "position",
                               "positions",   "file",       "part",
                               "a",           "b",          "red",
                               "sqrt",        "max",        "colors",
                               "{",           "}",          "[",
                               "]",           "(",          ")",
                               ",",           ";",          ":",
                               ".",           "=",          "+",
                               "-",           "*",          "/",
                               "%",           "^",          "==",
                               "!=",          "<",          "<=",
                               "&&",          "..",         "+=",
                               "1",           "0.5",        "-2",
                               "3cm",         "1e999",      "0xff",
                               "#f00",        "#12345",     "\"x\"",
                               "\"a.lrs\"",   "\"",         "//",
                               "/*",          "*/",         "\n",
                               "\n  ",        "\n",         " ",
                               " ",           "\xC3\xA9",   "\xFF",
                               "\\",          "'",          "sphere { radius: 2 }\n",
                               "let a = 1\n", "[1, 2, 3]",  "[[0, 0, 0], [1, 0, 0], [0, 1, 0]]",
                               "radius: 1, ", "group {\n"};

void expect_sane(const Loaded& loaded, const std::string& text) {
    ASSERT_EQ(loaded.scene.has_value(), !loaded.has_errors()) << text;
    // Every place can be shown.
    static_cast<void>(format_diagnostics(loaded.diagnostics, loaded.sources, {}));
}

TEST(HostileText, SoupOfTokensEndsInASceneOrInErrors) {
    const std::uint64_t seed = 7;
    LRAY_TRACE_SEED(seed);
    Random random(seed);
    for (int i = 0; i < 2000; ++i) {
        std::string text;
        const std::uint64_t count = 1 + random.below(60);
        for (std::uint64_t k = 0; k < count; ++k) text += kWords[random.below(kWords.size())];
        expect_sane(load_text(text), text);
        if (HasFatalFailure()) return;
    }
}

TEST(HostileText, MutatedExamplesEndInASceneOrInErrors) {
    const std::uint64_t seed = 11;
    LRAY_TRACE_SEED(seed);
    Random random(seed);
    const Examples examples;
    for (int i = 0; i < 1000; ++i) {
        const std::string& name = examples.names()[random.below(examples.names().size())];
        std::string text = examples.text(name);
        const std::uint64_t count = 1 + random.below(8);
        for (std::uint64_t k = 0; k < count && !text.empty(); ++k) {
            const std::size_t at = random.below(text.size());
            const std::size_t size = random.below(20);
            switch (random.below(5)) {
                case 0:
                    text[at] = static_cast<char>(random.below(256));
                    break;
                case 1:
                    text.erase(at, size);
                    break;
                case 2:
                    text.insert(at, kWords[random.below(kWords.size())]);
                    break;
                case 3:
                    text.insert(at, text.substr(random.below(text.size()), size));
                    break;
                default:
                    text.resize(at + 1);
                    break;
            }
        }
        expect_sane(examples.load_changed(name, text), text);
        if (HasFatalFailure()) return;
    }
}

TEST(HostileText, EveryPrefixOfAnExampleEnds) {
    const Examples examples;
    for (const std::string& name : examples.names()) {
        const std::string text = examples.text(name);
        for (std::size_t size = 0; size < text.size(); size += 23) {
            const std::string prefix = text.substr(0, size);
            expect_sane(examples.load_changed(name, prefix), prefix);
            if (HasFatalFailure()) return;
        }
    }
}

// Once deep recursion or time that grew with the square of the size.
TEST(HostileText, LongRunsOfOneMistakeEnd) {
    for (const char* piece :
         {"$", "# no comment\n", "''", "\xE2\x80\x98", "\xE2\x80\x98x\xE2\x80\x99,", "\xC2\xA0",
          "sphere { radios: 1 } ", "let a = unknown; "}) {
        std::string text;
        for (int i = 0; i < 50'000; ++i) text += piece;
        EXPECT_TRUE(load_text(text).has_errors()) << piece;
    }
}

TEST(HostileText, ALongLineOfBlocksIsReadInOneGo) {
    std::string text = "let red = material { }; ";
    for (int i = 0; i < 100'000; ++i) text += "sphere { material: red } ";
    const Loaded loaded = load_text(text);
    ASSERT_TRUE(loaded.scene.has_value()) << loaded.text();
    EXPECT_EQ(loaded.scene->spheres.size(), 100'000u);
}

TEST(HostileText, APartOfEachNameIsFoundAmongMany) {
    std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    std::string text;
    for (int i = 0; i < 50'000; ++i) {
        mesh += fmt::format("g part{}\nf 1 2 3\n", i);
        text += fmt::format("mesh {{ file: \"m.obj\", part: \"part{}\" }}\n", i);
    }
    const Loaded loaded = load_text(text, parser::LoadSettings{}, {{"m.obj", mesh}});
    ASSERT_TRUE(loaded.scene.has_value()) << loaded.text();
    const scene::MeshUse& last = loaded.scene->mesh_uses.back();
    EXPECT_EQ(loaded.scene->meshes[0].parts[last.part].name, "part49999");
}

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
    return loaded.text() + (loaded.scene ? dump(*loaded.scene, loaded.sources) : "no scene");
}

/// A block of literals, mostly right; now and then it is not one for the short cut.
std::string literal_scene(Random& random) {
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
    const auto vector = [&](std::uint64_t size) {
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
        {"cylinder", {{"from", 3}, {"to", 3}, {"radius", 1}, {"radius_to", 1}}},
        {"disk", {{"center", 3}, {"normal", 3}, {"radius", 1}, {"hole", 1}}},
        {"box", {{"min", 3}, {"max", 3}}},
        {"box", {{"center", 3}, {"size", 3}, {"translate", 3}}},
        {"plane", {{"point", 3}, {"normal", 3}}},
        {"torus", {{"radius", 1}, {"tube", 1}}},
    };
    std::string scene;
    const std::uint64_t count = 1 + random.below(6);
    for (std::uint64_t i = 0; i < count; ++i) {
        const Shape& shape = kShapes[random.below(kShapes.size())];
        scene += std::string(shape.name) + (random.below(9) == 0 ? " \"label\" {" : " {");
        for (const Property& property : shape.properties) {
            if (random.below(7) == 0) continue;
            const std::uint64_t size = random.below(40) == 0 ? 2 : property.size;
            scene += fmt::format("{}{}: {}", random.below(2) == 0 ? "\n  " : ", ", property.name,
                                 size == 1 ? number() : vector(size));
        }
        scene += random.below(5) == 0 ? "\n} // end\n" : " }\n";
    }
    return scene;
}

TEST(LiteralShortCut, GeneratedScenesAreTheSameWithoutIt) {
    const std::uint64_t seed = 3;
    LRAY_TRACE_SEED(seed);
    Random random(seed);
    parser::LoadSettings without;
    without.use_literal_fast_path = false;
    int scenes = 0;
    for (int i = 0; i < 2000; ++i) {
        const std::string text = literal_scene(random);
        const Loaded fast = load_text(text);
        scenes += fast.scene ? 1 : 0;
        ASSERT_EQ(outcome(fast), outcome(load_text(text, without))) << text;
    }
    EXPECT_GT(scenes, 200) << "too few of the scenes are right to compare anything";
}

TEST(LiteralShortCut, ExamplesAreTheSameWithoutIt) {
    parser::LoadSettings without;
    without.use_literal_fast_path = false;
    const Examples examples;
    for (const std::string& name : examples.names()) {
        const std::string text = examples.text(name);
        EXPECT_EQ(outcome(examples.load_changed(name, text)),
                  outcome(examples.load_changed(name, text, without)))
            << name;
    }
}

TEST(LiteralShortCut, MistakesReadTheSameWithoutIt) {
    parser::LoadSettings without;
    without.use_literal_fast_path = false;
    for (const char* text :
         {"sphere { radius: -1 }", "sphere { radius: 0 }", "sphere { radius: 1, radius: 2 }",
          "sphere { center: [0, 0] }", "triangle { a: [0, 0, 0], b: [1, 1, 1], c: [2, 2, 2] }",
          "box { min: [1, 1, 1], max: [0, 0, 0] }", "rectangle { size: [1, 1], corner: [0, 0, 0] }",
          "sphere { radius: 1 center: [0, 0, 0] }", "sphere { radius: 1e999 }",
          "sphere {\n radius: 1", "group { sphere { radius: 1 } }",
          "sphere { sphere { radius: 1 } }", "let sphere = 1\nsphere { radius: 1 }",
          "disk { hole: 2 }", "plane { normal: [0, 0, 0] }"}) {
        EXPECT_EQ(outcome(load_text(text)), outcome(load_text(text, without))) << text;
    }
}

}  // namespace
}  // namespace lray::test
