// Tiles on threads, in blocks of pixels. Without a limit of time each block is rendered to its end
// on a film of its own, so that memory beyond the picture does not grow with it; with one, all
// blocks are kept and go on together, pass by pass.
#include "render/render.h"

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

#include "base/assert.h"
#include "render/block.h"
#include "render/progress_meter.h"
#include "render/sample_tracer.h"
#include "render/squares.h"
#include "render/threads.h"
#include "render/tiles.h"

namespace lray::render {

namespace {

constexpr std::uint32_t kSamplesPerReport = 4;  // of a block, between two looks at progress
constexpr double kPassSeconds = 0.05;           // what a pass takes if it holds several samples

/// What the tiles share. Each writes its own pixels of the picture.
struct Job {
    BlockSettings settings;
    PixelRect area{};
    ProgressMeter progress;
    KeptFilm* kept = nullptr;
    RenderResult result{};
    std::mutex result_mutex{};
};

void take_work(Job& job, const BlockWork& work) {
    const std::lock_guard lock(job.result_mutex);
    job.result.primary += work.rays.primary;
    job.result.light += work.rays.light;
    job.result.sample_count += work.samples;
    job.result.converged_pixels += work.converged_pixels;
    if (work.is_cancelled) job.result.is_complete = job.result.has_all_samples = false;
}

Block make_block(Job& job, const PixelRect& part) {
    if (job.kept == nullptr) return {part, job.settings};
    Block block(part, job.kept->part(part), job.settings);
    job.progress.add(0, part.pixel_count() - block.open_count());
    return block;
}

/// Renders a block up to a sample.
BlockWork advance(Job& job, Block& block, SampleRange samples) {
    BlockWork work;
    std::uint32_t next = std::max(samples.begin, block.next_sample());
    while (next < samples.end && !block.is_finished() && !work.is_cancelled) {
        next += std::min(kSamplesPerReport, samples.end - next);
        const FilmCounts before = block.counts();
        const BlockWork more = block.advance(next, job.settings);
        job.progress.add(more.samples, more.finished_pixels);
        work += more;
        // Cancelled, some pixels have a sample more than others: nothing to go on from.
        if (job.kept == nullptr || more.is_cancelled) continue;
        job.kept->put(block.part(), block.film(), block.counts() - before);
    }
    return work;
}

void finish_block(Job& job, const Block& block, FilmCounts& counts) {
    if (job.kept != nullptr) return;  // what there is is on that film
    block.resolve(job.area, job.result.image);
    counts += block.counts();
}

void render_tile(Job& job, const PixelRect& tile) {
    const Squares parts{tile, kBlockSize};
    BlockWork work;
    FilmCounts counts;
    for (std::uint64_t part = 0; part != parts.count(); ++part) {
        Block block = make_block(job, parts.at(part));
        work += advance(job, block, job.settings.samples);
        finish_block(job, block, counts);
    }
    take_work(job, work);
    const std::lock_guard lock(job.result_mutex);
    job.result.samples += counts;
}

void render_tiles(Job& job) {
    const Squares tiles{job.area, kTileSize};
    for_each_tile(tiles.count(), [&](std::uint64_t tile) { render_tile(job, tiles.at(tile)); });
}

using Tile = std::vector<Block>;

std::vector<Tile> make_tiles(Job& job) {
    const Squares areas{job.area, kTileSize};
    std::vector<Tile> tiles(areas.count());
    for (std::uint64_t i = 0; i != areas.count(); ++i) {
        const Squares parts{areas.at(i), kBlockSize};
        for (std::uint64_t part = 0; part != parts.count(); ++part) {
            tiles[i].push_back(make_block(job, parts.at(part)));
        }
    }
    return tiles;
}

bool is_finished(const std::vector<Tile>& tiles) {
    return std::all_of(tiles.begin(), tiles.end(), [](const Tile& tile) {
        return std::all_of(tile.begin(), tile.end(),
                           [](const Block& block) { return block.is_finished(); });
    });
}

/// The first sample that some pixel still gets.
std::uint32_t first_open_sample(const std::vector<Tile>& tiles, SampleRange samples) {
    std::uint32_t first = samples.end;
    for (const Tile& tile : tiles) {
        for (const Block& block : tile) {
            if (!block.is_finished()) first = std::min(first, block.next_sample());
        }
    }
    return first;
}

/// How many samples the next pass gives each pixel: one, or more where that is quick, but not
/// beyond the time.
std::uint32_t pass_size(double seconds_per_sample, double seconds_left) {
    const double size = std::min(kPassSeconds, seconds_left) / seconds_per_sample;
    return static_cast<std::uint32_t>(std::clamp(size, 1.0, double{Film::kMaxSamples}));
}

void render_passes(Job& job, double seconds) {
    std::vector<Tile> tiles = make_tiles(job);
    const SampleRange samples = job.settings.samples;
    const std::uint32_t first = first_open_sample(tiles, samples);
    SampleRange pass{first, std::min(first + 1, samples.end)};
    while (pass.begin != samples.end) {
        const double begin = job.progress.seconds();
        for_each_tile(tiles.size(), [&](std::uint64_t i) {
            BlockWork work;
            for (Block& block : tiles[i]) work += advance(job, block, pass);
            take_work(job, work);
        });
        const double now = job.progress.seconds();
        const bool is_over = now >= seconds || pass.end == samples.end || is_finished(tiles);
        if (is_over || !job.result.is_complete) break;
        const double per_sample = std::max((now - begin) / pass.count(), 1e-9);
        const std::uint32_t size = pass_size(per_sample, seconds - now);
        pass = {pass.end, pass.end + std::min(size, samples.end - pass.end)};
    }
    job.result.has_all_samples = is_finished(tiles);
    for (const Tile& tile : tiles) {
        for (const Block& block : tile) finish_block(job, block, job.result.samples);
    }
}

}  // namespace

RenderResult render(const scene::World& world, const bvh::Accel& accel, const scene::Camera& camera,
                    const RenderOptions& options, const ProgressFunction& on_progress,
                    const std::atomic<bool>& cancel, KeptFilm* kept) {
    const auto [width, height] = options.resolution;
    const PixelRect area = options.crop.value_or(PixelRect{0, 0, width, height});
    LRAY_ASSERT(area.x0 < area.x1 && area.x1 <= width && area.y0 < area.y1 && area.y1 <= height);
    const SampleRange samples = options.samples;
    LRAY_ASSERT(samples.begin < samples.end && samples.count() <= Film::kMaxSamples);
    const SampleTracer tracer(world, accel, camera, options, cancel);
    const RenderProgress total{.total_samples = area.pixel_count() * samples.count(),
                               .total_pixels = area.pixel_count(),
                               .kept_samples = kept == nullptr ? 0 : kept->sample_count(),
                               .limits = options.limits};
    Job job{.settings = {tracer, samples, options.limits.noise, image::Display(options.display),
                         cancel},
            .area = area,
            .progress = ProgressMeter(total, on_progress),
            .kept = kept};
    job.result.image = image::Image(area.width(), area.height());
    job.result.thread_count = thread_count_of(options.thread_count);
    with_threads(options.thread_count, [&] {
        if (options.limits.seconds) {
            render_passes(job, *options.limits.seconds);
        } else {
            render_tiles(job);
        }
    });
    if (kept != nullptr) {
        const Film film = kept->film();
        job.result.image = film.picture();
        job.result.samples = film.counts();
    }
    return std::move(job.result);
}

}  // namespace lray::render
