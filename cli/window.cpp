#include "cli/window.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>
#include <variant>

#include "base/assert.h"
#include "base/json_writer.h"
#include "base/terminal_text.h"
#include "cli/console.h"
#include "cli/interrupt.h"
#include "cli/memory_limit.h"
#include "cli/picture_names.h"
#include "cli/run.h"
#include "cli/stored_views.h"
#include "cli/window_scene.h"
#include "gui/window.h"
#include "parser/tools/camera_text.h"

namespace lray::cli {

namespace {

constexpr const char* kUseOutput = "write a picture instead: `-o image.png`";

/// Opens the file that the next picture goes to, and puts its name into the options.
std::variant<OutputFile, Failure> open_next_picture(Options& options,
                                                    const WindowSceneLoader& loader) {
    std::string problem;
    const auto name = next_picture_name(options, problem);
    if (!name) return Failure{ExitCode::output, problem, {}};
    options.output_path = *name;
    return open_output(options, loader.files());
}

gui::Outcome save(image::Image light, const image::DisplaySettings& display,
                  const WindowSceneLoader& loader, Options options) {
    auto opened = open_next_picture(options, loader);
    if (const auto* failure = std::get_if<Failure>(&opened)) return {false, failure->message};
    const auto failure = write_picture(std::move(std::get<OutputFile>(opened)),
                                       for_file(std::move(light), display, options), display.gamma,
                                       loader.info(), options);
    if (failure) return {false, failure->message};
    return {true, fmt::format("saved {}", escape_for_terminal(options.output_path))};
}

/// Tells a wrong name of the output at once, not when there is a picture for it.
std::optional<Failure> check_output(Options options, const WindowSceneLoader& loader) {
    if (options.output_path.empty()) return std::nullopt;
    const auto opened = open_next_picture(options, loader);
    if (const auto* failure = std::get_if<Failure>(&opened)) return *failure;
    return std::nullopt;
}

gui::StoredViews read_stored_views(const Options& options) {
    const std::string path = views_path(options.scene_path);
    if (path.empty()) return {};
    FileAccess files = file_access(options);
    std::string problem;
    gui::StoredViews views = read_views(path, files, problem);
    if (!problem.empty()) print_warning(problem);
    return views;
}

gui::Outcome write_stored_views(const Options& options, const gui::StoredViews& views) {
    const std::string path = views_path(options.scene_path);
    if (path.empty()) return {false, "a scene from stdin has no place for views"};
    std::string problem = write_views(path, views);
    if (!problem.empty()) return {false, std::move(problem)};
    return {true, fmt::format("stored in {}", escape_for_terminal(path))};
}

gui::Program program_of(const Options& options, WindowSceneLoader& loader) {
    const std::string title =
        options.scene_path == "-" ? "<stdin>" : escape_for_terminal(options.scene_path);
    std::error_code ignored;
    return {
        .title = title,
        .can_load_again = std::filesystem::is_regular_file(options.scene_path, ignored),
        .load = [&](std::span<const gui::ParamText> params) { return loader.load_again(params); },
        .save =
            [&](image::Image light, const image::DisplaySettings& display) {
                return save(std::move(light), display, loader, options);
            },
        .camera_text = [](const scene::Camera& camera) { return parser::camera_text(camera); },
        .read_views = [&] { return read_stored_views(options); },
        .write_views =
            [&](const gui::StoredViews& views) { return write_stored_views(options, views); },
        .print = [](std::string_view line) { print_requested(fmt::format("{}\n", line)); },
        .is_interrupted = [] { return stop_requested().load(); },
        .end_without_window =
            [](std::string_view why) {
                const ExitCode code =
                    report_failure({ExitCode::window, std::string(why), kUseOutput});
                std::fflush(nullptr);
                std::_Exit(static_cast<int>(code));
            },
    };
}

std::string stats_text(const gui::WindowStats& stats) {
    const auto rate = [](double count, double per) { return per > 0.0 ? count / per : 0.0; };
    const auto passes = static_cast<double>(stats.passes);
    const auto frames = static_cast<double>(stats.frames);
    return fmt::format(
        "first picture after {:.3f} s; {} passes in {:.2f} s, {:.1f} a second; {} frames, {:.2f} "
        "ms each to upload\n",
        stats.first_picture_seconds, stats.passes, stats.pass_seconds,
        rate(passes, stats.pass_seconds), stats.frames, rate(1e3 * stats.upload_seconds, frames));
}

std::string stats_json(const gui::WindowStats& stats) {
    JsonWriter json;
    json.begin_object();
    json.key("first_picture_seconds").decimal(stats.first_picture_seconds);
    json.member("passes", stats.passes);
    json.key("pass_seconds").decimal(stats.pass_seconds);
    json.member("frames", stats.frames);
    json.key("upload_seconds").decimal(stats.upload_seconds);
    json.end_object();
    return json.take() + "\n";
}

ExitCode exit_code_of(gui::WindowEnd end) {
    switch (end) {
        case gui::WindowEnd::closed:
            return ExitCode::done;
        case gui::WindowEnd::interrupted:
            return interrupt_exit_code().value_or(ExitCode::done);
        case gui::WindowEnd::out_of_memory:
            return report_failure(out_of_memory());
    }
    LRAY_ASSERT(false);
}

}  // namespace

ExitCode show_window(const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    if (!gui::has_display()) {
        return report_failure({ExitCode::window, "there is no display for a window", kUseOutput});
    }
    WindowSceneLoader loader(options);
    gui::LoadedScene first;
    if (const auto end = loader.load_first(first)) return *end;
    if (const auto failure = check_output(options, loader)) return report_failure(*failure);
    for (const std::string& warning : options.warnings) print_warning(warning);

    catch_interrupts();
    const gui::WindowResult result =
        gui::show_window(std::move(first), program_of(options, loader), start);
    if (options.stats == StatsFormat::text) print_message(stats_text(result.stats));
    if (options.stats == StatsFormat::json) print_message(stats_json(result.stats));
    const ExitCode code = exit_code_of(result.end);
    if (result.is_loading) {  // nobody waits for a scene that nobody will see
        std::fflush(nullptr);
        std::_Exit(static_cast<int>(code));
    }
    return code;
}

}  // namespace lray::cli
