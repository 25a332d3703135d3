// Rays that carry light back to the eye, and the samples that they are followed for.
#pragma once

#include <cstdint>

#include "base/random.h"
#include "base/ray.h"
#include "base/sampler.h"
#include "base/vec.h"
#include "shade/transport/media.h"

namespace lray::shade {

/// How wide the part of the picture is that a ray stands for: `width` at its origin, in world
/// units, growing by `spread` per unit of distance. What textures show is averaged over it.
/// Source: Akenine-Moeller et al. 2019, "Texture Level of Detail Strategies for Real-Time Ray
/// Tracing" (ray cones), without the curvature of what is met.
struct RayCone {
    float width = 0.0f;
    float spread = 0.0f;

    float width_at(float t) const { return width + spread * t; }
};

/// A ray on its way from the eye. What is decided for it at random has keys of its own, which
/// depend on how it came about, not on the rays followed before.
struct TransportRay {
    Ray ray{};
    RayCone cone{};
    Color weight{1.0f};        // the share of what it meets that reaches the sample
    std::uint32_t sample = 0;  // index among those followed together
    std::uint16_t depth = 0;   // reflections and refractions before it
    std::uint16_t passes = 0;  // holes it came through since
    std::uint64_t branch = 0;  // key of its decisions
    float pdf = 0.0f;          // of choosing its direction among those of a matt or glossy surface;
                               // 0: it had no choice
    Vec3 normal{0.0f};         // for shading, where that was chosen
    Media media{};

    /// Returns a ray that this one leads to, `way` telling them apart; the rest is as of this one.
    TransportRay next(const Ray& onward, float t, std::uint64_t way) const {
        TransportRay result = *this;
        result.ray = onward;
        result.cone.width = cone.width_at(t);
        result.branch = mix_bits(branch + way);
        return result;
    }

    /// Key of a decision: what is decided, and for which of several.
    std::uint64_t decision(std::uint64_t purpose, std::uint64_t which = 0) const {
        return branch + mix_bits(purpose + which * kPurposeCount);
    }

    static constexpr std::uint64_t kPurposeCount = 16;
};

}  // namespace lray::shade
