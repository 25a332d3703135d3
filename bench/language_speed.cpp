// How fast programs of the language run, beside the same programs in POV-Ray's.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/diagnostic_printer.h"
#include "base/diagnostics.h"
#include "base/file_access.h"
#include "base/source.h"
#include "parser/load.h"

namespace {

using namespace lray;

constexpr std::string_view kUsage =
    "usage: language_speed [--repeat K] DIRECTORY\n"
    "  Writes small programs to DIRECTORY and runs each K times (3), by parser::load() and by\n"
    "  POV-Ray, where `povray` is installed; the best in seconds of processor time\n";

/// The same work in both languages.
struct Program {
    std::string_view name{};
    std::string_view what{};
    std::string_view lrs{};
    std::string_view pov{};        // empty: of lray alone
    double longest = 0.0;          // seconds, that lray is to take; 0: ten times less than POV-Ray
    std::size_t sphere_count = 0;  // that are placed
};

constexpr std::string_view kPovHeader = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n";

constexpr std::array kPrograms = {
    Program{"empty", "nothing: taken from all that follow", "\n", "\n"},
    Program{"while", "1,000,000 times round a while loop",
            "var i = 0\n"
            "while i < 1000000 { i = i + 1 }\n",
            "#declare I = 0;\n"
            "#while (I < 1000000) #declare I = I + 1; #end\n"},
    Program{"math", "1,000,000 times sin * cos + sqrt",
            "var i = 0\n"
            "var s = 0\n"
            "while i < 1000000 {\n"
            "  s = s + sin(i) * cos(i) + sqrt(i)\n"
            "  i = i + 1\n"
            "}\n",
            "#declare I = 0;\n"
            "#declare S = 0;\n"
            "#while (I < 1000000)\n"
            "  #declare S = S + sin(I) * cos(I) + sqrt(I);\n"
            "  #declare I = I + 1;\n"
            "#end\n"},
    Program{"scatter", "100,000 spheres at random places",
            "for i in range(100000) {\n"
            "  sphere { center: [rand(1, i, 0), rand(1, i, 1), rand(1, i, 2)], radius: 0.01 }\n"
            "}\n",
            "#declare S = seed(1);\n"
            "#declare I = 0;\n"
            "#while (I < 100000)\n"
            "  sphere { <rand(S), rand(S), rand(S)>, 0.01 }\n"
            "  #declare I = I + 1;\n"
            "#end\n",
            0.0, 100'000},
    Program{"grid", "1,000,000 spheres from nested loops",
            "for i in range(1000) {\n"
            "  for j in range(1000) { sphere { center: [i, 0, j], radius: 0.25 } }\n"
            "}\n",
            "", 1.0, 1'000'000},
    Program{"fib", "242,785 calls of a function: fib(25)",
            "fn fib(n) = if n < 2 then n else fib(n - 1) + fib(n - 2)\n"
            "assert(fib(25) == 75025)\n",
            "", 0.2},
    Program{"instances", "100,000 uses of a component, each with its own arguments",
            "component post(height) { cylinder { to: [0, height, 0], radius: 0.1 } }\n"
            "for i in range(100000) { post { height: 1 + i, translate: [i, 0, 0] } }\n",
            "", 0.5},
    Program{"lists", "1,000,000 elements through map, filter and a comprehension",
            "let squares = map(range(1000000), fn(x) = x * x)\n"
            "let odd = filter(squares, fn(x) = x % 2 == 1)\n"
            "let points = [for i, x in odd if i % 5 == 0: [i, x, 0]]\n"
            "assert(len(points) == 100000)\n",
            "", 1.0},
};

/// What a process took.
struct Usage {
    double seconds = 0.0;  // of the processor, the system's included
    double peak = 0.0;     // bytes
};

double seconds_of(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Runs a function in a process of its own; empty if that does not return 0.
template <class Function>
std::optional<Usage> run_apart(Function function) {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) _exit(function());
    int status = 0;
    rusage used{};
    const bool is_done = child > 0 && wait4(child, &status, 0, &used) == child &&
                         WIFEXITED(status) && WEXITSTATUS(status) == 0;
    if (!is_done) return std::nullopt;
    return Usage{seconds_of(used.ru_utime) + seconds_of(used.ru_stime),
                 static_cast<double>(used.ru_maxrss) * 1024.0};
}

int load(const std::string& path) {
    FileAccess files;
    Sources sources;
    Diagnostics diagnostics;
    const auto result = parser::load(path, {}, files, sources, diagnostics);
    if (result.scene) return 0;
    const std::string text = format_diagnostics(diagnostics, sources, {});
    std::fwrite(text.data(), 1, text.size(), stderr);
    return 1;
}

/// One pixel, no picture, no display, no bounding boxes: what is left is the parser.
int run_povray(const std::string& path) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    const std::string input = "+I" + path;
    execlp("povray", "povray", input.c_str(), "+W1", "+H1", "-D", "-F", "-A", "-MB", "+WT1",
           static_cast<char*>(nullptr));
    return 127;
}

template <class Function>
std::optional<Usage> best_of(int repeat_count, Function function) {
    std::optional<Usage> best;
    for (int i = 0; i < repeat_count; ++i) {
        const std::optional<Usage> usage = run_apart(function);
        if (!usage) return std::nullopt;
        if (!best || usage->seconds < best->seconds) best = usage;
    }
    return best;
}

std::string write(const std::filesystem::path& path, std::string_view header,
                  std::string_view text) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file << header << text;
    file.close();
    if (file.good()) return path.string();
    fmt::print(stderr, "{}: cannot be written\n", path.string());
    std::exit(4);
}

