#include "cli/film_run.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <utility>

#include "base/assert.h"
#include "base/output_file.h"
#include "base/terminal_text.h"
#include "cli/console.h"
#include "cli/frames.h"
#include "cli/named_file.h"
#include "cli/picture_identity.h"

namespace lray::cli {

namespace {

using namespace std::chrono_literals;

// Of a film file, beside its pixels: the head, mostly what the scene says of itself.
constexpr std::uint64_t kMaxHeadSize = std::uint64_t{16} << 20;
constexpr std::uint64_t kMaxPixelSize = 80;

bool is_there(const std::string& path) {
    struct stat status {};
    return stat(path.c_str(), &status) == 0;
}

/// Writes a film beside the picture. Returns what is wrong, in words; empty if nothing is.
std::string save_state(const std::string& path, const render::FilmDescription& description,
                       const render::Film& film) {
    std::string error;
    auto output = OutputFile::open(path, error);
    if (!output) return error;
    if (!render::write_film(*output, description, film) || !output->commit()) {
        return output->error();
    }
    return {};
}

void warn_unsaved(const std::string& path, const std::string& error) {
    print_warning(fmt::format("the state `{}` could not be saved: {}", path, error));
}

/// Why a state is not one to go on with; empty if it is. `film`: what there would be without it.
std::string why_another(const render::StoredFilm& stored,
                        const render::FilmDescription& description, const render::Film& film,
                        const render::SampleRange& samples) {
    const std::string difference =
        render::first_difference(description.identity, stored.description.identity);
    if (!difference.empty()) return fmt::format("is of another picture: {}", difference);
    const std::vector<render::SampleRange>& there = stored.description.samples;
    if (there.size() != 1 || there.front().begin != samples.begin) {
        return fmt::format("is of the samples from {} on, not from {}", there.front().begin,
                           samples.begin);
    }
    // The identity says so too, but it is a text: what it says is not taken on trust.
    const bool has_pixels = !stored.film.pixels().empty();
    if (has_pixels &&
        (stored.film.width() != film.width() || stored.film.height() != film.height() ||
         stored.film.keeps() != film.keeps())) {
        return "is of another picture: they differ in size";
    }
    std::uint32_t most = has_pixels ? 0 : there.front().count();
    for (const auto& pixel : stored.film.pixels()) most = std::max(most, pixel.sample_count);
    if (most > samples.count()) {
        return fmt::format("has {} samples of some pixels already, more than the {} asked for",
                           most, samples.count());
    }
    return {};
}

/// What notes that a frame is done. Of the same picture there may be other files.
render::FilmDescription note_of(render::FilmDescription description, const Options& options) {
    const image::WriteSettings usual;
    description.info.emplace_back(
        "file", fmt::format("{} {} {}",
                            options.is_film ? "film" : image::format_name(options.format.value()),
                            static_cast<int>(options.png_bits.value_or(usual.png_bits)),
                            options.jpeg_quality.value_or(usual.jpeg_quality)));
    return description;
}

/// True if what was noted of a frame would be noted again.
bool is_of_same_file(const render::FilmDescription& a, const render::FilmDescription& b) {
    return a.samples == b.samples && a.total == b.total && a.display == b.display &&
           a.info == b.info;
}

/// Where time or noise ends the render it is not known how much is left.
void tell_going_on(const std::string& path, const render::Film& film,
                   const render::RenderOptions& options) {
    std::string share;
    if (!options.limits.is_any()) {
        const double whole = static_cast<double>(film.pixels().size()) * options.samples.count();
        share = fmt::format(", which has {:.0f} % of the samples",
                            std::floor(100.0 * static_cast<double>(film.sample_count()) / whole));
    }
    print_note(fmt::format("going on from `{}`{}", path, share));
}

}  // namespace

std::variant<render::StoredFilm, std::string> read_film_file(const std::string& path,
                                                             std::uint64_t max_pixels) {
    FileAccess files;
    const std::uint64_t most_pixels = std::min(max_pixels, std::uint64_t{1} << 40);  // no overflow
    const ReadResult read = files.read_main(path, most_pixels * kMaxPixelSize + kMaxHeadSize);
    if (read.status != ReadStatus::ok) return why_unread(read);
    std::string error;
    const std::string_view text = read.text.view();
    auto stored = render::read_film(std::as_bytes(std::span(text)), max_pixels, error);
    if (!stored) return error;
    return std::move(*stored);
}

std::string state_path(std::string_view output_path) {
    return fmt::format("{}.state", output_path);
}

std::variant<FilmRun, Failure> FilmRun::begin(const Options& options, const View& view,
                                              const scene::Scene& scene, const FileAccess& files) {
    FilmRun run;
    if (!options.is_resuming && !options.is_film) return run;
    const render::RenderOptions& render_options = view.render_options;
    const auto [width, height] = render_options.resolution;
    const render::PixelRect area =
        render_options.crop.value_or(render::PixelRect{0, 0, width, height});
    run.description_.identity = picture_identity(scene, files.fingerprint(), view, options);
    run.description_.samples = {render_options.samples};
    run.description_.total = options.samples;
    if (!options.sample_range) run.description_.total = render_options.samples.end;
    run.description_.display = render_options.display;
    run.description_.info = scene.info;
    const render::Film::Keeps keeps = render::film_keeps(render_options.limits.noise);
    render::Film film(area.width(), area.height(), keeps);
    if (!options.is_resuming) {
        run.kept_ = std::make_unique<render::KeptFilm>(std::move(film), area,
                                                       render::KeptFilm::Save{}, 1.0s);
        return run;
    }
    run.state_path_ = state_path(options.output_path);
    run.note_ = note_of(run.description_, options);
    run.is_one_of_several_ = !options.frame_label.empty();
    if (is_there(run.state_path_)) {
        auto read = read_film_file(run.state_path_, options.max_output_pixels);
        if (const auto* reason = std::get_if<std::string>(&read)) {
            return Failure{
                ExitCode::output,
                fmt::format("the state `{}` cannot be used: {}", run.state_path_, *reason),
                "remove it to begin anew"};
        }
        auto& stored = std::get<render::StoredFilm>(read);
        const std::string why = why_another(stored, run.description_, film, render_options.samples);
        if (!why.empty()) {
            return Failure{ExitCode::usage, fmt::format("the state `{}` {}", run.state_path_, why),
                           "remove it to begin anew, or give the output another name"};
        }
        const bool has_pixels = stored.film.width() != 0;
        run.is_done_ = !has_pixels && is_there(options.output_path) &&
                       is_of_same_file(stored.description, run.note_);
        if (has_pixels) {
            film = std::move(stored.film);
            if (!options.quiet) tell_going_on(run.state_path_, film, render_options);
        }
    }
    render::FilmDescription unfinished = run.description_;
    unfinished.is_complete = false;
    run.kept_ = std::make_unique<render::KeptFilm>(
        std::move(film), area,
        [unfinished, path = run.state_path_, is_told = false](const render::Film& now) mutable {
            const std::string error = save_state(path, unfinished, now);
            if (!error.empty() && !std::exchange(is_told, true)) warn_unsaved(path, error);
        },
        std::chrono::duration<double>(options.save_seconds));
    return run;
}

std::optional<Failure> FilmRun::write(OutputFile output) const {
    LRAY_ASSERT(kept_);
    if (!render::write_film(output, description_, kept_->film()) || !output.commit()) {
        return Failure{ExitCode::output, output.error(), {}};
    }
    return std::nullopt;
}

void FilmRun::end(const render::RenderResult& result, ExitCode exit_code) const {
    if (state_path_.empty()) return;
    if (exit_code == ExitCode::done && result.has_all_samples) {
        if (!is_one_of_several_) {
            std::remove(state_path_.c_str());
            return;
        }
        const std::string error = save_state(state_path_, note_, render::Film(0, 0));
        if (!error.empty()) warn_unsaved(state_path_, error);
        return;
    }
    render::FilmDescription unfinished = description_;
    unfinished.is_complete = false;
    const std::string error = save_state(state_path_, unfinished, kept_->film());
    if (!error.empty()) return warn_unsaved(state_path_, error);
    print_note(fmt::format("the same command goes on from `{}`", state_path_));
}

void forget_frames(const Options& options) {
    if (!options.is_resuming || frame_count(options) <= 1) return;
    for (std::uint64_t i = 0; i < frame_count(options); ++i) {
        std::remove(state_path(options_of_frame(options, i).output_path).c_str());
    }
}

}  // namespace lray::cli
