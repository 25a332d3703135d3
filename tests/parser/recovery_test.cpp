// What one missing or wrong character costs: a bracket deleted from a good scene is reported, and
// reported about once.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "tests/parser/loaded.h"
#include "tests/parser/syntax_tree.h"

namespace lray::test {
namespace {

/// A scene with what the examples may lack: meshes, calls, choices, groups in groups.
constexpr std::string_view kWorkshop = R"(lrs 1.0
render {
  resolution: [320, 240]
  background: #203040
}
camera "front" { position: [0, 2, 8], look_at: [0, 1, 0], fov: 40 }

let r = 0.5
let paint = material {
  diffuse: mix(red, gold, 0.5)
  specular: rgb(0.1, (r + 0.2) / 2, 0.3)
}
let pair = group {
  sphere { radius: r, material: paint }
  sphere { radius: if r > 0.4 then r else 2 * r, translate: [2 * r, 0, 0] }
}

group "workshop" {
  material: paint
  group {
    pair { translate: [0, 1, 0] }
    pair {
      rotate_y: 90
      translate: [0, max(1, r), 0]
    }
  }
  mesh {
    positions: [
      [0, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1]
    ]
    triangles: [[0, 1, 2], [0, 2, 3]]
  }
  box { min: [0, 0, 0], max: [1, 1, 1] }
  transform: [translation([1, 0, 0]), rotation([0, 1, 0], 45)]
}

rectangle {
  size: [8, 8]
  material { diffuse: #808080 }
}
)";

/// Statements, functions and components: what they may hold and stand in.
constexpr std::string_view kGarden = R"(import "plants.lrs" as plants
param seed = 42 in [0, 1000]
param trees: int = 12 in [0, 100]

/// Height of the ground.
fn height(x, z) = 8 * fbm([x, z] * 0.04, octaves: 6, seed: seed)

fn factorial(n: int) {
  if n <= 1 { return 1 }
  return n * factorial(n - 1)
}

fn mean(xs: list) {
  var sum = 0
  for i, x in xs {
    if x < 0 { continue }
    sum = sum + x
    if (sum > 100 or i == 3) and xs[i] > 0 { break }
  }
  return sum / len(xs)
}

/// A flake with smaller ones around it.
component flake(radius = 1, depth: int = 3) {
  sphere { radius: radius }
  if depth > 0 {
    let r = radius / 3
    for i in range(6) {               // ring on the equator
      flake {
        radius: r, depth: depth - 1
        translate: [0, radius + r, 0], rotate_z: 90, rotate_y: 60 * i
      }
    }
    for i in range(3) { flake { radius: r, depth: depth - 1, translate: [0, r, 0] } }
  } else if depth == 0 {
    box { size: [r, r, r] }
  } else {
    cylinder { radius: r, to: [0, 1, 0] }
  }
}

component pedestal(
  height = 0.5,
  paint: material = plants.bark(tint: rgb(0.2, 0.1, 0))
) {
  cylinder { to: [0, height, 0], radius: 0.4, material: paint }
  children { translate: [0, height, 0] }
}

let squares = [for i in range(10) if i % 2 == 0: i * i]
let grid = [for x in range(3): [for z in range(3): [x, height(x, z), z]]]
let ease = fn(t, k = 2) = if t < 0.5 then t ^ k else 1 - (1 - t) ^ k

var n = 0
while n < trees {
  let at = grid[n % 3][0]
  if at.y > -1 and at.y < 3 {
    plants.pine { scale: rand_range(0.7, 1.4, seed, n, 3), translate: at }
  }
  n = n + 1
}

for i, m in [plants.leaf, plants.bark()] {
  pedestal {
    height: 0.4 + 0.15 * ease(i / 2)
    translate: [1.2 * (i - 1), 0, 0]
    sphere { center: [0, 0.35, 0], radius: 0.35, material: m }
  }
}
group "row" {
  for i in range(4) { flake { depth: 2, translate: [3 * i, 0, 0] } }
  if seed > 3 { material { diffuse: red } }
}
assert(factorial(3) == 6, "three")
)";

/// Deletes each bracket of a good scene; what it costs is added up.
struct Cost {
    std::size_t deletions = 0;
    std::size_t errors = 0;
};

/// Offsets of the brackets that are code: not in comments or strings.
std::vector<std::size_t> brackets_of(std::string_view text) {
    std::vector<std::size_t> offsets;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text.substr(i, 2) == "//") {
            i = std::min(text.find('\n', i), text.size());
        } else if (text[i] == '"') {
            i = text.find('"', i + 1);
        } else if (std::string_view("()[]{}").find(text[i]) != std::string_view::npos) {
            offsets.push_back(i);
        }
    }
    return offsets;
}

