// NFF files as scenes, included and imported; what they become is the same in every way.
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "parser/tools/dump.h"
#include "tests/parser/loaded.h"
#include "tests/parser/same_world.h"

namespace lray::test {
namespace {

constexpr std::string_view kNff =
    "b 0.1 0.2 0.3\n"
    "v\nfrom 0 1 8\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 40 30\n"
    "l 5 5 5\nl -5 5 5 1 0.5 0.25\n"
    "f 1 0.5 0.25 0.6 0.3 12 0 1\ns 0 0 0 1\nc 2 0 0 0.5 2 2 0 0\n"
    "f 0 1 0 0.4 0 1 0.5 1.3\np 4 -9 -2 9 9 -2 9 9 -2 -9 -9 -2 -9\n"
    "pp 3 0 2 0 0 0 1 1 2 0 0 1 1 0 3 0 0 0 1\n";

constexpr std::string_view kCamera = "camera { position: [0, 0, 9] }\n";

Loaded load_nff(std::string_view text, const parser::LoadSettings& settings = {}) {
    const TempDirectory directory;
    return load_file(directory.write("main.NFF", std::string(text)), settings);
}

Loaded load_with(std::string_view scene, std::string_view nff = kNff,
                 const parser::LoadLimits& limits = {}) {
    return load_text(scene, limits, {{"part.nff", nff}});
}

scene::Scene scene_of(const Loaded& loaded) {
    EXPECT_TRUE(loaded.scene) << loaded.text();
    return loaded.scene.value_or(scene::Scene{});
}

TEST(Nff, IsASceneByTheEndingOfItsName) {
    const Loaded loaded = load_nff(kNff);
    const scene::Scene scene = scene_of(loaded);
    EXPECT_EQ(loaded.text(), "");
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.cameras[0].name, "main");
    EXPECT_EQ(scene.cameras[0].background, Color(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(scene.cameras[0].resolution, (scene::Resolution{40, 30}));
    EXPECT_EQ(scene::children_of(scene, scene.node(scene.root)).size(), 7u);
}

TEST(Nff, DumpIsTheSameWorld) {
    const Loaded loaded = load_nff(kNff);
    const scene::Scene scene = scene_of(loaded);
    const std::string text = parser::dump(scene);
    const Loaded again = load_text(text);
    EXPECT_EQ(again.text(), "");
    ASSERT_FALSE(world_text(scene).empty());
    EXPECT_EQ(world_text(scene_of(again)), world_text(scene));
    EXPECT_EQ(parser::dump(scene_of(again)), text);
}

TEST(Nff, IncludePlacesEverything) {
    const Loaded included = load_with("include \"part.nff\"\n");
    EXPECT_EQ(included.text(), "");
    const scene::Scene scene = scene_of(included);
    EXPECT_EQ(world_text(scene), world_text(scene_of(load_nff(kNff))));
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.cameras[0].name, "part");
    EXPECT_EQ(scene.render.background, Color(0.0f)) << "it belongs to the view";
}

TEST(Nff, IncludeAddsToWhatIsThere) {
    const scene::Scene scene = scene_of(
        load_with("camera \"own\" { position: [0, 0, 9] }\nsphere { }\ninclude \"part.nff\"\n"
                  "group { translate: [0, 5, 0]\n  include \"part.nff\"\n}\n"));
    ASSERT_EQ(scene.cameras.size(), 2u) << "the file in the group brings no view";
    EXPECT_EQ(scene.cameras[0].name, "own");
    EXPECT_EQ(scene::children_of(scene, scene.node(scene.root)).size(), 1u + 7u + 1u);
    EXPECT_EQ(scene.lights.size(), 4u);
}

TEST(Nff, BackgroundWithoutAViewIsThatOfTheScene) {
    constexpr std::string_view kBackground = "b 0.25 0.5 1\n";
    const Color blue(0.25f, 0.5f, 1.0f);
    EXPECT_EQ(scene_of(load_nff(kBackground)).render.background, blue);
    EXPECT_EQ(scene_of(load_with("include \"part.nff\"", kBackground)).render.background, blue);
    EXPECT_EQ(scene_of(load_with("group { include \"part.nff\" }", kBackground)).render.background,
              Color(0.0f));
    for (const std::string_view text : {"render { background: 0.5 }\ninclude \"part.nff\"\n",
                                        "include \"part.nff\"\nrender { background: 0.5 }\n"}) {
        EXPECT_EQ(scene_of(load_with(text, kBackground)).render.background, Color(0.5f)) << text;
    }
}

TEST(Nff, ImportNamesWhatIsInItAndPlacesNothing) {
    const Loaded loaded =
        load_with(std::string(kCamera) + "import \"part.nff\" as part\npart.shapes { }\n");
    EXPECT_EQ(loaded.text(), "");
    const scene::Scene scene = scene_of(loaded);
    EXPECT_EQ(scene.cameras.size(), 1u) << "no view";
    Diagnostics diagnostics;
    const auto world = scene::flatten(scene, {}, diagnostics);
    ASSERT_TRUE(world);
    EXPECT_EQ(world->spheres.size(), 1u);
    EXPECT_EQ(world->triangles.size(), 3u);
    EXPECT_EQ(world->lights.size(), 0u);
}

TEST(Nff, ImportedSceneIsPlacedAsAGroup) {
    const std::string placed =
        std::string(kCamera) + "import \"part.nff\"\npart.scene { rotate_y: 30, scale: 2 }\n";
    const std::string grouped =
        std::string(kCamera) + "group { rotate_y: 30, scale: 2\n  include \"part.nff\"\n}\n";
    const std::string parts = std::string(kCamera) +
                              "import \"part.nff\"\nlet all = group { part.shapes { }\n"
                              "part.lights { } }\nall { rotate_y: 30, scale: 2 }\n";
    const std::string world = world_text(scene_of(load_with(placed)));
    ASSERT_FALSE(world.empty());
    EXPECT_EQ(world, world_text(scene_of(load_with(grouped))));
    EXPECT_EQ(world, world_text(scene_of(load_with(parts))));
    EXPECT_EQ(world, world_text(scene_of(load_text(parser::dump(scene_of(load_with(placed)))))));
}

TEST(Nff, ImportHasNoOtherNames) {
    const Loaded loaded = load_with("import \"part.nff\"\npart.shape { }\n");
    EXPECT_EQ(loaded.text().substr(0, 10), "E0207 2:6 ");
    EXPECT_EQ(loaded.diagnostics.sorted().at(0)->hint, "did you mean `shapes`?");
}

TEST(Nff, MistakesAreToldInTheFile) {
    EXPECT_EQ(load_nff("s 0 0 0 1").text(),
              "E0706 1:1 `s` before the first `f`, which says what shapes are made of\n");
    for (const std::string_view scene :
         {"include \"part.nff\"\n", "import \"part.nff\"\npart.scene { }\n"}) {
        const Loaded loaded = load_with(scene, "b 0 0");
        ASSERT_EQ(loaded.codes(), "E0706") << scene;
        EXPECT_NE(loaded.text().find("/part.nff:1:1 `b` needs 3 numbers, this has 2\n"),
                  std::string::npos)
            << loaded.text();
    }
}

TEST(Nff, WarningsAreToldInTheFile) {
    EXPECT_EQ(load_nff("").text(), "W1503 1:1 the scene is empty: there is no shape in it\n");
    Loaded flat = load_nff(
        "v from 0 0 9 at 0 0 0 up 0 1 0 angle 40\nl 0 0 9\n"
        "f 1 1 1 1 0 1 0 1\np 3 0 0 0\n 1 1 1\n 2 2 2\n");
    static_cast<void>(flatten_and_lint(flat));
    EXPECT_NE(flat.text().find("W1201 4:1 "), std::string::npos) << flat.text();
    const Loaded blind = load_nff("f 1 1 1 1 0 1 0 1\ns 0 0 0 1\n");
    EXPECT_EQ(blind.codes(), "W1501");
    EXPECT_EQ(blind.diagnostics.sorted().at(0)->helps.at(0),
              "add a view, like `v from 0 2 6 at 0 0 0 up 0 1 0 angle 45`");
}

TEST(Nff, LimitsHold) {
    parser::LoadLimits limits;
    limits.nodes = 6;
    EXPECT_EQ(load_nff(kNff, with_limits(limits)).codes(), "E0513");
    limits = {};
    limits.value_bytes = 600;
    EXPECT_EQ(load_nff(kNff, with_limits(limits)).codes(), "E0516");
    limits = {};
    limits.scene_bytes = kNff.size() - 1;
    EXPECT_EQ(load_nff(kNff, with_limits(limits)).codes(), "E0516");
}

TEST(Nff, HasNoParams) {
    parser::LoadSettings settings;
    settings.definitions = {{"size", "1"}};
    const TempDirectory directory;
    FileAccess files;
    Sources sources;
    Diagnostics diagnostics;
    const auto result = parser::load(directory.write("main.nff", std::string(kNff)), settings,
                                     files, sources, diagnostics);
    EXPECT_EQ(result.usage_mistakes.size(), 1u);
}

}  // namespace
}  // namespace lray::test
