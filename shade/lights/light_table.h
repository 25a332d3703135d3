// The lights of a world, ready to be sampled.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/ray.h"
#include "base/vec.h"
#include "scene/world.h"
#include "shade/textures/texture_set.h"

namespace lray::shade {

/// Light that arrives at a point from one direction.
struct LightSample {
    Vec3 wi{};                   // unit, towards the light
    float distance = kInfinity;  // to the light: what is nearer casts a shadow
    Color irradiance{0.0f};      // E / pi of a surface that faces wi; the mean over all u is
                                 // the light's, so samples are added up and divided by number
    float pdf = 0.0f;            // per solid angle; 0: the light has no extent, and is met by
                                 // no ray that was not sent to it
};

/// What a ray in some direction sees of a light itself.
struct LightHit {
    float t = kInfinity;  // infinite for an environment
    Color radiance{0.0f};
    std::uint32_t light = 0;
};

/// Const calls are thread-safe. The world and the textures must outlive it.
class LightTable {
 public:
    LightTable(const scene::World& world, const TextureSet& textures);

    /// The lights that shine at all, numbered from 0, in the order of the world.
    std::uint32_t count() const;
    bool casts_shadow(std::uint32_t light) const;
    /// Of an environment, a ball, a sun and an area; 1 of lights without extent.
    std::uint32_t sample_count(std::uint32_t light) const;

    /// Returns light that arrives at a point (world space) by the light's sample u, uniform in
    /// [0, 1)^2.
    /// Errors: empty when none does: behind a spot light or an area light.
    std::optional<LightSample> sample(std::uint32_t light, DVec3 point, DVec2 u) const;

    /// Returns the density with which sample() chooses a direction from a point; 0 for lights
    /// without extent and directions that do not meet the light.
    float pdf(std::uint32_t light, DVec3 point, Vec3 wi) const;

    /// Returns a light chosen for a point at random, u uniform in [0, 1), and the probability of
    /// that choice; greater than 0 for each light that may light the point.
    struct Choice {
        std::uint32_t light = 0;
        float probability = 1.0f;
    };
    Choice choose(DVec3 point, double u) const;
    float probability(std::uint32_t light, DVec3 point) const;

    /// Returns the nearest visible area or ball light that the ray meets in the interval; none
    /// when it meets none. Environments are environment()'s.
    std::optional<LightHit> nearest_hit(const Ray& ray, Interval interval) const;

    /// Returns what the environment shows in a direction; none if there is no environment.
    bool has_environment() const;
    /// The environment's number among the lights.
    std::uint32_t environment_light() const;
    Color environment(Vec3 direction) const;
};

}  // namespace lray::shade
