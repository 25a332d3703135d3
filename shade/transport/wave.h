// Rays that are followed together, and what they have in common.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/fixed_list.h"
#include "base/sampler.h"
#include "bvh/accel.h"
#include "shade/settings.h"
#include "shade/transport/lit_world.h"
#include "shade/transport/sample_sum.h"
#include "shade/transport/shading_point.h"
#include "shade/transport/shadow.h"
#include "shade/transport/transport_ray.h"
#include "shade/transport/wave_size.h"

namespace lray::shade {

/// What following light costs beside the rays from the camera.
struct LightCounts {
    bvh::TraceCounts onward{};  // rays after a reflection or refraction
    bvh::TraceCounts shadow{};

    LightCounts& operator+=(const LightCounts& other) {
        onward += other.onward;
        shadow += other.shadow;
        return *this;
    }
};

/// Samples that are followed together: where their light is added up, and the rays that are still
/// to be followed for them.
struct WaveContext {
    const LitWorld& lit;
    const Settings& settings;
    ShadowKind shadow_kind = ShadowKind::opaque;
    std::span<const PixelSample> samples{};
    std::span<SampleSum> sums{};
    std::vector<TransportRay>& queue;
    LightCounts& counts;

    void add(const TransportRay& ray, Color light) const {
        sums[ray.sample].add(ray.weight * light);
    }
    const PixelSample& sample_of(const TransportRay& ray) const { return samples[ray.sample]; }
};

/// A ray that hit a surface, and the surface.
struct MetSurface {
    TransportRay ray{};
    ShadingPoint point{};
    float distance = 0.0f;  // from the ray's origin
};

using Wave = FixedList<MetSurface, kMaxWaveSize>;

/// What is decided at random for a ray (TransportRay::decision): from 1, less than kPurposeCount.
enum Purpose : std::uint64_t {
    kLightPoint = 1,
    kLightChoice,
    kComponent,
    kLobe,
    kDirection,
    kRoulette,
    kHole,
};

/// How a ray goes on (TransportRay::next).
enum Way : std::uint64_t { kMirror = 1, kRefraction, kThroughHole, kBounce };

/// Rays to lights, gathered to be followed together, and what each brings if nothing is in the way.
class ShadowWave {
 public:
    /// `owner` says what the light is for.
    void add(const Vec3& origin, const LightSample& sample, std::size_t owner, const Color& light) {
        const Ray& ray = rays_.add_made([&] { return Ray{origin, sample.wi}; });
        intervals_.add_made([&] { return shadow_interval(ray, sample.distance); });
        owners_.add(owner);
        lights_.add(light);
    }

    /// Calls receive(owner, light) for each ray, with the light that comes through.
    template <class Receive>
    void follow(const WaveContext& context, Receive receive) {
        Color shares[kMaxWaveSize];
        find_light_shares(context.lit, context.shadow_kind, rays_.all(), intervals_.all(),
                          std::span(shares).first(rays_.size()), context.counts.shadow);
        for (std::size_t i = 0; i < rays_.size(); ++i) receive(owners_[i], shares[i] * lights_[i]);
        rays_.clear();
        intervals_.clear();
        owners_.clear();
        lights_.clear();
    }

 private:
    FixedList<Ray, kMaxWaveSize> rays_;
    FixedList<Interval, kMaxWaveSize> intervals_;
    FixedList<std::size_t, kMaxWaveSize> owners_;
    FixedList<Color, kMaxWaveSize> lights_;
};

inline float largest(Color color) {
    return color.r > color.g ? (color.r > color.b ? color.r : color.b)
                             : (color.g > color.b ? color.g : color.b);
}

}  // namespace lray::shade
