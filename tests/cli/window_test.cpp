// The window for real: on a virtual display, with keys and mouse.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "image/srgb.h"
#include "tests/cli/lray_test.h"
#include "tests/support/virtual_display.h"
#include "tests/support/wait_until.h"

namespace lray {
namespace {

using namespace std::chrono_literals;
using test::Screenshot;
using test::VirtualDisplay;

constexpr const char* kBall =
    "render { resolution: [400, 300] }\n"
    "camera { position: [0, 0, 10], look_at: [0, 0, 0] }\n"
    "sphere \"ball\" { radius: 2, material: material { diffuse: red } }\n";

class WindowTest : public LrayTest {
 protected:
    void SetUp() override {
        ASSERT_TRUE(VirtualDisplay::is_possible()) << "these tests need Xvfb and xdotool";
        display_ = std::make_unique<VirtualDisplay>();
    }

    /// Starts the program and waits for its first picture. The mouse, and so the keyboard, is in
    /// the window: there is no window manager.
    void open(std::vector<std::string> arguments, std::string_view input = {},
              std::vector<std::string> environment = {}) {
        start(std::move(arguments), input, std::move(environment));
        display_->hands({"search", "--sync", "--onlyvisible", "--name", "lray", "windowmove", "0",
                         "0", "mousemove", "5", "5"});
        EXPECT_TRUE(comes_true([&] { return is_anything_shown(); }));
    }

    void start(std::vector<std::string> arguments, std::string_view input = {},
               std::vector<std::string> environment = {}) {
        // Drivers of OpenGL keep what they have to the end.
        std::vector<std::string> command{"/usr/bin/env", "DISPLAY=" + display_->name(),
                                         "ASAN_OPTIONS=detect_leaks=0"};
        command.insert(command.end(), environment.begin(), environment.end());
        command.emplace_back(LRAY_BINARY);
        command.insert(command.end(), arguments.begin(), arguments.end());
        process_ = std::make_unique<test::Process>(command, input, directory_.path());
    }

    void keys(std::vector<std::string> names) {
        names.insert(names.begin(), "key");
        display_->hands(names);
    }

    void click(int x, int y) {
        display_->hands({"mousemove", std::to_string(x), std::to_string(y), "click", "1"});
    }

    template <class Condition>
    testing::AssertionResult comes_true(Condition condition) {
        bool is_true = false;
        test::wait_until([&] { return (is_true = condition()) || !process_->is_running(); }, 10ms);
        if (is_true) return testing::AssertionSuccess();
        return testing::AssertionFailure()
               << (process_->is_running() ? "not within half a minute: " : "it ended: ")
               << process_->err();
    }

    test::ProcessResult quit() {
        keys({"Escape"});
        return process_->wait();
    }

    bool is_anything_shown() {
        const Screenshot shot = display_->screenshot();
        return std::any_of(shot.bytes.begin(), shot.bytes.end(),
                           [](int byte) { return byte != 0; });
    }

    /// Whether the window comes to show the picture, to the bit.
    testing::AssertionResult comes_to_show(const image::Image& picture) {
        const testing::AssertionResult result = comes_true([&] { return shows(picture); });
        if (result) return result;
        return testing::AssertionFailure() << result.message() << difference(picture);
    }

    bool shows(const image::Image& picture) { return difference(picture).empty(); }

    /// The first pixel that the window shows otherwise, in words; empty if there is none.
    std::string difference(const image::Image& picture) {
        const Screenshot shot = display_->screenshot();
        for (std::uint32_t y = 0; y < picture.height; ++y) {
            for (std::uint32_t x = 0; x < picture.width; ++x) {
                const std::uint8_t* const shown = shot.pixel(x, y);
                const Color& pixel = picture.at(x, y);
                for (int channel = 0; channel < 3; ++channel) {
                    const int wanted = image::srgb_encode_8(pixel[channel]);
                    if (shown[channel] == wanted) continue;
                    return "pixel " + std::to_string(x) + ", " + std::to_string(y) + ", channel " +
                           std::to_string(channel) + ": " + std::to_string(shown[channel]) +
                           " instead of " + std::to_string(wanted);
                }
            }
        }
        return {};
    }

