#include "shade/transport/whitted.h"

#include "shade/models/reflection.h"
#include "shade/transport/boundary.h"

namespace lray::shade {

namespace {

/// Adds up what lights, one after the other, bring to all points of the wave: rays to one light
/// run close together.
class DirectLight {
 public:
    DirectLight(const WaveContext& context, const Wave& wave) : context_(context), wave_(wave) {
        for (std::size_t i = 0; i < wave.count; ++i) {
            const ShadingPoint& point = wave.points[i];
            wo_[i] = point.local(point.wo);
            origins_[i] = point.leaving(point.wo).origin;  // on the side of all lights
            sums_[i] = Color{0.0f};
            is_lit_[i] = point.is_outside || point.material.two_sided;
        }
    }

    void add_light(std::uint32_t light) {
        const std::uint32_t sample_count = context_.lit.lights.sample_count(light);
        for (std::uint32_t part = 0; part < sample_count; ++part) {
            for (std::size_t i = 0; i < wave_.count; ++i) {
                if (is_lit_[i]) add_sample(i, light, part, sample_count);
            }
            shadows_.follow(context_, [&](std::size_t point, Color light_through) {
                sums_[point] += light_through;
            });
        }
    }

    Color sum(std::size_t point) const { return sums_[point]; }

 private:
    void add_sample(std::size_t i, std::uint32_t light, std::uint32_t part,
                    std::uint32_t sample_count) {
        const ShadingPoint& point = wave_.points[i];
        const TransportRay& ray = wave_.rays[i];
        const LightTable& lights = context_.lit.lights;
        const DVec2 u =
            lights.has_extent(light)
                ? context_.sample_of(ray).pair(ray.decision(kLightPoint, light), part, sample_count)
                : DVec2{0.0};
        const std::optional<LightSample> sample =
            lights.sample(light, DVec3{point.surface.position}, point.normal, u);
        if (!sample || !point.is_before(sample->wi)) return;
        const Color bright = sample->irradiance / static_cast<float>(sample_count) *
                             reflected(point.material, point.local(sample->wi), wo_[i]);
        if (bright == Color{0.0f}) return;
        if (lights.casts_shadow(light)) {
            shadows_.add({origins_[i], sample->wi}, sample->distance, i, bright);
        } else {
            sums_[i] += bright;
        }
    }

    const WaveContext& context_;
    const Wave& wave_;
    ShadowWave shadows_;
    std::array<Vec3, kMaxWaveSize> wo_;
    std::array<Vec3, kMaxWaveSize> origins_;
    std::array<Color, kMaxWaveSize> sums_;
    std::array<bool, kMaxWaveSize> is_lit_;
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
    for (std::size_t i = 0; i < wave.count; ++i) {
        const MaterialPoint& material = wave.points[i].material;
        context.add(wave.rays[i], material.emission + context.settings.ambient * material.ambient +
                                      direct.sum(i));
        push_onward(context, wave.rays[i], wave.points[i], wave.distances[i]);
    }
}

}  // namespace lray::shade
