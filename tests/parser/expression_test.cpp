// Expressions: how operators bind, what they compute, and where a line ends.
#include <gtest/gtest.h>

#include <string>

#include "tests/parser/evaluate.h"
#include "tests/parser/loaded.h"

namespace lray::test {
namespace {

TEST(Operators, BindAsInMathematics) {
    EXPECT_EQ(number_of("2 + 3 * 4"), 14.0);
    EXPECT_EQ(number_of("(2 + 3) * 4"), 20.0);
    EXPECT_EQ(number_of("-2^2"), -4.0);
    EXPECT_EQ(number_of("2^-1"), 0.5);
    EXPECT_EQ(number_of("2^3^2"), 512.0);
    EXPECT_EQ(number_of("2 * 3^2"), 18.0);
    EXPECT_EQ(number_of("7 - 4 - 2"), 1.0);
    EXPECT_EQ(number_of("24 / 4 / 2"), 3.0);
    EXPECT_EQ(number_of("- - 3"), 3.0);
    EXPECT_EQ(number_of("--3"), 3.0);
    EXPECT_EQ(number_of("1 - -3"), 4.0);
    EXPECT_EQ(number_of("+3"), 3.0);
    EXPECT_EQ(number_of("-[1, 2, 3].y^2"), -4.0);
    EXPECT_EQ(number_of("(1 + 2) * -(3)"), -9.0);
}

TEST(Operators, RemainderHasTheSignOfTheDivisor) {
    EXPECT_EQ(number_of("7 % 3"), 1.0);
    EXPECT_EQ(number_of("-7 % 3"), 2.0);
    EXPECT_EQ(number_of("7 % -3"), -2.0);
    EXPECT_EQ(number_of("-7 % -3"), -1.0);
    EXPECT_EQ(number_of("6 % 3"), 0.0);
}

TEST(Operators, WordsBindLooserThanComparisons) {
    EXPECT_TRUE(is_true("1 < 2 and 3 > 2"));
    EXPECT_TRUE(is_true("true or false and false"));
    EXPECT_FALSE(is_true("(true or false) and false"));
    EXPECT_TRUE(is_true("not 1 > 2"));
    EXPECT_TRUE(is_true("not false and true"));
    EXPECT_FALSE(is_true("not (false or true)"));
    EXPECT_TRUE(is_true("not not true"));
    EXPECT_TRUE(is_true("true and not false"));
    EXPECT_TRUE(is_true("1 + 1 == 2"));
}

TEST(Operators, WordsStopWhenDecided) {
    EXPECT_FALSE(is_true("false and 1 / 0 > 1"));
    EXPECT_TRUE(is_true("true or 1 / 0 > 1"));
}

TEST(Operators, ComparisonsOrderNumbersAndMatchEverything) {
    EXPECT_TRUE(is_true("1 <= 1 and 1 >= 1 and 1 != 2"));
    EXPECT_FALSE(is_true("1 < 1 or 1 > 1"));
    EXPECT_TRUE(is_true("\"a\" == \"a\" and \"a\" != \"b\""));
    EXPECT_TRUE(is_true("[1, 2] == [1, 2] and [1, 2] != [1, 3] and [1] != [1, 1]"));
    EXPECT_TRUE(is_true("[[1, 2], [3, 4]] == [[1, 2], [3, 4]]"));
    EXPECT_TRUE(is_true("[1, true, \"x\"] == [1, true, \"x\"]"));
    EXPECT_FALSE(is_true("[1, [true]] == [1, [false]]"));
    EXPECT_TRUE(is_true("1 != \"1\" and true != 1"));
    EXPECT_TRUE(is_true("red == #ff0000 and red != #ff0001"));
    EXPECT_TRUE(is_true("[] == []"));
    EXPECT_TRUE(is_true("m == m and m != n", "let m = material { }\nlet n = material { }"));
}

TEST(Operators, VectorsAreTakenElementByElement) {
    EXPECT_EQ(vec3_of("[1, 2, 3] + [10, 20, 30]"), DVec3(11, 22, 33));
    EXPECT_EQ(vec3_of("[1, 2, 3] - 1"), DVec3(0, 1, 2));
    EXPECT_EQ(vec3_of("2 * [1, 2, 3]"), DVec3(2, 4, 6));
    EXPECT_EQ(vec3_of("[6, 9, 8] / [2, 3, 4]"), DVec3(3, 3, 2));
    EXPECT_EQ(vec3_of("12 / [2, 3, 4]"), DVec3(6, 4, 3));
    EXPECT_EQ(vec3_of("[1, 2, 3] ^ 2"), DVec3(1, 4, 9));
    EXPECT_EQ(vec3_of("[5, 6, 7] % 4"), DVec3(1, 2, 3));
    EXPECT_EQ(vec3_of("-[1, 2, 3]"), DVec3(-1, -2, -3));
}

TEST(Operators, PlusJoinsStrings) {
    EXPECT_EQ(string_of("\"four \" + a", "let a = \"balls\""), "four balls");
}

TEST(Operators, ChoicesEvaluateOneBranch) {
    EXPECT_EQ(number_of("if 1 < 2 then 3 else 1 / 0"), 3.0);
    EXPECT_EQ(number_of("if 1 > 2 then 1 / 0 else if true then 4 else 5"), 4.0);
    EXPECT_EQ(number_of("1 + (if false then 1 else 2)"), 3.0);
    EXPECT_EQ(number_of("if\n true\n then\n 1\n else\n 2"), 1.0);
}

TEST(Lists, ElementsAndFieldsAreRead) {
    EXPECT_EQ(number_of("xs[2]", "let xs = [10, 20, 30]"), 30.0);
    EXPECT_EQ(number_of("[1, 2, 3][1]"), 2.0);
    EXPECT_EQ(number_of("xs[1][0]", "let xs = [[1, 2], [3, 4]]"), 3.0);
    EXPECT_EQ(number_of("xs[1].y", "let xs = [[1, 2], [3, 4]]"), 4.0);
    EXPECT_EQ(number_of("xs[1 + 1]", "let xs = [true, \"x\", 7]"), 7.0);
    EXPECT_EQ(number_of("p.x + p.y * 10 + p.z * 100 + p.w * 1000", "let p = [1, 2, 3, 4]"), 4321.0);
    EXPECT_EQ(number_of("colors.red.r + red.g"), 1.0);
    EXPECT_EQ(number_of("m.shininess", "let m = material { shininess: 7 }"), 7.0);
    EXPECT_EQ(number_of("material { }.ior"), 1.5);
    EXPECT_EQ(number_of("s.radius + s.center.y", "let s = sphere { center: [0, 2, 0] }"), 3.0);
    EXPECT_EQ(number_of("r.size.y", "let r = rectangle { size: [3, 4] }"), 4.0);
}

TEST(Lists, WhatStandsInParenthesesHasElementsAndFields) {
    EXPECT_EQ(number_of("(v * 2)[1]", "let v = [1, 2, 3]"), 4);
    EXPECT_EQ(number_of("(v + v).z", "let v = [1, 2, 3]"), 6);
    EXPECT_EQ(number_of("([[1, 2], [3, 4]])[1][0]"), 3);
}

TEST(Lists, TrailingCommasAndLineBreaksAreAllowed) {
    EXPECT_EQ(vec3_of("[1, 2, 3,]"), DVec3(1, 2, 3));
    EXPECT_EQ(vec3_of("[\n1,\n2\n,\n3\n]"), DVec3(1, 2, 3));
    EXPECT_EQ(vec3_of("[\n1 +\n1, 2\n+ 3, (4\n- 1)]"), DVec3(2, 5, 3));
    EXPECT_EQ(number_of("max(\n1,\n2,\n)"), 2.0);
}

TEST(Lists, PackedAndGeneralListsAgree) {
    // A name among the elements keeps a list from being packed while it is read.
    const std::string before = "let one = 1";
    EXPECT_TRUE(is_true("[1, 2, 3] == [one, 2, 3]", before));
    EXPECT_TRUE(is_true("[[1, 2], [3, 4]] == [[one, 2], [3, 4]]", before));
    EXPECT_TRUE(is_true(
        "[[1, 2, 3, 4, 5], [6, 7, 8, 9, 0]] == [[one, 2, 3, 4, 5], [6, 7, 8, 9, 0]]", before));
    EXPECT_TRUE(is_true("[[1], [2, 3]] == [[one], [2, 3]]", before));
    EXPECT_TRUE(is_true("[-1, -2.5e3, .5] == [-one, -2500, 1 / 2]", before));
    EXPECT_TRUE(is_true(
        "[[[1, 2], [3, 4]], [[5, 6], [7, 8]]] == [[[one, 2], [3, 4]], [[5, 6], [7, 8]]]", before));
    EXPECT_EQ(vec3_of("[[1, 2, 3], [4, 5, 6]][1] + [[one, 2, 3]][0]", before), DVec3(5, 7, 9));
    EXPECT_EQ(vec3_of("[1 /* a */, 2, // b\n 30cm]"), DVec3(1, 2, 0.3));
}

TEST(Separators, NewLinesCommasAndSemicolonsAreTheSame) {
    for (const std::string separator : {"\n", ",", ";", ", ", ";\n", "\n\n,\n"}) {
        EXPECT_EQ(
            codes_of("sphere { radius: 2" + separator + "center: [0, 0, 0]" + separator + "}"), "");
        EXPECT_EQ(codes_of("let a = 1" + separator + "let b = a" + separator + "sphere { }"), "");
    }
}

TEST(Separators, AreNeededUnlessABraceEndsTheItem) {
    EXPECT_EQ(codes_of("sphere { material { } radius: 2 }"), "");
    EXPECT_EQ(codes_of("group { sphere { } sphere { } }"), "");
    EXPECT_EQ(codes_of("let m = material { } sphere { material: m }"), "");
    EXPECT_EQ(codes_of("sphere { radius: 1 center: [0, 0, 0] }"), "E0105");
    EXPECT_EQ(codes_of("let a = 1 let b = 2"), "E0105");
}

TEST(Separators, AnOperatorAtTheEndGoesOnInTheNextLine) {
    EXPECT_EQ(number_of("a", "let a = 1 +\n  2"), 3.0);
    EXPECT_EQ(number_of("a", "let a =\n  2"), 2.0);
    EXPECT_EQ(codes_of("sphere { radius:\n2 }"), "");
    EXPECT_EQ(codes_of("let a = 1\n  * 2"), "E0113");
    EXPECT_EQ(codes_of("let a = true\n  and true"), "E0113");
}

TEST(Separators, BracesInBracketsSwitchLinesOnAgain) {
    EXPECT_EQ(codes_of("let xs = [sphere {\n radius: 2\n center: [0, 0, 0]\n}, box { }]"), "");
    EXPECT_EQ(codes_of("let xs = [sphere { radius: 2 center: [0, 0, 0] }]"), "E0105");
}

TEST(Names, LiveFromTheirLineToTheEndOfTheirBraces) {
    EXPECT_EQ(codes_of("group { let a = 1, sphere { radius: a } }\nsphere { radius: a }"), "E0201");
    EXPECT_EQ(codes_of("sphere { let a = 2, radius: a }"), "");
    EXPECT_EQ(codes_of("let a = 1\ngroup { let b = a + 1, group { sphere { radius: a + b } } }"),
              "");
    EXPECT_EQ(codes_of("group { let _a = 1 }\ngroup { let _a = 2 }"), "");
    EXPECT_EQ(codes_of("sphere { radius: a }\nlet a = 1"), "E0202");
    EXPECT_EQ(codes_of("let a = 1\nlet a = 2"), "E0203");
    EXPECT_EQ(codes_of("let a = 1\ngroup { let a = 2, sphere { radius: a } }"), "W1102");
}

TEST(Names, OfTheLanguageMayBeUsedAnewButBlocks) {
    EXPECT_EQ(number_of("red", "let red = 5"), 5.0);
    EXPECT_EQ(number_of("sqrt", "let sqrt = 5"), 5.0);
    EXPECT_EQ(number_of("colors.red.r", "let red = 5"), 1.0);
    EXPECT_EQ(codes_of("let sphere = 5"), "E0203");
}

TEST(Names, AFailedValueIsSilentFromThenOn) {
    EXPECT_EQ(
        codes_of("let a = 1 / 0\nlet b = [a, a]\nsphere { radius: a, center: b }\nlet c = a + b"),
        "E0503");
    EXPECT_EQ(codes_of("let m = material { shininess: nowhere }\nsphere { material: m }"), "E0201");
}

}  // namespace
}  // namespace lray::test