    /// What the program writes for the same scene, as a PPM picture.
    image::Image rendered(std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"-o", "expected.ppm"});
        const auto result = run(std::move(arguments));
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return picture("expected.ppm");
    }

    /// Presses C until the camera that is printed rests, and returns it: a tap takes its time.
    std::string camera() {
        std::string now = printed_camera();
        for (std::string before; before != now;) {
            before = now;
            std::this_thread::sleep_for(60ms);
            now = printed_camera();
        }
        return now;
    }

    std::string printed_camera() {
        const std::size_t before = process_->out().size();
        keys({"c"});
        EXPECT_TRUE(comes_true([&] { return process_->out().size() > before; }));
        EXPECT_TRUE(comes_true([&] { return process_->out().ends_with("}\n"); }));
        return process_->out().substr(before);
    }

    /// The numbers of a property of a printed camera.
    static std::vector<double> numbers(const std::string& camera, const std::string& name) {
        std::vector<double> values(3, 0.0);
        const std::size_t at = camera.find(name + ": [");
        EXPECT_NE(at, camera.npos) << camera;
        if (at == camera.npos) return values;
        const std::string text = camera.substr(at + name.size());
        EXPECT_EQ(std::sscanf(text.c_str(), ": [%lf, %lf, %lf", &values[0], &values[1], &values[2]),
                  3);
        return values;
    }

    std::unique_ptr<VirtualDisplay> display_;
    std::unique_ptr<test::Process> process_;
};

TEST_F(WindowTest, ShowsThePictureOfTheSameSamplesToTheBit) {
    directory_.write("scene.lrs", kScene);
    open({"-n", "3", "-ps", "5", "--size", "200x150", "-i", "scene.lrs"});
    keys({"i"});
    const image::Image expected =
        rendered({"-n", "2", "-ps", "5", "--size", "200x150", "-i", "scene.lrs"});
    EXPECT_TRUE(comes_to_show(expected));
    const auto result = quit();
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "");
}

TEST_F(WindowTest, OldOpenGlShowsTheSame) {
    directory_.write("scene.lrs", kScene);
    const image::Image expected =
        rendered({"-n", "2", "-ps", "2", "--size", "200x150", "-i", "scene.lrs"});
    // Without shaders, without pixel buffers, without textures of any size.
    for (const char* version : {"2.1", "2.0", "1.4"}) {
        open({"-ps", "2", "--size", "200x150", "scene.lrs"}, {},
             {std::string("MESA_GL_VERSION_OVERRIDE=") + version});
        keys({"i"});
        EXPECT_TRUE(comes_to_show(expected)) << version;
        EXPECT_EQ(quit().exit_code, 0);
    }
}

TEST_F(WindowTest, SavesWhatItShows) {
    directory_.write("scene.lrs", kScene);
    open({"-ps", "3", "--stats=json", "scene.lrs"});
    const image::Image expected = rendered({"-n", "2", "-ps", "3", "scene.lrs"});
    keys({"i"});
    EXPECT_TRUE(comes_to_show(expected));
    keys({"p"});
    EXPECT_TRUE(
        comes_true([&] { return std::filesystem::exists(directory_.path("scene-001.png")); }));
    keys({"p"});
    EXPECT_TRUE(
        comes_true([&] { return std::filesystem::exists(directory_.path("scene-002.png")); }));
    const auto result = quit();
    EXPECT_EQ(picture("scene-001.png").pixels, expected.pixels);
    EXPECT_TRUE(contains(result.err, "\"passes\":3")) << result.err;
}

