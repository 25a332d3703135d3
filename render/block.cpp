#include "render/block.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "base/assert.h"

namespace lray::render {

namespace {

bool is_converged(const Film& film, FilmPlace place, const image::Display& display, double noise) {
    const Color mean = film.resolve(place.x, place.y);
    const Color error = film.standard_error(place.x, place.y);
    for (int channel = 0; channel < 3; ++channel) {
        const double shown = display.displayed_error(static_cast<double>(mean[channel]),
                                                     static_cast<double>(error[channel]));
        if (!(shown <= noise)) return false;
    }
    return true;
}

}  // namespace

Block::Block(const PixelRect& part, const BlockSettings& settings)
    : Block(part, Film(part.width(), part.height(), film_keeps(settings.noise)), settings) {}

/// Pixels that were closed have fewer samples than others, but for those that were closed last:
/// their noise tells again.
Block::Block(const PixelRect& part, Film film, const BlockSettings& settings)
    : part_(part), film_(std::move(film)) {
    LRAY_ASSERT(film_.width() == part.width() && film_.height() == part.height());
    std::uint32_t count = 0;
    for (const Film::Pixel& pixel : film_.pixels()) count = std::max(count, pixel.sample_count);
    LRAY_ASSERT(count <= settings.samples.count());
    next_sample_ = settings.samples.begin + count;
    if (next_sample_ == settings.samples.end) return;
    open_.reserve(part.pixel_count());
    for (std::uint32_t y = 0; y < part.height(); ++y) {
        for (std::uint32_t x = 0; x < part.width(); ++x) {
            if (film_.pixel(x, y).sample_count == count) open_.push_back({x, y});
        }
    }
    close_converged(settings);
}

/// Where the pixels have as many samples as it takes to look at their noise again, or all.
std::uint32_t Block::next_stop(const BlockSettings& settings) const {
    if (!settings.noise) return settings.samples.end;
    const std::uint32_t count = next_sample_ - settings.samples.begin;
    const std::uint32_t check = std::max(std::bit_ceil(count + 1), kFirstNoiseCheck);
    return settings.samples.begin + std::min(check, settings.samples.count());
}

void Block::close_converged(const BlockSettings& settings) {
    const std::uint32_t count = next_sample_ - settings.samples.begin;
    if (!settings.noise || count < kFirstNoiseCheck || !std::has_single_bit(count)) return;
    std::erase_if(open_, [&](FilmPlace place) {
        return is_converged(film_, place, settings.display, *settings.noise);
    });
}

BlockWork Block::advance(std::uint32_t end, const BlockSettings& settings) {
    LRAY_DCHECK(end <= settings.samples.end);
    BlockWork work;
    while (!open_.empty() && next_sample_ < end) {
        const SampleRange samples{next_sample_, std::min(end, next_stop(settings))};
        const std::uint64_t asked = std::uint64_t{open_.size()} * samples.count();
        const std::uint64_t done =
            settings.tracer.add_samples(part_, open_, samples, film_, work.rays, settings.cancel);
        work.samples += done;
        if (done != asked) {
            work.is_cancelled = true;
            return work;
        }
        next_sample_ = samples.end;
        const std::size_t open_before = open_.size();
        if (next_sample_ == settings.samples.end) {
            open_.clear();
        } else {
            close_converged(settings);
        }
        const std::uint64_t finished = open_before - open_.size();
        work.finished_pixels += finished;
        if (next_sample_ != settings.samples.end) work.converged_pixels += finished;
    }
    return work;
}

void Block::resolve(const PixelRect& area, image::Image& picture) const {
    for (std::uint32_t y = 0; y < part_.height(); ++y) {
        for (std::uint32_t x = 0; x < part_.width(); ++x) {
            picture.at(part_.x0 - area.x0 + x, part_.y0 - area.y0 + y) = film_.resolve(x, y);
        }
    }
}

}  // namespace lray::render
