// The program as people run it: pictures, messages and exit codes.
#include <gtest/gtest.h>

#include <unistd.h>
#include <cstring>
#include <filesystem>

#include <array>

#include "base/diagnostic_codes.h"
#include "cli/memory_limit.h"
#include "image/compare.h"
#include "tests/cli/lray_test.h"
#include "tests/support/json.h"

namespace lray {
namespace {

constexpr const char* kWrongScene =
    "camera { position: [0, 0, 5], look_at: [0, 0, 0] }\n"
    "sphere { radios: 1 }\n";

constexpr const char* kSceneWithoutCamera =
    "point_light { position: [2, 5, 5] }; sphere { radius: 1 }\n";

class EndToEnd : public LrayTest {};

TEST_F(EndToEnd, LevelOneWritesAFlatPicture) {
    directory_.write("scene.lrs", kScene);
    const auto result = run({"-n", "1", "-i", "scene.lrs", "-o", "image.ppm"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "");
    const image::Image image = picture("image.ppm");
    ASSERT_EQ(image.width, 64u);
    ASSERT_EQ(image.height, 48u);
    EXPECT_GT(image.at(32, 24).r, 0.5f) << "the sphere, in the default grey";
    EXPECT_EQ(image.at(32, 24).r, image.at(32, 24).b);
    EXPECT_EQ(image.at(0, 0), Color(0.0f)) << "the background";
    // The silhouette's half height: 24 px tan(asin(1/5)) / tan(22.5 deg) = 11.8 px.
    EXPECT_EQ(image.at(32, 24 - 11).r, image.at(32, 24).r);
    EXPECT_EQ(image.at(32, 24 - 13), Color(0.0f));
    EXPECT_EQ(directory_.names(), (std::vector<std::string>{"image.ppm", "scene.lrs"}));
}

TEST_F(EndToEnd, FormatsAndStreamsShowTheSamePicture) {
    directory_.write("scene.lrs", kScene);
    EXPECT_EQ(run({"scene.lrs", "-o", "a.ppm"}).exit_code, 0);
    EXPECT_EQ(run({"scene.lrs", "-o", "a.png"}).exit_code, 0);
    EXPECT_EQ(run({"scene.lrs", "-o", "a.data", "--format", "png"}).exit_code, 0);
    EXPECT_EQ(picture("a.png").pixels, picture("a.ppm").pixels);
    EXPECT_EQ(directory_.read("a.data"), directory_.read("a.png"));
    const auto streamed = run({"-i", "-", "-o", "-"}, kScene);
    EXPECT_EQ(streamed.exit_code, 0) << streamed.err;
    EXPECT_EQ(streamed.out, directory_.read("a.ppm"));
    EXPECT_EQ(streamed.err, "");
}

TEST_F(EndToEnd, PfmHoldsTheLightBeforeItsDisplay) {
    directory_.write("scene.lrs",
                     "render { exposure: 3, tonemap: \"aces\", resolution: [1, 1] }\n"
                     "camera { position: [0, 0, 5] }\npoint_light { position: [0, 0, 2] }\n"
                     "plane { normal: [0, 0, 1], material { diffuse: 0, specular: 0, emission: "
                     "6.25 } }\n");
    ASSERT_EQ(run({"scene.lrs", "-o", "a.pfm", "--quiet"}).exit_code, 0);
    const std::string file = directory_.read("a.pfm");
    float red = 0.0f;
    ASSERT_GT(file.size(), 12u);
    std::memcpy(&red, file.data() + file.size() - 12, sizeof red);
    EXPECT_EQ(red, 6.25f);
}

TEST_F(EndToEnd, ThreadsAndCropsDoNotChangeAPixel) {
    directory_.write("scene.lrs", kScene);
    ASSERT_EQ(run({"scene.lrs", "-o", "a.ppm", "--threads", "1"}).exit_code, 0);
    ASSERT_EQ(run({"scene.lrs", "-o", "b.ppm", "--threads", "8"}).exit_code, 0);
    EXPECT_EQ(directory_.read("a.ppm"), directory_.read("b.ppm"));
    ASSERT_EQ(run({"scene.lrs", "-o", "c.ppm", "--crop", "20,10,50,40"}).exit_code, 0);
    const image::Image whole = picture("a.ppm");
    const image::Image crop = picture("c.ppm");
    ASSERT_EQ(crop.width, 30u);
    ASSERT_EQ(crop.height, 30u);
    for (std::uint32_t y = 0; y < 30; ++y) {
        for (std::uint32_t x = 0; x < 30; ++x) {
            ASSERT_EQ(crop.at(x, y), whole.at(x + 20, y + 10));
        }
    }
}

/// A scene of all kinds: quadrics, meshes, instances.
const std::string kStillLife = std::string(LRAY_SOURCE_DIR) + "/examples/still_life.lrs";

TEST_F(EndToEnd, ThreadsDoNotChangeAByteOfARichScene) {
    const auto one = run({kStillLife, "-o", "-", "--size", "200x150", "--threads", "1"});
    const auto eight = run({kStillLife, "-o", "-", "--size", "200x150", "--threads", "8"});
    ASSERT_EQ(one.exit_code, 0) << one.err;
    EXPECT_TRUE(one.out.starts_with("P6\n200 150\n255\n"));
    EXPECT_TRUE(one.out == eight.out) << "the pictures differ";
}

TEST_F(EndToEnd, CropsTileThePictureToTheByte) {
    ASSERT_EQ(run({kStillLife, "-o", "whole.ppm", "--size", "97x61"}).exit_code, 0);
    const image::Image whole = picture("whole.ppm");
    // Four parts about a pixel that is on no tile's border, an edge of one pixel among them.
    const std::vector<std::array<std::uint32_t, 4>> parts{
        {0, 0, 33, 60}, {33, 0, 97, 60}, {0, 60, 33, 61}, {33, 60, 97, 61}};
    std::uint64_t pixel_count = 0;
    for (const auto& [x0, y0, x1, y1] : parts) {
        const std::string crop = std::to_string(x0) + "," + std::to_string(y0) + "," +
                                 std::to_string(x1) + "," + std::to_string(y1);
        ASSERT_EQ(run({kStillLife, "-o", "part.ppm", "--size", "97x61", "--crop", crop}).exit_code,
                  0);
        const image::Image part = picture("part.ppm");
        ASSERT_EQ(part.width, x1 - x0);
        ASSERT_EQ(part.height, y1 - y0);
        for (std::uint32_t y = y0; y < y1; ++y) {
            for (std::uint32_t x = x0; x < x1; ++x) {
                ASSERT_EQ(part.at(x - x0, y - y0), whole.at(x, y)) << crop << " " << x << "," << y;
                ++pixel_count;
            }
        }
    }
    EXPECT_EQ(pixel_count, 97u * 61u);
}

constexpr const char* kTwoCameras =
    "render { resolution: [8, 6], background: blue }\n"
    "camera { position: [0, 0, 5] }\n"
    "camera \"top\" { position: [0, 5, 0], look_at: [0, 0, 0], up: [0, 0, -1], "
    "resolution: [4, 4], background: lime }\n"
    "camera \"nowhere\" { position: [9, 9, 9], look_at: [99, 99, 99] }\n"
    "rectangle { size: [9, 9], material { diffuse: red } }\n";  // seen from its edge by the first

TEST_F(EndToEnd, CameraIsTheFirstOrTheOneNamed) {
    directory_.write("scene.lrs", kTwoCameras);
    const Color red{1, 0, 0};
    const Color lime{0, 1, 0};
    const Color blue{0, 0, 1};
    ASSERT_EQ(run({"scene.lrs", "-o", "a.ppm"}).exit_code, 0);
    EXPECT_EQ(picture("a.ppm").width, 8u);
    EXPECT_EQ(picture("a.ppm").at(0, 0), blue) << "the first camera";
    ASSERT_EQ(run({"scene.lrs", "-o", "b.ppm", "--camera", "top"}).exit_code, 0);
    ASSERT_EQ(picture("b.ppm").width, 4u) << "its own resolution";
    EXPECT_EQ(picture("b.ppm").at(2, 2), red);
    ASSERT_EQ(run({"scene.lrs", "-o", "c.ppm", "--camera", "nowhere"}).exit_code, 0);
    EXPECT_EQ(picture("c.ppm").at(4, 3), blue);
    ASSERT_EQ(run({"scene.lrs", "-o", "d.ppm", "--camera", "top", "--size", "20x5"}).exit_code, 0);
    ASSERT_EQ(picture("d.ppm").width, 20u) << "the command line counts first";
    EXPECT_EQ(picture("d.ppm").at(0, 2), lime) << "beside the rectangle";
    const auto wrong = run({"scene.lrs", "-o", "e.ppm", "--camera", "tpo"});
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_TRUE(contains(wrong.err, "no camera named `tpo`")) << wrong.err;
    EXPECT_TRUE(contains(wrong.err, "did you mean `top`?")) << wrong.err;
}

TEST_F(EndToEnd, SceneOfAnotherDirectoryFindsItsFilesBesideIt) {
    directory_.write("far/scene.lrs", std::string(kScene) + "include \"parts/ball.lrs\"\n");
    directory_.write("far/parts/ball.lrs", "mesh { file: \"ball.obj\" }\n");
    directory_.write("far/parts/ball.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto result = run({"far/scene.lrs", "-o", "a.ppm"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    // Read from stdin, it has only the directory it is run in.
    const auto streamed =
        run({"-i", "-", "-o", "b.ppm"}, std::string(kScene) + "include \"far/parts/ball.lrs\"\n");
    EXPECT_EQ(streamed.exit_code, 0) << streamed.err;
    EXPECT_EQ(directory_.read("a.ppm"), directory_.read("b.ppm"));
    const auto lost =
        run({"-i", "-", "-o", "c.ppm"}, std::string(kScene) + "include \"ball.lrs\"\n");
    EXPECT_EQ(lost.exit_code, 1);
    EXPECT_TRUE(contains(lost.err, "<stdin>:4:9: error[E0601]")) << lost.err;
    const auto found = run({"-I", "far/parts", "-i", "-", "-o", "c.ppm"},
                           std::string(kScene) + "include \"ball.lrs\"\n");
    EXPECT_EQ(found.exit_code, 0) << found.err;
    EXPECT_EQ(directory_.read("a.ppm"), directory_.read("c.ppm"));
}

TEST_F(EndToEnd, FilesOfOthersAreOutOfReachUnlessAllowed) {
    directory_.write("secret.lrs", "sphere { center: [1, 0, 0] }\n");
    directory_.write("scenes/scene.lrs", std::string(kScene) + "include \"../secret.lrs\"\n");
    const auto refused = run({"scenes/scene.lrs", "-o", "a.ppm"});
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_TRUE(contains(refused.err, "scenes/scene.lrs:4:9: error[E0605]")) << refused.err;
    EXPECT_TRUE(contains(refused.err, "--allow")) << refused.err;
    EXPECT_FALSE(contains(refused.err, "center")) << "what is in it must not be told";
    const auto allowed = run({"scenes/scene.lrs", "-o", "a.ppm", "--allow", "."});
    EXPECT_EQ(allowed.exit_code, 0) << allowed.err;
}

TEST_F(EndToEnd, MisspeltOptionsAreSuggested) {
    directory_.write("scene.lrs", kScene);
    const std::vector<std::pair<std::string, std::string>> misspelt{
        {"--sise", "--size"},       {"--thread", "--threads"},       {"--cammera", "--camera"},
        {"-quit", "--quiet"},       {"--max-error", "--max-errors"}, {"--chekc", "--check"},
        {"--explian", "--explain"},
    };
    for (const auto& [wrong, right] : misspelt) {
        const auto result = run({"scene.lrs", "-o", "a.ppm", wrong, "1"});
        EXPECT_EQ(result.exit_code, 2) << wrong;
        EXPECT_TRUE(contains(result.err, "unknown option `" + wrong + "`")) << result.err;
        EXPECT_TRUE(contains(result.err, "did you mean `" + right + "`")) << result.err;
    }
    EXPECT_EQ(directory_.names(), std::vector<std::string>{"scene.lrs"});
}

TEST_F(EndToEnd, EveryCodeIsExplained) {
    for (const CodeInfo& info : code_infos()) {
        const auto result = run({"--explain", std::string(info.id)});
        EXPECT_EQ(result.exit_code, 0) << info.id;
        EXPECT_TRUE(result.out.starts_with(std::string(info.id) + ": " + std::string(info.title)))
            << result.out;
        EXPECT_EQ(result.err, "");
    }
    const auto unknown = run({"--explain", "E4001"});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_TRUE(contains(unknown.err, "there is no code `E4001`")) << unknown.err;
}

TEST_F(EndToEnd, InfoOfTheSceneIsInThePng) {
    directory_.write("scene.lrs", std::string(kScene) + "info { title: \"One sphere\" }\n");
    ASSERT_EQ(run({"scene.lrs", "-o", "a.png"}).exit_code, 0);
    EXPECT_TRUE(contains(directory_.read("a.png"), std::string_view("Title\0One sphere", 16)));
}

TEST_F(EndToEnd, RequestedTextGoesToStdout) {
    const auto help = run({"--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_TRUE(contains(help.out, "       lray -n 1 -i scene.lrs -o image.ppm\n"));
    EXPECT_EQ(help.err, "");
    const auto version = run({"-version"});
    EXPECT_EQ(version.exit_code, 0);
    EXPECT_TRUE(version.out.starts_with("lray "));
    const auto explained = run({"--explain", "e0401"});
    EXPECT_EQ(explained.exit_code, 0);
    EXPECT_TRUE(explained.out.starts_with("E0401: ")) << explained.out;
    EXPECT_EQ(explained.err, "");
}

TEST_F(EndToEnd, CheckSaysThatThereAreNoErrors) {
    directory_.write("scene.lrs", kScene);
    const auto result = run({"--check", "scene.lrs"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.out, "scene.lrs: no errors\n");
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(directory_.names(), std::vector<std::string>{"scene.lrs"});
}

TEST_F(EndToEnd, CheckOfAWrongSceneExits1) {
    directory_.write("scene.lrs", kWrongScene);
    const auto result = run({"--check", "scene.lrs"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(result.out, "");
    EXPECT_TRUE(contains(result.err, "scene.lrs:2:10: error[E0401]")) << result.err;
    EXPECT_TRUE(result.err.ends_with("1 error\n")) << result.err;
}

TEST_F(EndToEnd, WrongSceneExits1AndTouchesNothing) {
    directory_.write("scene.lrs", kWrongScene);
    directory_.write("image.ppm", "old");
    const auto result = run({"-n", "1", "scene.lrs", "-o", "image.ppm"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(contains(result.err, "did you mean `radius`?")) << result.err;
    EXPECT_TRUE(result.err.ends_with("1 error; nothing rendered\n")) << result.err;
    EXPECT_EQ(directory_.read("image.ppm"), "old");
}

TEST_F(EndToEnd, MissingSceneExits1) {
    const auto result = run({"nowhere.lrs", "-o", "image.ppm"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(contains(result.err, "nowhere.lrs")) << result.err;
    EXPECT_TRUE(directory_.names().empty());
}

TEST_F(EndToEnd, WarningsRenderUnlessDenied) {
    directory_.write("scene.lrs", kSceneWithoutCamera);
    const auto warned = run({"scene.lrs", "-o", "a.ppm", "--size", "64x48"});
    EXPECT_EQ(warned.exit_code, 0);
    EXPECT_TRUE(contains(warned.err, "warning[W1501]")) << warned.err;
    EXPECT_GT(picture("a.ppm").at(32, 24).r, 0.5f) << "the fitted camera looks at the sphere";
    const auto denied = run({"scene.lrs", "-o", "b.ppm", "--deny", "warnings"});
    EXPECT_EQ(denied.exit_code, 1);
    EXPECT_TRUE(contains(denied.err, "1 warning, denied by `--deny`; nothing rendered"))
        << denied.err;
    EXPECT_EQ(directory_.names(), (std::vector<std::string>{"a.ppm", "scene.lrs"}));
    const auto checked = run({"--check", "scene.lrs"});
    EXPECT_EQ(checked.exit_code, 0);
    EXPECT_EQ(checked.out, "scene.lrs: no errors, 1 warning\n");
}

TEST_F(EndToEnd, WrongCommandLinesExit2) {
    directory_.write("scene.lrs", kScene);
    const std::vector<std::vector<std::string>> wrong{
        {},
        {"-n", "1", "scene.lrs"},
        {"-n", "2", "scene.lrs"},
        {"-n", "2", "scene.lrs", "-o", "a.ppm", "-ps", "0"},
        {"scene.lrs", "-o", "a.ppm", "--shading", "phong"},
        {"scene.lrs", "-o", "a.ppm", "--time", "30"},
        {"scene.lrs", "-o", "a.ppm", "--noise", "0"},
        {"scene.lrs", "-o", "a.ppm", "--samples", "0:8", "--time", "1s"},
        {"scene.lrs", "-o", "a.ppm", "-ps", "4", "--samples", "4:8"},
        {"-n", "3", "scene.lrs", "-o", "-"},
        {"scene.lrs", "--frames", "1:3"},
        {"scene.lrs", "-o", "a.gif"},
        {"scene.lrs", "-o", "a.ppm", "--acc", "none"},
        {"scene.lrs", "-o", "a.ppm", "--camera", "top"},
        {"scene.lrs", "-o", "a.ppm", "--crop", "0,0,65,48"},
        {"scene.lrs", "-o", "scene.lrs", "--format", "ppm"},
        {"--explain", "E9999"},
    };
    for (const auto& arguments : wrong) {
        const auto result = run(arguments);
        EXPECT_EQ(result.exit_code, 2) << testing::PrintToString(arguments) << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_TRUE(result.err.starts_with("lray: ")) << result.err;
    }
    EXPECT_EQ(directory_.read("scene.lrs"), kScene);
    EXPECT_EQ(directory_.names(), std::vector<std::string>{"scene.lrs"});
}

TEST_F(EndToEnd, ControlCharactersNeverReachTheTerminal) {
    const auto result = run({"--\x1b[31mred", "scene.lrs"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_FALSE(contains(result.err, "\x1b")) << result.err;
}

TEST_F(EndToEnd, MemoryBeyondItsLimitIsTold) {
    directory_.write("scene.lrs", "let a = range(10000000)\n");
    const auto result = run({"--check", "scene.lrs", "--max-memory", "50000000"});
    EXPECT_EQ(result.exit_code, cli::kCanLimitMemory ? 3 : 0) << result.err;
    EXPECT_EQ(contains(result.err, "not enough memory"), cli::kCanLimitMemory) << result.err;
    EXPECT_EQ(contains(result.err, "`--max-memory N`"), cli::kCanLimitMemory) << result.err;
    const auto enough = run({"--check", "scene.lrs", "--max-memory", "500000000"});
    EXPECT_EQ(enough.exit_code, 0) << enough.err;
}

TEST_F(EndToEnd, FileBeyondTheLimitOfMemoryIsNotCalledUnreadable) {
    directory_.write("scene.lrs", "mesh { file: \"zeros.obj\" }\n");
    directory_.write("zeros.obj", "");
    std::filesystem::resize_file(std::filesystem::path(directory_.path()) / "zeros.obj",
                                 200'000'000);
    const auto result = run({"--check", "scene.lrs", "--max-memory", "50000000"});
    EXPECT_EQ(result.exit_code, cli::kCanLimitMemory ? 3 : 1) << result.err;
    EXPECT_EQ(contains(result.err, "not enough memory"), cli::kCanLimitMemory) << result.err;
    EXPECT_FALSE(contains(result.err, "E0604")) << result.err;
}

TEST_F(EndToEnd, LimitsExit3) {
    directory_.write("scene.lrs", std::string(kScene) + "sphere { radius: 2 }\n");
    const auto pixels = run({"scene.lrs", "-o", "a.ppm", "--max-output-pixels", "3071"});
    EXPECT_EQ(pixels.exit_code, 3);
    EXPECT_TRUE(contains(pixels.err, "3072 pixels; the limit is 3071")) << pixels.err;
    EXPECT_TRUE(contains(pixels.err, "--max-output-pixels")) << pixels.err;
    EXPECT_EQ(run({"scene.lrs", "-o", "a.ppm", "--size", "16385x16384"}).exit_code, 3);
    const auto primitives = run({"scene.lrs", "-o", "a.ppm", "--max-primitives", "1"});
    EXPECT_EQ(primitives.exit_code, 3);
    EXPECT_TRUE(contains(primitives.err, "--max-primitives")) << primitives.err;
    EXPECT_EQ(run({"scene.lrs", "-o", "a.ppm", "--max-scene-bytes", "10"}).exit_code, 3);
    EXPECT_EQ(directory_.names(), std::vector<std::string>{"scene.lrs"});
    EXPECT_EQ(
        run({"scene.lrs", "-o", "a.ppm", "--max-output-pixels", "3072", "--max-primitives", "2"})
            .exit_code,
        0);
}

TEST_F(EndToEnd, OutputThatCannotBeWrittenExits4) {
    directory_.write("scene.lrs", kScene);
    const auto nowhere = run({"scene.lrs", "-o", "no/such/place.ppm"});
    EXPECT_EQ(nowhere.exit_code, 4);
    EXPECT_TRUE(
        contains(nowhere.err, "lray: cannot write `no/such/place.ppm`: there is no directory"))
        << nowhere.err;
    const auto full = run({"scene.lrs", "-o", "/dev/full", "--format", "ppm"});
    EXPECT_EQ(full.exit_code, 4);
    EXPECT_TRUE(contains(full.err, "/dev/full")) << full.err;
    EXPECT_EQ(run({"scene.lrs", "-o", "/dev/full", "--format", "png"}).exit_code, 4);
}

TEST_F(EndToEnd, StdoutThatIsFullOrClosedExits4) {
    directory_.write("scene.lrs", kScene);
    const std::string lray = std::string("'") + LRAY_BINARY + "'";
    for (const std::string arguments : {" --help", " scene.lrs -o -"}) {
        const auto full = test::run_process({"/bin/sh", "-c", lray + arguments + " >/dev/full"}, {},
                                            directory_.path());
        EXPECT_EQ(full.exit_code, 4) << arguments << full.err;
        // The reader is gone before the program starts; its exit code goes to a file.
        const auto closed = test::run_process(
            {"/bin/sh", "-c", "{ sleep 0.2; " + lray + arguments + "; echo $? >code; } | true"}, {},
            directory_.path());
        EXPECT_EQ(directory_.read("code"), "4\n") << arguments << closed.err;
    }
}

TEST_F(EndToEnd, APictureNeverReplacesAFileOfTheScene) {
    const std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    directory_.write("m.obj", mesh);
    directory_.write("scene.lrs", std::string(kScene) + "mesh { file: \"m.obj\" }\n");
    const auto over_mesh = run({"scene.lrs", "-o", "m.obj", "--format", "ppm"});
    EXPECT_EQ(over_mesh.exit_code, 2);
    EXPECT_TRUE(contains(over_mesh.err, "`-o m.obj` would overwrite a file of the scene"))
        << over_mesh.err;
    EXPECT_EQ(directory_.read("m.obj"), mesh);
    const auto over_scene = run({"scene.lrs", "-o", "scene.lrs", "--format", "ppm"});
    EXPECT_EQ(over_scene.exit_code, 2);
    EXPECT_TRUE(contains(over_scene.err, "would overwrite the scene")) << over_scene.err;
}

TEST_F(EndToEnd, SamplesAtLevelOneWarnAndRender) {
    directory_.write("scene.lrs", kScene);
    const auto result = run({"-n", "1", "-ps", "16", "scene.lrs", "-o", "a.ppm"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_TRUE(contains(result.err, "warning: `-ps 16` is ignored")) << result.err;
}

TEST_F(EndToEnd, StatsGoToStderr) {
    directory_.write("scene.lrs", kScene);
    for (const std::string accel : {"none", "spheres", "boxes"}) {
        const auto result = run({"scene.lrs", "-o", "-", "-ps", "2", "--stats", "--accel", accel});
        EXPECT_EQ(result.exit_code, 0);
        EXPECT_TRUE(result.out.starts_with("P6"));
        EXPECT_TRUE(contains(result.err, "1 spheres")) << result.err;
        EXPECT_TRUE(contains(result.err, "hierarchy    " + accel)) << result.err;
        EXPECT_TRUE(contains(result.err, "64 x 48 pixels, 2 samples each")) << result.err;
        EXPECT_TRUE(contains(result.err, "6144 primary")) << result.err;
        const auto machine =
            run({"scene.lrs", "-o", "-", "--stats=json", "--accel", accel, "--quiet"});
        EXPECT_EQ(machine.out.size(), result.out.size());
        const test::Json json = test::read_json(machine.err);
        EXPECT_EQ(json["hierarchy"]["kind"].string, accel);
        EXPECT_EQ(json["rays"]["primary"]["count"].number, 3072.0);
    }
}

}  // namespace
}  // namespace lray