TEST_F(WindowTest, SavesToItsOutputAndWritesNothingBefore) {
    directory_.write("scene.lrs", kScene);
    open({"-n", "3", "-i", "scene.lrs", "-o", "out.ppm"});
    EXPECT_FALSE(std::filesystem::exists(directory_.path("out.ppm")));
    keys({"p"});
    EXPECT_TRUE(comes_true([&] { return std::filesystem::exists(directory_.path("out.ppm")); }));
    EXPECT_EQ(quit().exit_code, 0);
    EXPECT_EQ(picture("out.ppm").width, 64u);
}

TEST_F(WindowTest, ArrowsGoForwardBackAndTurn) {
    directory_.write("scene.lrs", kBall);
    open({"scene.lrs"});
    keys({"Up"});
    const std::string forward = camera();
    EXPECT_LT(numbers(forward, "position")[2], 9.99);
    keys({"Home", "Down"});
    EXPECT_GT(numbers(camera(), "position")[2], 10.01);
    keys({"Home", "Left"});
    EXPECT_LT(numbers(camera(), "look_at")[0], -0.1);
    keys({"Home", "Right"});
    EXPECT_GT(numbers(camera(), "look_at")[0], 0.1);
    keys({"Home"});
    EXPECT_EQ(numbers(camera(), "position")[2], 10.0);
    quit();
}

TEST_F(WindowTest, AKeyHeldLongerLeadsFarther) {
    directory_.write("scene.lrs", kBall);
    open({"scene.lrs"});
    keys({"Up"});
    const double tap = 10.0 - numbers(camera(), "position")[2];
    keys({"Home"});
    display_->hands({"keydown", "Up", "sleep", "0.6", "keyup", "Up"});
    EXPECT_GT(10.0 - numbers(camera(), "position")[2], tap);
    quit();
}

TEST_F(WindowTest, TheMouseTurnsTheScene) {
    directory_.write("scene.lrs", kBall);
    open({"scene.lrs"});
    display_->hands({"mousemove", "200", "250", "mousedown", "1", "mousemove", "250", "250",
                     "mousemove", "280", "250", "mouseup", "1"});
    const std::string orbited = camera();
    EXPECT_LT(numbers(orbited, "position")[0], -1.0);
    EXPECT_EQ(numbers(orbited, "look_at")[0], 0.0);
    display_->hands({"click", "4"});
    const std::string closer = camera();
    EXPECT_LT(numbers(closer, "position")[2], numbers(orbited, "position")[2]);
    quit();
}

TEST_F(WindowTest, AnEditorsSaveIsShown) {
    directory_.write("scene.lrs", "include \"ball.lrs\"\ncamera { position: [0, 0, 10] }\n");
    directory_.write("ball.lrs", "sphere { radius: 2, material: material { diffuse: red } }\n");
    open({"--size", "400x300", "scene.lrs"});
    const auto is_colored = [&](int channel) {
        const Screenshot shot = display_->screenshot();
        const std::uint8_t* const pixel = shot.pixel(200, 180);
        return pixel[channel] > 200 && pixel[2 - channel] < 50;
    };
    EXPECT_TRUE(comes_true([&] { return is_colored(0); }));
    // Another file takes its name, as editors do.
    directory_.write("ball.lrs~", "sphere { radius: 2, material: material { diffuse: blue } }\n");
    std::filesystem::rename(directory_.path("ball.lrs~"), directory_.path("ball.lrs"));
    EXPECT_TRUE(comes_true([&] { return is_colored(2); }));
    EXPECT_EQ(quit().exit_code, 0);
}

