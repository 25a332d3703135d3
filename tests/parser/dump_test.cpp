// The dump: it is the same scene to the bit, it is its own dump, and it is in the canonical style.
#include "parser/tools/dump.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "parser/tools/format.h"
#include "tests/parser/loaded.h"
#include "tests/parser/same_world.h"
#include "tests/support/temp_directory.h"

namespace lray::test {
namespace {

std::string formatted(const std::string& text) {
    Sources sources;
    Diagnostics diagnostics;
    const SourceId id = sources.add("dump.lrs", Text(text));
    return parser::format(id, sources, {}, diagnostics).value_or("not formatted");
}

std::string views_text(const scene::Scene& scene) {
    std::string text;
    for (const scene::Camera& camera : scene.cameras) {
        text += fmt::format("{} {} {} {} {} {} {}\n", camera.name, camera.position.x, camera.fov,
                            camera.height, camera.aperture, camera.focus.value_or(-1.0),
                            camera.samples.value_or(0));
    }
    return text + fmt::format("{} {} {} {} {} {}", scene.render.resolution.width,
                              scene.render.samples, scene.render.seed, scene.render.exposure,
                              scene.render.background.x, scene.info.size());
}

/// Checks the dump of a scene that stands in a file, in whose directory the dump is put.
void expect_same(const std::string& path, const parser::LoadSettings& settings = {}) {
    SCOPED_TRACE(path);
    const Loaded original = load_file(path, settings);
    ASSERT_TRUE(original.scene.has_value()) << original.text();
    const std::string text = parser::dump(*original.scene);
    const std::string beside =
        (std::filesystem::path(path).parent_path() / "lray_dumped.lrs").string();
    std::filesystem::remove(beside);
    {
        std::FILE* const file = std::fopen(beside.c_str(), "w");
        ASSERT_NE(file, nullptr);
        std::fwrite(text.data(), 1, text.size(), file);
        std::fclose(file);
    }
    const Loaded again = load_file(beside);
    std::filesystem::remove(beside);
    ASSERT_TRUE(again.scene.has_value()) << again.text() << "\n" << text.substr(0, 4000);
    EXPECT_EQ(parser::dump(*again.scene), text);
    EXPECT_EQ(formatted(text), text);
    const std::string world = world_text(*original.scene);
    EXPECT_FALSE(world.empty());
    EXPECT_TRUE(world == world_text(*again.scene)) << text.substr(0, 4000);
    EXPECT_EQ(views_text(*original.scene), views_text(*again.scene));
}

void expect_same_text(std::string_view text) {
    const TempDirectory directory;
    expect_same(directory.write("main.lrs", text));
}

/// A copy of a directory of scenes, and the scenes in it.
std::vector<std::string> copied_scenes(const char* name, const TempDirectory& directory) {
    namespace fs = std::filesystem;
    fs::copy(fs::path(LRAY_SOURCE_DIR) / name, directory.path(), fs::copy_options::recursive);
    std::vector<std::string> paths;
    for (const auto& entry : fs::directory_iterator(directory.path())) {
        if (entry.path().extension() == ".lrs") paths.push_back(entry.path().string());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

constexpr std::string_view kProgram = R"(
param n = 5
info { title: "a \"dump\"", license: "CC0" }
render { resolution: [64, 48], samples: 5, background: #336699, exposure: 0.5, seed: 7 }
camera "main" { position: [3, 4, 9], look_at: [0, 1, 0], fov: 37.3, focus: [0, 1, 0], aperture: 0.1 }
camera { projection: "orthographic", height: 3.3, samples: 12 }
let red = material { diffuse: crimson, shininess: 12.5, reflect: 0.1 }
let same = material { diffuse: crimson, shininess: 12.5, reflect: 0.1 }
let stone = marble { a: #ccc, b: 0.1, scale: 0.3, rotate: [10, 20, 30], translate: [1, 2, 3] }
fn wave(x, z) = 0.3 * sin(90 * x) + z * 0.1
component tower(height = 3) {
  for i in range(height) {
    box { center: [0, i * 0.7, 0], size: [1, 0.5, 1] / (i + 1), rotate_y: 17 * i }
    sphere "ball" { radius: 0.3, translate: [0.1, 0.7 * i, 0], scale: 1.1, material: same }
  }
  children { translate: [0, height, 0], rotate_z: 33 }
}
for i in range(n) {
  tower { height: 2 + i % 2, rotate_y: 31 * i, scale: 0.9, translate: [i * 1.3, 0, -i], material: red }
}
tower { sphere { material { diffuse: stone, bump: checker { size: 0.1 }, bump_height: -1 / 3, bump_unit: "uv" } } torus { scale: [1, 2, 1] } }
let ball = sphere { radius: 1 / 3 }
let pair = group { ball { translate: [0, 1, 0] } ball { translate: [1, 0, 0], scale: [-1, 1, 1] } }
pair { rotate: [1, 2, 3], visible: false }
pair { matrix: [[1, 0.3, 0, 3], [0, 1, 0, 0], [0, 0, 1, 0]], casts_shadow: false }
let moved = pair { translate: [5, 5, 5] }
moved { }
heightfield { resolution: 9, size: [3, 2], height: wave, translate: [0, -1, 0] }
terrain { resolution: 9, seed: 3, size: [10, 10], height: 1 }
mesh { positions: [[0, 0, 0], [1, 0, 0.1], [0.3, 1, 0]], triangles: [[0, 1, 2]],
  normals: [[1, 2, 3], [0.1, 1, 0], [0, 0, 5]], uvs: [[0, 0], [0.1, 0.2], [1, 1]], up: "z" }
triangle { a: [0, 0, 0], b: [1, 0, 0], c: [0, 1, 0], normals: [[1, 2, 3], [0, 1, 0], [0, 0, 1]] }
disk { normal: [1, 2, 3], hole: 0.2, rotate_x: 30 }
plane { normal: [1, 7, 3], point: [0, -5, 0] }
rectangle { size: [2, 3], normal: [1, 1, 0.2], translate: [0, 0, 1], look_at: [3, 4, 5] }
cylinder { radius: 0.3, radius_to: 0.7, caps: false, transform: [rotation([1, 2, 3], 77), scaling(2.5)] }
point_light { position: [1, 2, 3], color: kelvin(3000), radius: 0.1, samples: 4 }
let lamp = spot_light { position: [0, 5, 0], target: [1, 0, 0.3], angle: 33.3, falloff: "none" }
group { lamp { rotate_y: 20 } lamp { translate: [1, 0, 0] } }
directional_light { direction: [-1, -2, -3], angle: 0.53, samples: 8 }
area_light { center: [0, 4, 0], size: [1, 2], normal: [0.1, -1, 0], rotate_y: 12 }
environment { image: ramp { stops: [[-1, #123456], [0.2, white], [1, [0.3, 0.4, 0.5]]] }, intensity: 0.3, samples: 5 }
)";

TEST(Dump, ExamplesAreTheSameToTheBit) {
    const TempDirectory directory;
    const auto paths = copied_scenes("examples", directory);
    ASSERT_FALSE(paths.empty());
    for (const std::string& path : paths) expect_same(path);
}

TEST(Dump, GoldenScenesAreTheSameToTheBit) {
    const TempDirectory directory;
    const auto paths = copied_scenes("tests/golden", directory);
    ASSERT_FALSE(paths.empty());
    for (const std::string& path : paths) expect_same(path);
}

TEST(Dump, ProgramIsTheSameToTheBit) {
    expect_same_text(kProgram);
}

TEST(Dump, ProgramWithoutShortCutsIsTheSameToTheBit) {
    const TempDirectory directory;
    const std::string path = directory.write("main.lrs", kProgram);
    parser::LoadSettings slow;
    slow.use_literal_fast_path = false;
    expect_same(path, slow);
    EXPECT_EQ(parser::dump(*load_file(path, slow).scene), parser::dump(*load_file(path).scene));
    slow.use_memo = false;
    expect_same(path, slow);
    EXPECT_TRUE(world_text(*load_file(path, slow).scene) == world_text(*load_file(path).scene));
}

TEST(Dump, ComponentsNestedDeepNeedNoDeepText) {
    const std::string text =
        "component nest(n) {\n  sphere { }\n  if n > 0 { nest { n: n - 1, "
        "translate: [0.1, 0, 0] } }\n}\nnest { n: 400 }\n";
    expect_same_text(text);
    const std::string dumped = parser::dump(*load_text(text).scene);
    int depth = 0;
    int deepest = 0;
    for (const char c : dumped) {
        depth += c == '{' ? 1 : c == '}' ? -1 : 0;
        deepest = std::max(deepest, depth);
    }
    EXPECT_LT(deepest, 20);
}

TEST(Dump, SharedNodeIsOneDefinition) {
    const std::string text = parser::dump(
        *load_text("let b = sphere { }\nb { translate: [1, 0, 0] }\nb { scale: 2 }\n").scene);
    EXPECT_NE(text.find("let n1 = sphere { center: [0, 0, 0], radius: 1 }\n"
                        "n1 { translate: [1, 0, 0] }\n"),
              std::string::npos)
        << text;
    EXPECT_EQ(text.find("let n2"), std::string::npos) << text;
}

TEST(Dump, EqualMaterialsAreOneDefinition) {
    const std::string text = parser::dump(*load_text("sphere { material { diffuse: red } }\n"
                                                     "sphere { material { diffuse: red } }\n")
                                               .scene);
    EXPECT_NE(text.find("let m1 = material { diffuse: rgb(1, 0, 0) }\n"), std::string::npos);
    EXPECT_EQ(text.find("let m2"), std::string::npos) << text;
}

TEST(Dump, SimilarityThatIsNoneIsRefused) {
    const Loaded loaded = load_text(
        "sphere { transform: similarity([[1, 0, 0, 0], [0, 2, 0, 0], [0, 0, 1, 0]], 1) }\n");
    EXPECT_TRUE(loaded.has_errors());
    EXPECT_EQ(loaded.codes().substr(0, 5), "E0503");
}

}  // namespace
}  // namespace lray::test
