// Adds up films of one picture, rendered apart.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "render/film_file.h"

namespace lray::render {

struct NamedFilm {
    std::string name{};  // for messages
    StoredFilm stored{};
};

/// Returns the film of all samples together: to the bit what rendering them in one go gives. What
/// is said beside the samples is that of the first film.
/// Shape: one film or more.
/// Errors: empty, and `error` tells why in words: films of other pictures, that share samples, that
/// hold no pixels or are not complete, or that have too many together.
std::optional<StoredFilm> merge_films(std::span<const NamedFilm> films, std::string& error);

/// Returns the samples that a film lacks of 0 up to its total, or if that is not known up to its
/// last one, in words: "16:32 and 48:64"; empty if none.
std::string missing_samples(const FilmDescription& description);

}  // namespace lray::render
