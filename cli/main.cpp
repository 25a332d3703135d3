// lray: the whole pipeline, from the command line to the picture.
#include <exception>
#include <new>
#include <span>
#include <stdexcept>
#include <utility>
#include <variant>

#include "cli/console.h"
#include "cli/dependencies.h"
#include "cli/diff_pictures.h"
#include "cli/dump_scene.h"
#include "cli/explain.h"
#include "cli/film_run.h"
#include "cli/format_files.h"
#include "cli/frames.h"
#include "cli/interrupt.h"
#include "cli/load_world.h"
#include "cli/memory_limit.h"
#include "cli/merge_parts.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "cli/report.h"
#include "cli/run.h"
#include "cli/stats.h"
#include "cli/view.h"
#include "cli/window.h"

namespace lray::cli {

namespace {

ExitCode check_or_render(const Options& options, DiagnosticsReport& report) {
    StageTimes times;
    Stopwatch watch;
    const LoadedWorld loaded = load_world(options, watch, times);
    const auto& [scene, usage_mistakes, params] = loaded.result;
    const auto& world = loaded.world;
    if (!usage_mistakes.empty()) return report_usage_mistakes(usage_mistakes);
    if (const auto end = report.print(loaded.diagnostics, loaded.sources, options)) return *end;

    const auto chosen = choose_view(*scene, *world, options);
    if (const auto* failure = std::get_if<Failure>(&chosen)) return report_failure(*failure);
    const View& view = std::get<View>(chosen);
    print_notes(view, *world, options);

    catch_interrupts();
    if (const auto interrupted = interrupt_exit_code()) return *interrupted;  // between frames
    auto opened = open_output(
        options, loaded.files.files_read());  // before the work: a wrong name is told at once
    if (const auto* failure = std::get_if<Failure>(&opened)) return report_failure(*failure);

    const auto begun = FilmRun::begin(options, view, *scene, loaded.files);
    if (const auto* failure = std::get_if<Failure>(&begun)) return report_failure(*failure);
    const FilmRun& film = std::get<FilmRun>(begun);
    if (film.is_done()) return ExitCode::done;

    watch.lap();
    Progress progress(progress_style(options), options.frame_label);
    print_message(progress.begin());
    const auto accel = build_hierarchy(*world, options, progress);
    const auto lit = prepare_light(view, *world, *accel, options);
    times.build = watch.lap();
    const render::RenderResult result =
        render_view(view, *world, *accel, lit.get(), options, progress, film.kept());
    times.render = watch.lap();
    const ExitCode exit_code = save_picture(std::move(std::get<OutputFile>(opened)), result, view,
                                            scene->info, film, options);
    times.write = watch.lap();
    if (options.stats != StatsFormat::none) {
        print_stats({*world, options, view, accel->stats(), result, times});
    }
    return exit_code;
}

ExitCode check_or_render_frames(const Options& options) {
    DiagnosticsReport report;
    for (std::uint64_t i = 0; i < frame_count(options); ++i) {
        const ExitCode exit_code = check_or_render(options_of_frame(options, i), report);
        if (exit_code != ExitCode::done) return exit_code;
    }
    forget_frames(options);
    return ExitCode::done;
}

ExitCode run(std::span<const char* const> arguments) {
    const auto parsed = parse_options(arguments);
    if (const auto* failure = std::get_if<Failure>(&parsed)) return report_failure(*failure);
    const Options& options = std::get<Options>(parsed);
    limit_memory(memory_limit(options.max_memory));
    switch (options.mode) {
        case Mode::render:
        case Mode::check:
            return check_or_render_frames(options);
        case Mode::window:
            return show_window(options);
        case Mode::dump:
            return dump_scene(options);
        case Mode::deps:
            return print_dependencies(options);
        case Mode::format:
            return format_files(options);
        case Mode::explain:
            return explain(options.explained);
        case Mode::diff:
            return diff_pictures(options);
        case Mode::merge:
            return merge_parts(options);
        case Mode::help:
            return print_requested(help_text());
        case Mode::version:
            return print_requested(version_text());
    }
    LRAY_ASSERT(false);
}

/// Nothing thrown leaves the program.
ExitCode run_safely(std::span<const char* const> arguments) {
    try {
        return run(arguments);
    } catch (const std::bad_alloc&) {
        return report_failure(out_of_memory());
    } catch (const std::length_error&) {
        return report_failure(out_of_memory());
    } catch (const std::exception& error) {
        return report_failure({ExitCode::internal, "internal error", error.what()});
    }
}

}  // namespace

}  // namespace lray::cli

int main(int argc, char** argv) {
    lray::cli::ignore_broken_pipes();
    const std::span arguments(argv, static_cast<std::size_t>(argc));
    return static_cast<int>(lray::cli::run_safely(arguments.subspan(argc > 0 ? 1 : 0)));
}
