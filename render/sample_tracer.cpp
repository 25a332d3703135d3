#include "render/sample_tracer.h"

#include <algorithm>
#include <array>
#include <span>

#include "base/assert.h"
#include "render/pixel_sample.h"
#include "shade/depth.h"
#include "shade/transport/boundary.h"

namespace lray::render {

namespace {

constexpr std::uint32_t kMaxBatchSize = 64;
static_assert(kMaxBatchSize <= shade::kMaxWaveSize);

}  // namespace

/// Rays that are traced together. Each may meet anything: no interval is ever changed.
struct SampleTracer::Batch {
    std::array<Ray, kMaxBatchSize> rays;
    std::array<Interval, kMaxBatchSize> intervals;
    std::array<bvh::Hit, kMaxBatchSize> hits;
    std::array<bvh::TraceCounts, kMaxBatchSize> counts;  // of each ray, where its cost is shown
    std::array<PixelSample, kMaxBatchSize> samples;
    std::array<shade::RayCone, kMaxBatchSize> cones;
    std::array<Color, kMaxBatchSize> colors;
};

namespace {

template <class Batch>
bvh::TraceCounts trace(const bvh::Accel& accel, Batch& batch, std::size_t size, bool is_cost_shown,
                       const std::atomic<bool>& cancel) {
    bvh::TraceCounts counts{.cancel = &cancel};
    if (!is_cost_shown) {
        accel.nearest_hits(std::span(batch.rays).first(size),
                           std::span(batch.intervals).first(size),
                           std::span(batch.hits).first(size), counts);
        return counts;
    }
    for (std::size_t i = 0; i < size; ++i) {
        batch.counts[i] = {.cancel = &cancel};
        batch.hits[i] = accel.nearest_hit(batch.rays[i], batch.intervals[i], batch.counts[i]);
        counts += batch.counts[i];
    }
    return counts;
}

}  // namespace

SampleTracer::SampleTracer(const scene::World& world, const bvh::Accel& accel,
                           const scene::Camera& camera, const RenderOptions& options)
    : accel_(accel),
      rays_(camera, options.resolution),
      options_(options),
      shading_{world, options.shading} {
    LRAY_ASSERT(options.batch_size > 0);
    shading_.settings.depth_unit = shade::depth_unit(camera.position, camera.look_at);
    options_.batch_size = std::min(options.batch_size, kMaxBatchSize);
    if (options_.shading.shader == shade::Shader::full) {
        LRAY_ASSERT(options_.lit != nullptr);
        bvh::TraceCounts cost;
        camera_media_ = shade::media_at(*options_.lit, Vec3{camera.position}, cost);
    }
}

bool SampleTracer::shade(Batch& batch, std::size_t size, shade::LightCounts& counts,
                         const std::atomic<bool>& cancel) const {
    if (options_.shading.shader != shade::Shader::full) {
        for (std::size_t i = 0; i < size; ++i) {
            batch.colors[i] = shade::shade(shading_, batch.rays[i], batch.hits[i], batch.counts[i]);
        }
        return true;
    }
    const shade::CameraWave wave{std::span(batch.rays).first(size),
                                 std::span(batch.cones).first(size),
                                 std::span(batch.samples).first(size),
                                 std::span(batch.hits).first(size)};
    return shade::follow_light(*options_.lit, options_.shading, camera_media_, wave,
                               std::span(batch.colors).first(size), counts, cancel);
}

std::uint32_t SampleTracer::add_sample(const PixelRect& part, std::uint32_t sample, Film& film,
                                       RayCounts& counts,
                                       const std::atomic<bool>& cancel) const {
    LRAY_DCHECK(film.width() == part.width() && film.height() == part.height());
    const auto pixel_count = static_cast<std::uint32_t>(part.pixel_count());
    const bool is_cost_shown = options_.shading.shader == shade::Shader::cost;
    Batch batch;
    std::uint32_t done = 0;
    while (done < pixel_count && !cancel.load(std::memory_order_relaxed)) {
        const std::uint32_t size = std::min(options_.batch_size, pixel_count - done);
        for (std::uint32_t i = 0; i < size; ++i) {
            const std::uint32_t x = part.x0 + (done + i) % part.width();
            const std::uint32_t y = part.y0 + (done + i) / part.width();
            batch.samples[i] =
                PixelSample::of(options_.sampler, options_.seed, x, y, sample);
            batch.cones[i] = {};
            batch.rays[i] =
                rays_.through(sample_position(options_.position, options_.seed, x, y, sample));
        }
        const bvh::TraceCounts cost = trace(accel_, batch, size, is_cost_shown, cancel);
        counts.primary += cost;
        if (cost.is_ended) break;
        if (!shade(batch, size, counts.light, cancel)) break;
        for (std::uint32_t i = 0; i < size; ++i) {
            film.add((done + i) % part.width(), (done + i) / part.width(), batch.colors[i]);
        }
        done += size;
    }
    return done;
}

}  // namespace lray::render
