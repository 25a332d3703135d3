// Writes a scene of the Standard Procedural Databases, or a mesh, for lray, POV-Ray and Tachyon.
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/diagnostic_printer.h"
#include "base/file_access.h"
#include "base/output_file.h"
#include "bench/nff_scene.h"
#include "bench/text_writer.h"

namespace {

using namespace lray;

constexpr std::string_view kUsage =
    "usage: nff_to_scene IN.nff|IN.obj [--mesh] [--lrs PATH] [--pov PATH] [--tachyon PATH]\n"
    "  --mesh  all triangles of a surface as one mesh, where there are meshes\n";

struct Arguments {
    std::string in{};
    std::string lrs{};
    std::string pov{};
    std::string tachyon{};
    bench::Triangles triangles = bench::Triangles::single;
};

std::optional<Arguments> parse_arguments(int argc, char** argv) {
    Arguments arguments;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        std::string* const path = word == "--lrs"       ? &arguments.lrs
                                  : word == "--pov"     ? &arguments.pov
                                  : word == "--tachyon" ? &arguments.tachyon
                                                        : nullptr;
        if (word == "--mesh") {
            arguments.triangles = bench::Triangles::mesh;
        } else if (path != nullptr) {
            if (++i == argc) return std::nullopt;
            *path = argv[i];
        } else if (arguments.in.empty() && !word.starts_with('-')) {
            arguments.in = word;
        } else {
            return std::nullopt;
        }
    }
    if (arguments.in.empty()) return std::nullopt;
    return arguments;
}

/// Writes a file by `write`, which returns false if the program cannot show the scene.
template <class Write>
bool write_file(const std::string& path, Write write) {
    if (path.empty()) return true;
    std::string error;
    std::optional<OutputFile> file = OutputFile::open(path, error);
    if (!file) {
        fmt::print(stderr, "{}: {}\n", path, error);
        return false;
    }
    bench::TextWriter out(*file);
    if (!write(out)) {
        fmt::print(stderr, "{}: the scene has cones, which the program does not have\n", path);
        return false;
    }
    if (out.finish()) return true;
    fmt::print(stderr, "{}: {}\n", path, file->error());
    return false;
}

}  // namespace

int main(int argc, char** argv) {
    const std::optional<Arguments> arguments = parse_arguments(argc, argv);
    if (!arguments) {
        fmt::print(stderr, "{}", kUsage);
        return 2;
    }
    FileAccess files;
    ReadResult in = files.read_main(arguments->in, std::numeric_limits<std::uint32_t>::max());
    if (in.status != ReadStatus::ok) {
        fmt::print(stderr, "{}: cannot be read\n", arguments->in);
        return 1;
    }
    Sources sources;
    Diagnostics diagnostics;
    const SourceId file = sources.add(arguments->in, std::move(in.text));
    const std::optional<bench::NffScene> scene =
        arguments->in.ends_with(".obj") ? bench::read_obj_scene(sources, file, diagnostics)
                                        : bench::read_nff(sources, file, diagnostics);
    if (!scene) {
        fmt::print(stderr, "{}", format_diagnostics(diagnostics, sources, {}));
        return 1;
    }
    const bench::Triangles triangles = arguments->triangles;
    const bool is_written = write_file(arguments->lrs,
                                       [&](bench::TextWriter& out) {
                                           bench::write_lrs(*scene, triangles, out);
                                           return true;
                                       }) &&
                            write_file(arguments->pov,
                                       [&](bench::TextWriter& out) {
                                           bench::write_pov(*scene, triangles, out);
                                           return true;
                                       }) &&
                            write_file(arguments->tachyon, [&](bench::TextWriter& out) {
                                return bench::write_tachyon(*scene, out);
                            });
    return is_written ? 0 : 4;
}