TEST_F(WindowTest, ASavedNffFileIsShown) {
    const auto ball = [](const char* color) {
        return std::string(
                   "v from 0 0 10 at 0 0 0 up 0 1 0 angle 45 hither 1 resolution 400 300\n"
                   "l 0 0 9\nf ") +
               color + " 1 0 1 0 1\ns 0 0 0 2\n";
    };
    directory_.write("ball.nff", ball("1 0 0"));
    open({"ball.nff"});
    const auto is_colored = [&](int channel) {
        const Screenshot shot = display_->screenshot();
        const std::uint8_t* const pixel = shot.pixel(200, 180);
        return pixel[channel] > 150 && pixel[2 - channel] < 50;
    };
    EXPECT_TRUE(comes_true([&] { return is_colored(0); }));
    directory_.write("ball.nff", ball("0 0 nothing"));
    EXPECT_TRUE(
        comes_true([&] { return contains(process_->err(), "ball.nff:3:7: error[E0706]"); }));
    directory_.write("ball.nff", ball("0 0 1"));
    EXPECT_TRUE(comes_true([&] { return is_colored(2); }));
    EXPECT_EQ(quit().exit_code, 0);
}

TEST_F(WindowTest, AMistakeIsShownOverThePictureAndToldInTheTerminal) {
    directory_.write("scene.lrs", kBall);
    open({"-ps", "2", "scene.lrs"});
    keys({"i"});
    const image::Image good = rendered({"-n", "2", "-ps", "2", "scene.lrs"});
    EXPECT_TRUE(comes_to_show(good));
    directory_.write("scene.lrs", "sphere { radus: 1 }\n");
    EXPECT_TRUE(comes_true([&] { return contains(process_->err(), "did you mean `radius`?"); }));
    EXPECT_TRUE(comes_true([&] { return !shows(good); }));
    const Screenshot shot = display_->screenshot();
    const std::uint8_t* const ball = shot.pixel(200, 205);
    EXPECT_GT(ball[0], 30) << "the old picture is still there, below or beside the panel";
    directory_.write("scene.lrs", kBall);
    EXPECT_TRUE(comes_to_show(good));
    EXPECT_EQ(quit().exit_code, 0);
}

TEST_F(WindowTest, AClickTellsNameAndPlace) {
    directory_.write("scene.lrs", kBall);
    open({"scene.lrs"});
    click(200, 150);
    EXPECT_TRUE(
        comes_true([&] { return contains(process_->out(), "scene.lrs:3:1: sphere `ball`\n"); }));
    quit();
}

TEST_F(WindowTest, ViewsAreStoredInAFileAndRecalled) {
    directory_.write("scene.lrs", kBall);
    open({"scene.lrs"});
    keys({"Up"});
    const std::string stored = camera();
    keys({"shift+F2"});
    EXPECT_TRUE(
        comes_true([&] { return std::filesystem::exists(directory_.path("scene.views.lrs")); }));
    keys({"Home"});
    EXPECT_NE(camera(), stored);
    keys({"F2"});
    EXPECT_EQ(camera(), stored);
    quit();
    EXPECT_TRUE(contains(directory_.read("scene.views.lrs"), "camera \"view 2\""));
    open({"scene.lrs"});
    keys({"F2"});
    EXPECT_EQ(camera(), stored);
    quit();
}

TEST_F(WindowTest, ASliderEvaluatesTheSceneAnew) {
    directory_.write("scene.lrs", std::string("param count = 1 in [1, 3]\n") + kBall +
                                      "for i in range(1, count) {\n"
                                      "  sphere { center: [0, 2.5 * i, 0] }\n}\n");
    open({"-ps", "2", "scene.lrs"});
    keys({"i"});
    const image::Image one = rendered({"-n", "2", "-ps", "2", "scene.lrs"});
    const image::Image two = rendered({"-n", "2", "-ps", "2", "-D", "count=2", "scene.lrs"});
    EXPECT_TRUE(comes_to_show(one));
    keys({"shift+Right"});
    EXPECT_TRUE(comes_to_show(two));
    quit();
}

TEST_F(WindowTest, ASceneFromStdinIsShown) {
    open({"-i", "-", "-ps", "2"}, kScene);
    keys({"i"});
    directory_.write("scene.lrs", kScene);
    const image::Image expected = rendered({"-n", "2", "-ps", "2", "scene.lrs"});
    EXPECT_TRUE(comes_to_show(expected));
    EXPECT_EQ(quit().exit_code, 0);
}

