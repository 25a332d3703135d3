#include "shade/transport/path.h"

#include <algorithm>
#include <numbers>

#include "shade/models/reflection.h"
#include "shade/transport/boundary.h"

namespace lray::shade {

namespace {

/// Rays after so many bounces are ended at random, the sooner the less they carry.
constexpr std::uint32_t kSureBounces = 3;

/// The ways that a path may go on from a surface, and how likely each is taken.
struct Ways {
    Vec3 wo{};  // in the shading frame
    Boundary boundary{};
    float reflection = 0.0f;  // by the reflection model
    float mirror = 0.0f;
    float through = 0.0f;

    bool is_end() const { return !(reflection + mirror + through > 0.0f); }
};

Ways ways_from(const WaveContext& context, const TransportRay& ray, const ShadingPoint& point) {
    Ways ways;
    ways.wo = point.local(point.wo);
    ways.boundary = boundary_at(context.lit, ray, point);
    if (point.is_outside || point.material.two_sided) {
        ways.reflection = largest(reflected_share(point.material, ways.wo));
    }
    ways.mirror = largest(ways.boundary.mirror_weight);
    ways.through = largest(ways.boundary.through_weight);
    const float sum = ways.reflection + ways.mirror + ways.through;
    if (sum > 0.0f) {
        ways.reflection /= sum;
        ways.mirror /= sum;
        ways.through /= sum;
    }
    return ways;
}

void add_light_sample(const WaveContext& context, ShadowWave& shadows, const Wave& wave,
                      std::size_t i, const Ways& ways, bool is_last) {
    const LightTable& lights = context.lit.lights;
    if (lights.count() == 0 || ways.reflection == 0.0f) return;
    const TransportRay& ray = wave[i].ray;
    const ShadingPoint& point = wave[i].point;
    const PixelSample& random = context.sample_of(ray);
    const DVec3 position{point.surface.position};
    const auto choice = lights.choose(position, random.number(ray.decision(kLightChoice)));
    if (!choice) return;
    const auto [light, probability] = *choice;
    const std::optional<LightSample> sample =
        lights.sample(light, position, point.normal, random.pair(ray.decision(kLightPoint)));
    if (!sample || !point.is_before(sample->wi)) return;
    const Vec3 wi = point.local(sample->wi);
    Color bright = sample->irradiance / probability * reflected(point.material, wi, ways.wo);
    if (bright == Color{0.0f}) return;
    if (sample->pdf > 0.0f && !is_last) {  // else no ray of the other kind may bring this light
        bright *= balance(sample->pdf * probability,
                          ways.reflection * reflected_pdf(point.material, wi, ways.wo));
    }
    if (lights.casts_shadow(light)) {
        shadows.add(point.leaving(sample->wi).origin, *sample, i, bright);
    } else {
        context.add(ray, bright);
    }
}

/// Returns the ray that the path goes on with; empty where it ends.
std::optional<TransportRay> onward(const WaveContext& context, const TransportRay& ray,
                                   const ShadingPoint& point, float t, const Ways& ways) {
    const PixelSample& random = context.sample_of(ray);
    double choice = random.number(ray.decision(kComponent));
    if (choice < static_cast<double>(ways.reflection)) {
        const auto sample =
            sample_reflected(point.material, ways.wo, random.number(ray.decision(kLobe)),
                             random.pair(ray.decision(kDirection)));
        if (!sample) return std::nullopt;
        const Vec3 direction = point.from_local(sample->wi);
        if (!point.is_before(direction)) return std::nullopt;
        const float pdf = sample->pdf * ways.reflection;
        TransportRay next = ray.next(point.leaving(direction), t, kBounce);
        next.weight *=
            reflected(point.material, sample->wi, ways.wo) / (std::numbers::pi_v<float> * pdf);
        next.pdf = pdf;
        next.normal = point.normal;
        return next;
    }
    const bool is_mirror =
        choice < static_cast<double>(ways.reflection + ways.mirror) || ways.through == 0.0f;
    const Boundary& boundary = ways.boundary;
    TransportRay next =
        ray.next(point.leaving(is_mirror ? boundary.mirror_direction : boundary.through_direction),
                 t, is_mirror ? kMirror : kRefraction);
    if (is_mirror) {
        if (ways.mirror == 0.0f) return std::nullopt;
        next.weight *= boundary.mirror_weight / ways.mirror;
    } else {
        next.weight *= boundary.through_weight / ways.through;
        next.media = boundary.media_through;
    }
    next.pdf = 0.0f;
    return next;
}

void push(const WaveContext& context, TransportRay ray) {
    const float weight = largest(ray.weight);
    if (!(weight > 0.0f)) return;
    ++ray.depth;
    ray.passes = 0;
    if (ray.depth > kSureBounces && weight < 1.0f) {
        const PixelSample& random = context.sample_of(ray);
        if (random.number(ray.decision(kRoulette)) >= static_cast<double>(weight)) return;
        ray.weight /= weight;
    }
    context.queue.push_back(ray);
}

}  // namespace

void shade_paths(const WaveContext& context, Wave& wave) {
    ShadowWave shadows;
    for (std::size_t i = 0; i < wave.size(); ++i) {
        const auto& [ray, point, distance] = wave[i];
        context.add(ray, point.material.emission);
        const Ways ways = ways_from(context, ray, point);
        const bool is_last = ray.depth >= context.settings.max_depth;
        add_light_sample(context, shadows, wave, i, ways, is_last);
        if (is_last || ways.is_end()) continue;
        if (const auto next = onward(context, ray, point, distance, ways)) {
            push(context, *next);
        }
    }
    shadows.follow(context, [&](std::size_t i, Color light) { context.add(wave[i].ray, light); });
}

}  // namespace lray::shade
