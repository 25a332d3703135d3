// Point and spot lights, which may be balls: what of their light arrives at a point.
#pragma once

#include <cmath>
#include <optional>

#include "base/ray.h"
#include "scene/light.h"
#include "shade/lights/light_sample.h"

namespace lray::shade {

/// Light of a ball is that of a point in its middle where it is far, and its falloff is quadratic:
/// its radiance is L / (4 pi r^2). With other falloffs, which no ball has, only the directions
/// vary.
struct BallLight {
    static BallLight of(const scene::PointLight& point, Color color, double intensity,
                        bool is_visible);
    static BallLight of(const scene::SpotLight& spot, Color color, double intensity);

    /// True if surely no light of it falls on a surface: it is below, with a little to spare for
    /// the rounding of directions.
    bool is_below(const DVec3& point, const Vec3& normal) const {
        const DVec3 way = position - point;
        const double size = std::fabs(way.x) + std::fabs(way.y) + std::fabs(way.z);
        return dot(way, DVec3{normal}) < -(radius + size * 0x1p-20);
    }

    /// Errors: empty outside of a spot's cone, and in the very middle of the light.
    std::optional<LightSample> sample(const DVec3& point, const DVec2& u) const {
        const DVec3 to_middle = position - point;
        const double distance_squared = dot(to_middle, to_middle);
        if (!(distance_squared > 0.0)) return std::nullopt;
        const double distance = std::sqrt(distance_squared);
        const DVec3 towards = to_middle * (1.0 / distance);
        double light = strength;
        if (is_spot) light *= cone_share(-towards);
        if (!(light > 0.0)) return std::nullopt;
        if (radius > 0.0) return sample_extent(to_middle, towards, distance, light, u);
        light *= fall(distance_squared);
        return LightSample{Vec3(towards), finite_distance(distance), light_color(color, light)};
    }
    float pdf(DVec3 point, Vec3 wi) const;

    /// Returns how strong the light is at a point, without its colour; 0 where it does not shine.
    double strength_at(DVec3 point) const;

    /// Returns where a ray meets the ball from outside or from inside.
    std::optional<float> hit(const Ray& ray, Interval interval) const;
    Color radiance() const;

    /// The share of its light that leaves at an angle to the axis of its cone: smoothstep between
    /// the inner cone and the rim, by the angle. Shape: from_light is unit.
    double cone_share(DVec3 from_light) const;

    /// sample() of a light that is more than a point. `light` is its strength that way.
    std::optional<LightSample> sample_extent(const DVec3& to_middle, const DVec3& towards,
                                             double distance, double light, const DVec2& u) const;

    /// 1 / d^2 or what takes its place.
    double fall(double distance_squared) const {
        switch (falloff) {
            case scene::Falloff::quadratic:
                return 1.0 / distance_squared;
            case scene::Falloff::linear:
                return 1.0 / std::sqrt(distance_squared);
            case scene::Falloff::none:
                return 1.0;
        }
        return 0.0;
    }

    DVec3 position{0.0};
    double radius = 0.0;
    double strength = 0.0;  // L / (4 pi)
    Color color{1.0f};
    scene::Falloff falloff = scene::Falloff::quadratic;
    bool is_spot = false;
    bool is_met = false;  // by rays not sent to it: an even ball that is visible
    DVec3 axis{0.0, 0.0, -1.0};
    double cos_inner = -1.0;
    double cos_rim = -1.0;
    float inner = 0.0f;  // radians from the axis
    float rim = 0.0f;
};

}  // namespace lray::shade
