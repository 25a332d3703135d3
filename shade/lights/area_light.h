// Area lights: parallelograms that shine to one side.
#pragma once

#include <optional>

#include "base/ray.h"
#include "scene/light.h"
#include "shade/lights/light_sample.h"

namespace lray::shade {

/// Near a rectangle its directions are chosen uniformly by solid angle; from farther away, where
/// they are nearly so, and on parallelograms its points are, uniformly by area.
struct AreaLight {
    static AreaLight of(const scene::AreaLight& light, Color color, double intensity,
                        bool is_visible);

    /// Errors: empty behind the light and in its plane.
    std::optional<LightSample> sample(DVec3 point, DVec2 u) const;
    float pdf(DVec3 point, Vec3 wi) const;

    /// Returns about how strong the light is at a point, without its colour; 0 where it does not
    /// shine.
    double strength_at(DVec3 point) const;

    /// Returns where a ray meets the side that shines.
    std::optional<float> hit(const Ray& ray, Interval interval) const;

    DVec3 corner{0.0};
    DVec3 edge_u{1.0, 0.0, 0.0};
    DVec3 edge_v{0.0, 0.0, 1.0};
    DVec3 normal{0.0, -1.0, 0.0};  // unit; the side that shines
    DVec3 u_of{0.0};               // u of a point is dot(u_of, point - corner)
    DVec3 v_of{0.0};
    DVec3 x{1.0, 0.0, 0.0};  // the edges, unit
    DVec3 y{0.0, 0.0, 1.0};
    DVec2 length{1.0};  // and how long they are
    double area = 1.0;
    double intensity = 0.0;
    Color color{1.0f};
    Color radiance{0.0f};
    bool is_rectangle = true;
    bool is_met = true;  // by rays not sent to it: it is visible
};

}  // namespace lray::shade
