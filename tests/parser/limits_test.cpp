// Every limit of loading: what is one below it and at it passes, what is one above does not.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "tests/parser/loaded.h"

namespace lray::test {
namespace {

std::string repeated(std::string_view text, std::size_t count) {
    std::string result;
    for (std::size_t i = 0; i < count; ++i) result += text;
    return result;
}

/// Scenes of a form grow with their number; some size is the last that a limit lets pass.
struct NestingForm {
    const char* name;
    std::function<std::string(std::size_t)> make;
};

const std::vector<NestingForm> kNestingForms = {
    {"parentheses",
     [](std::size_t n) { return "let x = " + repeated("(", n) + "1" + repeated(")", n); }},
    {"lists",
     [](std::size_t n) { return "let x = " + repeated("[", n) + "true" + repeated("]", n); }},
    {"number lists",
     [](std::size_t n) { return "let x = " + repeated("[", n) + "1" + repeated("]", n); }},
    {"groups", [](std::size_t n) { return repeated("group {", n) + repeated("}", n); }},
    {"signs", [](std::size_t n) { return "let x = " + repeated("-", n) + "1"; }},
    {"separated signs", [](std::size_t n) { return "let x = " + repeated("- ", n) + "1"; }},
    {"not", [](std::size_t n) { return "let x = " + repeated("not ", n) + "true"; }},
    {"sums", [](std::size_t n) { return "let x = 1" + repeated(" + 1", n); }},
    {"powers", [](std::size_t n) { return "let x = 1" + repeated(" ^ 1", n); }},
    {"choices",
     [](std::size_t n) { return "let x = " + repeated("if true then 1 else ", n) + "1"; }},
    {"calls",
     [](std::size_t n) { return "let x = " + repeated("abs(", n) + "1" + repeated(")", n); }},
    {"indices",
     [](std::size_t n) {
         return "let a = [0]\nlet x = a" + repeated("[a", n) + repeated("[0]]", n);
     }},
    {"fields", [](std::size_t n) { return "let a = material { }\nlet x = a" + repeated(".b", n); }},
    {"derived blocks",
     [](std::size_t n) { return "let a = material { }\nlet x = a" + repeated(" { }", n); }},
};

TEST(NestingLimit, HoldsForEveryFormOfDepth) {
    parser::LoadLimits limits;
    limits.nesting = 40;
    for (const NestingForm& form : kNestingForms) {
        std::size_t last_fitting = 0;
        for (std::size_t n = 1; n <= 2 * limits.nesting; ++n) {
            const std::string codes = load_text(form.make(n), limits).codes();
            const bool is_too_deep = codes.find("E0115") != codes.npos;
            if (is_too_deep) {
                EXPECT_EQ(codes, "E0115") << form.name << " " << n;
            } else {
                EXPECT_EQ(last_fitting + 1, n) << form.name << ": once too deep, always too deep";
                last_fitting = n;
            }
        }
        EXPECT_GE(last_fitting, limits.nesting / 4) << form.name;
        EXPECT_LE(last_fitting, limits.nesting) << form.name;
    }
}

TEST(NestingLimit, IsExactForBracketsAndGroups) {
    parser::LoadLimits limits;
    for (const std::uint32_t nesting : {9u, 10u, 11u}) {
        limits.nesting = nesting;
        const bool fits = nesting >= 10;
        // The value is a level, and each bracket one more.
        EXPECT_EQ(
            load_text("let x = " + repeated("(", 9) + "1" + repeated(")", 9), limits).has_errors(),
            !fits);
        EXPECT_EQ(load_text(repeated("group { ", 10) + repeated("}", 10), limits).has_errors(),
                  !fits);
        EXPECT_EQ(load_text("let x = 1" + repeated(" + 1", 9), limits).has_errors(), !fits);
    }
}

TEST(NestingLimit, HoldsAgainstALongScene) {
    for (const NestingForm& form : kNestingForms) {
        EXPECT_EQ(load_text(form.make(100'000)).codes(), "E0115") << form.name;
    }
}

TEST(NestingLimit, CountsChainsInBlocksInChains) {
    parser::LoadLimits limits;
    limits.nesting = 40;
    std::string value = "1";
    for (int i = 0; i < 5; ++i) {
        value = "sphere { radius: (" + value + ") + 1" + repeated(" + 1", 6) + " }.radius";
    }
    EXPECT_EQ(load_text("let x = " + value, limits).codes(), "E0115");
    limits.nesting = 80;
    EXPECT_FALSE(load_text("let x = " + value, limits).has_errors());

    std::string copies = "sphere { }";
    for (int i = 0; i < 80; ++i) {
        copies = "sphere { radius: (" + copies + ").radius }" + repeated(" { }", 200);
    }
    EXPECT_EQ(load_text("let x = " + copies).codes(), "E0115");
}

TEST(NestingLimit, CountsThroughIncludes) {
    const std::string part = repeated("group { ", 10) + repeated("}", 10);
    const std::string main = repeated("group { ", 10) + "include \"part.lrs\"" + repeated("}", 10);
    for (const std::uint32_t nesting : {19u, 20u}) {
        parser::LoadLimits limits;
        limits.nesting = nesting;
        EXPECT_EQ(load_text(main, limits, {{"part.lrs", part}}).codes(),
                  nesting < 20 ? "E0115" : "W1501");
    }
}

TEST(NestingLimit, IsNoLimitOfLength) {
    EXPECT_FALSE(load_text("let x = [" + repeated("1 + 1, ", 10'000) + "]").has_errors());
    EXPECT_FALSE(load_text(repeated("group { }\n", 10'000)).has_errors());
}

TEST(IncludeLimits, DepthIsCountedFromTheMainFile) {
    const std::vector<Companion> chain = {
        {"a.lrs", "include \"b.lrs\""}, {"b.lrs", "include \"c.lrs\""}, {"c.lrs", "sphere { }"}};
    for (const std::uint32_t depth : {2u, 3u, 4u}) {
        parser::LoadLimits limits;
        limits.include_depth = depth;
        const Loaded loaded = load_text("include \"a.lrs\"", limits, chain);
        EXPECT_EQ(loaded.codes(), depth < 3 ? "E0515" : "W1501");
        EXPECT_EQ(loaded.diagnostics.has_limit_errors(), depth < 3);
    }
}

TEST(IncludeLimits, FilesAreCountedWithMeshesAndTheMainFile) {
    const std::vector<Companion> files = {{"a.lrs", "sphere { }"},
                                          {"m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}};
    for (const std::uint32_t count : {2u, 3u, 4u}) {
        parser::LoadLimits limits;
        limits.files = count;
        EXPECT_EQ(load_text("include \"a.lrs\"\nmesh { file: \"m.obj\" }", limits, files).codes(),
                  count < 3 ? "E0515" : "W1501");
    }
}

TEST(SizeLimits, FilesOfAKindMayBeAsLargeAsTheirLimitTogether) {
    const std::string scene = "include \"a.lrs\"\nmesh { file: \"m.obj\" }\n";
    const std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const std::string part = "sphere { }\n";
    for (const int more : {-1, 0, 1}) {
        parser::LoadLimits limits;
        const std::size_t both = scene.size() + part.size();
        limits.scene_bytes = static_cast<std::uint64_t>(static_cast<int>(both) + more);
        EXPECT_EQ(load_text(scene, limits, {{"a.lrs", part}, {"m.obj", mesh}}).codes(),
                  more < 0 ? "E0516" : "W1501");
        limits = {};
        limits.mesh_bytes = static_cast<std::uint64_t>(static_cast<int>(mesh.size()) + more);
        EXPECT_EQ(load_text(scene, limits, {{"a.lrs", part}, {"m.obj", mesh}}).codes(),
                  more < 0 ? "E0516" : "W1501");
        limits = {};
        const std::string long_part = part + repeated(" ", scene.size());
        const std::size_t long_both = scene.size() + long_part.size();
        limits.scene_bytes = static_cast<std::uint64_t>(static_cast<int>(long_both) + more);
        EXPECT_EQ(load_text(scene, limits, {{"a.lrs", long_part}, {"m.obj", mesh}}).codes(),
                  more < 0 ? "E0516" : "W1501");
    }
}

TEST(SizeLimits, AFileCountsAsOftenAsItIsRead) {
    const std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const std::string scene =
        "mesh { file: \"m.obj\" }\nmesh { file: \"./m.obj\" }\nmesh { file: \"n.obj\" }\n";
    parser::LoadLimits limits;
    limits.mesh_bytes = 2 * mesh.size();  // one file under two names, and a copy of it
    EXPECT_EQ(load_text(scene, limits, {{"m.obj", mesh}, {"n.obj", mesh}}).codes(), "W1501");
    --limits.mesh_bytes;
    EXPECT_EQ(load_text(scene, limits, {{"m.obj", mesh}, {"n.obj", mesh}}).text(),
              fmt::format("E0516 3:14 with `n.obj` the files are larger than {} bytes together\n",
                          limits.mesh_bytes));
}

TEST(SizeLimits, AreToldOnce) {
    const std::string scene =
        "include \"a.lrs\"\ninclude \"a.lrs\"\ninclude \"a.lrs\"\ninclude \"a.lrs\"\n";
    const std::string part = "sphere { } // a part that is included again and again, and longer";
    parser::LoadLimits limits;
    limits.scene_bytes = scene.size() + part.size();
    EXPECT_EQ(load_text(scene, limits, {{"a.lrs", part}}).codes(), "E0516");
}

TEST(StepLimit, APartCostsTheStretchesOfItsName) {
    const std::string mesh =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + repeated("g a\nf 1 2 3\ng b\nf 1 2 3\n", 100);
    const std::string scene = "mesh { file: \"m.obj\", part: \"a\" }";
    parser::LoadLimits limits;
    limits.steps = 102;  // and two strings
    EXPECT_EQ(load_text(scene, limits, {{"m.obj", mesh}}).codes(), "W1501");
    --limits.steps;
    EXPECT_EQ(load_text(scene, limits, {{"m.obj", mesh}}).codes(), "E0512");
}

TEST(StepLimit, EachExpressionIsAStep) {
    // Two numbers and their sum, and a name.
    const std::string scene = "let a = 1 + 2\nlet b = a\nsphere { }";
    for (const std::uint64_t steps : {3u, 4u, 5u}) {
        parser::LoadLimits limits;
        limits.steps = steps;
        EXPECT_EQ(load_text(scene, limits).codes(), steps < 4 ? "E0512" : "W1501");
    }
}

TEST(StepLimit, LongListsCostTheirLength) {
    const std::string list = "let a = [" + repeated("1, ", 1000) + "]\n";
    parser::LoadLimits limits;
    limits.steps = 900;
    EXPECT_EQ(load_text(list + "sphere { }", limits).codes(), "W1501");
    EXPECT_EQ(load_text(list + "let b = a + a\nsphere { }", limits).codes(), "E0512");
    EXPECT_EQ(load_text(list + "let b = a == a\nsphere { }", limits).codes(), "E0512");
    EXPECT_EQ(load_text(list + "let b = sqrt(a)\nsphere { }", limits).codes(), "E0512");
    EXPECT_EQ(load_text(list + "let b = -a\nsphere { }", limits).codes(), "E0512");
}

TEST(StepLimit, EndsTheComparisonOfWhatGrowsByDoubling) {
    std::string scene = "let a0 = [1, true]\nlet b0 = [1, true]\n";
    for (int i = 1; i <= 40; ++i) {
        scene += fmt::format("let a{0} = [a{1}, a{1}]\nlet b{0} = [b{1}, b{1}]\n", i, i - 1);
    }
    parser::LoadLimits limits;
    limits.steps = 1'000'000;
    EXPECT_EQ(load_text(scene + "let c = a40 == b40", limits).codes(), "E0512");
}

TEST(StepLimit, ListsNestedByNameAreComparedToTheirLimit) {
    std::string scene = "let a0 = [1, true]\nlet b0 = [1, true]\n";
    for (int i = 1; i <= 199; ++i) {
        scene += fmt::format("let a{0} = [a{1}]\nlet b{0} = [b{1}]\n", i, i - 1);
    }
    scene += "sphere { radius: if a199 == b199 then 2 else 1 }";
    const Loaded loaded = load_text(scene);
    ASSERT_TRUE(loaded.scene.has_value()) << loaded.text();
    EXPECT_EQ(loaded.scene->spheres[0].radius, 2.0);
    EXPECT_EQ(load_text(scene + "\nlet a200 = [a199]").codes(), "E0514");
}

TEST(Parameters, AreSixtyFourAtMost) {
    for (const int count : {63, 64, 65}) {
        std::string parameters;
        std::string sum;
        for (int i = 0; i < count; ++i) {
            parameters += fmt::format("{}a{} = 0", i > 0 ? ", " : "", i);
            sum += fmt::format("{}a{}", i > 0 ? " + " : "", i);
        }
        const std::string scene = fmt::format("fn f({}) = {}\nsphere {{ radius: f(a{}: 7) }}",
                                              parameters, sum, count - 1);
        const Loaded loaded = load_text(scene);
        ASSERT_EQ(loaded.scene.has_value(), count <= 64) << loaded.text();
        if (count > 64) {
            EXPECT_EQ(loaded.codes(), "E0306");
        } else {
            EXPECT_EQ(loaded.scene->spheres[0].radius, 7.0);
        }
    }
}

TEST(Records, OfManyFieldsAreMadeWithinTheSteps) {
    std::string fields;
    for (int i = 0; i < 20'000; ++i) fields += fmt::format("f{}: {}, ", i, i);
    const Loaded loaded =
        load_text("let r = record { " + fields + "}\nsphere { radius: r.f19999 }");
    ASSERT_TRUE(loaded.scene.has_value()) << loaded.text();
    EXPECT_EQ(loaded.scene->spheres[0].radius, 19'999.0);
    EXPECT_EQ(load_text("let r = record { " + fields + "f7: 1 }").codes(), "E0402");
}

TEST(StepLimit, LongTextsCostTheirLength) {
    const std::string text = "let s = \"" + std::string(1'600, 'x') + "\"\n";
    for (const char* use : {"s + s", "rand(s)", "noise(0.5, seed: s)"}) {
        const std::string scene =
            text + "for i in range(1000) { let t = " + use + "\nassert(t == t) }";
        parser::LoadLimits limits;
        limits.steps = 50'000;
        EXPECT_EQ(load_text(scene, limits).codes(), "E0512") << use;
        limits.steps = 10'000'000;
        EXPECT_EQ(load_text(scene + "\nsphere { }", limits).codes(), "W1501") << use;
    }
}

TEST(StepLimit, ListsOfTransformsAndCopiesOfRecordsCostTheirLength) {
    std::string record = "let r = record { ";
    for (int i = 0; i < 1000; ++i) record += fmt::format("f{}: 1, ", i);
    const std::string transforms =
        "let ts = [for i in range(1000): if i == 0 then rotation_x(1) else rotation_y(1)]\n";
    for (const std::string& scene :
         {record + "}\nfor i in range(1000) { let x = r { }\nassert(x.f0 == 1) }",
          record + "}\nfor i in range(1000) { let x = r { f5: 2 }\nassert(x.f5 == 2) }",
          transforms + "for i in range(100) { group { transform: ts } }"}) {
        parser::LoadLimits limits;
        limits.steps = 50'000;
        EXPECT_EQ(load_text(scene, limits).codes(), "E0512") << scene.substr(0, 20);
        limits.steps = 2'000'000;
        EXPECT_EQ(load_text(scene + "\nsphere { }", limits).codes(), "W1501");
    }
}

TEST(StepLimit, WhatIsCopiedOutOfCallsCostsItsSize) {
    const std::string scene =
        "fn f(n) {\n"
        "  if n == 0 { return [range(100000), \"a\"] }\n"
        "  return f(n - 1)\n"
        "}\n"
        "let x = f(900)\n"
        "sphere { radius: x[0][7] }";
    parser::LoadLimits limits;
    limits.steps = 1'000'000;  // 900 copies would be 22 million
    const Loaded loaded = load_text(scene, limits);
    ASSERT_TRUE(loaded.scene.has_value()) << loaded.text();
    EXPECT_EQ(loaded.scene->spheres[0].radius, 7.0);
}

TEST(ValueLimit, LabelsAndCamerasCount) {
    const std::string label(1000, 'x');
    for (const std::string& scene : {"for i in range(1000) { sphere \"" + label + "\" { } }",
                                     "for i in range(1000) { camera \"" + label + "\" { } }"}) {
        parser::LoadLimits limits;
        limits.value_bytes = 500'000;
        EXPECT_NE(load_text(scene, limits).codes().find("E0516"), std::string::npos);
    }
}

TEST(ValueLimit, RowsOfManyNumbersAreMadeAnew) {
    parser::LoadLimits limits;
    limits.value_bytes = 500'000;
    const std::string rows = "[" + repeated("[1, 2, 3, 4, 5], ", 1000) + "]";
    const std::string scene = "group { for i in range(1000) { let _x = " + rows +
                              "\n if false { scale: 2 } } }\n sphere { }";
    EXPECT_EQ(load_text(scene, limits).codes(), "E0516");
}

TEST(ValueLimit, StringsCountTheirBytes) {
    // 10 + 10 and 20 + 10 bytes.
    const std::string scene = "let a = \"0123456789\"\nlet b = a + a\nlet c = b + a\nsphere { }";
    for (const std::uint64_t bytes : {49u, 50u, 51u}) {
        parser::LoadLimits limits;
        limits.value_bytes = bytes;
        EXPECT_EQ(load_text(scene, limits).codes(), bytes < 50 ? "E0516" : "W1501");
    }
}

TEST(ValueLimit, WhateverCanBeCopiedCounts) {
    parser::LoadLimits limits;
    limits.value_bytes = 100'000;
    const std::string numbers = "let a = [" + repeated("1, ", 1000) + "]\n";
    EXPECT_EQ(
        load_text(numbers + repeated("a + 1, ", 0) + "let b = [" + repeated("a + 1, ", 20) + "]",
                  limits)
            .codes(),
        "E0516");
    EXPECT_EQ(load_text(numbers + "let b = [" + repeated("sqrt(a), ", 20) + "]", limits).codes(),
              "E0516");
    std::string groups =
        "let s = sphere { }\nlet g = group {\n" + repeated("s { }\n", 1000) + "}\n";
    for (int i = 0; i < 40; ++i) groups += fmt::format("let g{} = g {{ }}\n", i);
    EXPECT_EQ(load_text(groups, limits).codes(), "E0516");
    const std::string text = "let s = \"" + repeated("x", 10'000) + "\"\n";
    std::string info = "info {\n";
    for (int i = 0; i < 20; ++i) info += fmt::format("a{}: s\n", i);
    EXPECT_EQ(load_text(text + info + "}", limits).codes(), "E0516");
    const std::string points = "let p = [" + repeated("[0, 0, 0], ", 1000) + "]\n";
    EXPECT_EQ(
        load_text(points + repeated("mesh { positions: p, triangles: [[0, 1, 2]] }\n", 20), limits)
            .codes(),
        "E0516");
}

}  // namespace
}  // namespace lray::test
