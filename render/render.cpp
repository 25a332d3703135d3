// Tiles on threads, in blocks of pixels. Each block adds up its samples on a film of its own and
// resolves it into the picture, so that memory beyond the picture does not grow with it.
#include "render/render.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <utility>

#include "base/assert.h"
#include "render/sample_tracer.h"
#include "render/threads.h"

namespace lray::render {

namespace {

constexpr std::uint32_t kTileSize = 16;  // what a thread takes at a time
constexpr std::uint32_t kBlockSize = 8;  // whose rays are traced together, sample by sample
constexpr std::chrono::milliseconds kProgressPeriod{100};

/// A grid of squares over an area, those at its right and lower edge cut off.
struct Squares {
    PixelRect area{};
    std::uint32_t size = 1;

    std::uint64_t count() const {
        return std::uint64_t{along(area.width())} * along(area.height());
    }

    PixelRect at(std::uint64_t index) const {
        const std::uint32_t columns = along(area.width());
        const std::uint32_t x = static_cast<std::uint32_t>(index % columns) * size;
        const std::uint32_t y = static_cast<std::uint32_t>(index / columns) * size;
        return {area.x0 + x, area.y0 + y, area.x0 + std::min(x + size, area.width()),
                area.y0 + std::min(y + size, area.height())};
    }

 private:
    std::uint32_t along(std::uint32_t pixel_count) const {
        return pixel_count / size + (pixel_count % size != 0 ? 1 : 0);
    }
};

/// Counts samples that are done and reports them now and then.
class ProgressMeter {
 public:
    ProgressMeter(std::uint64_t total_samples, const ProgressFunction& on_progress)
        : total_(total_samples), on_progress_(on_progress) {}

    void add(std::uint64_t sample_count) {
        const std::uint64_t done = done_ += sample_count;
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

/// What samples cost, and which were not added as they came.
struct Tally {
    RayCounts rays{};
    FilmCounts samples{};

    Tally& operator+=(const Tally& other) {
        rays += other.rays;
        samples += other.samples;
        return *this;
    }
};

/// What the tiles share. Each writes its own pixels of the picture.
struct Job {
    SampleTracer tracer;
    PixelRect area{};
    SampleRange samples{};
    const std::atomic<bool>& cancel;
    ProgressMeter progress;
    RenderResult result{};
    Tally tally{};
    std::mutex tally_mutex{};
};

Tally render_block(Job& job, const PixelRect& block) {
    Film film(block.width(), block.height());
    Tally tally;
    for (std::uint32_t sample = job.samples.begin; sample != job.samples.end; ++sample) {
        const std::uint32_t done =
            job.tracer.add_sample(block, sample, film, tally.rays, job.cancel);
        if (done == 0) break;
        job.progress.add(done);
    }
    for (std::uint32_t y = 0; y < block.height(); ++y) {
        for (std::uint32_t x = 0; x < block.width(); ++x) {
            job.result.image.at(block.x0 - job.area.x0 + x, block.y0 - job.area.y0 + y) =
                film.resolve(x, y);
        }
    }
    tally.samples = film.counts();
    return tally;
}

void render_tile(Job& job, const PixelRect& tile) {
    const Squares blocks{tile, kBlockSize};
    Tally tally;
    for (std::uint64_t block = 0; block != blocks.count(); ++block) {
        tally += render_block(job, blocks.at(block));
    }
    const std::lock_guard lock(job.tally_mutex);
    job.tally += tally;
}

}  // namespace

RenderResult render(const scene::World& world, const bvh::Accel& accel, const scene::Camera& camera,
                    const RenderOptions& options, const ProgressFunction& on_progress,
                    const std::atomic<bool>& cancel) {
    const auto [width, height] = options.resolution;
    const PixelRect area = options.crop.value_or(PixelRect{0, 0, width, height});
    LRAY_ASSERT(area.x0 < area.x1 && area.x1 <= width && area.y0 < area.y1 && area.y1 <= height);
    const SampleRange samples = options.samples;
    LRAY_ASSERT(samples.begin < samples.end && samples.count() <= Film::kMaxSamples);
    Job job{.tracer = SampleTracer(world, accel, camera, options),
            .area = area,
            .samples = samples,
            .cancel = cancel,
            .progress = ProgressMeter(area.pixel_count() * samples.count(), on_progress)};
    job.result.image = image::Image(area.width(), area.height());
    job.result.thread_count = thread_count_of(options.thread_count);

    const Squares tiles{area, kTileSize};
    with_threads(options.thread_count, [&] {
        tbb::parallel_for(
            tbb::blocked_range<std::uint64_t>(0, tiles.count()),
            [&](const tbb::blocked_range<std::uint64_t>& range) {
                for (std::uint64_t tile = range.begin(); tile != range.end(); ++tile) {
                    render_tile(job, tiles.at(tile));
                }
            },
            tbb::simple_partitioner());
    });
    job.result.primary = job.tally.rays.primary;
    job.result.light = job.tally.rays.light;
    job.result.samples = job.tally.samples;
    job.result.is_complete = job.progress.is_complete();
    return std::move(job.result);
}

}  // namespace lray::render
