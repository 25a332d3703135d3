// Loops, choices, comprehensions, scopes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/parser/program.h"

namespace lray::test {
namespace {

TEST(Loops, LeaveTheInnermostOne) {
    EXPECT_EQ(told_by(R"(
var log = ""
for i in range(4) {
  for j in range(4) {
    if j == i { continue }
    if j == 3 { break }
    log = log + str(i, j, " ")
  }
  if i == 2 { break }
}
print(log)
var n = 0
while true {
  n = n + 1
  if n % 2 == 0 { continue }
  var m = 0
  while m < 10 {
    m = m + 1
    if m == n { break }
  }
  if n > 6 { break }
}
print(n)
)"),
              "01 02 10 12 20 21 \n7\n");
}

TEST(Loops, GoThroughListsAndRanges) {
    EXPECT_EQ(
        told_by(R"(
for x in [[1, 2], [3, 4]] { print(x, x.y) }
for i, x in ["a", true, #fff] { print(i, x == true) }
for i, x in range(5, 0, -2) { print(i, x) }
for x in range(0) { print("never", x) }
for x in range(3, 1) { print("never", x) }
for x in range(1, 3, -1) { print("never", x) }
for x in [] { print("never", x) }
for x in range(0, 1, 0.4) { print(x) }
for x in range(2.5) { print(x) }
)"),
        "[1, 2] 2\n[3, 4] 4\n0 false\n1 true\n2 false\n0 5\n1 3\n2 1\n0\n0.4\n0.8\n0\n1\n2\n");
    EXPECT_EQ(told_by("for x in range(0, 4, 0) { print(x) }").substr(0, 3), "E03");
    EXPECT_EQ(told_by("let n = 3\nfor x in n { print(x) }"),
              "E0301 2:10 a loop goes through a list, this is a number\n");
    EXPECT_EQ(told_by("let n = 0\nfor x in range(1 / n) { print(x) }").substr(0, 10), "E0503 2:18");
}

// A range in a loop is counted, the same as a list is made.
TEST(Loops, CountARangeAsItsListIsMade) {
    for (const std::string range :
         {"0, 1, 0.1", "1, 0, -0.25", "-3, 3, 2", "0, 10, 3", "5, 5, 1", "0.1, 0.7, 0.1"}) {
        EXPECT_EQ(
            told_by(fmt::format("var xs = []\nfor x in range({0}) {{ xs = concat(xs, [x]) }}\n"
                                "let ys = range({0})\nprint(xs == ys, len(xs) == len(ys))",
                                range)),
            "true true\n")
            << range;
    }
}

TEST(Loops, TheListOfALoopIsThatOfItsBegin) {
    EXPECT_EQ(told_by(R"(
var xs = [[1, 2], [3, 4]]
for x in xs {
  xs = concat(xs, [x + x])
}
print(xs)
)"),
              "[[1, 2], [3, 4], [2, 4], [6, 8]]\n");
}

TEST(Loops, ComprehensionsNestAndChoose) {
    EXPECT_EQ(told_by(R"(
print([for i in range(3): [for j in range(i): [i, j]]])
print([for i, x in ["a", "b", "c"] if i != 1: str(x, i)])
print([for i in range(20) if i % 2 == 0 and i % 3 == 0: i])
print([for row in [for i in range(3): [i, i * i]]: row.x + row.y])
print([for i in range(3) if false: i], len([for x in []: x]))
let i = 7
print(i)
)"),
              "[[], [[1, 0]], [[2, 0], [2, 1]]]\n[\"a0\", \"c2\"]\n[0, 6, 12, 18]\n[0, 2, 6]\n"
              "[] 0\n7\n");
    EXPECT_EQ(told_by("let a = [for i in range(3): 1 / i]"), "E0503 1:31 division by zero\n");
    EXPECT_EQ(told_by("let a = [for i in range(3) if i: i]").substr(0, 10), "E0301 1:31");
}

TEST(Loops, StopAtAnErrorAndTellItOnce) {
    EXPECT_EQ(told_by("let z = 0\nfor i in range(1000) {\n  print(i)\n  let x = 1 / z\n"
                      "  print(x)\n}\nprint(\"on\")"),
              "0\non\nE0503 4:13 division by zero\n");
    EXPECT_EQ(told_by("var n = 0\nwhile n < 10 {\n  n = n + 1\n  assert(n < 3)\n}\nprint(n)"),
              "3\nE0507 4:10 `n < 3` does not hold\n");
}

TEST(Scopes, EndWithTheirBraces) {
    EXPECT_EQ(told_by("if true { let a = 1\n print(a) }\nprint(a)"),
              "E0201 3:7 unknown name `a`\n");
    EXPECT_EQ(told_by("for i in range(2) { print(i) }\nprint(i)"), "E0201 2:7 unknown name `i`\n");
    EXPECT_EQ(told_by("let a = 1\nif true {\n  let a = 2\n  print(a)\n}\nprint(a)"),
              "2\n1\nW1102 3:7 `a` hides the outer `a`\n");
    EXPECT_EQ(told_by("let red = 3\nlet sin = 4\nprint(red, sin, colors.red == #ff0000)"),
              "3 4 true\n");
    EXPECT_EQ(told_by("let sphere = 1").substr(0, 9), "E0203 1:5");
    EXPECT_EQ(told_by("let a = 1\nlet a = 2"), "E0203 2:5 `a` is already defined\n");
    EXPECT_EQ(told_by("fn a() = 1\nlet a = 2\nlet b = a"), "E0203 2:5 `a` is already defined\n");
    EXPECT_EQ(told_by("fn f(a, a) = a\nprint(f(1, 2))"), "E0203 1:9 `a` is already defined\n");
    EXPECT_EQ(told_by("for i, i in [1] { print(i) }"), "E0203 1:8 `i` is already defined\n");
    EXPECT_EQ(told_by("let a = a + 1"), "E0202 1:9 `a` is used before line 1 defines it\n");
}

TEST(Scopes, BranchesThatDoNotRunAreChecked) {
    EXPECT_EQ(told_by("if false {\n  sphere { radios: 1 }\n  print(nothing)\n}").substr(0, 9),
              "E0401 2:1");
    EXPECT_EQ(told_by("fn f() = undefined_name"), "E0201 1:10 unknown name `undefined_name`\n");
}

TEST(Scopes, WhatCouldNotBeWorkedOutIsSilent) {
    EXPECT_EQ(told_by("let z = 0\nlet a = 1 / z\nlet b = a + 1\nsphere { radius: b }\n"
                      "print(a)\nif a > 1 { print(2) }\nfor i in range(a) { print(i) }\n"
                      "print([a, 1][0])\nprint(record { x: b }.x)"),
              "E0503 2:11 division by zero\n");
}

TEST(Scopes, VariablesChangeInEveryBracesBelow) {
    EXPECT_EQ(told_by(R"(
var n = 1
if true { n = n + 1 }
for i in range(3) { if i > 0 { n = n * 10 + i } }
while n > 1000 { n = n - 1000 }
group { n = n + 0.5 }
print(n)
var v = [1, 2, 3]
v = v * 2
print(v.y)
)"),
              "212.5\n4\n");
    EXPECT_EQ(told_by("var v = [1, 2]\nv.x = 3").substr(0, 9), "E0204 2:1");
}

TEST(Messages, AssertShowsBothSides) {
    const Ran loaded = run("let a = [1, 2]\nlet b = 3\nassert(len(a) == b, \"lengths\")");
    EXPECT_EQ(loaded.told(), "E0507 3:8 lengths\n");
    EXPECT_EQ(loaded.loaded.diagnostics.sorted()[0]->notes.at(0), "`len(a)` is 2, `b` is 3");
    EXPECT_EQ(told_by("let a = 1\nassert(a < 0)"), "E0507 2:8 `a < 0` does not hold\n");
    EXPECT_EQ(told_by("let a = 1\nassert(a > 0)\nassert(a == 1, 1 / 0)"), "");
}

}  // namespace
}  // namespace lray::test
