// Renders that are interrupted and go on: --resume.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "base/output_file.h"
#include "render/film_file.h"
#include "tests/cli/lray_test.h"

namespace lray {
namespace {

/// Seconds of work: soft shadows of many samples.
constexpr const char* kSlowScene =
    "render { resolution: [96, 72] }\n"
    "camera { position: [0, 1, 5], look_at: [0, 0, 0] }\n"
    "area_light { corner: [-1, 4, -1], edge_u: [2, 0, 0], edge_v: [0, 0, 2], samples: 100 }\n"
    "sphere { radius: 1 }\n"
    "plane { point: [0, -1, 0] }\n";

class Resume : public LrayTest {
 protected:
    Resume() { directory_.write("scene.lrs", kSlowScene); }

    std::vector<std::string> command(std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments{"scene.lrs", "-o",           "image.png", "-ps",
                                           "8",         "--save-every", "10ms",      "--resume"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }

    /// The picture that is made without a break.
    std::string whole() {
        EXPECT_EQ(run({"scene.lrs", "-o", "whole.png", "-ps", "8"}).exit_code, 0);
        return directory_.read("whole.png");
    }

    /// Starts the render and sends a signal once a state was saved.
    test::ProcessResult interrupt(int signal_number) {
        std::vector<std::string> arguments = command({"--threads", "1"});
        arguments.insert(arguments.begin(), LRAY_BINARY);
        test::Process process(arguments, {}, directory_.path());
        for (int i = 0; i < 6000 && !exists("image.png.state") && process.is_running(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        process.send_signal(signal_number);
        const auto result = process.wait();
        EXPECT_TRUE(exists("image.png.state"));
        EXPECT_FALSE(exists("image.png")) << "it was not interrupted";
        return result;
    }

    bool exists(std::string_view name) const {
        return std::filesystem::exists(directory_.path(name));
    }

    void expect_goes_on() {
        const auto result = run(command());
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_TRUE(directory_.read("image.png") == whole());
        EXPECT_FALSE(exists("image.png.state")) << "nothing is left to do";
    }
};

TEST_F(Resume, GoesOnAfterAKill) {
    EXPECT_EQ(interrupt(SIGKILL).exit_code, 128 + SIGKILL);
    EXPECT_EQ(interrupt(SIGKILL).exit_code, 128 + SIGKILL);
    expect_goes_on();
}

TEST_F(Resume, GoesOnAfterControlC) {
    const auto result = interrupt(SIGINT);
    EXPECT_EQ(result.exit_code, 130);
    EXPECT_TRUE(contains(result.err, "image.partial.png")) << result.err;
    EXPECT_TRUE(contains(result.err, "lray: note: the same command goes on from `image.png.state`"))
        << result.err;
    expect_goes_on();
}

TEST_F(Resume, WithoutAStateItBegins) {
    expect_goes_on();
}

TEST_F(Resume, CommentsThreadsAndHierarchyMayBeOthers) {
    interrupt(SIGKILL);
    directory_.write("scene.lrs", std::string("// the same scene\n") + kSlowScene);
    const auto result = run(command({"--threads", "2", "--accel", "spheres"}));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(contains(result.err, "lray: note: going on from `image.png.state`, which has "))
        << result.err;
    EXPECT_TRUE(directory_.read("image.png") == whole());
}

TEST_F(Resume, MoreSamplesAreAddedToThoseThere) {
    interrupt(SIGKILL);
    ASSERT_EQ(run(command({"-ps", "9"})).exit_code, 0);
    ASSERT_EQ(run({"scene.lrs", "-o", "whole.png", "-ps", "9"}).exit_code, 0);
    EXPECT_TRUE(directory_.read("image.png") == directory_.read("whole.png"));
}

TEST_F(Resume, TheStateOfAnotherPictureIsRefusedAndKept) {
    interrupt(SIGKILL);
    const std::string state = directory_.read("image.png.state");
    const auto seed = run(command({"--seed", "9"}));
    EXPECT_EQ(seed.exit_code, 2);
    EXPECT_EQ(seed.err,
              "lray: the state `image.png.state` is of another picture: they differ in the seed: 9 "
              "and 0\n"
              "  remove it to begin anew, or give the output another name\n");
    directory_.write("scene.lrs", std::string(kSlowScene) + "sphere { radius: 0.1 }\n");
    const auto scene = run(command());
    EXPECT_EQ(scene.exit_code, 2);
    EXPECT_TRUE(contains(scene.err, "they differ in what is in the scene")) << scene.err;
    EXPECT_TRUE(directory_.read("image.png.state") == state);
}

TEST_F(Resume, APictureOfTheSceneCounts) {
    directory_.write("scene.lrs", std::string(kSlowScene) + "mesh { file: \"a.obj\" }\n");
    directory_.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    interrupt(SIGKILL);
    directory_.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n");
    const auto result = run(command());
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_TRUE(contains(result.err, "they differ in the meshes and pictures of the scene"))
        << result.err;
}

TEST_F(Resume, ADamagedStateIsRefused) {
    interrupt(SIGKILL);
    std::string state = directory_.read("image.png.state");
    state[state.size() / 2] = static_cast<char>(state[state.size() / 2] ^ 1);
    directory_.write("image.png.state", state);
    const auto result = run(command());
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_EQ(result.err,
              "lray: the state `image.png.state` cannot be used: this film is damaged\n"
              "  remove it to begin anew\n");
}

TEST_F(Resume, AFilmOfAnotherSizeIsRefusedWhateverItSaysOfItself) {
    directory_.write("scene.lrs", kScene);
    ASSERT_EQ(run({"scene.lrs", "-o", "a.film", "-ps", "2"}).exit_code, 0);
    const std::string bytes = directory_.read("a.film");
    std::string error;
    const auto stored = render::read_film(std::as_bytes(std::span(bytes)), 10'000, error);
    ASSERT_TRUE(stored) << error;
    for (const render::Film& film :
         {render::Film(3, 3), render::Film(64, 48, render::Film::Keeps::squares)}) {
        auto out = OutputFile::open(directory_.path("image.png.state"), error);
        ASSERT_TRUE(out && render::write_film(*out, stored->description, film) && out->commit());
        const auto result = run({"scene.lrs", "-o", "image.png", "-ps", "2", "--resume"});
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_EQ(result.err,
                  "lray: the state `image.png.state` is of another picture: they differ in size\n"
                  "  remove it to begin anew, or give the output another name\n");
    }
}

TEST_F(Resume, FewerSamplesThanThereAreRefused) {
    interrupt(SIGKILL);
    const auto result = run(command({"-ps", "1"}));
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_TRUE(contains(result.err, "samples of some pixels already, more than the 1 asked for"))
        << result.err;
}

TEST_F(Resume, TimeAddsToWhatTimeLeft) {
    const std::vector<std::string> timed{"scene.lrs", "-o",     "image.png", "-ps",
                                         "5",         "--time", "1ms",       "--resume"};
    const auto first = run(timed);
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_TRUE(contains(first.err, "goes on from `image.png.state`")) << first.err;
    int runs = 1;
    for (; runs < 10 && exists("image.png.state"); ++runs) ASSERT_EQ(run(timed).exit_code, 0);
    EXPECT_GT(runs, 1);
    ASSERT_EQ(run({"scene.lrs", "-o", "whole.png", "-ps", "5"}).exit_code, 0);
    EXPECT_TRUE(directory_.read("image.png") == directory_.read("whole.png"));
}

TEST_F(Resume, FramesThatAreDoneAreNotRenderedAgain) {
    directory_.write("scene.lrs", std::string(kScene) +
                                      "animation { frames: 3 }\n"
                                      "sphere { radius: 0.2, center: [frame, 1, 0] }\n"
                                      "if frame == 2 { mesh { file: \"late.obj\" } }\n");
    const std::vector<std::string> frames{"scene.lrs", "-o",  "out-#.png",
                                          "--frames",  "0:2", "--resume"};
    EXPECT_EQ(run(frames).exit_code, 1) << "frame 2 lacks its mesh";
    EXPECT_TRUE(exists("out-0.png.state"));
    EXPECT_LT(std::filesystem::file_size(directory_.path("out-0.png.state")), 3000u);
    directory_.write("out-0.png", "not rendered again");
    std::filesystem::remove(directory_.path("out-1.png"));
    directory_.write("late.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto result = run(frames);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(directory_.read("out-0.png"), "not rendered again");
    EXPECT_TRUE(exists("out-1.png")) << "its picture was gone";
    EXPECT_EQ(directory_.names(), (std::vector<std::string>{"late.obj", "out-0.png", "out-1.png",
                                                            "out-2.png", "scene.lrs"}));
}

TEST_F(Resume, AFrameThatIsDoneOtherwiseIsRenderedAnew) {
    const std::string scene = std::string(kScene) +
                              "animation { frames: 2 }\n"
                              "if frame == 1 { mesh { file: \"late.obj\" } }\n";
    std::string brighter = scene;
    brighter.replace(brighter.find("render {"), 8, "render { exposure: 1,");
    const auto resume = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments{"scene.lrs", "-o",  "out-#.png",
                                           "--frames",  "0:1", "--resume"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    };
    const auto expect_anew = [&](std::vector<std::string> more) {
        directory_.write("out-0.png", "of the run before");
        EXPECT_EQ(resume(more).exit_code, 1) << "frame 1 lacks its mesh";
        more.insert(more.end(), {"scene.lrs", "-o", "whole.png", "--frame", "0"});
        EXPECT_EQ(run(more).exit_code, 0);
        EXPECT_TRUE(directory_.read("out-0.png") == directory_.read("whole.png")) << more.front();
    };
    directory_.write("scene.lrs", scene);
    EXPECT_EQ(resume({"-ps", "2"}).exit_code, 1);
    expect_anew({"-ps", "3"});
    expect_anew({"-ps", "3", "--png-bits", "16"});
    directory_.write("scene.lrs", brighter);
    expect_anew({"-ps", "3"});
    const auto fewer = resume({"-ps", "2"});
    EXPECT_EQ(fewer.exit_code, 2);
    EXPECT_TRUE(contains(fewer.err, "has 3 samples of some pixels already, more than the 2"))
        << fewer.err;
}

TEST_F(Resume, StdoutIsAUsageError) {
    const auto result = run({"scene.lrs", "-o", "-", "--resume"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_TRUE(contains(result.err, "`--resume` cannot go on with what was written to stdout"))
        << result.err;
}

}  // namespace
}  // namespace lray
