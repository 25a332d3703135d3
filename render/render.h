// Camera -> film: blocking rendering on all cores.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "bvh/accel.h"
#include "image/image.h"
#include "render/film.h"
#include "render/kept_film.h"
#include "render/options.h"
#include "scene/camera.h"
#include "scene/world.h"
#include "shade/transport/follow_light.h"

namespace lray::render {

struct RenderProgress {
    std::uint64_t done_samples = 0;
    std::uint64_t total_samples = 0;  // of all pixels together; with limits, at most
    std::uint64_t finished_pixels = 0;
    std::uint64_t total_pixels = 0;
    std::uint64_t kept_samples = 0;  // of those done: that were there before
    double seconds = 0.0;            // of rendering
    SampleLimits limits{};           // of the render
};

struct RenderResult {
    image::Image image{};        // the light, before its display; of the crop's size
    bvh::TraceCounts primary{};  // of the rays from the camera
    shade::LightCounts light{};  // of those that full shading sent after them
    FilmCounts samples{};
    std::uint64_t sample_count = 0;      // of all pixels together
    std::uint64_t converged_pixels = 0;  // that ended by their noise, before they had all samples
    std::uint32_t thread_count = 1;      // that were used
    /// False if cancelled: pixels not reached are black, others the mean of the samples they have.
    bool is_complete = true;
    bool has_all_samples = true;  // false if time ended it, or it was cancelled
};

using ProgressFunction = std::function<void(const RenderProgress&)>;

/// Renders one view: each pixel is the mean of its samples. The picture does not depend on the
/// number of threads; a crop is the same pixels of the whole. With a limit of time that holds for
/// as many passes as there was time for: all pixels that still get samples have the same number.
/// `on_progress` (may be empty) is called from render threads, one at a time, at most some ten
/// times a second. `cancel` is looked at between batches of rays.
/// With a film that is kept, what is on it is not rendered again, and all that is rendered is put
/// there, whole rounds of samples at a time: cancelled or killed in between, a later call with the
/// film as it was saved gives the same picture to the bit. Asserts that it is of the size of the
/// picture, keeps what noise asks for (film_keeps()), and holds no more samples than are asked for.
RenderResult render(const scene::World& world, const bvh::Accel& accel, const scene::Camera& camera,
                    const RenderOptions& options, const ProgressFunction& on_progress,
                    const std::atomic<bool>& cancel, KeptFilm* kept = nullptr);

}  // namespace lray::render
