// Heightfields and terrains: what their properties make, and what is told of mistakes.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "base/file_access.h"
#include "parser/blocks/build_heightfield.h"
#include "parser/blocks/schemas.h"
#include "scene/height_grid.h"
#include "tests/parser/call_builtin_of.h"
#include "tests/parser/loaded.h"

namespace lray::test {
namespace {

using parser::Value;

/// The errors of a scene, one a line: "E0401 1:10 message".
std::string errors_of(std::string_view text, const parser::LoadLimits& limits = {},
                      const std::vector<Companion>& companions = {}) {
    const Loaded loaded = load_text(text, limits, companions);
    std::string errors;
    for (const Diagnostic* diagnostic : loaded.diagnostics.sorted()) {
        if (diagnostic->severity != Severity::error) continue;
        errors += std::string(code_info(diagnostic->code).id) + " " +
                  place_of(loaded.sources, diagnostic->span) + " " + diagnostic->message + "\n";
    }
    return errors;
}

scene::Mesh mesh_of(std::string_view text, const std::vector<Companion>& companions = {}) {
    const Loaded loaded = load_text(text, parser::LoadLimits{}, companions);
    EXPECT_TRUE(loaded.scene) << loaded.text();
    if (!loaded.scene || loaded.scene->meshes.size() != 1) return {};
    return loaded.scene->meshes[0];
}

/// Builds `heightfield { size: [4, 2], resolution: 5, height: function }`.
struct Built {
    explicit Built(std::function<Value(std::span<const Value>)> function,
                   parser::Budget budget = budget_of(1000, 1 << 20)) {
        namespace schemas = parser::schemas;
        parser::PropertyValues values(schemas::kHeightfield);
        const std::array size = {4.0, 2.0};
        values.set(parser::find_property(schemas::kHeightfield, "size"), Value::of_numbers(size));
        values.set(parser::find_property(schemas::kHeightfield, "resolution"), Value::of(5.0));
        values.set(parser::find_property(schemas::kHeightfield, "height"),
                   Value::of_function(nullptr, 1));
        std::array<Span, parser::kMaxProperties> spans{};
        spans[parser::find_property(schemas::kHeightfield, "resolution")] = Span{10, 0, 1};
        spans[parser::find_property(schemas::kHeightfield, "height")] = Span{20, 0, 1};
        runtime.function = std::move(function);
        FileAccess access;
        Sources sources;
        parser::FileLoader files(access, sources, {}, {}, diagnostics);
        use = parser::build_heightfield({values, spans, Span{1, 0, 1}},
                                        {files, budget, runtime, scene, diagnostics});
    }

    std::string told() const {
        std::string text;
        for (const Diagnostic* diagnostic : diagnostics.sorted()) {
            text += std::string(code_info(diagnostic->code).id) + " " +
                    std::to_string(diagnostic->span.offset) + " " + diagnostic->message;
        }
        return text;
    }

