// The film of a whole picture that is kept while it is rendered, so that a render which is
// interrupted goes on from there.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>

#include "render/film.h"
#include "render/options.h"

namespace lray::render {

/// All functions may be called by any thread.
class KeptFilm {
 public:
    using Save = std::function<void(const Film&)>;

    /// `film`: what is there already; of the size of `area`, the part of the full picture that is
    /// rendered. `save` is handed a copy of it each `period` while parts are put, by the thread
    /// that puts one; it may be empty.
    KeptFilm(Film film, const PixelRect& area, Save save, std::chrono::duration<double> period)
        : film_(std::move(film)),
          area_(area),
          save_(std::move(save)),
          period_(period),
          last_save_(Clock::now()) {}

    /// Space: of the full picture, as below.
    Film part(const PixelRect& part) const;

    /// Replaces a part; `more` is what is to be counted of its new samples.
    void put(const PixelRect& part, const Film& film, const FilmCounts& more);

    Film film() const;
    std::uint64_t sample_count() const;

 private:
    using Clock = std::chrono::steady_clock;

    mutable std::mutex mutex_;  // of the film
    Film film_;
    PixelRect area_{};

    std::mutex save_mutex_;
    Save save_;
    std::chrono::duration<double> period_{};
    Clock::time_point last_save_{};
};

}  // namespace lray::render