TEST_F(WindowTest, TheButtonOfTheWindowClosesIt) {
    directory_.write("scene.lrs", kScene);
    open({"scene.lrs"});
    display_->ask_to_close("scene.lrs");
    const auto result = process_->wait();
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
}

TEST_F(WindowTest, SignalsEndItWithTheirCodes) {
    directory_.write("scene.lrs", kScene);
    for (const auto& [signal, code] : {std::pair{SIGINT, 130}, {SIGTERM, 143}}) {
        open({"scene.lrs"});
        process_->send_signal(signal);
        EXPECT_EQ(process_->wait().exit_code, code);
    }
}

TEST_F(WindowTest, ADisplayThatGoesAwayIsToldAndExits5) {
    directory_.write("scene.lrs", kScene);
    open({"scene.lrs"});
    display_->vanish();
    const auto result = process_->wait();
    EXPECT_EQ(result.exit_code, 5);
    EXPECT_TRUE(contains(result.err, "the display went away")) << result.err;
}

TEST_F(WindowTest, AKilledConnectionIsToldAndExits5) {
    directory_.write("scene.lrs", kScene);
    open({"scene.lrs"});
    display_->hands({"search", "--name", "lray", "windowkill"});
    const auto result = process_->wait();
    EXPECT_EQ(result.exit_code, 5);
    EXPECT_TRUE(contains(result.err, "the display went away")) << result.err;
}

TEST_F(WindowTest, AMistakeAtTheStartIsToldWithoutAWindow) {
    directory_.write("scene.lrs", "sphere { radus: 1 }\n");
    start({"scene.lrs"});
    const auto result = process_->wait();
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(contains(result.err, "did you mean `radius`?")) << result.err;
}

TEST_F(WindowTest, AnOutputThatCannotBeIsToldAtTheStart) {
    directory_.write("scene.lrs", kScene);
    start({"-n", "3", "-i", "scene.lrs", "-o", "scene.lrs", "--format", "ppm"});
    auto result = process_->wait();
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_TRUE(contains(result.err, "would overwrite the scene")) << result.err;
    start({"-n", "3", "-i", "scene.lrs", "-o", "no/such/directory.png"});
    result = process_->wait();
    EXPECT_EQ(result.exit_code, 4) << result.err;
    EXPECT_EQ(directory_.names(), (std::vector<std::string>{"scene.lrs"}));
}

class NoDisplay : public LrayTest {
 protected:
    test::ProcessResult run_without(std::vector<std::string> arguments,
                                    const std::string& display) {
        std::vector<std::string> command{"/usr/bin/env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY"};
        if (!display.empty()) command.push_back("DISPLAY=" + display);
        command.emplace_back(LRAY_BINARY);
        command.insert(command.end(), arguments.begin(), arguments.end());
        return test::run_process(command, {}, directory_.path());
    }
};

TEST_F(NoDisplay, IsToldAndExits5) {
    directory_.write("scene.lrs", kScene);
    for (const char* display : {"", ":4321", "nowhere.invalid:0"}) {
        const auto result = run_without({"scene.lrs"}, display);
        EXPECT_EQ(result.exit_code, 5) << display;
        EXPECT_TRUE(contains(result.err, "there is no display for a window")) << result.err;
        EXPECT_TRUE(contains(result.err, "-o image.png")) << result.err;
    }
}

TEST_F(NoDisplay, IsNoneOfTheBusinessOfPictures) {
    directory_.write("scene.lrs", kScene);
    EXPECT_EQ(run_without({"-n", "1", "scene.lrs", "-o", "1.ppm"}, "").exit_code, 0);
    EXPECT_EQ(run_without({"-n", "2", "scene.lrs", "-o", "2.ppm"}, "").exit_code, 0);
    EXPECT_EQ(run_without({"scene.lrs", "-o", "3.ppm"}, "").exit_code, 0);
    EXPECT_EQ(run_without({"--check", "scene.lrs"}, "").exit_code, 0);
}

}  // namespace
}  // namespace lray
