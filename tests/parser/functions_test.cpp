// Functions: scopes, captures, recursion, arguments, functions as values.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/parser/program.h"

namespace lray::test {
namespace {

TEST(Functions, AreKnownInTheirWholeBracesAndMayNameEachOther) {
    EXPECT_EQ(told_by(R"(
print(even(10), odd(10), even(7))
fn even(n) = if n == 0 then true else odd(n - 1)
fn odd(n) = if n == 0 then false else even(n - 1)
if true {
  print(inner(3))
  fn inner(n) = if n == 0 then 0 else n + other(n - 1)
  fn other(n) = inner(n) * 10
}
)"),
              "true false false\n123\n");
}

TEST(Functions, MayNameALaterLetOnceItHasItsValue) {
    EXPECT_EQ(told_by("fn f() = later * 2\nlet later = 21\nprint(f())"), "42\n");
    EXPECT_EQ(told_by("fn f() = later * 2\nprint(f())\nlet later = 21"),
              "E0202 1:10 `later` has no value yet when this runs\n");
    EXPECT_EQ(told_by("group {\n  fn f() = g() + 1\n  fn g() = later\n  let later = 4\n"
                      "  print(f())\n}"),
              "5\n");
    EXPECT_EQ(told_by("print(later)\nlet later = 1"),
              "E0202 1:7 `later` is used before line 2 defines it\n");
}

TEST(Functions, CannotSeeAVariableOfTheOutside) {
    EXPECT_EQ(told_by("var n = 0\nfn f() = n\nlet x = f()"),
              "E0205 2:10 `f` cannot read the variable `n`; pass it as a parameter\n");
    EXPECT_EQ(told_by("var n = 0\nfn f() { n = 1\n return 2 }\nlet x = f()"),
              "E0205 2:10 a function cannot change the variable `n` around it\n");
    EXPECT_EQ(told_by("var n = 0\nlet x = map([1], fn(a) = a + n)"),
              "E0205 2:30 a function cannot read the variable `n`; pass it as a parameter\n");
    EXPECT_EQ(told_by("var n = 0\ncomponent c() { sphere { radius: n } }\nc { }"),
              "E0205 2:34 `c` cannot read the variable `n`; pass it as a parameter\n");
    EXPECT_EQ(told_by("fn f() {\n  var n = 1\n  fn g() = n\n  return g()\n}\nlet x = f()"),
              "E0205 3:12 `g` cannot read the variable `n`; pass it as a parameter\n");
    EXPECT_EQ(told_by("fn f() = n\nvar n = 0\nlet x = f()"),
              "E0205 1:10 `f` cannot read the variable `n`; pass it as a parameter\n");
    EXPECT_EQ(told_by("fn f() {\n  var n = 1\n  n = n + 1\n  return n\n}\nprint(f(), f())"),
              "2 2\n");
}

TEST(Functions, MadeInALoopKeepTheirOwnValues) {
    EXPECT_EQ(told_by(R"(
var fs = []
for i, x in ["a", "b", "c"] {
  let twice = 2 * i
  fs = concat(fs, [fn(y) = str(x, i, twice, y)])
}
for f in fs { print(f("!")) }
print(fs[1]("?"))
let gs = [for i in range(3): fn() = i * i]
print([for g in gs: g()])
)"),
              "a00!\nb12!\nc24!\nb12?\n[0, 1, 4]\n");
}

// The value of the time round before must not be seen.
TEST(Functions, NamingALaterLetOfTheirTimeRoundHaveNoneAtFirst) {
    const std::string_view kStale = "E0202 {} `later` has no value yet when this runs\n";
    EXPECT_EQ(told_by(R"(
for i in range(3) {
  let f = fn() = later[0]
  if i > 0 { print(f()) }
  let later = [i, i]
}
)"),
              fmt::format(fmt::runtime(kStale), "3:18"));
    EXPECT_EQ(told_by(R"(
for i in range(3) {
  fn f() = later[0]
  if i > 0 { print(f()) }
  let later = [i, i]
}
)"),
              fmt::format(fmt::runtime(kStale), "3:12"));
    EXPECT_EQ(told_by(R"(
var i = 0
while i < 3 {
  if i > 0 { print(map([1], fn(x) = later[0])) }
  let later = [i, i]
  i = i + 1
}
)"),
              fmt::format(fmt::runtime(kStale), "4:37"));
    EXPECT_EQ(told_by(R"(
var i = 0
while i < 3 and map([1], fn(x) = later[0]) == [0] {
  let later = [i, i]
  i = i + 1
}
)"),
              "E0201 3:34 unknown name `later`\n");
}

TEST(Functions, CaptureThroughFunctionsInFunctions) {
    EXPECT_EQ(told_by(R"(
fn outer(a) {
  let b = a * 10
  fn middle(c) {
    fn inner(d) = [a, b, c, d]
    return inner
  }
  return middle(b + 1)
}
let f = outer(1)
let g = outer(2)
print(f(5), g(6), f(7))
fn compose(f2, g2) = fn(x) = f2(g2(x))
fn add(n) = fn(x) = x + n
print(compose(compose(add(1), add(10)), add(100))(0))
fn count_down(n) {
  fn step(m) = if m == 0 then [n] else concat([m], step(m - 1))
  return step(n)
}
print(count_down(3))
)"),
              "[1, 10, 11, 5] [2, 20, 21, 6] [1, 10, 11, 7]\n111\n[3, 2, 1, 3]\n");
}

TEST(Functions, DefaultsUseTheParametersBeforeThem) {
    EXPECT_EQ(told_by(R"(
let base = 100
fn f(a, b = a + 1, c = [a, b, base]) = [a, b, c]
print(f(1), f(1, 5), f(1, c: 3), f(c: 7, a: 2))
)"),
              "[1, 2, [1, 2, 100]] [1, 5, [1, 5, 100]] [1, 2, 3] [2, 3, 7]\n");
    EXPECT_EQ(told_by("fn f(a = b, b = 1) = a\nprint(f())"), "E0201 1:10 unknown name `b`\n");
    EXPECT_EQ(told_by("fn f(a = 1, b) = a\nprint(f(1, 2))"),
              "E0305 1:13 `b` needs a default, as a parameter before it has one\n");
    EXPECT_EQ(told_by("fn f(a) = a\nprint(f(b: 1))").substr(0, 5), "E0306");
    EXPECT_EQ(told_by("fn f(a) = a\nprint(f(1, 2))").substr(0, 5), "E0306");
    EXPECT_EQ(told_by("fn f(a) = a\nprint(f())").substr(0, 5), "E0305");
    EXPECT_EQ(told_by("fn f(a: number) = a\nlet s = \"x\"\nprint(f(s))"),
              "E0301 3:7 `a` needs a number, this is a string\n");
}

TEST(Functions, AreValues) {
    EXPECT_EQ(told_by(R"(
fn twice(x) = 2 * x
let k = 3
print(map([1, 2], twice), map([4, 9], sqrt), filter(range(6), fn(x) = x % 2 == 0))
print(sort([3, 1, 2]), sort([3, 1, 2], fn(x) = -x * k))
print(reduce([1, 2, 3], fn(a, b) = a + b), map([twice, abs], fn(f) = f(-4)))
print(twice == twice, twice == abs, [twice] == [twice])
if true {
  let n = [1, 2]
  fn near(x) = x + n
  print(near == near, [near, 1] == [near, 1])
}
component row(f) { for i in range(3) { sphere { center: [f(i), 0, 0] } } }
row { f: twice }
row { f: fn(x) = x + k }
)"),
              "[2, 4] [2, 3] [0, 2, 4]\n[1, 2, 3] [3, 2, 1]\n6 [-8, 4]\ntrue false true\n"
              "true true\n");
    EXPECT_EQ(told_by("let f = 3\nprint(f(1))"), "E0307 2:7 `f` is not a function\n");
    EXPECT_EQ(told_by("let f = fn(a, b) = a\nprint(map([1], f))").substr(0, 5), "E0305");
}

TEST(Functions, ReturnOutOfLoopsAndChoices) {
    EXPECT_EQ(told_by(R"(
fn first(rows, wanted) {
  for i, row in rows {
    for j, x in row {
      if x == wanted { return [i, j] }
      if x < 0 { break }
    }
  }
  return [-1, -1]
}
print(first([[1, 2], [3, 4]], 4), first([[1, -2], [3, 2]], 2), first([[-1, 7]], 7))
fn collatz(n) {
  var x = n
  var steps = 0
  while true {
    if x == 1 { return steps }
    steps = steps + 1
    if x % 2 == 0 {
      x = x / 2
      continue
    }
    x = 3 * x + 1
  }
}
print(collatz(27))
)"),
              "[1, 1] [1, 1] [-1, -1]\n111\n");
    EXPECT_EQ(told_by("fn f(x) {\n  if x > 0 { return 1 }\n}\nprint(f(1))\nprint(f(0))"),
              "1\nE0506 5:7 `f` ends without `return`\n");
}

TEST(Functions, PlaceNothing) {
    EXPECT_EQ(told_by("fn f() { sphere { }\n return 1 }\nlet x = f()").substr(0, 5), "E0404");
    const Ran placed = run("fn ball(r) = sphere { radius: r }\nball(3) { translate: [1, 0, 0] }");
    ASSERT_TRUE(placed.loaded.scene) << placed.told();
    EXPECT_EQ(placed.loaded.scene->spheres.back().radius, 3.0);
}

TEST(Functions, ThatCaptureTooMuchAreToldSo) {
    const auto lets = [](char name, int count) {
        std::string text;
        for (int i = 0; i < count; ++i) text += fmt::format("  let {}{} = {}\n", name, i, i);
        return text;
    };
    const auto sum = [](char name, int count) {
        std::string text = "[";
        for (int i = 0; i < count; ++i) text += fmt::format("{}{}, ", name, i);
        return text + "]";
    };
    for (const int count : {255, 256, 257}) {
        const std::string direct = "group {\n" + lets('a', count) +
                                   "  fn f() = " + sum('a', count) + "\n  print(len(f()))\n}";
        const std::string told = told_by(direct);
        EXPECT_EQ(told.substr(0, 4), count <= 256 ? fmt::format("{}\n", count) : "E030") << count;
    }
    for (const int count : {128, 129}) {
        const std::string through = "group {\n" + lets('a', count) + lets('b', count) +
                                    "  fn f() = " + sum('a', count) +
                                    "\n  fn g() = " + sum('b', count) +
                                    "\n  fn h() = f()[1] + g()[127]\n" + "  print(h())\n}";
        const std::string told = told_by(through);
        EXPECT_EQ(told.substr(0, 5), count == 128 ? "128\n" : "E0306") << told;
    }
}

TEST(Functions, ReportTheCallsAroundAnErrorOnce) {
    const Ran loaded =
        run("fn f(n) = 1 / n\nfn g(n) = f(n - 1)\nfor i in range(5) { print(g(i)) }");
    EXPECT_EQ(loaded.told(), "-1\nE0503 1:13 division by zero\n");
    const Diagnostic& diagnostic = *loaded.loaded.diagnostics.sorted()[0];
    ASSERT_EQ(diagnostic.calls.size(), 2u);
    EXPECT_EQ(diagnostic.calls[0].name, "f");
    EXPECT_EQ(diagnostic.calls[1].name, "g");
}

}  // namespace
}  // namespace lray::test
