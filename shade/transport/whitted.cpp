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
        const std::uint32_t sample_count = lights.sample_count(light);
        for (std::uint32_t part = 0; part < sample_count; ++part) {
            // What kind of light it is, is asked for once for all points.
            lights.visit(light, [&](const auto& source) {
                for (std::size_t i = 0; i < wave_.size(); ++i) {
                    if (is_lit_[i]) add_sample(source, i, light, part, sample_count);
                }
            });
            shadows_.follow(context_,
                            [&](std::size_t i, const Color& through) { sums_[i] += through; });
        }
    }

    const Color& sum(std::size_t point) const { return sums_[point]; }

 private:
    template <class Source>
    void add_sample(const Source& source, std::size_t i, std::uint32_t light, std::uint32_t part,
                    std::uint32_t sample_count) {
        const auto& [ray, point, distance] = wave_[i];
        const DVec3 position{point.surface.position};
        if (is_below(source, position, point.facing())) return;
        const LightTable& lights = context_.lit.lights;
        const DVec2 u =
            lights.has_extent(light)
                ? context_.sample_of(ray).pair(ray.decision(kLightPoint, light), part, sample_count)
                : DVec2{0.0};
        const std::optional<LightSample> sample = sample_light(source, position, point.normal, u);
        if (!sample || !point.is_before(sample->wi)) return;
        const Vec3 wi = point.local(sample->wi);
        const Color irradiance = sample_count == 1
                                     ? sample->irradiance
                                     : sample->irradiance / static_cast<float>(sample_count);
        const Color bright = irradiance * reflected(point.material, wi, wo_[i]);
        if (bright == Color{0.0f}) return;
        if (lights.casts_shadow(light)) {
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
