// Films in files: sums of samples, so that a render can go on, and parts of one can be added up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/output_file.h"
#include "image/tone_map.h"
#include "render/film.h"
#include "render/options.h"

namespace lray::render {

/// What tells pictures apart: names and values, in order. Samples of two films belong to one
/// picture if these are the same.
using PictureIdentity = std::vector<std::pair<std::string, std::string>>;

struct FilmDescription {
    PictureIdentity identity{};
    /// Which samples each pixel has; rising, none touching. Of a film that is not complete, which
    /// it is to have: some pixels have fewer, and with a limit of noise some never get all.
    std::vector<SampleRange> samples{};
    std::optional<std::uint32_t> total{};  // samples that the whole picture has, if it is known
    bool is_complete = true;
    image::DisplaySettings display{};                         // as which the light is shown
    std::vector<std::pair<std::string, std::string>> info{};  // of the scene, for picture files
};

struct StoredFilm {
    FilmDescription description{};
    Film film{0, 0};
};

/// Writes a film: a head of text lines, the pixels, and a fingerprint of both. The bytes depend on
/// the arguments alone.
/// Errors: false; out.error() tells why in words.
bool write_film(OutputFile& out, const FilmDescription& description, const Film& film);

/// Reads what write_film() wrote, a film without pixels too; nothing is taken on trust.
/// `max_pixels` bounds the size.
/// Errors: empty, and `error` tells why in words.
std::optional<StoredFilm> read_film(std::span<const std::byte> file, std::uint64_t max_pixels,
                                    std::string& error);

/// Returns what the first difference between two pictures is, in words; empty if they are one.
std::string first_difference(const PictureIdentity& a, const PictureIdentity& b);

}  // namespace lray::render
