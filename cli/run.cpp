#include "cli/run.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <chrono>
#include <cstdlib>
#include <utility>
#include <vector>

#include "base/assert.h"
#include "base/terminal_text.h"
#include "cli/console.h"
#include "cli/importer.h"
#include "cli/interrupt.h"
#include "cli/library.h"
#include "image/tone_map.h"
#include "render/threads.h"

namespace lray::cli {

namespace {

// Brute force makes some 5e7 tests a second and core: beyond this it takes longer than people like
// to wait without a word.
constexpr double kSlowTestCount = 2e9;

/// Primitives that a ray meets without a hierarchy: those of an instance as often as it is placed.
double expanded_count(const scene::World& world) {
    std::vector<double> counts;  // of the prototypes; each uses only those before it
    const auto expanded = [&](const scene::Geometry& geometry) {
        double count = static_cast<double>(geometry.primitive_count());
        for (const scene::WorldInstance& instance : geometry.instances) {
            count += counts[instance.prototype];
        }
        return count;
    };
    for (const scene::Geometry& prototype : world.prototypes) {
        counts.push_back(expanded(prototype));
    }
    return expanded(world);
}

/// True for a pipe or a device: there is no place beside it for a partial picture.
bool is_special_file(const std::string& path) {
    struct stat status {};
    return path == "-" || (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode));
}

bool is_same_file(const std::string& a, const std::string& b) {
    struct stat status_a {};
    struct stat status_b {};
    return stat(a.c_str(), &status_a) == 0 && stat(b.c_str(), &status_b) == 0 &&
           S_ISREG(status_a.st_mode) && status_a.st_dev == status_b.st_dev &&
           status_a.st_ino == status_b.st_ino;
}

Failure output_failure(std::string reason) {
    return {ExitCode::output, std::move(reason), {}};
}

ExitCode save_partial_picture(const render::RenderResult& result, const View& view,
                              image::Metadata metadata, const Options& options,
                              ExitCode exit_code) {
    const bool is_empty = result.primary.rays == 0;  // interrupted while the hierarchy was built
    if (is_empty || options.is_film || is_special_file(options.output_path)) {
        print_message("lray: interrupted; nothing was written\n");
        return exit_code;
    }
    const std::string path = partial_path(options.output_path);
    std::string error;
    auto output = OutputFile::open(path, error);
    std::optional<Failure> failure =
        output ? write_picture(std::move(*output), result.image, view.render_options.display.gamma,
                               metadata, options)
               : output_failure(error);
    if (failure) {
        report_failure(*failure);
        return exit_code;
    }
    print_message(
        fmt::format("lray: interrupted; what there is was written to `{}`, `{}` is "
                    "untouched\n",
                    escape_for_terminal(path), escape_for_terminal(options.output_path)));
    return exit_code;
}

}  // namespace

ProgressStyle progress_style(const Options& options) {
    const bool is_for_machines = options.diagnostics_format != DiagnosticsFormat::text;
    if (options.quiet || is_for_machines) return ProgressStyle::silent;
    return stderr_is_terminal() ? ProgressStyle::bar : ProgressStyle::lines;
}

FileAccess file_access(const Options& options) {
    FileAccess files;
    files.set_library(library_directory());
    for (const std::string& directory : options.include_directories) files.allow(directory, true);
    if (const char* const path = std::getenv("LRAY_PATH")) {
        std::string_view rest = path;
        while (!rest.empty()) {
            const std::string_view directory = rest.substr(0, rest.find(':'));
            if (!directory.empty()) files.allow(std::string(directory), true);
            rest.remove_prefix(std::min(directory.size() + 1, rest.size()));
        }
    }
    for (const std::string& directory : options.allowed_directories) {
        files.allow(directory, false);
    }
    return files;
}

parser::LoadSettings load_settings(const Options& options) {
    parser::LoadSettings settings;
    settings.limits = options.load_limits;
    settings.importer = importer_program();
    settings.definitions = options.definitions;
    if (options.frames) settings.frame = static_cast<double>(options.frames->first);
    if (options.diagnostics_format == DiagnosticsFormat::text) {
        settings.print = [](std::string_view line) {
            print_message(escape_for_terminal(line) + "\n");
        };
    }
    return settings;
}

