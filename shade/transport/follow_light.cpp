#include "shade/transport/follow_light.h"

#include <algorithm>

#include "base/assert.h"
#include "shade/transport/absorption.h"
#include "shade/transport/path.h"
#include "shade/transport/whitted.h"

namespace lray::shade {

namespace {

/// So many holes a ray goes through before one counts as closed.
constexpr std::uint16_t kMaxPasses = 256;

/// The weight of a light that a ray met by itself.
float weight_of_light(const LitWorld& lit, const TransportRay& ray, std::uint32_t light) {
    if (ray.pdf == 0.0f) return 1.0f;
    const DVec3 origin{ray.ray.origin};
    return balance(ray.pdf, lit.lights.pdf(light, origin, ray.normal, ray.ray.dir) *
                                lit.lights.probability(light, origin));
}

void add_what_is_behind(const WaveContext& context, const TransportRay& ray) {
    const LightTable& lights = context.lit.lights;
    if (!lights.has_environment()) {
        context.add(ray, context.settings.background);
        return;
    }
    context.add(ray, weight_of_light(context.lit, ray, lights.environment_light()) *
                         lights.environment(ray.ray.dir));
}

/// Brings light that is not that of a surface: of a light that the ray meets first, or of what is
/// behind everything. Returns false if there is no surface to go on with.
bool meets_surface(const WaveContext& context, TransportRay& ray, const bvh::Hit& hit) {
    const LightTable& lights = context.lit.lights;
    const auto light = lights.are_met()
                           ? lights.nearest_hit(ray.ray, shadow_interval(ray.ray, hit.t))
                           : std::nullopt;
    const float t = light ? light->t : hit.t;
    if (!ray.media.is_empty()) {
        const MaterialPoint& medium = context.lit.materials.average(ray.media.innermost());
        ray.weight *= transmittance(medium.absorption, t);
    }
    if (light) {
        context.add(ray, weight_of_light(context.lit, ray, light->light) * light->radiance);
        return false;
    }
    if (hit.is_none()) add_what_is_behind(context, ray);
    return !hit.is_none();
}

/// Sends on what goes through holes. Returns false if nothing is left for the surface.
bool is_solid(const WaveContext& context, TransportRay& ray, const ShadingPoint& point, float t) {
    const float opacity = point.material.opacity;
    if (opacity >= 1.0f || ray.passes == kMaxPasses) return true;
    TransportRay through = ray.next(point.leaving(ray.ray.dir), t, kThroughHole);
    ++through.passes;
    if (context.settings.integrator == scene::Integrator::path) {
        const PixelSample& random = context.sample_of(ray);
        if (random.number(ray.decision(kHole)) < static_cast<double>(opacity)) return true;
        context.queue.push_back(through);
        return false;
    }
    through.weight *= 1.0f - opacity;
    ray.weight *= opacity;
    if (largest(through.weight) >= kLeastWeight) context.queue.push_back(through);
    return largest(ray.weight) >= kLeastWeight;
}

void shade_wave(const WaveContext& context, Wave& wave) {
    if (wave.is_empty()) return;
    switch (context.settings.integrator) {
        case scene::Integrator::whitted:
            return shade_whitted(context, wave);
        case scene::Integrator::path:
            return shade_paths(context, wave);
    }
    LRAY_ASSERT(false);
}

void add_to_wave(const WaveContext& context, Wave& wave, TransportRay& ray, const bvh::Hit& hit) {
    if (!meets_surface(context, ray, hit)) return;
    MetSurface& met = wave.add_made([&] {
        return MetSurface{ray, shading_point(context.lit, ray, hit), hit.t};
    });
    if (!is_solid(context, met.ray, met.point, hit.t)) wave.remove_last();
}

/// Takes rays from the end of the queue: those that came last first, so that few are waiting.
void follow_queue(const WaveContext& context, Wave& wave) {
    std::vector<TransportRay>& queue = context.queue;
    const std::size_t size = std::min(queue.size(), kMaxWaveSize);
    FixedList<TransportRay, kMaxWaveSize> taken;
    FixedList<Ray, kMaxWaveSize> rays;
    for (std::size_t i = queue.size() - size; i < queue.size(); ++i) {
        taken.add(queue[i]);
        rays.add(queue[i].ray);
    }
    queue.resize(queue.size() - size);
    static constexpr std::array<Interval, kMaxWaveSize> kIntervals{};
    bvh::Hit hits[kMaxWaveSize];
    context.lit.accel.nearest_hits(rays.all(), std::span(kIntervals).first(size),
                                   std::span(hits).first(size), context.counts.onward);
    wave.clear();
    for (std::size_t i = 0; i < size; ++i) add_to_wave(context, wave, taken[i], hits[i]);
    shade_wave(context, wave);
}

/// True if a ray from the camera that hits nothing brings the background and nothing else.
bool has_plain_background(const LitWorld& lit, const Media& camera_media) {
    return camera_media.is_empty() && !lit.lights.are_met() && !lit.lights.has_environment();
}

}  // namespace

bool follow_light(const LitWorld& lit, const Settings& settings, const Media& camera_media,
                  const CameraWave& camera, std::span<Color> colors, LightCounts& counts,
                  const std::atomic<bool>& cancel) {
    const std::size_t size = camera.rays.size();
    LRAY_DCHECK(size <= kMaxWaveSize && colors.size() == size);
    std::array<SampleSum, kMaxWaveSize> sums{};
    std::vector<TransportRay> queue;
    LightCounts cost;
    cost.onward.cancel = &cancel;
    cost.shadow.cancel = &cancel;
    const WaveContext context{lit,
                              settings,
                              shadow_kind(lit, settings.transparent_shadows),
                              camera.samples,
                              std::span(sums).first(size),
                              queue,
                              cost};
    Wave wave;
    const bool shows_background = has_plain_background(lit, camera_media);
    for (std::uint32_t i = 0; i < size; ++i) {
        if (shows_background && camera.hits[i].is_none()) {
            sums[i].add(settings.background);
            continue;
        }
        TransportRay ray{.ray = camera.rays[i], .cone = camera.cones[i], .sample = i};
        ray.media = camera_media;
        add_to_wave(context, wave, ray, camera.hits[i]);
    }
    shade_wave(context, wave);
    while (!queue.empty()) {
        if (cancel.load(std::memory_order_relaxed)) return false;
        follow_queue(context, wave);
    }
    counts += cost;
    for (std::size_t i = 0; i < size; ++i) colors[i] = sums[i].color();
    return !cost.onward.is_ended && !cost.shadow.is_ended;
}

}  // namespace lray::shade
