#include "render/sample_tracer.h"

#include <algorithm>
#include <array>
#include <span>

#include "base/assert.h"
#include "base/fixed_list.h"
#include "render/decisions.h"
#include "shade/depth.h"
#include "shade/transport/boundary.h"

namespace lray::render {

namespace {

constexpr std::uint32_t kMaxBatchSize = 64;
static_assert(kMaxBatchSize <= shade::kMaxWaveSize);

}  // namespace

/// Rays that are traced together, the place on the film and the random numbers of each. Each may
/// meet anything: no interval is ever changed.
struct SampleTracer::Batch {
    FixedList<FilmPlace, kMaxBatchSize> places;
    FixedList<PixelSample, kMaxBatchSize> samples;
    FixedList<Ray, kMaxBatchSize> rays;
    FixedList<shade::RayCone, kMaxBatchSize> cones;
    FixedList<bvh::TraceCounts, kMaxBatchSize> counts;  // of each ray, where its cost is shown
    std::array<bvh::Hit, kMaxBatchSize> hits;
    std::array<Color, kMaxBatchSize> colors;

    std::size_t size() const { return rays.size(); }
    void clear() {
        places.clear();
        samples.clear();
        rays.clear();
        cones.clear();
        counts.clear();
    }
};

SampleTracer::SampleTracer(const scene::World& world, const bvh::Accel& accel,
                           const scene::Camera& camera, const RenderOptions& options,
                           const std::atomic<bool>& cancel)
    : accel_(accel),
      rays_(camera, options.resolution),
      options_(options),
      shading_{world, options.shading} {
    LRAY_ASSERT(options.batch_size > 0);
    shading_.settings.depth_unit = shade::depth_unit(camera.position, camera.look_at);
    options_.batch_size = std::min(options.batch_size, kMaxBatchSize);
    if (options_.shading.shader == shade::Shader::full) {
        LRAY_ASSERT(options_.lit != nullptr);
        bvh::TraceCounts cost{.cancel = &cancel};
        camera_media_ = shade::media_at(*options_.lit, Vec3{camera.position}, cost);
    }
}

bvh::TraceCounts SampleTracer::trace(Batch& batch, const std::atomic<bool>& cancel) const {
    bvh::TraceCounts counts{.cancel = &cancel};
    if (options_.shading.shader != shade::Shader::cost) {
        static constexpr std::array<Interval, kMaxBatchSize> kIntervals{};
        accel_.nearest_hits(batch.rays.all(), std::span(kIntervals).first(batch.size()),
                            std::span(batch.hits).first(batch.size()), counts);
        return counts;
    }
    for (std::size_t i = 0; i < batch.size(); ++i) {
        bvh::TraceCounts& cost = batch.counts.add({.cancel = &cancel});
        batch.hits[i] = accel_.nearest_hit(batch.rays[i], {}, cost);
        counts += cost;
    }
    return counts;
}

bool SampleTracer::shade(Batch& batch, shade::LightCounts& counts,
                         const std::atomic<bool>& cancel) const {
    if (options_.shading.shader != shade::Shader::full) {
        const bool shows_cost = !batch.counts.is_empty();
        for (std::size_t i = 0; i < batch.size(); ++i) {
            batch.colors[i] = shade::shade(shading_, batch.rays[i], batch.hits[i],
                                           shows_cost ? batch.counts[i] : bvh::TraceCounts{});
        }
        return true;
    }
    const shade::CameraWave wave{batch.rays.all(), batch.cones.all(), batch.samples.all(),
                                 std::span(batch.hits).first(batch.size())};
    return shade::follow_light(*options_.lit, options_.shading, camera_media_, wave,
                               std::span(batch.colors).first(batch.size()), counts, cancel);
}

PixelSample SampleTracer::pixel_sample(std::uint32_t x, std::uint32_t y,
                                       std::uint32_t index) const {
    return PixelSample::of(options_.sampler, options_.seed, x, y, index);
}

/// Without random positions all is in the middle, the ray on the lens too.
Ray SampleTracer::camera_ray(std::uint32_t x, std::uint32_t y, const PixelSample& sample) const {
    const DVec2 corner{x, y};
    if (options_.position == PixelPosition::center) return rays_.through(corner + DVec2{0.5});
    const DVec2 position = corner + sample.pair(kPositionDecision);
    if (!rays_.has_lens()) return rays_.through(position);
    return rays_.through(position, sample.pair(kLensDecision));
}

shade::RayCone SampleTracer::pixel_cone(std::uint32_t x, std::uint32_t y) const {
    if (options_.lit == nullptr || !options_.lit->materials.has_textures()) return {};
    return rays_.cone(DVec2{x, y} + DVec2{0.5});
}

void SampleTracer::add_ray(Batch& batch, std::uint32_t x, std::uint32_t y,
                           std::uint32_t index) const {
    const PixelSample& sample = batch.samples.add_made([&] { return pixel_sample(x, y, index); });
    batch.rays.add_made([&] { return camera_ray(x, y, sample); });
    batch.cones.add_made([&] { return pixel_cone(x, y); });
}

bool SampleTracer::finish(Batch& batch, RayCounts& counts, const std::atomic<bool>& cancel) const {
    const bvh::TraceCounts cost = trace(batch, cancel);
    counts.primary += cost;
    return !cost.is_ended && shade(batch, counts.light, cancel);
}

std::uint64_t SampleTracer::add_samples(const PixelRect& part, std::span<const FilmPlace> places,
                                        SampleRange samples, Film& film, RayCounts& counts,
                                        const std::atomic<bool>& cancel) const {
    LRAY_DCHECK(film.width() == part.width() && film.height() == part.height());
    const std::uint64_t total = std::uint64_t{places.size()} * samples.count();
    Batch batch;
    std::size_t at = 0;
    std::uint32_t index = samples.begin;
    std::uint64_t done = 0;
    while (done < total && !cancel.load(std::memory_order_relaxed)) {
        const auto size =
            static_cast<std::uint32_t>(std::min<std::uint64_t>(options_.batch_size, total - done));
        batch.clear();
        while (batch.size() < size) {
            const FilmPlace place = batch.places.add(places[at]);
            add_ray(batch, part.x0 + place.x, part.y0 + place.y, index);
            if (++at == places.size()) {
                at = 0;
                ++index;
            }
        }
        if (!finish(batch, counts, cancel)) break;
        for (std::uint32_t i = 0; i < size; ++i) {
            film.add(batch.places[i].x, batch.places[i].y, batch.colors[i]);
        }
        done += size;
    }
    return done;
}

bool SampleTracer::colors_of(std::span<const FilmPlace> pixels, std::uint32_t index,
                             std::span<Color> colors, RayCounts& counts,
                             const std::atomic<bool>& cancel) const {
    LRAY_DCHECK(pixels.size() == colors.size());
    Batch batch;
    while (!pixels.empty()) {
        if (cancel.load(std::memory_order_relaxed)) return false;
        const std::size_t size = std::min<std::size_t>(options_.batch_size, pixels.size());
        batch.clear();
        for (const FilmPlace pixel : pixels.first(size)) add_ray(batch, pixel.x, pixel.y, index);
        if (!finish(batch, counts, cancel)) return false;
        std::copy_n(batch.colors.begin(), size, colors.begin());
        pixels = pixels.subspan(size);
        colors = colors.subspan(size);
    }
    return true;
}

}  // namespace lray::render
