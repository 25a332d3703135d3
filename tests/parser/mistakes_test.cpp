// The sixty mistakes of docs/diagnostics.md: the code, the place and the gist of what is told.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

#include "tests/parser/program.h"

namespace lray::test {
namespace {

struct Mistake {
    int number = 0;
    std::string_view input{};
    std::string_view place{};  // "E0401 1:10"
    std::string_view gist{};   // part of the message, a hint, label, note or help
    bool is_alone = true;      // nothing else is told
};

constexpr std::string_view kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9999\n";

constexpr auto kMistakes = std::to_array<Mistake>({
    {1, "sphere { radios: 1 }", "E0401 1:10", "did you mean `radius`?"},
    {2, "spere { }", "E0201 1:1", "did you mean `sphere`?"},
    {3, "sphere { radius 1 }", "E0107 1:16", "expected `:` after `radius`"},
    {4, "sphere { radius = 1 }", "E0204 1:10", "`radius` is a property here; write `radius: 1`"},
    {5, "sphere { radius: 1 center: [0,0,0] }", "E0105 1:20",
     "expected `,` or a new line before `center`"},
    {6, "sphere { radius: 1, radius: 2 }", "E0402 1:21", "first set here"},
    {7, "sphere { radius: }", "E0109 1:10", "`radius:` needs a value, like `1`"},
    {8, "sphere {\n radius: 1", "E0103 1:8", "never closed"},
    {9, "sphere { } }", "E0104 1:12", "`}` closes nothing"},
    {10, "group {\n  sphere {\n    radius: 1\n}\nsphere { }", "E0103 2:10", "never closed"},
    {11, "let a = [1, 2\nsphere { }", "E0101 1:14", "expected `]` to close `[` at 1:9"},
    {12, "let a = (1 + 2]", "E0101 1:15", "expected `)`"},
    {13, "radius: 1", "E0410 1:1", "outside any block"},
    {14, "let s = \"abc", "E0005 1:9", "not closed on its line"},
    {15, "# my scene", "E0006 1:1", "comments start with `//`"},
    {16, "let c = #12345", "E0010 1:9", "3, 6 or 8 hex digits"},
    {17, "let w = 30px", "E0007 1:11", "unknown unit `px`"},
    {18, "let n = 1.2.3", "E0008 1:9", "`1.2.3` is not a number"},
    {19, "let \u0430 = 1", "E0004 1:5", "Latin `a`"},
    {20, "/* note", "E0011 1:1", "never closed"},
    {21, "let p = <1, 2, 3>", "E0109 1:9", "[1, 2, 3]"},
    {22, "let a = 1\nif a = 1 { }", "E0111 2:6", "`==`"},
    {23, "let a = true\nlet b = true\nif a && b { }", "E0112 3:6", "`and`"},
    {24, "var i = 0\ni += 1", "E0112 2:3", "i = i + 1"},
    {25, "let x = 0.5\nlet ok = 0 < x < 1", "E0110 2:16", "0 < x and x < 1"},
    {26, "let a = 1\nlet y = a\n  * 2", "E0113 3:3", "previous line"},
    {27, "for i in 0..10 { }", "E0112 1:11", "range(0, 10)"},
    {28, "let x = true\nif x sphere { }", "E0116 2:6", "`if` needs `{ }`"},
    {29, "let for = 1", "E0114 1:5", "`for` is a keyword"},
    {30, "break", "E0119 1:1", "outside a loop"},
    {31, "#declare R = 1;", "E0006 1:1", "let R = 1"},
    {32, "material red { diffuse: red }", "E0107 1:10", "let red = material { ... }"},
    {33, "light { }", "E0201 1:1", "point_light"},
    {34, "sphere { radius: r }\nlet r = 1", "E0202 1:18", "before line 2 defines it"},
    {35, "let a = 1\nlet a = 2", "E0203 2:5", "first defined here"},
    {36, "let n = 0\nn = 1", "E0204 2:1", "`n` is constant"},
    {37, "var n = 0\nfn f() = n", "E0205 2:10", "pass it as a parameter"},
    {38, "import \"mat.lrs\"\nlet x = mat.oka", "E0207 2:13", "did you mean `oak`?"},
    {39, "sphere { radius: \"1\" }", "E0301 1:18", "`radius` needs a number, this is a string"},
    {40, "sphere { center: [0, 1] }", "E0303 1:18", "`center` needs 3 numbers, this has 2"},
    {41, "let v = [1,2,3] + [1,2]", "E0302 1:17", "cannot add 3 and 2 elements"},
    {42, "sphere { radius: -1 }", "E0304 1:18", "`radius` must be greater than 0, this is -1"},
    {43, "sphere { center: red }", "E0309 1:18", "`center` needs a point, `red` is a colour"},
    {44, "box { scale: [1, 0, 1] }", "E0310 1:14", "rectangle"},
    {45, "camera { position: [0,0,5], look_at: [0,0,5] }", "E0311 1:1", "same point"},
    {46, "triangle { a: [0,0,0], b: [1,0,0] }", "E0406 1:1", "triangle needs `c`"},
    {47, "rectangle { size: [1,1], corner: [0,0,0] }", "E0411 1:26", "not both", false},
    {48, "let m = material { model: \"phongg\" }", "E0403 1:27", "did you mean `phong`?"},
    {49, "let m = material { }\nm { }", "E0408 2:1", "material: m"},
    {50, "component flake(depth) { }\nflake(depth: 2)", "E0407 2:1", "flake { depth: 2 }"},
    {51, "sphere { sphere { } }", "E0412 1:10", "group"},
    {52, "let n = 0\nlet z = 1 / n", "E0503 2:11", "`n` is 0, defined here"},
    {53, "let xs = [1, 2, 3]\nlet y = xs[3]", "E0504 2:12",
     "index 3, but `xs` has elements 0 to 2"},
    {54, "fn f(n) = f(n)\nprint(f(1))", "E0511 1:11", "more than 1000 nested calls"},
    {55, "include \"main.lrs\"", "E0602 1:9", "includes itself"},
    {56, "mesh { file: \"buny.obj\" }", "E0601 1:14", "bunny.obj"},
    {57, "mesh { file: \"bunny.obj\" }", "E0702 bunny.obj:4:7", "vertex 9999"},
    {58, "triangle { a: [0,0,0], b: [1,1,1], c: [2,2,2] }", "W1201 1:1", "on a line"},
    {59, "sphere { rotate_y: 3.14159 }", "W1302 1:20", "3.14159rad"},
    {60, "sphere { material { diffuse: [255, 0, 0] } }", "W1403 1:30", "#ff0000"},
});

std::string all_of(const Diagnostic& diagnostic) {
    std::string text = diagnostic.message + "\n" + diagnostic.hint;
    for (const Label& label : diagnostic.labels) text += "\n" + label.message;
    for (const std::string& note : diagnostic.notes) text += "\n" + note;
    for (const std::string& help : diagnostic.helps) text += "\n" + help;
    return text;
}

TEST(SixtyMistakes, AreToldAsTheTableSays) {
    ASSERT_EQ(kMistakes.size(), 60u);
    for (const Mistake& mistake : kMistakes) {
        Ran loaded =
            run(mistake.input, {}, {{"mat.lrs", "let oak = 1\nlet pine = 2"}, {"bunny.obj", kObj}});
        if (loaded.loaded.scene) {
            scene::flatten(*loaded.loaded.scene, {}, loaded.loaded.diagnostics);
        }
        std::string others;
        bool is_told = false;
        for (const Diagnostic* diagnostic : loaded.loaded.diagnostics.sorted()) {
            if (diagnostic->code == Code::W1501 || diagnostic->code == Code::W1503) continue;
            const std::string place =
                fmt::format("{} {}", code_info(diagnostic->code).id,
                            place_of(loaded.loaded.sources, diagnostic->span));
            const std::string all = all_of(*diagnostic);
            const bool is_it = place.ends_with(mistake.place.substr(6)) &&
                               place.substr(0, 5) == mistake.place.substr(0, 5) &&
                               all.find(mistake.gist) != all.npos;
            is_told = is_told || is_it;
            if (!is_it) others += place + " " + all + "\n";
        }
        EXPECT_TRUE(is_told) << mistake.number << ": " << mistake.input << "\n" << others;
        EXPECT_EQ(mistake.is_alone && is_told ? others : "", "") << mistake.number;
    }
}

}  // namespace
}  // namespace lray::test
