// Text that no one would write: whatever it is, loading ends, and gives a scene exactly when it
// reports no error.
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

}  // namespace
}  // namespace lray::test
