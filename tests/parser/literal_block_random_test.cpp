// The short cut for blocks of literals changes nothing, whatever is around them: generated
// programs, right ones and wrong ones.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/parser/short_cut.h"
#include "tests/support/random.h"

namespace lray::test {
namespace {

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

}  // namespace
}  // namespace lray::test
