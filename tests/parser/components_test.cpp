// Components: what they place, what they share, what is put into them. Records, too.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/parser/program.h"

namespace lray::test {
namespace {

/// "x y z r" of each sphere of the world, a line each.
std::string spheres_of(const Ran& loaded) {
    if (!loaded.loaded.scene) return loaded.told();
    Diagnostics diagnostics;
    const auto world = scene::flatten(*loaded.loaded.scene, {}, diagnostics);
    if (!world) return "no world";
    std::string text;
    for (const scene::Sphere& sphere : world->spheres) {
        text += fmt::format("{} {} {} {}\n", sphere.center.x, sphere.center.y, sphere.center.z,
                            sphere.radius);
    }
    return text;
}

std::string spheres(std::string_view text) {
    return spheres_of(run(text));
}

TEST(Components, TakeParametersStepsAndMaterial) {
    EXPECT_EQ(spheres(R"(
component pair(r, gap = 2 * r) {
  sphere { radius: r }
  sphere { radius: r, center: [gap, 0, 0] }
}
pair { r: 1, translate: [0, 5, 0] }
pair "second" { scale: 2, gap: 3, r: 2 }
)"),
              "0 5 0 1\n2 5 0 1\n0 0 0 4\n6 0 0 4\n");
    EXPECT_EQ(told_by("component c(r) { sphere { radius: r } }\nc { }").substr(0, 9), "E0406 2:1");
    EXPECT_EQ(told_by("component c(r = 1) { sphere { radius: r } }\nc { q: 1 }").substr(0, 9),
              "E0401 2:5");
    EXPECT_EQ(told_by("component c(material) { sphere { } }\nc { }").substr(0, 10), "E0203 1:13");
    EXPECT_EQ(told_by("component c(r: number) { sphere { radius: r } }\nlet s = \"x\"\nc { r: s }"),
              "E0301 3:1 `r` needs a number, this is a string\n");
}

TEST(Components, PlaceTheirChildrenAsOftenAsTheySay) {
    const std::string use = "both { sphere { } sphere { center: [1, 0, 0] } }";
    EXPECT_EQ(spheres("component both() { box { } }\n" + use), "");
    EXPECT_EQ(spheres("component both() { children { translate: [0, 2, 0] } }\n" + use),
              "0 2 0 1\n1 2 0 1\n");
    EXPECT_EQ(spheres("component both() { for i in range(3) { children { translate: [0, i, 0] } } "
                      "}\n" +
                      use),
              "0 0 0 1\n1 0 0 1\n0 1 0 1\n1 1 0 1\n0 2 0 1\n1 2 0 1\n");
    EXPECT_EQ(spheres("component both() { children { } }\nboth { }\nsphere { }"), "0 0 0 1\n");
    EXPECT_EQ(spheres("component inner() { children { translate: [1, 0, 0] } }\n"
                      "component both() { inner { children { } sphere { radius: 2 } } }\n" +
                      use),
              "1 0 0 1\n2 0 0 1\n1 0 0 2\n");
    EXPECT_EQ(told_by("children { }").substr(0, 9), "E0201 1:1");
}

TEST(Components, OfDepthTwentyAreTwentyNodesDeep) {
    const std::string flake = R"(
component flake(radius = 1, depth = 3) {
  sphere { radius: radius }
  if depth > 0 {
    let r = radius / 3
    for i in range(6) {
      flake { radius: r, depth: depth - 1
        translate: [0, radius + r, 0], rotate_z: 90, rotate_y: 60 * i }
    }
    for i in range(3) {
      flake { radius: r, depth: depth - 1
        translate: [0, radius + r, 0], rotate_z: 30, rotate_y: 120 * i + 30 }
    }
  }
}
)";
    const Ran deep = run(flake + "flake { depth: 20 }");
    ASSERT_TRUE(deep.loaded.scene) << deep.told();
    EXPECT_EQ(deep.loaded.scene->spheres.size(), 21u);
    EXPECT_LE(deep.loaded.scene->nodes.size(), 400u);
    parser::LoadSettings settings;
    settings.use_memo = false;
    EXPECT_EQ(spheres_of(run(flake + "flake { depth: 2 }")),
              spheres_of(run(flake + "flake { depth: 2 }", settings)));
}

/// Loads with and without sharing, and expects the same world; returns how many spheres were made.
std::size_t spheres_made(std::string_view text) {
    parser::LoadSettings settings;
    settings.use_memo = false;
    const Ran shared = run(text);
    EXPECT_EQ(spheres_of(shared), spheres_of(run(text, settings))) << text;
    return shared.loaded.scene ? shared.loaded.scene->spheres.size() : 0;
}

TEST(Components, ShareWhatIsEqualAndOnlyThat) {
    const std::string c = "component c(p) { sphere { radius: size(p) } }\n";
    const std::string of_list = c + "fn size(p) = p[0] + 1\n";
    EXPECT_EQ(spheres_made(of_list + "for i in range(9) { c { p: [i % 3, 1] } }"), 3u);
    EXPECT_EQ(spheres_made(of_list + "c { p: [1, [2]] }\nc { p: [1, [2]] }\nc { p: [1, [3]] }"),
              2u);
    const std::string of_record = c + "fn size(p) = p.a + 1\n";
    EXPECT_EQ(spheres_made(of_record + "for i in range(9) { c { p: record { a: i % 3 } } }"), 3u);
    EXPECT_EQ(spheres_made(of_record + "c { p: record { a: 1 } }\nc { p: record { a: 1, b: 2 } }"),
              2u);
    // A function counts with what it captures; what calls one may print, so it is not shared.
    const std::string of_function =
        "component c(f) { sphere { radius: 2 }\n let g = f\n"
        " sphere { radius: if g == f then 1 else 3 } }\n";
    EXPECT_EQ(spheres_made(of_function + "for i in range(9) { c { f: fn() = i % 3 } }"), 18u);
    EXPECT_EQ(spheres_made(of_function + "for i in range(9) { let k = i % 3\n c { f: fn() = k } }"),
              6u);
    EXPECT_EQ(spheres_made("component c(f) { sphere { radius: f(1) } }\n"
                           "for i in range(3) { c { f: fn(x) = x + i } }"),
              3u);
    // What is captured is part of it.
    EXPECT_EQ(spheres_made("for i in range(6) {\n  let r = 1 + i % 2\n"
                           "  component c() { sphere { radius: r } }\n  c { }\n}"),
              2u);
}

// The memory of a time round is used again: transforms were once told apart by their place in it.
TEST(Components, TellTransformsApartByTheirNumbers) {
    EXPECT_EQ(spheres_made("component c(t) { sphere { transform: t } }\n"
                           "for i in range(6) { c { t: translation([i % 3, 0, 0]) } }"),
              3u);
    EXPECT_EQ(told_by(R"(
var t = translation([1, 2, 3])
var u = t
for i in range(100) {
  t = translation([i, 0, 0])
  u = t
  let garbage = [for k in range(500): [k, k, i]]
  assert(len(garbage) == 500)
}
print(t == u, t == translation([99, 0, 0]), t == translation([98, 0, 0]))
)"),
              "true true false\n");
}

TEST(Components, ThatPrintRunEachTime) {
    EXPECT_EQ(told_by("component c(r) { print(\"c\", r)\n sphere { radius: r } }\n"
                      "c { r: 1 }\nc { r: 1 }\nc { r: 2 }"),
              "c 1\nc 1\nc 2\n");
    EXPECT_EQ(told_by("fn say(x) { print(x)\n return x }\n"
                      "component c(r) { sphere { radius: say(r) } }\nc { r: 1 }\nc { r: 1 }"),
              "1\n1\n");
    EXPECT_EQ(told_by("component c(f) { sphere { radius: f(1) } }\n"
                      "fn say(x) { print(x)\n return x }\nc { f: say }\nc { f: say }"),
              "1\n1\n");
}

TEST(Components, AsValuesAreCopiedWithOtherParameters) {
    EXPECT_EQ(spheres(R"(
component c(r = 1, n = 1) {
  for i in range(n) { sphere { radius: r, center: [i, 0, 0] } }
  children { }
}
let a = c { r: 2, translate: [0, 1, 0] }
let b = a { n: 2 }
a { }
b { translate: [10, 0, 0] }
let d = c { sphere { radius: 9 } }
let e = d { r: 3 }
e { }
)"),
              "0 1 0 2\n10 1 0 2\n11 1 0 2\n0 0 0 3\n0 0 0 9\n");
    EXPECT_EQ(told_by("component c(r = 1) { sphere { radius: r } }\nlet a = c { r: 2 }\n"
                      "a { r: 3 }")
                  .substr(0, 9),
              "E0401 3:5");
}

TEST(Components, ThatFailAreToldOnce) {
    // Each would try two of the next: a tree of 2^60 uses.
    EXPECT_EQ(told_by(R"(
component c(n) {
  if n == 0 { sphere { radius: 1 / n } }
  if n > 0 {
    c { n: n - 1 }
    c { n: n - 1, translate: [1, 0, 0] }
  }
}
c { n: 60 }
)"),
              "E0503 3:34 division by zero\n");
}

TEST(Records, AreCopiedComparedAndNested) {
    EXPECT_EQ(told_by(R"(
let r = record { a: 1, b: [2, 3], c: record { d: "x" } }
let s = r { a: 5 }
print(r.a, s.a, s.b.y, s.c.d)
print(r == s, s { a: 1 } == r, r == record { a: 1, b: [2, 3], c: record { d: "x" } })
print(r.c { d: "y", e: 2 })
let rows = [for i in range(3): record { i: i, square: i * i }]
print(rows[2].square, [for q in rows if q.square > 0: q.i])
let built = record {
  for i in range(1) { total: 10 + i }
  if r.a == 1 { kind: "one" } else { kind: "many" }
}
print(built.total, built.kind)
let f = record { call: fn(x) = x + r.a }
print(f.call(41))
)"),
              "1 5 3 x\nfalse true true\nrecord { d: \"y\", e: 2 }\n4 [1, 2]\n10 one\n42\n");
    EXPECT_EQ(told_by("print(record { a: 1, b: 2 } == record { b: 2, a: 1 },"
                      " record { a: 1, b: 2 } == record { b: 1, a: 2 },"
                      " record { a: 1, b: 2 } == record { a: 1, c: 2 })"),
              "true false false\n");
    EXPECT_EQ(told_by("fn r() {\n  print(\"made\")\n  return record { a: 1 }\n}\n"
                      "print(r() { b: 2 } { a: 3 })"),
              "made\nrecord { a: 3, b: 2 }\n");
    EXPECT_EQ(told_by("let r = record { alpha: 1 }\nprint(r.alpa)"),
              "E0409 2:9 this record has no field `alpa`\n");
    EXPECT_EQ(told_by("let r = record { a: 1, a: 2 }\nprint(r)").substr(0, 10), "E0402 1:24");
    EXPECT_EQ(told_by("let r = record { a: 1 }\nr { }").substr(0, 9), "E0408 2:1");
}

}  // namespace
}  // namespace lray::test
