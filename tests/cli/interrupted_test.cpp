// The program when it is told to stop: what it writes, and how it exits.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <optional>
#include <thread>

#include "tests/cli/lray_test.h"

namespace lray {
namespace {

/// A picture that takes minutes without a hierarchy, and the program at work on it.
class Interrupted : public LrayTest {
 protected:
    void start() {
        begin(20'000, "none");
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
    }

    /// Returns when the hierarchy is about to be built.
    void begin(int sphere_count, const std::string& accel) {
        std::string scene = kScene;
        for (int i = 0; i < sphere_count; ++i) {
            scene += "sphere { radius: 0.5, center: [0, 0, -" + std::to_string(i) + "] }\n";
        }
        begin_scene(scene, accel);
    }

    void begin_scene(const std::string& scene, const std::string& accel) {
        directory_.write("scene.lrs", scene);
        directory_.write("image.png", "old");
        process_.emplace(
            std::vector<std::string>{LRAY_BINARY, "-n", "1", "--accel", accel, "--threads", "1",
                                     "scene.lrs", "-o", "image.png", "--size", "2000x2000"},
            std::string_view{}, directory_.path());
        // Then the output is opened: a temporary file appears beside it.
        for (int i = 0; i < 6000 && directory_.names().size() < 3; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        ASSERT_GE(directory_.names().size(), 3u) << "the render did not begin";
    }

    void expect_partial_picture(const test::ProcessResult& result) {
        EXPECT_TRUE(contains(result.err, "image.partial.png")) << result.err;
        EXPECT_TRUE(contains(result.err, "without a hierarchy")) << result.err;
        EXPECT_EQ(directory_.read("image.png"), "old");
        EXPECT_EQ(directory_.names(),
                  (std::vector<std::string>{"image.partial.png", "image.png", "scene.lrs"}));
        EXPECT_EQ(picture("image.partial.png").width, 2000u);
    }

    std::optional<test::Process> process_;
};

TEST_F(Interrupted, ControlCWritesWhatThereIsAndExits130) {
    start();
    process_->send_signal(SIGINT);
    const auto result = process_->wait();
    EXPECT_EQ(result.exit_code, 130);
    expect_partial_picture(result);
}

TEST_F(Interrupted, WhileTheHierarchyIsBuiltThereIsNothingToWrite) {
    begin(200'000, "spheres");
    process_->send_signal(SIGINT);
    const auto result = process_->wait();
    EXPECT_EQ(result.exit_code, 130);
    EXPECT_TRUE(contains(result.err, "lray: interrupted; nothing was written")) << result.err;
    EXPECT_EQ(directory_.read("image.png"), "old");
    EXPECT_EQ(directory_.names(), (std::vector<std::string>{"image.png", "scene.lrs"}));
}

/// Things of two things each, one within the other: the first ray meets 2^60 in one place.
TEST_F(Interrupted, ControlCEndsARayThatMeetsInstancesWithoutEnd) {
    std::string scene = kScene;
    scene += "let thing0 = group { sphere { radius: 1 } box { size: [1, 1, 1] } }\n";
    for (int i = 1; i <= 60; ++i) {
        const std::string inner = "thing" + std::to_string(i - 1);
        scene +=
            "let thing" + std::to_string(i) + " = group { " + inner + " { } " + inner + " { } }\n";
    }
    begin_scene(scene + "thing60 { }\n", "boxes");
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    process_->send_signal(SIGINT);
    EXPECT_EQ(process_->wait().exit_code, 130);
}

TEST_F(Interrupted, TerminationWritesWhatThereIsAndExits143) {
    start();
    process_->send_signal(SIGTERM);
    const auto result = process_->wait();
    EXPECT_EQ(result.exit_code, 143);
    expect_partial_picture(result);
}

}  // namespace
}  // namespace lray
