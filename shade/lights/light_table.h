// The lights of a world, ready to be sampled.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/ray.h"
#include "base/vec.h"
#include "scene/world.h"
#include "shade/lights/area_light.h"
#include "shade/lights/ball_light.h"
#include "shade/lights/environment.h"
#include "shade/lights/light_sample.h"
#include "shade/lights/sun_light.h"
#include "shade/textures/texture_set.h"

namespace lray::shade {

/// LightTable::sample() of a light of known class.
inline std::optional<LightSample> sample_light(const BallLight& light, const DVec3& point,
                                               const Vec3& /*normal*/, const DVec2& u) {
    return light.sample(point, u);
}
inline std::optional<LightSample> sample_light(const SunLight& light, const DVec3& /*point*/,
                                               const Vec3& /*normal*/, const DVec2& u) {
    return light.sample(u);
}
inline std::optional<LightSample> sample_light(const AreaLight& light, const DVec3& point,
                                               const Vec3& /*normal*/, const DVec2& u) {
    return light.sample(point, u);
}
inline std::optional<LightSample> sample_light(const Environment& light, const DVec3& /*point*/,
                                               const Vec3& normal, const DVec2& u) {
    return light.sample(normal, u);
}

/// True if surely none of its light falls on a surface that is lit on the side of `normal`.
inline bool is_below(const BallLight& light, const DVec3& point, const Vec3& normal) {
    return light.is_below(point, normal);
}
template <class Light>
bool is_below(const Light& /*light*/, const DVec3& /*point*/, const Vec3& /*normal*/) {
    return false;  // sampling it tells
}

/// Const calls are thread-safe. The world and the textures must outlive it.
class LightTable {
 public:
    LightTable(const scene::World& world, const TextureSet& textures);

    /// The lights that shine at all, and the environment, numbered from 0, in the order of the
    /// world.
    std::uint32_t count() const { return static_cast<std::uint32_t>(entries_.size()); }
    bool casts_shadow(std::uint32_t light) const { return entries_[light].casts_shadow; }
    /// Of an environment, a ball, a sun and an area; 1 of lights without extent.
    std::uint32_t sample_count(std::uint32_t light) const { return entries_[light].sample_count; }

    /// True if sample() depends on u.
    bool has_extent(std::uint32_t light) const { return entries_[light].has_extent; }

    /// Returns the most samples that any of them asks for; 0 without lights.
    std::uint32_t most_samples() const;

    /// Returns visit(source) of the light itself, which is of one of the classes that it may be.
    template <class Visit>
    decltype(auto) visit(std::uint32_t light, Visit visit) const {
        const Entry& entry = entries_[light];
        switch (entry.kind) {
            case Kind::ball:
                return visit(balls_[entry.index]);
            case Kind::sun:
                return visit(suns_[entry.index]);
            case Kind::area:
                return visit(areas_[entry.index]);
            case Kind::environment:
                break;
        }
        return visit(*environment_);
    }

    /// Returns light that arrives at a point by the light's sample u, uniform in [0, 1)^2.
    /// Space: world; `normal` is unit, on the side of the surface that is lit: by it directions of
    /// an even environment are chosen, which for light from below it is empty.
    /// Errors: empty when none does: behind a spot light or an area light.
    std::optional<LightSample> sample(std::uint32_t light, const DVec3& point, const Vec3& normal,
                                      const DVec2& u) const {
        return visit(light,
                     [&](const auto& source) { return sample_light(source, point, normal, u); });
    }

    /// Returns the density with which sample() chooses a direction from a point; 0 for lights that
    /// no ray meets, and directions that do not meet the light.
    float pdf(std::uint32_t light, DVec3 point, Vec3 normal, Vec3 wi) const;

    /// Returns a light chosen for a point at random, u uniform in [0, 1), and the probability of
    /// that choice; greater than 0 for each light that may light the point. Of few lights it is in
    /// proportion to how strong they are there, of many to their power, and a part for each.
    /// Errors: none where there are no lights, or none shines to the point.
    struct Choice {
        std::uint32_t light = 0;
        float probability = 1.0f;
    };
    std::optional<Choice> choose(DVec3 point, double u) const;
    float probability(std::uint32_t light, DVec3 point) const;

    /// True if there are lights that rays meet.
    bool are_met() const { return !met_.empty(); }

    /// Returns the nearest visible area or ball light that the ray meets in the interval; none
    /// when it meets none. Environments are environment()'s.
    std::optional<LightHit> nearest_hit(const Ray& ray, Interval interval) const {
        return met_.empty() ? std::nullopt : nearest_met(ray, interval);
    }

    /// Returns what the environment shows in a direction; none if there is no environment, or it is
    /// not visible.
    bool has_environment() const { return environment_ && environment_->is_visible(); }
    /// The environment's number among the lights.
    std::uint32_t environment_light() const { return environment_light_; }
    Color environment(Vec3 direction) const { return environment_->radiance(direction); }

 private:
    enum class Kind : std::uint8_t { ball, sun, area, environment };
    struct Entry {
        Kind kind = Kind::ball;
        bool casts_shadow = true;
        bool has_extent = true;
        std::uint32_t index = 0;  // among those of its kind
        std::uint32_t sample_count = 1;
        float luminance = 1.0f;  // of its colour
    };

    void add(const scene::WorldLight& light, const scene::World& world, const TextureSet& textures);
    void sum_up_power(const scene::World& world);
    std::optional<LightHit> nearest_met(const Ray& ray, Interval interval) const;
    double strength_at(const Entry& entry, DVec3 point) const;
    double power(const Entry& entry, double scene_radius) const;

    std::vector<Entry> entries_{};
    std::vector<BallLight> balls_{};
    std::vector<SunLight> suns_{};
    std::vector<AreaLight> areas_{};
    std::optional<Environment> environment_{};
    std::uint32_t environment_light_ = 0;
    std::vector<std::uint32_t> met_{};  // the lights that rays meet
    std::vector<double> chosen_{};      // of many lights: the probability of those up to each
};

}  // namespace lray::shade
