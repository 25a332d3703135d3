// Light from everywhere: one colour, or a texture around the scene.
#pragma once

#include <optional>

#include "scene/world.h"
#include "shade/lights/light_sample.h"
#include "shade/lights/sky_distribution.h"
#include "shade/textures/texture_set.h"

namespace lray::shade {

/// Of one colour it is sampled by the cosine to the normal, which leaves nothing to chance but
/// shadows; of a texture by how bright it is.
class Environment {
 public:
    Environment(const scene::World& world, const TextureSet& textures,
                const scene::EnvironmentLight& light, Color color, double intensity,
                bool is_visible);

    Color radiance(Vec3 direction) const;
    /// Over all directions.
    Color mean_radiance() const { return mean_; }
    bool is_visible() const { return is_visible_; }

    /// Space: `normal` is unit, on the side of the surface that is lit.
    std::optional<LightSample> sample(Vec3 normal, DVec2 u) const;
    /// Returns the density with which sample() chooses wi.
    float density(const Vec3& normal, const Vec3& wi) const;
    /// Likewise, 0 if no ray meets the environment.
    float pdf(Vec3 normal, Vec3 wi) const { return is_visible_ ? density(normal, wi) : 0.0f; }

 private:
    struct SkyPoint {
        DVec3 direction_light{};
        double longitude = 0.0;
        double latitude = 0.0;     // 0 straight down, 1 straight up
        double solid_angle = 1.0;  // of the light's space for one of the world's
    };
    SkyPoint sky_point(DVec3 direction) const;
    Color texture_color(const SkyPoint& at, DVec3 direction, double width) const;
    void measure(const scene::World& world);

    const TextureSet& textures_;
    scene::TextureId texture_id_{};
    Color scale_{1.0f};
    Color mean_{0.0f};
    bool is_visible_ = true;
    DMat3 light_from_world_{1.0};
    DMat3 world_from_light_{1.0};
    double determinant_ = 1.0;  // of light_from_world_, without its sign
    /// Textures are not looked up nearer to a pole, in latitude from 0 to 1: one that repeats
    /// itself would show its other end there. Of pictures half a pixel; patterns begin anew up to
    /// 1/1024 early.
    double pole_ = 0x1p-9;
    std::optional<SkyDistribution> distribution_{};
};

}  // namespace lray::shade
