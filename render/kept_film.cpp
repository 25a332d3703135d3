#include "render/kept_film.h"

namespace lray::render {

Film KeptFilm::part(const PixelRect& part) const {
    const std::lock_guard lock(mutex_);
    return film_.part(part.x0 - area_.x0, part.y0 - area_.y0, part.width(), part.height());
}

void KeptFilm::put(const PixelRect& part, const Film& film, const FilmCounts& more) {
    {
        const std::lock_guard lock(mutex_);
        film_.set_part(part.x0 - area_.x0, part.y0 - area_.y0, film);
        film_.add_counts(more);
    }
    // Whoever finds another thread saving goes on: nobody waits for the disk but that one.
    const std::unique_lock lock(save_mutex_, std::try_to_lock);
    if (!save_ || !lock.owns_lock() || Clock::now() - last_save_ < period_) return;
    save_(this->film());
    last_save_ = Clock::now();
}

Film KeptFilm::film() const {
    const std::lock_guard lock(mutex_);
    return film_;
}

std::uint64_t KeptFilm::sample_count() const {
    const std::lock_guard lock(mutex_);
    return film_.sample_count();
}

}  // namespace lray::render
