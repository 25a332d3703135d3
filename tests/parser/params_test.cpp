// Imports, includes and params: files that make up one program, and values from outside.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/parser/program.h"

namespace lray::test {
namespace {

using Files = std::vector<Companion>;

std::string told(std::string_view scene, const Files& files) {
    return told_by(scene, {}, files);
}

TEST(Imports, GiveWhatIsAtTheirTopLevel) {
    const Files files = {{"lib.lrs",
                          "let size = 3\nlet _own = 4\nvar state = 5\nparam n = 6\n"
                          "fn f(x) = x * _own + hidden(x)\nfn hidden(x) = x + size\n"
                          "component c(r = size) { sphere { radius: r } }\nsphere { radius: 50 }\n"
                          "print(\"lib runs\")\ncamera { }\nrender { samples: 7 }\n"}};
    EXPECT_EQ(
        told("import \"lib.lrs\"\nprint(lib.size, lib.n, lib.f(1), map([1, 2], lib.f))", files),
        "lib runs\n3 6 8 [8, 13]\n");
    const Ran placed = run("import \"lib.lrs\" as l\nl.c { }\nl.c { r: 9 }", {}, files);
    ASSERT_TRUE(placed.loaded.scene) << placed.told();
    Diagnostics diagnostics;
    EXPECT_EQ(scene::flatten(*placed.loaded.scene, {}, diagnostics)->spheres.size(), 2u);
    EXPECT_TRUE(placed.loaded.scene->cameras.empty());
    EXPECT_EQ(placed.loaded.scene->render.samples, 1u);
    EXPECT_EQ(told("import \"lib.lrs\" as a\nimport \"lib.lrs\" as b\nprint(a.f == b.f, a.n + b.n)",
                   files),
              "lib runs\ntrue 12\n");
    EXPECT_EQ(told("import \"lib.lrs\" as l\nlet x = l._own", files).substr(0, 10), "E0206 2:11");
    EXPECT_EQ(told("import \"lib.lrs\" as l\nlet x = l.siz", files),
              "E0207 2:11 lib.lrs has no `siz`\n");
    EXPECT_EQ(told("import \"lib.lrs\" as l\nlet x = l.state", files),
              "E0207 2:11 lib.lrs has no `state`\n");
    EXPECT_EQ(told("import \"lib.lrs\" as l\nlet x = size", files),
              "E0201 2:9 unknown name `size`\n");
    EXPECT_EQ(told("import \"lib.lrs\" as l\nlet x = l", files).substr(0, 9), "E0301 2:9");
}

TEST(Imports, HaveAScopeOfTheirOwn) {
    EXPECT_EQ(told("let size = 1\nimport \"a.lrs\"\nprint(size, a.get())",
                   {{"a.lrs", "let size = 2\nfn get() = size\n"}}),
              "1 2\n");
    EXPECT_EQ(told("let size = 1\nimport \"a.lrs\"\nprint(a.x)", {{"a.lrs", "let x = size\n"}}),
              "E0201 a.lrs:1:9 unknown name `size`\n");
    EXPECT_EQ(told("import \"a.lrs\"\nprint(a.b.x)",
                   {{"a.lrs", "import \"b.lrs\"\nlet y = b.x"}, {"b.lrs", "let x = 1"}})
                  .substr(0, 9),
              "E0207 2:9");
}

TEST(Imports, RunOnceInWhateverFileTheyAre) {
    const Files files = {{"a.lrs", "import \"c.lrs\"\nlet x = c.x + 1"},
                         {"b.lrs", "import \"c.lrs\" as other\nlet y = other.x + 2"},
                         {"c.lrs", "print(\"once\")\nlet x = 10"}};
    EXPECT_EQ(
        told("import \"a.lrs\"\nimport \"b.lrs\"\nimport \"c.lrs\"\nprint(a.x, b.y, c.x)", files),
        "once\n11 12 10\n");
    // In a file that is included they are names of the including file.
    EXPECT_EQ(told("group { include \"part.lrs\"\n print(lib.x) }",
                   {{"part.lrs", "import \"lib.lrs\"\nsphere { radius: lib.x }"},
                    {"lib.lrs", "let x = 3"}}),
              "3\n");
    EXPECT_EQ(told("include \"part.lrs\"\nprint(lib.x)",
                   {{"part.lrs", "import \"lib.lrs\""}, {"lib.lrs", "let x = 3"}}),
              "3\n");
    EXPECT_EQ(told("for i in range(2) { import \"a.lrs\" }", {{"a.lrs", ""}}).substr(0, 10),
              "E0118 1:21");
    EXPECT_EQ(told("component c() { import \"a.lrs\" }", {{"a.lrs", ""}}).substr(0, 10),
              "E0118 1:17");
}

TEST(Imports, InACircleAreToldSo) {
    EXPECT_NE(told("import \"a.lrs\"\nprint(a.x)",
                   {{"a.lrs", "import \"b.lrs\"\nlet x = 1"}, {"b.lrs", "import \"a.lrs\""}})
                  .find("E0602 b.lrs:1:8"),
              std::string::npos);
    EXPECT_NE(told("import \"main.lrs\" as me", {}).find("E0602 1:8"), std::string::npos);
    EXPECT_NE(told("include \"a.lrs\"", {{"a.lrs", "import \"a.lrs\""}}).find("E0602"),
              std::string::npos);
}

TEST(Imports, KeepTheirValuesAfterMemoryIsGivenBack) {
    parser::LoadSettings settings;
    settings.limits.value_bytes = 2'000'000;
    EXPECT_EQ(told_by(R"(
import "lib.lrs"
for i in range(200) {
  let garbage = [for k in range(500): [k, i, k]]
  assert(len(garbage) == 500)
}
print(lib.rows[3], lib.fs[2](1), lib.made.v, lib.last)
)",
                      settings, {{"lib.lrs", R"(
let rows = [for i in range(5): [i, i * i]]
var collected = []
for i in range(200) {
  let more = [for k in range(300): [k, i]]
  collected = concat(collected, [fn(x) = [x, more[7].x, i]])
  if len(collected) > 4 { collected = slice(collected, 1) }
}
let fs = collected
let made = record { v: [1, 2, 3] }
fn newest() = fs[3](0)
let last = newest()
)"}}),
              "[3, 9] [1, 7, 198] [1, 2, 3] [0, 7, 199]\n");
}

TEST(Includes, ActAsIfTheyWereWrittenThere) {
    const Files files = {{"part.lrs", "sphere { radius: size }\n"},
                         {"names.lrs", "let size = 2\n"}};
    const Ran loaded = run(
        "include \"names.lrs\"\ngroup { include \"part.lrs\" }\ninclude \"part.lrs\"", {}, files);
    ASSERT_TRUE(loaded.loaded.scene) << loaded.told();
    EXPECT_EQ(loaded.loaded.scene->spheres.size(), 2u);
    EXPECT_EQ(told("include \"names.lrs\"\ninclude \"names.lrs\"", files),
              "E0203 names.lrs:1:5 `size` is already defined\n");
    EXPECT_EQ(told("for i in range(2) { include \"part.lrs\" }", files).substr(0, 10),
              "E0118 1:21");
    EXPECT_NE(told("include \"main.lrs\"", {}).find("E0602 1:9"), std::string::npos);
}

Ran with_definitions(std::string_view scene, const std::vector<parser::Definition>& definitions,
                     const Files& files = {}) {
    parser::LoadSettings settings;
    settings.definitions = definitions;
    return run(scene, settings, files);
}

std::string printed_with(std::string_view scene, const std::vector<parser::Definition>& definitions,
                         const Files& files = {}) {
    const Ran loaded = with_definitions(scene, definitions, files);
    std::string text = loaded.told();
    for (const std::string& mistake : loaded.usage_mistakes) text += "usage: " + mistake + "\n";
    return text;
}

TEST(Params, TakeValuesOfEveryKind) {
    EXPECT_EQ(printed_with("param a = 1\nparam b = [1, 2]\nparam c = #fff\nparam d = true\n"
                           "param e = \"x\"\nparam f = [[1, 2], [3, 4]]\n"
                           "print(a, b, c == #ff0000, d, e, f)",
                           {{"a", "-2.5"},
                            {"b", "[3, 4, 5]"},
                            {"c", "#ff0000"},
                            {"d", "false"},
                            {"e", "some text"},
                            {"f", "[[5, 6]]"}}),
              "-2.5 [3, 4, 5] true false some text [[5, 6]]\n");
    EXPECT_EQ(printed_with("param e = \"x\"\nprint(e)", {{"e", "\"quoted\""}}), "quoted\n");
    EXPECT_EQ(printed_with("param a = 1\nlet b = a * 2\nprint(a, b)", {}), "1 2\n");
    EXPECT_EQ(
        printed_with("import \"l.lrs\"\nprint(l.n)", {{"l.n", "4"}}, {{"l.lrs", "param n = 1"}}),
        "4\n");
}

TEST(Params, ThatDoNotFitAreMistakesOfUse) {
    const std::string ranged = "param n = 200 in [0, 5000]\nprint(n)";
    EXPECT_EQ(printed_with(ranged, {{"n", "0"}}), "0\n");
    EXPECT_EQ(printed_with(ranged, {{"n", "5000"}}), "5000\n");
    for (const std::string_view value : {"-1", "5001", "1.5", "true", "\"a\"", "[1]", "1 +", "x"}) {
        const Ran loaded = with_definitions(ranged, {{"n", std::string(value)}});
        EXPECT_FALSE(loaded.loaded.scene) << value;
        ASSERT_EQ(loaded.usage_mistakes.size(), 1u) << value << loaded.told();
        EXPECT_NE(loaded.usage_mistakes[0].find("n"), std::string::npos);
        EXPECT_FALSE(loaded.loaded.has_errors()) << loaded.told();
    }
    EXPECT_EQ(printed_with("param n = 0.5 in [0, 5000]\nprint(n)", {{"n", "1.5"}}), "1.5\n");
    EXPECT_EQ(printed_with("param s = \"a\" in [\"a\", \"b\"]\nprint(s)", {{"s", "b"}}), "b\n");
    EXPECT_EQ(
        with_definitions("param s = \"a\" in [\"a\", \"b\"]", {{"s", "c"}}).usage_mistakes.size(),
        1u);
    EXPECT_EQ(printed_with("param k = 2 in [1, 2, 4]\nprint(k)", {{"k", "4"}}), "4\n");
    EXPECT_EQ(with_definitions("param k = 2 in [1, 2, 4]", {{"k", "3"}}).usage_mistakes.size(), 1u);
    EXPECT_EQ(with_definitions("param kind = 1", {{"knd", "3"}}).usage_mistakes.at(0),
              "`-D knd`: the scene has no param `knd`; did you mean `kind`?");
    EXPECT_EQ(with_definitions("let a = 1", {{"a", "3"}}).usage_mistakes.size(), 1u);
    EXPECT_EQ(with_definitions("param a = 1", {{"a", "[1]"}}).usage_mistakes.size(), 1u);
}

TEST(Params, WithADefaultThatDoesNotFitAreErrors) {
    EXPECT_EQ(told_by("param n = 7 in [0, 5]").substr(0, 10), "E0304 1:11");
    EXPECT_EQ(told_by("param n = 7 in [5, 0]").substr(0, 10), "E0304 1:16");
    EXPECT_EQ(told_by("param n = \"c\" in [\"a\", \"b\"]").substr(0, 10), "E0304 1:11");
    EXPECT_EQ(told_by("param n: string = 7").substr(0, 5), "E0301");
    EXPECT_EQ(told_by("if true { param n = 1\n print(n) }").substr(0, 10), "E0118 1:11");
}

TEST(Time, FollowsTheFrame) {
    parser::LoadSettings settings;
    settings.frame = 12.0;
    EXPECT_EQ(told_by("animation { frames: 48, fps: 24, start: 1 }\nprint(time, frame)", settings),
              "1.5 12\n");
    EXPECT_EQ(told_by("print(time, frame)", settings), "0.5 12\n");
    EXPECT_EQ(told_by("fn f() = time * 2\nprint(f(), map([1], fn(x) = x + frame))", settings),
              "1 [13]\n");
}

}  // namespace
}  // namespace lray::test
