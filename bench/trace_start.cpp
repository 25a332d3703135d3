// How long a program takes to begin to answer.
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "bench/processor_time.h"
#include "bench/trace_modes.h"

namespace lray::bench {

namespace {

constexpr const char* kScene =
    "lrs 1.0\n"
    "render { resolution: [1, 1] }\n"
    "camera { position: [0, 0, 5], look_at: [0, 0, 0], fov: 40 }\n"
    "sphere { radius: 1 }\n";

/// In milliseconds since before the process was there.
struct Start {
    double first_byte = 0.0;
    double end = 0.0;
};

/// Runs `lray -n 1 -i SCENE -o -`; empty if that fails.
std::optional<Start> run_once(const std::string& lray_path, const std::string& scene_path) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return std::nullopt;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    std::array<std::string, 7> words{lray_path, "-n", "1", "-i", scene_path, "-o", "-"};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);

    pid_t child = 0;
    const double begin = wall_seconds();
    const int error =
        posix_spawnp(&child, lray_path.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    char byte = 0;
    const bool has_answered = error == 0 && read(ends[0], &byte, 1) == 1;
    const double first_byte = wall_seconds() - begin;
    while (error == 0 && read(ends[0], &byte, 1) == 1) {
    }
    close(ends[0]);
    int status = 1;
    if (error == 0) waitpid(child, &status, 0);
    const double end = wall_seconds() - begin;
    if (!has_answered || status != 0) return std::nullopt;
    return Start{1e3 * first_byte, 1e3 * end};
}

void print_row(const char* what, std::vector<double> milliseconds) {
    std::sort(milliseconds.begin(), milliseconds.end());
    fmt::print("  {:<12}{:>10.2f} {:>10.2f}\n", what, milliseconds.front(),
               milliseconds[milliseconds.size() / 2]);
}

}  // namespace

bool measure_start(const std::string& lray_path, int repeat_count) {
    const std::string scene_path =
        (std::filesystem::temp_directory_path() / fmt::format("trace_start-{}.lrs", getpid()))
            .string();
    std::ofstream(scene_path) << kScene;
    std::vector<double> first_bytes;
    std::vector<double> ends;
    for (int i = 0; i < repeat_count; ++i) {
        const auto start = run_once(lray_path, scene_path);
        if (!start) {
            fmt::print(stderr, "{}: cannot be run, or made no picture\n", lray_path);
            break;
        }
        first_bytes.push_back(start->first_byte);
        ends.push_back(start->end);
    }
    std::remove(scene_path.c_str());
    if (static_cast<int>(ends.size()) < repeat_count) return false;
    fmt::print("{}: a picture of one pixel, {} times, wall ms\n", lray_path, repeat_count);
    fmt::print("  {:<12}{:>10} {:>10}\n", "", "best", "median");
    print_row("first byte", first_bytes);
    print_row("end", ends);
    fmt::print("target: the first byte within 30 ms\n");
    return true;
}

}  // namespace lray::bench
