#include "cli/window_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>
#include <variant>

#include "base/diagnostic_printer.h"
#include "cli/console.h"
#include "cli/load_world.h"
#include "cli/memory_limit.h"
#include "cli/run.h"
#include "cli/stats.h"
#include "cli/view.h"

namespace lray::cli {

namespace {

/// A param that has a slider: a number between bounds, or one of some values.
std::optional<gui::Slider> slider_of(const parser::ParamValue& param) {
    gui::Slider slider;
    slider.name = param.name;
    if (param.range) {
        slider.value = param.range->value;
        slider.least = param.range->least;
        slider.greatest = param.range->greatest;
        slider.is_whole = param.range->is_whole;
        return slider;
    }
    if (param.choices.empty()) return std::nullopt;
    slider.choices = param.choices;
    const auto chosen = std::find(param.choices.begin(), param.choices.end(), param.value);
    if (chosen == param.choices.end()) return std::nullopt;
    slider.value = static_cast<double>(chosen - param.choices.begin());
    slider.greatest = static_cast<double>(param.choices.size() - 1);
    slider.is_whole = true;
    return slider;
}

std::vector<gui::Slider> sliders_of(std::span<const parser::ParamValue> params) {
    std::vector<gui::Slider> sliders;
    for (const parser::ParamValue& param : params) {
        if (auto slider = slider_of(param)) sliders.push_back(std::move(*slider));
    }
    return sliders;
}

std::string sentences(std::span<const std::string> lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

/// True if one of the sentences is about a param: `name` or `-D name=value`.
bool is_named_in(std::span<const std::string> sentences, std::string_view name) {
    const std::string alone = fmt::format("`{}`", name);
    const std::string defined = fmt::format("`-D {}", name);
    return std::ranges::any_of(sentences, [&](const std::string& sentence) {
        return sentence.find(alone) != sentence.npos || sentence.starts_with(defined);
    });
}

/// The command line with other values for some params: the last definition of a name counts.
Options with_params(Options options, std::span<const gui::ParamText> params) {
    for (const auto& [name, value] : params) options.definitions.push_back({name, value});
    return options;
}

}  // namespace

WindowSceneLoader::Attempt WindowSceneLoader::load(const Options& options) {
    Attempt attempt;
    StageTimes times;
    Stopwatch watch;
    LoadedWorld read = load_world(options, watch, times);
    gui::LoadedScene& loaded = attempt.loaded;
    loaded.files.assign(read.files.files_read().begin(), read.files.files_read().end());
    loaded.files.insert(loaded.files.end(), read.files.files_missed().begin(),
                        read.files.files_missed().end());
    attempt.usage_mistakes = std::move(read.result.usage_mistakes);
    if (!attempt.usage_mistakes.empty()) return attempt;
    loaded.messages = format_diagnostics(read.diagnostics, read.sources,
                                         {.max_errors = options.max_errors.value_or(0)});
    attempt.end = report_.print(read.diagnostics, read.sources, options);
    if (attempt.end) return attempt;

    const auto chosen = choose_view(read.scene(), *read.world, options);
    if (const auto* failure = std::get_if<Failure>(&chosen)) {
        attempt.end = report_failure(*failure);
        loaded.messages = fmt::format("{}\n{}\n", failure->message, failure->help);
        return attempt;
    }
    loaded.view = std::get<View>(chosen);
    loaded.bounds = finite_bounds(*read.world);
    loaded.sliders = sliders_of(read.result.params);
    auto prepared = std::make_unique<render::PreparedScene>(
        std::move(read.sources), std::move(*read.result.scene), std::move(*read.world));
    Progress silent(ProgressStyle::silent, {});
    prepared->accel = build_hierarchy(prepared->world, options, silent);
    prepared->lit = prepare_light(loaded.view, prepared->world, *prepared->accel, options);
    loaded.hierarchy = hierarchy_name(*options.accel, prepared->accel->stats());
    {
        const std::lock_guard lock(mutex_);
        info_ = prepared->scene.info;
        files_.assign(read.files.files_read().begin(), read.files.files_read().end());
    }
    loaded.prepared = std::move(prepared);
    return attempt;
}

WindowSceneLoader::Attempt WindowSceneLoader::load_or_run_out_of_memory(const Options& options) {
    try {
        return load(options);
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
    }
    const Failure failure = out_of_memory();
    Attempt attempt;
    attempt.end = report_failure(failure);
    attempt.loaded.messages = fmt::format("{}\n{}\n", failure.message, failure.help);
    attempt.loaded.files = files();
    return attempt;
}

std::optional<ExitCode> WindowSceneLoader::load_first(gui::LoadedScene& loaded) {
    Attempt attempt = load(options_);
    if (!attempt.usage_mistakes.empty()) return report_usage_mistakes(attempt.usage_mistakes);
    loaded = std::move(attempt.loaded);
    return attempt.end;
}

gui::LoadedScene WindowSceneLoader::load_again(std::span<const gui::ParamText> params) {
    std::vector<gui::ParamText> kept(params.begin(), params.end());
    Attempt attempt = load_or_run_out_of_memory(with_params(options_, kept));
    while (!attempt.usage_mistakes.empty() && !kept.empty()) {
        const std::size_t dropped = std::erase_if(kept, [&](const gui::ParamText& param) {
            return is_named_in(attempt.usage_mistakes, param.first);
        });
        if (dropped == 0) kept.clear();
        attempt = load_or_run_out_of_memory(with_params(options_, kept));
    }
    if (!attempt.usage_mistakes.empty()) {
        report_usage_mistakes(attempt.usage_mistakes);
        attempt.loaded.messages = sentences(attempt.usage_mistakes);
    }
    return std::move(attempt.loaded);
}

std::vector<std::pair<std::string, std::string>> WindowSceneLoader::info() const {
    const std::lock_guard lock(mutex_);
    return info_;
}

std::vector<std::string> WindowSceneLoader::files() const {
    const std::lock_guard lock(mutex_);
    return files_;
}

}  // namespace lray::cli