/// What one deletion led to.
struct Told {
    std::size_t count = 0;
    std::string text{};
};

Told told(const Loaded& loaded) {
    return {loaded.diagnostics.error_count(), loaded.text()};
}

template <class Load>
void delete_each_bracket(const std::string& name, const std::string& text, Load load, Cost& cost) {
    for (const std::size_t offset : brackets_of(text)) {
        std::string broken = text;
        broken.erase(offset, 1);
        const Told told = load(broken);
        ++cost.deletions;
        cost.errors += told.count;
        const auto line = std::count(text.begin(), text.begin() + static_cast<long>(offset), '\n');
        EXPECT_TRUE(told.count >= 1 && told.count <= 3)
            << name << ":" << line + 1 << " without `" << text[offset] << "`:\n"
            << told.text;
    }
}

double average_of(const Cost& cost) {
    return static_cast<double>(cost.errors) / static_cast<double>(cost.deletions);
}

TEST(Recovery, GoodScenesHaveNoErrors) {
    EXPECT_EQ(load_text(kWorkshop).text(), "");
    const Examples examples;
    for (const std::string& name : examples.names()) {
        const Loaded loaded = examples.load_changed(name, examples.text(name));
        EXPECT_FALSE(loaded.has_errors()) << name << "\n" << loaded.text();
    }
}

TEST(Recovery, ADeletedBracketIsReportedAboutOnce) {
    Cost cost;
    delete_each_bracket(
        "workshop", std::string(kWorkshop),
        [](const std::string& text) { return told(load_text(text)); }, cost);
    const Examples examples;
    for (const std::string& name : examples.names()) {
        const auto load = [&](const std::string& text) {
            return told(examples.load_changed(name, text));
        };
        delete_each_bracket(name, examples.text(name), load, cost);
    }
    ASSERT_GT(cost.deletions, 100u);
    RecordProperty("average", fmt::format("{:.3f}", average_of(cost)));
    EXPECT_LE(average_of(cost), 1.2)
        << cost.errors << " errors of " << cost.deletions << " deletions";
}

// What is below the list is read as if nothing had happened.
TEST(Recovery, AMistakeInAListOfBlocksEndsWithTheList) {
    const auto told_of = [](std::string_view element) {
        return load_text(
            fmt::format("let kinds = [\n  group {{ sphere {{ }} }},\n  {},\n"
                        "  group {{ box {{ }} }}\n]\nkinds[0] {{ }}\nsphere {{ radius 1 }}\n",
                        element));
    };
    for (const std::string_view element :
         {"group sphere { } }", "group { sphere } }", "group { sphere { }", "group { sphere { ) }",
          "group { box { size: [1, 2, 3 } }", "group { translate: [1, 2, 3] sphere { } "}) {
        const Loaded loaded = told_of(element);
        EXPECT_LE(loaded.diagnostics.error_count(), 3u) << loaded.text();
        EXPECT_NE(loaded.text().find("7:16 expected `:` after `radius`"), std::string::npos)
            << loaded.text();
        EXPECT_EQ(loaded.text().find("`]` closes nothing"), std::string::npos) << loaded.text();
    }
}

TEST(Recovery, ADeletedBracketOfAStatementOrFunctionIsReportedAboutOnce) {
    ASSERT_EQ(parse_text(kGarden).errors, "");
    const auto load = [](const std::string& text) {
        const Parsed parsed = parse_text(text);
        return Told{parsed.error_count, parsed.errors};
    };
    Cost cost;
    delete_each_bracket("garden", std::string(kGarden), load, cost);
    ASSERT_GT(cost.deletions, 100u);
    RecordProperty("average", fmt::format("{:.3f}", average_of(cost)));
    EXPECT_LE(average_of(cost), 1.2)
        << cost.errors << " errors of " << cost.deletions << " deletions";
}

}  // namespace
}  // namespace lray::test