    FakeRuntime runtime;
    scene::Scene scene;
    Diagnostics diagnostics;
    std::optional<scene::MeshUse> use;
};

TEST(Heightfield, FunctionIsCalledAtEachPoint) {
    const Built built(
        [](std::span<const Value> p) { return Value::of(10.0 * p[0].number + p[1].number); });
    ASSERT_TRUE(built.use) << built.told();
    EXPECT_EQ(built.runtime.calls, 25);
    const scene::Mesh& mesh = built.scene.meshes.at(0);
    EXPECT_EQ(mesh.triangles.size(), 32u);
    for (const Vec3& p : mesh.positions) EXPECT_EQ(p.y, 10.0f * p.x + p.z);
    EXPECT_EQ(mesh.positions.front(), (Vec3{-2, -21, -1}));
    EXPECT_EQ(mesh.positions.back(), (Vec3{2, 21, 1}));
}

TEST(Heightfield, FunctionWithoutAHeightIsAnErrorAtItsPoint) {
    const auto told = [](Value wrong) {
        return Built([wrong](std::span<const Value> p) {
                   return p[0].number == 1.0 && p[1].number == 0.5 ? wrong : Value::of(0.0);
               })
            .told();
    };
    EXPECT_EQ(told(Value::of(1e300)), "E0304 20 the height at x = 1, z = 0.5 is too large: 1e+300");
    EXPECT_EQ(told(Value::of(std::numeric_limits<double>::quiet_NaN())),
              "E0304 20 the height at x = 1, z = 0.5 is not finite: nan");
    EXPECT_EQ(told(Value::of_string("high", 0)),
              "E0301 20 the height at x = 1, z = 0.5 must be a number, this is a string");
}

TEST(Heightfield, FunctionThatFailsIsNotCalledAgain) {
    const Built built([](std::span<const Value>) { return Value::poison(); });
    EXPECT_FALSE(built.use);
    EXPECT_EQ(built.told(), "");  // the runtime has told
    EXPECT_EQ(built.runtime.calls, 1);
    EXPECT_TRUE(built.scene.meshes.empty());
}

TEST(Heightfield, LimitsAreMetBeforeTheFirstCall) {
    const auto zero = [](std::span<const Value>) { return Value::of(0.0); };
    const std::uint64_t bytes = scene::height_mesh_bytes(5, 5);
    EXPECT_TRUE(Built(zero, budget_of(25, bytes)).use);
    const Built steps(zero, budget_of(24, bytes));
    EXPECT_EQ(steps.told().substr(0, 8), "E0512 10");
    EXPECT_EQ(steps.runtime.calls, 0);
    const Built memory(zero, budget_of(25, bytes - 1));
    EXPECT_EQ(memory.told().substr(0, 8), "E0516 10");
    EXPECT_EQ(memory.runtime.calls, 0);
}

TEST(Heightfield, RowsRunAlongXFromTheFarSide) {
    const scene::Mesh mesh =
        mesh_of("camera { }\nheightfield { size: [2, 6], heights: [[1, 2, 3], [4, 5, 6]] }");
    ASSERT_EQ(mesh.positions.size(), 6u);
    EXPECT_EQ(mesh.positions[0], (Vec3{-1, 1, -3}));
    EXPECT_EQ(mesh.positions[2], (Vec3{1, 3, -3}));
    EXPECT_EQ(mesh.positions[3], (Vec3{-1, 4, 3}));
}

TEST(Heightfield, RowsMayBeWide) {
    const scene::Mesh mesh = mesh_of(
        "camera { }\nlet a = [1, 2, 3, 4, 5, 6]\nheightfield { heights: [a, a + 1, a * 2] }");
    ASSERT_EQ(mesh.positions.size(), 18u);
    EXPECT_EQ(mesh.positions[11].y, 7.0f);
    EXPECT_EQ(mesh.positions[17].y, 12.0f);
}

TEST(Heightfield, WrongRowsAreTold) {
    EXPECT_EQ(errors_of("heightfield { heights: [[1, 2, 3], [4, 5]] }"),
              "E0303 1:24 row 1 of `heights` has 2 numbers, row 0 has 3\n");
    EXPECT_EQ(errors_of("heightfield { heights: [[1, 2, 3]] }"),
              "E0303 1:24 `heights` needs 2 rows of 2 numbers or more\n");
    EXPECT_EQ(errors_of("heightfield { heights: [[1], [2]] }"),
              "E0303 1:24 `heights` needs 2 rows of 2 numbers or more\n");
    EXPECT_EQ(errors_of("heightfield { heights: [] }"),
              "E0303 1:24 `heights` needs 2 rows of 2 numbers or more\n");
    EXPECT_EQ(errors_of("heightfield { heights: [1, 2] }"),
              "E0301 1:24 `heights` needs rows of numbers, like [[0, 1], [0, 2]], this is a list "
              "of 2 numbers\n");
    EXPECT_EQ(errors_of("heightfield { heights: [[1, 2], [1, \"2\"]] }"),
              "E0301 1:24 `heights` needs rows of numbers, like [[0, 1], [0, 2]]; row 1 is a list "
              "of 2 elements\n");
    EXPECT_EQ(errors_of("heightfield { heights: [[1, 2], [1, 1e39]] }"),
              "E0304 1:24 row 1 of `heights` is too large: 1e+39\n");
}

// 3 x 2 pixels: black, white, black above red, green, blue.
const std::string kPicture = std::string("P6 3 2 255\n") +
                             std::string("\0\0\0\xff\xff\xff\0\0\0\xff\0\0\0\xff\0\0\0\xff", 18);

TEST(Heightfield, PictureIsLuminanceTimesScale) {
    const scene::Mesh mesh =
        mesh_of("camera { }\nheightfield { image: \"hills.ppm\", scale_y: 2, size: [2, 2] }",
                {{"hills.ppm", kPicture}});
    ASSERT_EQ(mesh.positions.size(), 6u);
    EXPECT_EQ(mesh.positions[0], (Vec3{-1, 0, -1}));  // the top left pixel is far and left
    EXPECT_FLOAT_EQ(mesh.positions[1].y, 2.0f);
    EXPECT_FLOAT_EQ(mesh.positions[3].y, 2.0f * 0.2126f);
    EXPECT_FLOAT_EQ(mesh.positions[4].y, 2.0f * 0.7152f);
    EXPECT_FLOAT_EQ(mesh.positions[5].y, 2.0f * 0.0722f);
}

TEST(Heightfield, WrongPicturesAreTold) {
    const std::vector<Companion> files = {{"notes.png", "not a picture"},
                                          {"line.ppm", std::string_view("P6 1 2 255\n______", 17)},
                                          {"cut.ppm", "P6 9 9 255\nxx"}};
    EXPECT_EQ(errors_of("heightfield { image: \"notes.png\" }", {}, files),
              "E0703 1:22 `notes.png`: this is not a PNG, JPEG, PPM, PFM, Radiance HDR or OpenEXR "
              "file\n");
    EXPECT_EQ(errors_of("heightfield { image: \"line.ppm\" }", {}, files),
              "E0703 1:22 a heightfield needs a picture of 2 x 2 pixels or more, this has 1 x 2\n");
    EXPECT_EQ(errors_of("heightfield { image: \"cut.ppm\" }", {}, files).substr(0, 11),
              "E0703 1:22 ");
    EXPECT_EQ(errors_of("heightfield { image: \"no.ppm\" }", {}, files),
              "E0601 1:22 `no.ppm` not found\n");
    EXPECT_EQ(errors_of("heightfield { image: \"/etc/passwd\" }", {}, files).substr(0, 11),
              "E0605 1:22 ");
    parser::LoadLimits small;
    small.mesh_bytes = kPicture.size() - 1;
    EXPECT_EQ(errors_of("heightfield { image: \"hills.ppm\" }", small, {{"hills.ppm", kPicture}}),
              "E0516 1:22 `hills.ppm` is larger than 28 bytes\n");
}

TEST(Heightfield, FormsExcludeEachOther) {
    EXPECT_EQ(errors_of("heightfield { }"),
              "E0406 1:1 heightfield needs `height`, `heights` or `image`\n");
    EXPECT_EQ(errors_of("heightfield { size: [2, 2] }"),
              "E0406 1:1 heightfield needs `height`, `heights` or `image`\n");
    EXPECT_EQ(errors_of("heightfield { resolution: 5 }"), "E0406 1:1 heightfield needs `height`\n");
    EXPECT_EQ(errors_of("heightfield { scale_y: 5 }"), "E0406 1:1 heightfield needs `image`\n");
    EXPECT_EQ(errors_of("heightfield { heights: [[1, 2], [3, 4]], image: \"a.png\" }"),
              "E0411 1:42 give `heights` or `image`, not both\n");
    EXPECT_EQ(errors_of("heightfield { image: \"a.png\", resolution: 9 }"),
              "E0411 1:31 give `resolution` or `image`, not both\n");
    EXPECT_EQ(errors_of("heightfield { height: 3 }"),
              "E0301 1:23 `height` needs a function, this is a number\n");
}

TEST(Terrain, SceneMakesAMesh) {
    for (const char* method : {"diamond_square", "fbm", "ridged"}) {
        const scene::Mesh mesh =
            mesh_of(std::string("camera { }\nterrain { seed: 42, resolution: 20, method: \"") +
                    method + "\" }");
        ASSERT_EQ(mesh.positions.size(), 400u) << method;
        EXPECT_EQ(mesh.positions.front().x, -50.0f);
        EXPECT_EQ(mesh.positions.front().z, -50.0f);
        EXPECT_EQ(mesh.triangles.size(), 2u * 19 * 19);
    }
}

TEST(Terrain, NodeUsedTwiceIsOneMesh) {
    const Loaded loaded = load_text(
        "camera { }\nlet hills = terrain { seed: 1, resolution: 9 }\nhills { }\n"
        "hills { translate: [100, 0, 0] }");
    ASSERT_TRUE(loaded.scene) << loaded.text();
    EXPECT_EQ(loaded.scene->meshes.size(), 1u);
}

TEST(Terrain, MistakesAreTold) {
    EXPECT_EQ(errors_of("terrain { }"), "E0406 1:1 terrain needs `seed`\n");
    EXPECT_EQ(errors_of("terrain { seed: 1, resolution: 1 }"),
              "E0304 1:32 `resolution` must be from 2 to 32768, this is 1\n");
    EXPECT_EQ(errors_of("terrain { seed: 1, resolution: 2.5 }"),
              "E0308 1:32 `resolution` needs a whole number, this is 2.5\n");
    EXPECT_EQ(errors_of("terrain { seed: 1, roughness: 1.5 }"),
              "E0304 1:31 `roughness` must be from 0 to 1, this is 1.5\n");
    EXPECT_EQ(errors_of("terrain { seed: 1, height: 1e39, size: [1, 1] }"),
              "E0304 1:28 `height` is too large: 1e+39\n");
    EXPECT_EQ(errors_of("terrain { seed: 1, size: [1e39, 1] }"),
              "E0304 1:26 `size` is too large: 1e+39\n");
    EXPECT_EQ(errors_of("terrain { seed: 1, method: \"fbn\" }"),
              "E0403 1:28 unknown method `fbn`; did you mean `fbm`?\n");
}

TEST(Terrain, LimitsAreMetBeforeMemoryIsTaken) {
    parser::LoadLimits few_steps;
    few_steps.steps = 1'000'000;
    EXPECT_EQ(errors_of("terrain { seed: 1, resolution: 32768 }", few_steps).substr(0, 11),
              "E0512 1:32 ");
    parser::LoadLimits little_memory;
    little_memory.steps = std::uint64_t{1} << 40;
    EXPECT_EQ(errors_of("terrain { seed: 1, resolution: 32768 }", little_memory).substr(0, 11),
              "E0516 1:32 ");
}

}  // namespace
}  // namespace lray::test
