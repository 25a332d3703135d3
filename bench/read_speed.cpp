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
#include "render/threads.h"
#include "scene/formats/read_mesh.h"

namespace {

using namespace lray;

constexpr std::string_view kUsage =
    "usage: read_speed [--repeat K] [--threads N] FILE...\n"
    "  Reads each .lrs, .nff or mesh file K times (5) on N threads (1); in seconds of processor\n"
    "  time, those of scene that have passed if there are more threads\n"
    "  bytes   the file into memory, nothing else\n"
    "  scene   .lrs, .nff: parser::load; .obj, .ply: the bytes and scene::read_mesh\n"
    "  format  .lrs: the bytes and parser::format\n"
    "  peak    of the process (VmHWM) after the first time; beyond: of that, more than before\n"
    "          and than the text; of a mesh also as a multiple of the mesh\n";

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
    if (std::string_view(path).ends_with(".lrs") || std::string_view(path).ends_with(".nff")) {
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
/// With more threads the time that has passed.
double used_seconds(unsigned thread_count = 1) {
    timespec time{};
    clock_gettime(thread_count == 1 ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &time);
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

/// Returns the bytes of the arrays that grow with a mesh.
std::uint64_t size_of(const scene::Mesh& mesh) {
    const auto bytes = [](const auto& array) { return array.size() * sizeof(array[0]); };
    return bytes(mesh.positions) + bytes(mesh.normals) + bytes(mesh.uvs) + bytes(mesh.colors) +
           bytes(mesh.triangles) + bytes(mesh.normal_indices) + bytes(mesh.uv_indices);
}

/// Prints the table of one file; false if it cannot be read.
bool measure(const char* path, int repeat_count, unsigned thread_count) {
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
        const double begin = used_seconds(thread_count);
        bool is_read = false;
        render::with_threads(thread_count, [&] { is_read = read_scene(path, outcome); });
        scene_seconds.push_back(used_seconds(thread_count) - begin);
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
            if (outcome.mesh) {
                const auto mesh = static_cast<double>(size_of(*outcome.mesh));
                memory += fmt::format(" = {:.2f} x mesh", beyond / mesh);
            }
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
bool measure_apart(const char* path, int repeat_count, unsigned thread_count) {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        const bool is_measured = measure(path, repeat_count, thread_count);
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
    int thread_count = 1;
    int first_file = 1;
    for (; first_file + 1 < argc; first_file += 2) {
        const std::string_view option = argv[first_file];
        if (option != "--repeat" && option != "--threads") break;
        (option == "--repeat" ? repeat_count : thread_count) = std::atoi(argv[first_file + 1]);
    }
    if (repeat_count < 1 || thread_count < 1 || first_file >= argc || argv[first_file][0] == '-') {
        fmt::print(stderr, "{}", kUsage);
        return 2;
    }
    bool are_all_measured = true;
    for (int i = first_file; i < argc; ++i) {
        are_all_measured =
            measure_apart(argv[i], repeat_count, static_cast<unsigned>(thread_count)) &&
            are_all_measured;
    }
    return are_all_measured ? 0 : 1;
}
