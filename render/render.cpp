// Tiles on threads. Each tile adds up its samples on a film of its own and resolves it into the
// picture, so that memory beyond the picture does not grow with it.
#include "render/render.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <utility>

#include "base/assert.h"
#include "render/camera_rays.h"
#include "shade/flat.h"

namespace lray::render {

namespace {

constexpr std::uint32_t kTileSize = 16;
constexpr std::chrono::milliseconds kProgressPeriod{100};

std::uint32_t tile_count_along(std::uint32_t pixel_count) {
    return pixel_count / kTileSize + (pixel_count % kTileSize != 0 ? 1 : 0);
}

PixelRect tile_rect(const PixelRect& area, std::uint64_t tile) {
    const std::uint32_t columns = tile_count_along(area.width());
    const std::uint32_t x = static_cast<std::uint32_t>(tile % columns) * kTileSize;
    const std::uint32_t y = static_cast<std::uint32_t>(tile / columns) * kTileSize;
    return {area.x0 + x, area.y0 + y, area.x0 + std::min(x + kTileSize, area.width()),
            area.y0 + std::min(y + kTileSize, area.height())};
}

/// Counts pixels that are done and reports them now and then.
class ProgressMeter {
 public:
    ProgressMeter(std::uint64_t total_pixels, const ProgressFunction& on_progress)
        : total_(total_pixels), on_progress_(on_progress) {}

    void add(std::uint64_t pixel_count) {
        const std::uint64_t done = done_ += pixel_count;
        if (!on_progress_) return;
        // Whoever finds another thread reporting goes on: nobody waits.
        const std::unique_lock lock(mutex_, std::try_to_lock);
        if (!lock.owns_lock()) return;
        const auto now = std::chrono::steady_clock::now();
        if (now < next_report_) return;
        next_report_ = now + kProgressPeriod;
        on_progress_({std::max(done, done_.load()), total_});
    }

    bool is_complete() const { return done_ == total_; }

 private:
    std::uint64_t total_ = 0;
    const ProgressFunction& on_progress_;
    std::atomic<std::uint64_t> done_{0};
    std::mutex mutex_;
    std::chrono::steady_clock::time_point next_report_{};
};

/// What the tiles share. Each writes its own pixels of the picture.
struct Job {
    const scene::World& world;
    const bvh::Accel& accel;
    const RenderOptions& options;
    const std::atomic<bool>& cancel;
    CameraRays rays;
    PixelRect area{};
    RenderResult result{};
    std::mutex counts_mutex{};

    void add_counts(const bvh::TraceCounts& counts, const FilmCounts& samples) {
        const std::lock_guard lock(counts_mutex);
        result.counts.rays += counts.rays;
        result.counts.primitive_tests += counts.primitive_tests;
        result.samples.clamped += samples.clamped;
        result.samples.nan += samples.nan;
    }
};

Color trace(const Job& job, DVec2 position_pixel, bvh::TraceCounts& counts) {
    const Ray ray = job.rays.through(position_pixel);
    const bvh::Hit hit = job.accel.nearest_hit(ray, Interval{}, counts);
    return shade::flat(job.world, hit, job.options.background);
}

void render_tile(Job& job, const PixelRect& tile, ProgressMeter& progress) {
    Film film(tile.width(), tile.height());
    bvh::TraceCounts counts;
    for (std::uint32_t y = tile.y0; y < tile.y1; ++y) {
        std::uint32_t x = tile.x0;
        for (; x < tile.x1 && !job.cancel.load(std::memory_order_relaxed); ++x) {
            const DVec2 position_pixel = DVec2{x + 0.5, y + 0.5};  // the centre
            film.add(x - tile.x0, y - tile.y0, trace(job, position_pixel, counts));
            job.result.image.at(x - job.area.x0, y - job.area.y0) =
                film.resolve(x - tile.x0, y - tile.y0);
        }
        progress.add(x - tile.x0);
    }
    job.add_counts(counts, film.counts());
}

}  // namespace

RenderResult render(const scene::World& world, const bvh::Accel& accel, const scene::Camera& camera,
                    const RenderOptions& options, const ProgressFunction& on_progress,
                    const std::atomic<bool>& cancel) {
    const auto [width, height] = options.resolution;
    Job job{world,
            accel,
            options,
            cancel,
            CameraRays(camera, options.resolution),
            options.crop.value_or(PixelRect{0, 0, width, height})};
    const PixelRect& area = job.area;
    LRAY_ASSERT(area.x0 < area.x1 && area.x1 <= width && area.y0 < area.y1 && area.y1 <= height);
    job.result.image = image::Image(area.width(), area.height());

    const std::uint32_t thread_count =
        options.thread_count != 0 ? options.thread_count
                                  : static_cast<std::uint32_t>(tbb::info::default_concurrency());
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, thread_count);
    tbb::task_arena arena(static_cast<int>(thread_count));

    const std::uint64_t tile_count =
        std::uint64_t{tile_count_along(area.width())} * tile_count_along(area.height());
    ProgressMeter progress(area.pixel_count(), on_progress);
    arena.execute([&] {
        tbb::parallel_for(
            tbb::blocked_range<std::uint64_t>(0, tile_count),
            [&](const tbb::blocked_range<std::uint64_t>& tiles) {
                for (std::uint64_t tile = tiles.begin(); tile != tiles.end(); ++tile) {
                    render_tile(job, tile_rect(area, tile), progress);
                }
            },
            tbb::simple_partitioner());
    });
    job.result.thread_count = thread_count;
    job.result.is_complete = progress.is_complete();
    return std::move(job.result);
}

}  // namespace lray::render
