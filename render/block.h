// A few pixels on their way to a picture: their film, and which of them still get samples.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "bvh/accel.h"
#include "image/image.h"
#include "image/tone_map.h"
#include "render/film.h"
#include "render/options.h"
#include "render/ray_counts.h"
#include "render/sample_tracer.h"

namespace lray::render {

/// What all blocks of a render have in common.
struct BlockSettings {
    const SampleTracer& tracer;
    SampleRange samples{};
    std::optional<double> noise{};  // SampleLimits
    image::Display display;
    const std::atomic<bool>& cancel;
};

/// What some samples were and cost.
struct BlockWork {
    std::uint64_t samples = 0;
    std::uint64_t finished_pixels = 0;   // that get no more
    std::uint64_t converged_pixels = 0;  // of those: before they had all
    RayCounts rays{};
    bool is_cancelled = false;

    BlockWork& operator+=(const BlockWork& other) {
        samples += other.samples;
        finished_pixels += other.finished_pixels;
        converged_pixels += other.converged_pixels;
        rays += other.rays;
        is_cancelled = is_cancelled || other.is_cancelled;
        return *this;
    }
};

class Block {
 public:
    Block(const PixelRect& part, const BlockSettings& settings);

    /// Goes on from a film of the part that an earlier block left, between two calls of advance(),
    /// under the same settings but for where its samples end.
    Block(const PixelRect& part, Film film, const BlockSettings& settings);

    /// Gives each pixel that still gets samples those up to `end` (of a picture's, not of a
    /// range's), or up to where its noise is looked at and found small.
    BlockWork advance(std::uint32_t end, const BlockSettings& settings);

    bool is_finished() const { return open_.empty(); }
    std::uint64_t open_count() const { return open_.size(); }

    /// The samples up to this one are there, of the pixels that still get some.
    std::uint32_t next_sample() const { return next_sample_; }

    const PixelRect& part() const { return part_; }
    const Film& film() const { return film_; }

    /// Writes the means into the picture of an area.
    void resolve(const PixelRect& area, image::Image& picture) const;

    const FilmCounts& counts() const { return film_.counts(); }

 private:
    std::uint32_t next_stop(const BlockSettings& settings) const;
    void close_converged(const BlockSettings& settings);

    PixelRect part_{};
    Film film_;
    std::vector<FilmPlace> open_;  // that still get samples
    std::uint32_t next_sample_ = 0;
};

}  // namespace lray::render
