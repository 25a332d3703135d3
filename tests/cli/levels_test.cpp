// The levels and hierarchies of the program as people run it: what a level chooses, and that what
// is chosen changes the time and not the picture.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "tests/cli/lray_test.h"
#include "tests/support/json.h"

namespace lray {
namespace {

/// A scene of all kinds: quadrics, meshes, instances.
const std::string kStillLife = std::string(LRAY_SOURCE_DIR) + "/examples/still_life.lrs";

class Levels : public LrayTest {
 protected:
    /// Renders an example small; returns how it went, the picture on stdout.
    test::ProcessResult run_example(const std::string& name, std::vector<std::string> options) {
        std::vector<std::string> arguments{
            "-n",      "2",
            "-ps",     "2",
            "-o",      "-",
            "--size",  "36x27",
            "--quiet", std::string(LRAY_SOURCE_DIR) + "/examples/" + name + ".lrs"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        // Without a hierarchy its 41 405 primitives would take most of the time. So coarse, the
        // ground may be warned of.
        if (name == "terrain") {
            for (const char* word : {"-D", "detail=25", "-D", "trees=40", "-A", "all"}) {
                arguments.push_back(word);
            }
        }
        auto result = run(arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return result;
    }

    std::string picture_of(const std::string& name, std::vector<std::string> options) {
        return run_example(name, std::move(options)).out;
    }
};

TEST_F(Levels, LevelTwoSmoothsEdges) {
    directory_.write("scene.lrs", kScene);
    const auto result =
        run({"-n", "2", "-ps", "16", "--shading", "flat", "-i", "scene.lrs", "-o", "image.ppm"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "");
    ASSERT_EQ(run({"-n", "1", "-i", "scene.lrs", "-o", "hard.ppm"}).exit_code, 0);
    const image::Image smooth = picture("image.ppm");
    const image::Image hard = picture("hard.ppm");
    EXPECT_EQ(smooth.at(32, 24), hard.at(32, 24));
    EXPECT_EQ(smooth.at(0, 0), hard.at(0, 0));
    const auto shades = [](const image::Image& image) {
        std::set<float> values;
        for (const Color& pixel : image.pixels) values.insert(pixel.r);
        return values.size();
    };
    EXPECT_EQ(shades(hard), 2u);
    EXPECT_GT(shades(smooth), 8u);
    EXPECT_LE(shades(smooth), 17u) << "from none to all of 16 samples";
}

TEST_F(Levels, SamplesOfTheSceneCountWithoutTheOption) {
    directory_.write("scene.lrs",
                     std::string(kScene) + "camera \"fine\" { position: [0, 0, 5], samples: 3 }\n");
    const auto samples = [&](std::vector<std::string> options) {
        std::vector<std::string> arguments{"scene.lrs", "-o", "a.ppm", "--stats=json", "--quiet"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const auto result = run(arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return test::read_json(result.err)["picture"]["samples"].number;
    };
    EXPECT_EQ(samples({}), 1.0);
    EXPECT_EQ(samples({"--camera", "fine"}), 3.0);
    EXPECT_EQ(samples({"--camera", "fine", "-ps", "2"}), 2.0);
    EXPECT_EQ(samples({"--camera", "fine", "--samples", "1:5"}), 4.0);
    EXPECT_EQ(samples({"--camera", "fine", "-n", "1"}), 1.0);
}

TEST_F(Levels, LevelTwoIsTheSameForThreadsAndCropsAndHierarchies) {
    const std::vector<std::string> base{"-n", "2", "-ps", "3", kStillLife, "--size", "97x61"};
    const auto rendered = [&](std::vector<std::string> options) {
        options.insert(options.begin(), base.begin(), base.end());
        const auto result = run(options);
        EXPECT_EQ(result.exit_code, 0) << result.err;
    };
    rendered({"-o", "a.ppm", "--threads", "1"});
    rendered({"-o", "b.ppm", "--threads", "7"});
    EXPECT_TRUE(directory_.read("a.ppm") == directory_.read("b.ppm"));
    rendered({"-o", "c.ppm", "--crop", "31,17,80,50"});
    const image::Image whole = picture("a.ppm");
    const image::Image crop = picture("c.ppm");
    ASSERT_EQ(crop.width, 49u);
    for (std::uint32_t y = 0; y < crop.height; ++y) {
        for (std::uint32_t x = 0; x < crop.width; ++x) {
            ASSERT_EQ(crop.at(x, y), whole.at(x + 31, y + 17)) << x << ", " << y;
        }
    }
    rendered({"-o", "d.ppm", "--seed", "5"});
    EXPECT_FALSE(directory_.read("a.ppm") == directory_.read("d.ppm")) << "the seed counts";
    rendered({"-o", "e.ppm", "--samples", "0:3"});
    EXPECT_TRUE(directory_.read("a.ppm") == directory_.read("e.ppm"));
}

// Every shader but the one that shows the hierarchy at work.
TEST_F(Levels, EveryHierarchyGivesTheSameBytesOfEveryExample) {
    const std::filesystem::path examples = std::string(LRAY_SOURCE_DIR) + "/examples";
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(examples)) {
        if (entry.path().extension() != ".lrs") continue;
        const std::string name = entry.path().stem().string();
        names.insert(name);
        for (const std::string shading : {"flat", "normals", "depth"}) {
            const auto picture = [&](const std::string& accel) {
                return picture_of(name, {"--accel", accel, "--shading", shading});
            };
            const std::string tested = picture("none");
            EXPECT_GT(std::set<char>(tested.begin(), tested.end()).size(), 10u);
            EXPECT_TRUE(picture("spheres") == tested) << name << " spheres " << shading;
            EXPECT_TRUE(picture("boxes") == tested) << name << " boxes " << shading;
        }
    }
    EXPECT_GE(names.size(), 8u);
    EXPECT_TRUE(names.contains("forest")) << "the one with instances";
}

TEST_F(Levels, QualityOfBoxesChangesTheTreeAndNoByte) {
    for (const std::string name : {"forest", "terrain"}) {
        std::set<double> reference_counts;
        for (const std::string quality : {"low", "medium", "high"}) {
            const auto result = run_example(name, {"--accel", "boxes", "--quality", quality,
                                                   "--shading", "normals", "--stats=json"});
            EXPECT_TRUE(result.out ==
                        picture_of(name, {"--accel", "spheres", "--shading", "normals"}))
                << name << " " << quality;
            reference_counts.insert(test::read_json(result.err)["hierarchy"]["references"].number);
        }
        EXPECT_EQ(reference_counts.size(), 2u) << name << ": high cuts some in two";
    }
}

TEST_F(Levels, CostShowsWhatAHierarchySaves) {
    const auto brightness = [&](const std::string& accel) {
        const auto result = run({kStillLife, "-o", "a.ppm", "--size", "60x45", "--shading", "cost",
                                 "--accel", accel, "--quiet"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        float red = 0.0f;  // from 64 tests on
        for (const Color& pixel : picture("a.ppm").pixels) red += pixel.r;
        return red;
    };
    EXPECT_GT(brightness("none"), 10.0f * brightness("spheres") + 1.0f);
}

}  // namespace
}  // namespace lray