void print_notes(const View& view, const scene::World& world, const Options& options) {
    if (options.diagnostics_format != DiagnosticsFormat::text) return;
    for (const std::string& warning : options.warnings) print_warning(warning);
    if (options.accel != bvh::AccelKind::none || options.quiet) return;
    const double primitive_count = expanded_count(world);
    if (static_cast<double>(view.ray_count()) * primitive_count <= kSlowTestCount) return;
    print_note(
        fmt::format("without a hierarchy each of {} rays tests all {:.0f} primitives, which will "
                    "be slow; `--accel boxes` gives the same picture sooner",
                    view.ray_count(), primitive_count));
}

std::variant<OutputFile, Failure> open_output(const Options& options,
                                              std::span<const std::string> files_read) {
    for (const std::string& file : files_read) {
        if (options.output_path == "-" || !is_same_file(options.output_path, file)) continue;
        const std::string_view what =
            file == options.scene_path ? "the scene" : "a file of the scene";
        return Failure{ExitCode::usage,
                       fmt::format("`-o {}` would overwrite {}", options.output_path, what),
                       "give the output another name"};
    }
    std::string error;
    auto output = OutputFile::open(options.output_path, error);
    if (!output) return output_failure(error);
    return std::move(*output);
}

std::unique_ptr<bvh::Accel> build_hierarchy(const scene::World& world, const Options& options,
                                            Progress& progress) {
    LRAY_ASSERT(options.accel);
    if (*options.accel != bvh::AccelKind::none) {
        print_message(progress.building(world.primitive_count()));
    }
    const bvh::BuildOptions asked{
        .kind = *options.accel,
        .quality = options.quality.value_or(bvh::BuildQuality::medium),
    };
    std::unique_ptr<bvh::Accel> accel;
    render::with_threads(options.thread_count, [&] { accel = bvh::build(world, asked); });
    return accel;
}

std::unique_ptr<shade::LitWorld> prepare_light(const View& view, const scene::World& world,
                                               const bvh::Accel& accel, const Options& options) {
    std::unique_ptr<shade::LitWorld> lit;
    if (view.render_options.shading.shader != shade::Shader::full) return lit;
    render::with_threads(options.thread_count,
                         [&] { lit = std::make_unique<shade::LitWorld>(world, accel); });
    return lit;
}

render::RenderResult render_view(const View& view, const scene::World& world,
                                 const bvh::Accel& accel, const shade::LitWorld* lit,
                                 const Options& options, Progress& progress,
                                 render::KeptFilm* kept) {
    const auto start = std::chrono::steady_clock::now();
    const auto on_progress = [&](const render::RenderProgress& done) {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        print_message(progress.update(done, elapsed.count()));
    };
    render::RenderOptions render_options = view.render_options;
    render_options.lit = lit;
    render::RenderResult result = render::render(world, accel, view.camera, render_options,
                                                 on_progress, stop_requested(), kept);
    print_message(progress.finish());
    result.image = for_file(std::move(result.image), view.render_options.display, options);
    return result;
}

image::Image for_file(image::Image light, const image::DisplaySettings& display,
                      const Options& options) {
    if (options.format && image::holds_light(*options.format)) return light;
    return image::displayed(std::move(light), display);
}

std::optional<Failure> write_picture(OutputFile output, const image::Image& picture,
                                     image::Gamma gamma, image::Metadata metadata,
                                     const Options& options) {
    std::string error;
    image::WriteSettings settings;
    settings.png_bits = options.png_bits.value_or(settings.png_bits);
    settings.jpeg_quality = options.jpeg_quality.value_or(settings.jpeg_quality);
    if (!write_image(output, picture, *options.format, gamma, metadata, error, settings)) {
        return output_failure(error);
    }
    if (!output.commit()) return output_failure(output.error());
    return std::nullopt;
}

ExitCode save_picture(OutputFile output, const render::RenderResult& result, const View& view,
                      image::Metadata metadata, const FilmRun& film, const Options& options) {
    ExitCode exit_code = ExitCode::done;
    if (result.is_complete) {
        const auto failure =
            options.is_film ? film.write(std::move(output))
                            : write_picture(std::move(output), result.image,
                                            view.render_options.display.gamma, metadata, options);
        if (failure) exit_code = report_failure(*failure);
    } else {
        const auto interrupted = interrupt_exit_code();
        LRAY_ASSERT(interrupted);
        exit_code = save_partial_picture(result, view, metadata, options, *interrupted);
    }
    film.end(result, exit_code);
    return exit_code;
}

std::string partial_path(std::string_view output_path) {
    const std::string_view extension = image::extension(output_path);
    if (extension.empty()) return fmt::format("{}.partial", output_path);
    output_path.remove_suffix(extension.size() + 1);
    return fmt::format("{}.partial.{}", output_path, extension);
}

}  // namespace lray::cli
