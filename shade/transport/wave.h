// Rays that are followed together, and what they have in common.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

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

/// Rays that hit a surface, and the surface.
struct Wave {
    std::array<TransportRay, kMaxWaveSize> rays;
    std::array<ShadingPoint, kMaxWaveSize> points;
    std::array<float, kMaxWaveSize> distances;  // from the ray's origin
    std::size_t count = 0;
};

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
    void add(const Ray& ray, float distance, std::size_t point, Color light) {
        rays_[count_] = ray;
        intervals_[count_] = shadow_interval(ray, distance);
        points_[count_] = point;
        lights_[count_] = light;
        ++count_;
    }

    /// Calls receive(point, light) for each ray, with the light that comes through.
    template <class Receive>
    void follow(const WaveContext& context, Receive receive) {
        std::array<Color, kMaxWaveSize> shares;
        find_light_shares(context.lit, context.shadow_kind, std::span(rays_).first(count_),
                          std::span(intervals_).first(count_), std::span(shares).first(count_),
                          context.counts.shadow);
        for (std::size_t i = 0; i < count_; ++i) receive(points_[i], shares[i] * lights_[i]);
        count_ = 0;
    }

 private:
    std::array<Ray, kMaxWaveSize> rays_;
    std::array<Interval, kMaxWaveSize> intervals_;
    std::array<std::size_t, kMaxWaveSize> points_;
    std::array<Color, kMaxWaveSize> lights_;
    std::size_t count_ = 0;
};

inline float largest(Color color) {
    return color.r > color.g ? (color.r > color.b ? color.r : color.b)
                             : (color.g > color.b ? color.g : color.b);
}

}  // namespace lray::shade
