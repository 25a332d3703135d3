// Limits of running programs: one below, at, and one above; and what would never end.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/parser/program.h"

namespace lray::test {
namespace {

std::string told_with(std::string_view scene, const parser::LoadLimits& limits) {
    return told_by(scene, with_limits(limits));
}

TEST(ProgramLimits, CallDepthIsExact) {
    const std::string_view scene = "fn f(n) = if n == 0 then 0 else 1 + f(n - 1)\nprint(f(9))";
    for (const std::uint32_t depth : {9u, 10u, 11u}) {
        parser::LoadLimits limits;
        limits.call_depth = depth;
        EXPECT_EQ(told_with(scene, limits),
                  depth >= 10 ? "9\n" : "E0511 1:37 more than 9 nested calls\n");
    }
    EXPECT_EQ(told_by("fn f(n) = if n == 0 then 0 else 1 + f(n - 1)\nprint(f(999))"), "999\n");
    EXPECT_EQ(told_by("fn f(n) = if n == 0 then 0 else 1 + f(n - 1)\nprint(f(1000))").substr(0, 5),
              "E0511");
}

TEST(ProgramLimits, EndlessRecursionOfEveryKindIsToldOnce) {
    for (const std::string_view scene : {
             "fn f(n) = f(n)\nprint(f(1))",
             "fn f(n) = f(n) + f(n)\nprint(f(1))",
             "fn f(n) = [f(n), f(n), f(n)]\nprint(f(1))",
             "fn f(n) = g(n)\nfn g(n) = if f(n) then 1 else f(n)\nprint(f(1))",
             "fn f(n) = map([1, 2], f)\nprint(f(1))",
             "fn f(n) = sort([3, 1, 2], fn(x) = f(x))\nprint(f(1))",
             "fn f(g) = g(g)\nprint(f(f))",
             "fn f(n = f()) = n\nprint(f())",
             "fn f(n) { for i in range(2) { let x = f(n + i)\n print(x) }\n return 1 "
             "}\nprint(f(1))",
             "component c() { c { } c { translate: [1, 0, 0] } }\nc { }",
             "component c(n) { c { n: n + 1 } c { n: n + 2 } }\nc { n: 0 }",
             "component c() { children { } c { children { } } c { children { } } }\nc { sphere { } "
             "}",
             "component a() { b { } b { } }\ncomponent b() { a { } a { } }\na { }",
         }) {
        const Ran loaded = run(scene);
        EXPECT_EQ(loaded.loaded.codes(), "E0511") << scene << "\n" << loaded.told();
        EXPECT_TRUE(loaded.loaded.diagnostics.has_limit_errors());
    }
}

TEST(ProgramLimits, EndlessLoopsEndByTheirSteps) {
    parser::LoadLimits limits;
    limits.steps = 1'000'000;
    for (const std::string_view scene : {
             "var n = 0\nwhile n < 1 { n = n * 1 }",
             "var n = 0\nwhile true { n = n + 1\n if n < 0 { break } }",
             "for i in range(1000000000000) { let x = i\n print(x) }",
             "for i in range(1000000000000) { }",
             "let x = [for i in range(1000000000000) if i < 0: i]",
             "fn f() { while 1 < 2 + time { } \n return 1 }\nlet x = f()",
         }) {
        const std::string codes = run(scene, with_limits(limits)).loaded.codes();
        EXPECT_NE(codes.find("E051"), std::string::npos) << scene << "\n" << codes;
    }
}

TEST(ProgramLimits, ListSizeIsExact) {
    for (const std::uint64_t size : {4u, 5u, 6u}) {
        parser::LoadLimits limits;
        limits.list_size = size;
        for (const std::string_view scene :
             {"print(len([for i in range(9) if i < 5: i]))", "print(len(range(5)))",
              "print(len(concat([1, 2], [3, 4, 5])))", "print(len(linspace(0, 1, 5)))"}) {
            EXPECT_EQ(told_with(scene, limits).substr(0, 5), size >= 5 ? "5\n" : "E0514") << scene;
        }
    }
}

TEST(ProgramLimits, NodesAreExact) {
    // Five spheres and the root.
    for (const std::uint64_t nodes : {5u, 6u, 7u}) {
        parser::LoadLimits limits;
        limits.nodes = nodes;
        EXPECT_EQ(told_with("for i in range(5) { sphere { radius: i + 1 } }", limits).substr(0, 5),
                  nodes >= 6 ? "" : "E0513");
    }
}

TEST(ProgramLimits, PrintedBytesAreExact) {
    for (const std::uint64_t bytes : {7u, 8u, 9u}) {
        parser::LoadLimits limits;
        limits.printed_bytes = bytes;
        EXPECT_EQ(told_with("print(\"abc\")\nprint(\"def\")", limits).substr(0, 9),
                  bytes >= 8 ? "abc\ndef\n" : "abc\nE0517");
    }
    parser::LoadLimits limits;
    limits.printed_bytes = 1000;
    const std::string told = told_with("for i in range(1000000) { print(i) }", limits);
    EXPECT_LT(told.size(), 1200u);
    EXPECT_NE(told.find("E0517"), std::string::npos);
}

TEST(ProgramLimits, IncludeDepthCountsImports) {
    const std::vector<Companion> chain = {{"a.lrs", "import \"b.lrs\"\nlet x = b.x"},
                                          {"b.lrs", "include \"c.lrs\""},
                                          {"c.lrs", "let x = 3"}};
    for (const std::uint32_t depth : {2u, 3u, 4u}) {
        parser::LoadLimits limits;
        limits.include_depth = depth;
        const std::string told =
            told_by("import \"a.lrs\"\nprint(a.x)", with_limits(limits), chain);
        if (depth < 3) {
            EXPECT_NE(told.find("E0515 b.lrs:1:9"), std::string::npos) << told;
        } else {
            EXPECT_EQ(told, "3\n");
        }
    }
}

TEST(ProgramLimits, DeepCallsOfDeepExpressionsNeedNoMoreThanTheStack) {
    const std::string deep = repeated("(1 + ", 100) + "f(n - 1)" + repeated(")", 100);
    const std::string told = told_by("fn f(n) = if n == 0 then 0 else " + deep + "\nprint(f(990))");
    const bool is_done = told == "99000\n";
    EXPECT_TRUE(is_done || told.substr(0, 5) == "E0511") << told;
    const std::string in_lists = repeated("[0, ", 60) + "f(n - 1)" + repeated("][1]", 60);
    const std::string of_lists =
        told_by("fn f(n) = if n == 0 then 7 else " + in_lists + "\nprint(f(990))");
    EXPECT_TRUE(of_lists == "7\n" || of_lists.substr(0, 5) == "E0511") << of_lists;
    const std::string through =
        told_by("fn f(n) = if n == 0 then 0 else 1 + map([n - 1], fn(x) = f(x))[0]\nprint(f(499))");
    EXPECT_EQ(through, "499\n");
}

TEST(ProgramLimits, DeepBlocksAreFine) {
    const std::string blocks = repeated("if true { ", 200) + "print(1)" + repeated(" }", 200);
    EXPECT_EQ(told_by(blocks), "1\n");
    const std::string loops = repeated("for i in [0] { ", 3) + "print(2)" + repeated(" }", 3);
    EXPECT_EQ(told_by(loops).substr(0, 2), "2\n");
    EXPECT_EQ(told_by(repeated("group { ", 250) + "print(3)" + repeated(" }", 250)), "3\n");
}

}  // namespace
}  // namespace lray::test
