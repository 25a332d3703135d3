// Pictures of the program against those in tests/golden, byte by byte. LRAY_BLESS=NAME (or all)
// makes them anew: `./dev bless NAME`.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/output_file.h"
#include "image/compare.h"
#include "image/read.h"
#include "image/write.h"
#include "tests/support/process.h"
#include "tests/support/temp_directory.h"

namespace lray {
namespace {

namespace fs = std::filesystem;

struct Golden {
    std::string name{};
    std::string scene{};  // from the top of the project
    std::vector<std::string> options{};
};

std::ostream& operator<<(std::ostream& out, const Golden& golden) {
    return out << golden.name;
}

/// A picture of the scene in full light, of so many rays per pixel.
Golden lit(std::string name, std::string scene, std::string size, std::string rays,
           std::vector<std::string> more = {}) {
    Golden golden{std::move(name), std::move(scene), {"-n", "2", "--accel", "boxes"}};
    golden.options.insert(golden.options.end(),
                          {"--shading", "full", "-ps", std::move(rays), "--size", std::move(size)});
    golden.options.insert(golden.options.end(), more.begin(), more.end());
    return golden;
}

/// Every scene of examples/, the library and tests/golden; many twice: flat, as level 1 paints,
/// and lit.
std::vector<Golden> goldens() {
    return {
        {"primitives", "examples/primitives.lrs", {"--size", "160x120"}},
        {"still_life", "examples/still_life.lrs", {"--size", "160x120"}},
        {"still_life_above", "examples/still_life.lrs", {"--size", "160x120", "--camera", "above"}},
        {"still_life_apples",
         "examples/still_life.lrs",
         {"--size", "120x120", "--camera", "apples"}},
        // The same pixels as in still_life.
        {"still_life_crop",
         "examples/still_life.lrs",
         {"--size", "160x120", "--crop", "10,30,90,100"}},
        {"chess", "examples/chess.lrs", {"--size", "160x100"}},
        {"chess_board", "examples/chess.lrs", {"--size", "120x120", "--camera", "board"}},
        {"orbits_0", "examples/orbits.lrs", {"--size", "150x100", "--frame", "0"}},
        {"orbits_3", "examples/orbits.lrs", {"--size", "150x100", "--frame", "3"}},
        {"sphereflake", "examples/sphereflake.lrs", {"--size", "120x90"}},
        {"staircase", "examples/staircase.lrs", {"--size", "120x160"}},
        {"terrain",
         "examples/terrain.lrs",
         {"--size", "128x72", "-D", "detail=25", "-D", "trees=120"}},
        {"terrain_map",
         "examples/terrain.lrs",
         {"--size", "64x64", "--camera", "map", "-D", "detail=25", "-D", "seed=7"}},
        {"forest", "examples/forest.lrs", {"--size", "128x72", "-D", "trees=500"}},
        {"materials", "examples/lib/materials.lrs", {"--size", "120x60"}},
        {"std_colors", "parser/std/colors.lrs", {"--size", "90x90"}},
        {"std_lights", "parser/std/lights.lrs", {"--size", "128x80"}},
        {"std_materials", "parser/std/materials.lrs", {"--size", "160x80"}},
        {"primitives_smooth",
         "examples/primitives.lrs",
         {"-n", "2", "-ps", "16", "--size", "160x120", "--shading", "flat"}},
        {"chess_smooth",
         "examples/chess.lrs",
         {"-n", "2", "-ps", "4", "--size", "160x100", "--shading", "flat"}},
        {"normals",
         "examples/primitives.lrs",
         {"-n", "2", "-ps", "4", "--size", "160x120", "--shading", "normals"}},
        {"depth",
         "examples/primitives.lrs",
         {"-n", "2", "-ps", "4", "--size", "160x120", "--shading", "depth"}},
        {"cost_of_spheres",
         "examples/sphereflake.lrs",
         {"-n", "2", "-ps", "1", "--size", "120x90", "--shading", "cost"}},
        {"boxes", "tests/golden/boxes.lrs", {"--size", "160x120"}},
        {"cones", "tests/golden/cones.lrs", {"--size", "160x120"}},
        {"disks", "tests/golden/disks.lrs", {"--size", "160x120"}},
        {"nff_shapes", "tests/golden/shapes.nff"},
        {"fitted_camera", "tests/golden/fitted_camera.lrs", {"--size", "160x120"}},
        {"instances", "tests/golden/instances.lrs", {"--size", "160x120"}},
        {"mesh_materials", "tests/golden/mesh_materials.lrs", {"--size", "160x120"}},
        {"meshes", "tests/golden/meshes.lrs", {"--size", "160x120"}},
        {"orthographic", "tests/golden/orthographic.lrs", {"--size", "160x120"}},
        {"planes", "tests/golden/planes.lrs", {"--size", "160x120"}},
        {"quadrics", "tests/golden/quadrics.lrs", {"--size", "160x120"}},
        {"torus", "tests/golden/torus.lrs", {"--size", "160x120"}},
        {"textures", "tests/golden/textures.lrs", {"--size", "160x120"}},
        {"transforms", "tests/golden/transforms.lrs", {"--size", "160x120"}},
        {"vertex_colors", "tests/golden/vertex_colors.lrs", {"--size", "160x120"}},
        lit("lit_vertex_colors", "tests/golden/vertex_colors.lrs", "160x120", "4"),
        {"cornell", "examples/cornell.lrs", {"--size", "120x120"}},
        {"depth_of_field", "examples/depth_of_field.lrs", {"--size", "128x72"}},
        {"gallery", "examples/gallery.lrs", {"--size", "160x90"}},
        {"glass", "examples/glass.lrs", {"--size", "160x120"}},
        lit("lit_lights", "tests/golden/lights.lrs", "160x120", "4"),
        lit("lit_mesh_materials", "tests/golden/mesh_materials.lrs", "160x120", "4"),
        lit("lit_soft_shadows", "tests/golden/soft_shadows.lrs", "160x120", "4"),
        lit("lit_environment", "tests/golden/environment.lrs", "160x120", "4"),
        lit("lit_models", "tests/golden/models.lrs", "160x120", "4"),
        lit("lit_glass", "tests/golden/glass.lrs", "160x120", "4"),
        lit("lit_coloured_shadows", "tests/golden/coloured_shadows.lrs", "160x120", "4"),
        lit("lit_paths", "tests/golden/paths.lrs", "120x90", "32"),
        lit("lit_textured", "tests/golden/textured.lrs", "160x120", "4"),
        lit("lit_nff_shapes", "tests/golden/shapes.nff", "160x120", "4"),
        lit("lit_lens", "tests/golden/depth_of_field.lrs", "160x120", "16"),
        lit("lit_panorama", "tests/golden/panorama.lrs", "160x80", "4"),
        lit("lit_smooth_normals", "tests/golden/smooth_normals.lrs", "160x120", "4"),
        lit("lit_tone_none", "tests/golden/tone_maps.lrs", "160x60", "4"),
        lit("lit_tone_reinhard", "tests/golden/tone_maps.lrs", "160x60", "4",
            {"-D", "tone=reinhard"}),
        lit("lit_tone_aces", "tests/golden/tone_maps.lrs", "160x60", "4", {"-D", "tone=aces"}),
        lit("lit_primitives", "examples/primitives.lrs", "160x120", "4"),
        lit("lit_still_life", "examples/still_life.lrs", "160x120", "4"),
        lit("lit_chess", "examples/chess.lrs", "160x100", "4"),
        lit("lit_orbits", "examples/orbits.lrs", "150x100", "4", {"--frame", "0"}),
        lit("lit_sphereflake", "examples/sphereflake.lrs", "120x90", "4"),
        lit("lit_staircase", "examples/staircase.lrs", "120x160", "4"),
        lit("lit_terrain", "examples/terrain.lrs", "128x72", "4",
            {"-D", "detail=25", "-D", "trees=120"}),
        lit("lit_forest", "examples/forest.lrs", "128x72", "4", {"-D", "trees=500"}),
        lit("lit_materials", "examples/lib/materials.lrs", "120x60", "4"),
        lit("lit_example_glass", "examples/glass.lrs", "160x120", "4"),
        lit("lit_cornell", "examples/cornell.lrs", "90x90", "64"),
        lit("lit_depth_of_field", "examples/depth_of_field.lrs", "128x72", "16"),
        lit("lit_gallery", "examples/gallery.lrs", "160x90", "4"),
        lit("lit_std_lights", "parser/std/lights.lrs", "128x80", "4"),
        lit("lit_std_materials", "parser/std/materials.lrs", "160x80", "4"),
    };
}

const fs::path kTop = LRAY_SOURCE_DIR;

fs::path golden_path(const std::string& name) {
    return kTop / "tests" / "golden" / (name + ".ppm");
}

std::optional<image::Image> decode(const std::string& bytes) {
    std::string error;
    return image::read_image(std::as_bytes(std::span(bytes)), {}, error);
}

void write_png(const fs::path& path, const image::Image& image) {
    std::string error;
    auto file = OutputFile::open(path.string(), error);
    ASSERT_TRUE(file) << error;
    ASSERT_TRUE(image::write_image(*file, image, image::Format::png, image::Gamma::srgb, {}, error))
        << error;
    ASSERT_TRUE(file->commit());
}

/// Puts the picture and its difference beside the program, to be looked at; returns where.
std::string keep_for_inspection(const Golden& golden, const std::string& actual,
                                const std::string& expected) {
    const fs::path directory = fs::path(LRAY_BINARY).parent_path() / "golden";
    fs::create_directories(directory);
    const fs::path actual_path = directory / (golden.name + ".actual.png");
    const auto actual_image = decode(actual);
    if (!actual_image) return "the program wrote no picture";
    write_png(actual_path, *actual_image);
    std::string told = fmt::format("it is {}", actual_path.string());
    const auto expected_image = decode(expected);
    const bool are_comparable = expected_image && expected_image->width == actual_image->width &&
                                expected_image->height == actual_image->height;
    if (!are_comparable) return told + "; the golden has another size";
    const fs::path difference_path = directory / (golden.name + ".difference.png");
    write_png(difference_path, image::difference_picture(*actual_image, *expected_image, 0.0f));
    const auto difference = image::compare(*actual_image, *expected_image, 0.0f);
    return told + fmt::format("; the difference is {}: {:.2f} % of the pixels, up to {:.0f} levels",
                              difference_path.string(), 100.0 * difference->share_beyond,
                              static_cast<double>(difference->max));
}

bool is_to_be_blessed(const std::string& name) {
    const char* const bless = std::getenv("LRAY_BLESS");
    return bless != nullptr && (name == bless || std::string_view(bless) == "all");
}

class GoldenPicture : public testing::TestWithParam<Golden> {};

TEST_P(GoldenPicture, IsTheSameToTheByte) {
    const Golden& golden = GetParam();
    std::vector<std::string> command{
        LRAY_BINARY, "-n", "1", "-i", (kTop / golden.scene).string(), "-o", "-", "--format", "ppm"};
    command.insert(command.end(), golden.options.begin(), golden.options.end());
    const test::ProcessResult result = test::run_process(command);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const fs::path path = golden_path(golden.name);
    if (is_to_be_blessed(golden.name)) {
        std::ofstream(path, std::ios::binary) << result.out;
        return;
    }
    ASSERT_TRUE(fs::exists(path)) << "to make it, run: ./dev bless " << golden.name;
    const std::string expected = test::read_bytes(path.string());
    if (result.out == expected) return;  // EXPECT_EQ would print the bytes
    ADD_FAILURE() << golden.name
                  << " is another picture: " << keep_for_inspection(golden, result.out, expected)
                  << ".\nIf it is right, look at it and run: ./dev bless " << golden.name;
}

INSTANTIATE_TEST_SUITE_P(Golden, GoldenPicture, testing::ValuesIn(goldens()),
                         [](const auto& instance) { return instance.param.name; });

/// Names of the files in a directory with that extension, without it, sorted.
std::vector<std::string> stems(const fs::path& directory, std::string_view extension) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(directory)) {
        if (entry.path().extension() == extension) names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

TEST(GoldenPictures, AreDescribedAndNoneIsForgotten) {
    std::vector<std::string> names;
    std::vector<std::string> scenes;
    const std::string description =
        test::read_bytes((kTop / "tests" / "golden" / "README.md").string());
    for (const Golden& golden : goldens()) {
        names.push_back(golden.name);
        scenes.push_back(golden.scene);
        EXPECT_NE(description.find(fmt::format("| `{}` |", golden.name)), std::string::npos)
            << "tests/golden/README.md does not tell what " << golden.name << " shows";
    }
    std::sort(names.begin(), names.end());
    EXPECT_EQ(stems(kTop / "tests" / "golden", ".ppm"), names);
    for (const std::string& stem : stems(kTop / "tests" / "golden", ".nff")) {
        EXPECT_GT(std::ranges::count(scenes, "tests/golden/" + stem + ".nff"), 0) << stem;
    }
    for (const std::string folder : {"examples", "examples/lib", "parser/std", "tests/golden"}) {
        for (const std::string& stem : stems(kTop / folder, ".lrs")) {
            const std::string scene = folder + "/" + stem + ".lrs";
            EXPECT_GT(std::ranges::count(scenes, scene), 0) << scene;
        }
    }
}

TEST(GoldenPictures, CropIsAPartOfTheWhole) {
    const auto whole = decode(test::read_bytes(golden_path("still_life").string()));
    const auto crop = decode(test::read_bytes(golden_path("still_life_crop").string()));
    ASSERT_TRUE(whole && crop);
    ASSERT_EQ(crop->width, 80u);
    ASSERT_EQ(crop->height, 70u);
    for (std::uint32_t y = 0; y < crop->height; ++y) {
        for (std::uint32_t x = 0; x < crop->width; ++x) {
            ASSERT_EQ(crop->at(x, y), whole->at(x + 10, y + 30)) << x << ", " << y;
        }
    }
}

}  // namespace
}  // namespace lray