std::string bytes_per_sphere(const Program& program, const Usage& usage, const Usage& empty) {
    if (program.sphere_count == 0) return {};
    const double size = usage.peak - empty.peak;
    return fmt::format("{:.0f}", size / static_cast<double>(program.sphere_count));
}

/// Prints the table; false if a program does not run or is slower than it should be.
bool measure(const std::filesystem::path& directory, int repeat_count) {
    const bool has_povray =
        run_apart([] {
            const int nowhere = open("/dev/null", O_WRONLY);
            dup2(nowhere, STDOUT_FILENO);
            dup2(nowhere, STDERR_FILENO);
            execlp("povray", "povray", "--version", static_cast<char*>(nullptr));
            return 127;
        }).has_value();
    if (!has_povray) fmt::print("povray is not installed: its columns stay empty\n");
    fmt::print("{:<10} {:>9} {:>9} {:>7} {:>10} {:>10}  \n", "", "lray s", "povray s", "times",
               "B/sphere", "povray's");
    Usage empty;
    Usage povray_empty;
    bool is_fast = true;
    for (const Program& program : kPrograms) {
        const std::filesystem::path base = directory / program.name;
        const std::string lrs = write(base.string() + ".lrs", "", program.lrs);
        const std::optional<Usage> ours = best_of(repeat_count, [&] { return load(lrs); });
        if (!ours) {
            fmt::print(stderr, "{}: did not run\n", lrs);
            return false;
        }
        std::optional<Usage> theirs;
        if (has_povray && !program.pov.empty()) {
            const std::string pov = write(base.string() + ".pov", kPovHeader, program.pov);
            theirs = best_of(repeat_count, [&] { return run_povray(pov); });
            if (!theirs) {
                fmt::print(stderr, "{}: povray failed\n", pov);
                return false;
            }
        }
        const double seconds = ours->seconds - empty.seconds;
        std::string povray_seconds;
        std::string ratio;
        std::string povray_bytes;
        bool is_fast_enough = program.longest == 0.0 || seconds <= program.longest;
        if (theirs) {
            const double their_seconds = theirs->seconds - povray_empty.seconds;
            povray_seconds = fmt::format("{:.4f}", their_seconds);
            povray_bytes = bytes_per_sphere(program, *theirs, povray_empty);
            if (program.name != "empty") {
                ratio = fmt::format("{:.1f}", their_seconds / seconds);
                is_fast_enough = is_fast_enough && their_seconds >= 10.0 * seconds;
            }
        }
        fmt::print("{:<10} {:>9.4f} {:>9} {:>7} {:>10} {:>10}  {}{}\n", program.name, seconds,
                   povray_seconds, ratio, bytes_per_sphere(program, *ours, empty), povray_bytes,
                   program.what, is_fast_enough ? "" : "  TOO SLOW");
        is_fast = is_fast && is_fast_enough;
        if (program.name == "empty") {
            empty = *ours;
            if (theirs) povray_empty = *theirs;
        }
    }
    return is_fast;
}

}  // namespace

int main(int argc, char** argv) {
    int repeat_count = 3;
    int first = 1;
    if (argc > 2 && std::string_view(argv[1]) == "--repeat") {
        repeat_count = std::atoi(argv[2]);
        first = 3;
    }
    const bool is_right =
        repeat_count >= 1 && first + 1 == argc && std::filesystem::is_directory(argv[first]);
    if (!is_right) {
        fmt::print(stderr, "{}", kUsage);
        return 2;
    }
    return measure(argv[first], repeat_count) ? 0 : 1;
}
