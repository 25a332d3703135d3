#include "cli/merge_parts.h"

#include <fmt/format.h>

#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/console.h"
#include "cli/film_run.h"
#include "cli/run.h"
#include "image/tone_map.h"
#include "render/merge_films.h"

namespace lray::cli {

namespace {

Failure unmergeable(std::string message, std::string help = {}) {
    return {ExitCode::usage, std::move(message), std::move(help)};
}

std::variant<std::vector<render::NamedFilm>, Failure> read_parts(const Options& options) {
    std::vector<render::NamedFilm> parts;
    for (const std::string& path : options.paths) {
        auto read = read_film_file(path, options.max_output_pixels);
        if (const auto* reason = std::get_if<std::string>(&read)) {
            return unmergeable(fmt::format("`{}`: {}", path, *reason));
        }
        parts.push_back({path, std::move(std::get<render::StoredFilm>(read))});
    }
    return parts;
}

std::optional<Failure> write_merged(const render::StoredFilm& merged, const Options& options) {
    const auto& [description, film] = merged;
    const std::string missing = render::missing_samples(description);
    if (!options.is_film && !missing.empty()) {
        return unmergeable(
            fmt::format("the samples {} are missing", missing),
            "render them with `--samples A:B`, or merge into a film: `-o parts.film`");
    }
    auto opened = open_output(options, options.paths);
    if (auto* failure = std::get_if<Failure>(&opened)) return std::move(*failure);
    OutputFile output = std::move(std::get<OutputFile>(opened));
    if (!options.is_film) {
        const image::Image picture = for_file(film.picture(), description.display, options);
        return write_picture(std::move(output), picture, description.display.gamma,
                             description.info, options);
    }
    if (render::write_film(output, description, film) && output.commit()) return std::nullopt;
    return Failure{ExitCode::output, output.error(), {}};
}

}  // namespace

ExitCode merge_parts(const Options& options) {
    const auto read = read_parts(options);
    if (const auto* failure = std::get_if<Failure>(&read)) return report_failure(*failure);
    std::string error;
    const auto merged = render::merge_films(std::get<std::vector<render::NamedFilm>>(read), error);
    if (!merged) return report_failure(unmergeable(error));
    const auto failure = write_merged(*merged, options);
    return failure ? report_failure(*failure) : ExitCode::done;
}

}  // namespace lray::cli
