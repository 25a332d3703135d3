// How fast scenes and meshes are read, and in how much memory, beside merely reading the bytes.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/diagnostic_printer.h"
#include "base/diagnostics.h"
#include "base/file_access.h"
#include "base/source.h"
#include "parser/load.h"
#include "parser/tools/format.h"
#include "scene/formats/read_mesh.h"

namespace {

using namespace lray;

constexpr std::string_view kUsage =
    "usage: read_speed [--repeat K] FILE...\n"
    "  Reads each .lrs or mesh file K times (5) on one thread; in seconds of processor time\n"
    "  bytes   the file into memory, nothing else\n"
    "  scene   .lrs: parser::load; .obj, .ply: the bytes and scene::read_mesh\n"
    "  format  .lrs: the bytes and parser::format\n"
    "  peak    of the process (VmHWM) after the first time; beyond: of that, more than before\n"
    "          and than the text\n";

constexpr double kMega = 1e6;

/// Returns a line of /proc/self/status in bytes; 0 where there is none.
std::uint64_t memory_of_process(std::string_view name) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with(name)) {
            return std::strtoull(line.c_str() + name.size(), nullptr, 10) * 1024;
        }
    }
    return 0;
}

bool read_bytes(const char* path) {
    FileAccess files;
    const ReadResult result = files.read_main(path, std::numeric_limits<std::uint32_t>::max());
    return result.status == ReadStatus::ok;
}

/// Keeps what the reader made until all is measured: freeing is no part of reading.
struct Outcome {
    Sources sources{};
    Diagnostics diagnostics{};
    std::optional<scene::Scene> scene{};
    std::optional<scene::Mesh> mesh{};
};

bool read_scene(const char* path, Outcome& outcome) {
    FileAccess files;
    if (std::string_view(path).ends_with(".lrs")) {
        outcome.scene = parser::load(path, {}, files, outcome.sources, outcome.diagnostics).scene;
        return outcome.scene.has_value();
    }
    ReadResult result = files.read_main(path, std::numeric_limits<std::uint32_t>::max());
    if (result.status != ReadStatus::ok) return false;
    const SourceId file = outcome.sources.add(path, std::move(result.text));
    const scene::MeshFormat format = scene::mesh_format_of(path).value_or(scene::MeshFormat::obj);
    outcome.mesh = scene::read_mesh(format, outcome.sources, file, Span{}, {}, outcome.diagnostics);
    return outcome.mesh.has_value();
}

bool format_scene(const char* path) {
    FileAccess files;
    Sources sources;
    Diagnostics diagnostics;
    return parser::format_file(path, {}, files, sources, diagnostics).has_value();
}

/// Returns the processor time that this process has used: what else the machine does is not in it.
double used_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void print_row(std::string_view what, std::uint64_t size, std::vector<double> seconds,
               std::string_view memory) {
    std::sort(seconds.begin(), seconds.end());
    const double best = seconds.front();
    const double median = seconds[seconds.size() / 2];
    const double megabytes = static_cast<double>(size) / kMega;
    fmt::print("  {:<6} {:>9.4f} {:>9.4f} {:>8.0f} {:>8.0f}  {}\n", what, best, median,
               megabytes / best, megabytes / median, memory);
}

/// Prints the table of one file; false if it cannot be read.
bool measure(const char* path, int repeat_count) {
    std::uint64_t size = 0;
    {
        FileAccess files;
        const ReadResult result = files.read_main(path, std::numeric_limits<std::uint32_t>::max());
        if (result.status != ReadStatus::ok) {
            fmt::print(stderr, "{}: cannot be read {}\n", path, result.reason);
            return false;
        }
        size = result.text.size();
    }
    const std::uint64_t before = memory_of_process("VmRSS:");
    std::ofstream("/proc/self/clear_refs") << "5";  // the peak begins anew: proc(5)

    std::vector<double> scene_seconds;
    std::string memory;
    for (int i = 0; i < repeat_count; ++i) {
        Outcome outcome;
        const double begin = used_seconds();
        const bool is_read = read_scene(path, outcome);
        scene_seconds.push_back(used_seconds() - begin);
        if (!is_read) {
            fmt::print(stderr, "{}{}: cannot be read\n",
                       format_diagnostics(outcome.diagnostics, outcome.sources, {}), path);
            return false;
        }
        if (i == 0) {
            const std::uint64_t peak = memory_of_process("VmHWM:");
            const double beyond = static_cast<double>(peak) - static_cast<double>(before + size);
            memory = fmt::format("peak {:.1f} MB, beyond the text {:.1f} MB = {:.2f} x text",
                                 static_cast<double>(peak) / kMega, beyond / kMega,
                                 beyond / static_cast<double>(size));
        }
    }
    std::vector<double> byte_seconds;
    for (int i = 0; i < repeat_count; ++i) {
        const double begin = used_seconds();
        if (!read_bytes(path)) return false;
        byte_seconds.push_back(used_seconds() - begin);
    }

    std::vector<double> format_seconds;
    for (int i = 0; i < repeat_count && std::string_view(path).ends_with(".lrs"); ++i) {
        const double begin = used_seconds();
        if (!format_scene(path)) return false;
        format_seconds.push_back(used_seconds() - begin);
    }

    fmt::print("{}: {:.2f} MB, {} times\n", path, static_cast<double>(size) / kMega, repeat_count);
    fmt::print("         best s  median s  MB/s best  median\n");
    print_row("bytes", size, byte_seconds, "");
    print_row("scene", size, scene_seconds, memory);
    if (!format_seconds.empty()) print_row("format", size, format_seconds, "");
    return true;
}

/// Measures in a process of its own: the memory of one file is not that of the next.
bool measure_apart(const char* path, int repeat_count) {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        const bool is_measured = measure(path, repeat_count);
        std::fflush(stdout);
        _exit(is_measured ? 0 : 1);
    }
    int status = 0;
    return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) &&
           WEXITSTATUS(status) == 0;
}

}  // namespace

int main(int argc, char** argv) {
    int repeat_count = 5;
    int first_file = 1;
    if (argc > 2 && std::string_view(argv[1]) == "--repeat") {
        repeat_count = std::atoi(argv[2]);
        first_file = 3;
    }
    if (repeat_count < 1 || first_file >= argc || argv[first_file][0] == '-') {
        fmt::print(stderr, "{}", kUsage);
        return 2;
    }
    bool are_all_measured = true;
    for (int i = first_file; i < argc; ++i) {
        are_all_measured = measure_apart(argv[i], repeat_count) && are_all_measured;
    }
    return are_all_measured ? 0 : 1;
}
