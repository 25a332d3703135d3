#include "shade/transport/whitted.h"

#include <algorithm>
#include <numbers>

#include "shade/models/reflection.h"
#include "shade/transport/boundary.h"

namespace lray::shade {

namespace {

/// Of how many samples of a light one is which.
struct SampleKey {
    std::uint32_t light = 0;
    std::uint32_t part = 0;
    std::uint32_t count = 1;

    DVec2 pair(const WaveContext& context, const TransportRay& ray, Purpose purpose) const {
        return context.sample_of(ray).pair(ray.decision(purpose, light), part, count);
    }
};

/// Returns how many samples of a light are taken after reflections and refractions: each time a
/// quarter, as each time there are more such points to a pixel, and less of each is seen.
std::uint32_t samples_after(std::uint32_t count, std::uint32_t depth) {
    return depth < 16 ? std::max(count >> (2 * depth), 1u) : 1u;
}

/// Light of a source of known kind, by its sample u.
template <class Source>
std::optional<LightSample> sample_at(const Source& source, const WaveContext& /*context*/,
                                     const MetSurface& met, const Vec3& /*wo*/,
                                     const SampleKey& /*key*/, const DVec2& u) {
    return sample_light(source, DVec3{met.point.surface.position}, met.point.normal, u);
}

/// Light of an environment comes from everywhere: what has highlights chooses half of the
/// directions itself, or those few that it mirrors would be found by chance, and be too bright. The
/// density is that of both together. Source: Veach 1997, "Robust Monte Carlo Methods for Light
/// Transport Simulation", sec. 9.2 (the one-sample model with the balance heuristic).
std::optional<LightSample> sample_at(const Environment& sky, const WaveContext& context,
                                     const MetSurface& met, const Vec3& wo, const SampleKey& key,
                                     const DVec2& u) {
    const ShadingPoint& point = met.point;
    if (!has_highlight(point.material)) return sky.sample(point.normal, u);
    LightSample result;
    if (u.x < 0.5) {
        const auto by_sky = sky.sample(point.normal, {2.0 * u.x, u.y});
        if (!by_sky) return std::nullopt;
        result = *by_sky;
    } else {
        const double choice = key.pair(context, met.ray, kLobe).x;
        const auto by_surface =
            sample_reflected(point.material, wo, choice, {2.0 * u.x - 1.0, u.y});
        if (!by_surface) return std::nullopt;
        result.wi = point.from_local(by_surface->wi);
    }
    const float density = 0.5f * sky.density(point.normal, result.wi) +
                          0.5f * reflected_pdf(point.material, point.local(result.wi), wo);
    if (!(density > 0.0f)) return std::nullopt;
    result.irradiance =
        light_color(sky.radiance(result.wi), std::numbers::inv_pi / static_cast<double>(density));
    return result;
}

/// Adds up what lights, one after the other, bring to all points of the wave: rays to one light
/// run close together.
class DirectLight {
 public:
    DirectLight(const WaveContext& context, const Wave& wave) : context_(context), wave_(wave) {
        for (std::size_t i = 0; i < wave.size(); ++i) {
            const ShadingPoint& point = wave[i].point;
            wo_[i] = point.local(point.wo);
            origins_[i] = point.leaving(point.wo).origin;  // on the side of all lights
            sums_[i] = Color{0.0f};
            is_lit_[i] = point.is_outside || point.material.two_sided;
        }
    }

    void add_light(std::uint32_t light) {
        const LightTable& lights = context_.lit.lights;
        const std::uint32_t most =
            std::min(lights.sample_count(light), context_.settings.max_light_samples);
        for (std::uint32_t part = 0; part < most; ++part) {
            // What kind of light it is, is asked for once for all points.
            lights.visit(light, [&](const auto& source) {
                for (std::size_t i = 0; i < wave_.size(); ++i) {
                    const SampleKey key{light, part, samples_after(most, wave_[i].ray.depth)};
                    if (is_lit_[i] && part < key.count) add_sample(source, i, key);
                }
            });
            shadows_.follow(context_,
                            [&](std::size_t i, const Color& through) { sums_[i] += through; });
        }
    }

    const Color& sum(std::size_t point) const { return sums_[point]; }

 private:
    template <class Source>
    void add_sample(const Source& source, std::size_t i, const SampleKey& key) {
        const auto& [ray, point, distance] = wave_[i];
        const DVec3 position{point.surface.position};
        if (is_below(source, position, point.facing())) return;
        const LightTable& lights = context_.lit.lights;
        const DVec2 u =
            lights.has_extent(key.light) ? key.pair(context_, ray, kLightPoint) : DVec2{0.0};
        const std::optional<LightSample> sample =
            sample_at(source, context_, wave_[i], wo_[i], key, u);
        if (!sample || !point.is_before(sample->wi)) return;
        const Vec3 wi = point.local(sample->wi);
        const Color irradiance = key.count == 1
                                     ? sample->irradiance
                                     : sample->irradiance / static_cast<float>(key.count);
        const Color bright = irradiance * reflected(point.material, wi, wo_[i]);
        if (bright == Color{0.0f}) return;
        if (lights.casts_shadow(key.light)) {
            shadows_.add(origins_[i], *sample, i, bright);
        } else {
            sums_[i] += bright;
        }
    }

    const WaveContext& context_;
    const Wave& wave_;
    ShadowWave shadows_;
    Vec3 wo_[kMaxWaveSize];
    Vec3 origins_[kMaxWaveSize];
    Color sums_[kMaxWaveSize];
    bool is_lit_[kMaxWaveSize];
};

void push(const WaveContext& context, TransportRay ray, Color weight) {
    ray.weight *= weight;
    if (largest(ray.weight) < kLeastWeight) return;
    ++ray.depth;
    ray.passes = 0;
    context.queue.push_back(ray);
}

void push_onward(const WaveContext& context, const TransportRay& ray, const ShadingPoint& point,
                 float t) {
    const MaterialPoint& material = point.material;
    if (ray.depth >= context.settings.max_depth) return;
    if (material.reflect == Color{0.0f} && material.transmit == Color{0.0f}) return;
    const Boundary boundary = boundary_at(context.lit, ray, point);
    if (boundary.mirror_weight != Color{0.0f}) {
        push(context, ray.next(point.leaving(boundary.mirror_direction), t, kMirror),
             boundary.mirror_weight);
    }
    if (boundary.through_weight != Color{0.0f}) {
        TransportRay through = ray.next(point.leaving(boundary.through_direction), t, kRefraction);
        through.media = boundary.media_through;
        push(context, through, boundary.through_weight);
    }
}

}  // namespace

void shade_whitted(const WaveContext& context, Wave& wave) {
    DirectLight direct(context, wave);
    for (std::uint32_t light = 0; light < context.lit.lights.count(); ++light) {
        direct.add_light(light);
    }
    for (std::size_t i = 0; i < wave.size(); ++i) {
        const auto& [ray, point, distance] = wave[i];
        context.add(ray, point.material.emission +
                             context.settings.ambient * point.material.ambient + direct.sum(i));
        push_onward(context, ray, point, distance);
    }
}

}  // namespace lray::shade
