#include "render/merge_films.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/assert.h"

namespace lray::render {

namespace {

/// A stretch of samples and the film that has it.
struct Stretch {
    SampleRange samples{};
    const NamedFilm* film = nullptr;
};

std::string text_of(SampleRange samples) {
    return fmt::format("{}:{}", samples.begin, samples.end);
}

std::string why_not_one_picture(const NamedFilm& a, const NamedFilm& b) {
    const std::string difference =
        first_difference(a.stored.description.identity, b.stored.description.identity);
    const bool is_same_film = a.stored.film.width() == b.stored.film.width() &&
                              a.stored.film.height() == b.stored.film.height() &&
                              a.stored.film.keeps() == b.stored.film.keeps();
    if (difference.empty() && is_same_film) return {};
    return fmt::format("`{}` and `{}` are not of one picture: {}", a.name, b.name,
                       difference.empty() ? "they differ in size" : difference);
}

std::vector<SampleRange> joined(std::span<const Stretch> stretches) {
    std::vector<SampleRange> ranges;
    for (const Stretch& stretch : stretches) {
        if (!ranges.empty() && ranges.back().end == stretch.samples.begin) {
            ranges.back().end = stretch.samples.end;
        } else {
            ranges.push_back(stretch.samples);
        }
    }
    return ranges;
}

}  // namespace

std::optional<StoredFilm> merge_films(std::span<const NamedFilm> films, std::string& error) {
    LRAY_ASSERT(!films.empty());
    std::vector<Stretch> stretches;
    std::uint64_t sample_count = 0;
    for (const NamedFilm& film : films) {
        if (film.stored.film.pixels().empty()) {
            error = fmt::format("`{}` holds no pixels, it notes that a frame is done", film.name);
            return std::nullopt;
        }
        error = why_not_one_picture(films.front(), film);
        if (!error.empty()) return std::nullopt;
        if (!film.stored.description.is_complete) {
            error = fmt::format("`{}` is not complete: its render was interrupted", film.name);
            return std::nullopt;
        }
        for (const SampleRange samples : film.stored.description.samples) {
            stretches.push_back({samples, &film});
            sample_count += samples.count();
        }
    }
    std::stable_sort(stretches.begin(), stretches.end(), [](const Stretch& a, const Stretch& b) {
        return a.samples.begin < b.samples.begin;
    });
    for (std::size_t i = 1; i < stretches.size(); ++i) {
        const Stretch& a = stretches[i - 1];
        const Stretch& b = stretches[i];
        if (b.samples.begin >= a.samples.end) continue;
        const SampleRange shared{b.samples.begin, std::min(a.samples.end, b.samples.end)};
        error = fmt::format("`{}` and `{}` both have the samples {}", a.film->name, b.film->name,
                            text_of(shared));
        return std::nullopt;
    }
    if (sample_count > Film::kMaxSamples) {
        error = fmt::format("together they have {} samples a pixel; the most is {}", sample_count,
                            Film::kMaxSamples);
        return std::nullopt;
    }
    StoredFilm whole = films.front().stored;
    whole.description.samples = joined(stretches);
    for (const NamedFilm& film : films.subspan(1)) {
        whole.film.add_film(film.stored.film);
        whole.description.total = std::max(whole.description.total, film.stored.description.total);
    }
    return whole;
}

std::string missing_samples(const FilmDescription& description) {
    std::vector<SampleRange> missing;
    std::uint32_t next = 0;
    for (const SampleRange samples : description.samples) {
        if (samples.begin > next) missing.push_back({next, samples.begin});
        next = samples.end;
    }
    if (description.total.value_or(0) > next) missing.push_back({next, *description.total});
    std::string text;
    for (std::size_t i = 0; i < missing.size(); ++i) {
        const char* const joint = i == 0 ? "" : i + 1 == missing.size() ? " and " : ", ";
        text += joint + text_of(missing[i]);
    }
    return text;
}

}  // namespace lray::render
