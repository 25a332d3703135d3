#include "shade/lights/ball_light.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "shade/lights/cone.h"

namespace lray::shade {

namespace {

constexpr double kPi = std::numbers::pi;

double cosine(double radians) {
    return unit_circle_point(radians / (2.0 * kPi)).x;
}

/// 1 - cos of the cone in which a ball is seen from outside, divided by the square of its radius.
double cone_height_per_area(double radius, double distance_squared) {
    const double sin_squared = radius * radius / distance_squared;
    return 1.0 / (distance_squared * (1.0 + std::sqrt(std::max(1.0 - sin_squared, 0.0))));
}

}  // namespace

BallLight BallLight::of(const scene::PointLight& point, Color color, double intensity,
                        bool is_visible) {
    BallLight ball;
    ball.position = point.position;
    ball.radius = point.radius;
    ball.strength = intensity / (4.0 * kPi);
    ball.color = color;
    ball.falloff = point.falloff;
    ball.is_met = is_visible && point.radius > 0.0 && point.falloff == scene::Falloff::quadratic;
    return ball;
}

BallLight BallLight::of(const scene::SpotLight& spot, Color color, double intensity) {
    BallLight ball;
    ball.position = spot.position;
    ball.radius = spot.radius;
    ball.strength = intensity / (4.0 * kPi);
    ball.color = color;
    ball.falloff = spot.falloff;
    ball.is_spot = true;
    ball.axis = spot.direction;
    const double rim = 0.5 * spot.angle;
    const double inner = rim * (1.0 - spot.softness);
    ball.rim = static_cast<float>(rim);
    ball.inner = static_cast<float>(inner);
    ball.cos_rim = cosine(rim);
    ball.cos_inner = cosine(inner);
    return ball;
}

double BallLight::cone_share(DVec3 from_light) const {
    if (!is_spot) return 1.0;
    const double c = dot(from_light, axis);
    if (!(c > cos_rim)) return 0.0;
    if (c >= cos_inner) return 1.0;
    const float angle =
        std::atan2(static_cast<float>(glm::length(cross(from_light, axis))), static_cast<float>(c));
    const float t = std::clamp((rim - angle) / (rim - inner), 0.0f, 1.0f);
    return static_cast<double>(t * t * (3.0f - 2.0f * t));
}

double BallLight::strength_at(DVec3 point) const {
    const DVec3 to_middle = position - point;
    const double distance_squared = dot(to_middle, to_middle);
    const double share = is_spot && distance_squared > 0.0
                             ? cone_share(-to_middle / std::sqrt(distance_squared))
                             : 1.0;
    return share * strength * fall(std::max(distance_squared, radius * radius));
}

std::optional<LightSample> BallLight::sample_extent(const DVec3& to_middle, const DVec3& towards,
                                                    double distance, double light,
                                                    const DVec2& u) const {
    const double distance_squared = dot(to_middle, to_middle);
    const double area = radius * radius;
    const bool is_inside = !(distance > radius);
    const double height_per_area =
        is_inside ? 2.0 / area : cone_height_per_area(radius, distance_squared);
    const double height = is_inside ? 2.0 : height_per_area * area;
    const DVec3 wi = cone_direction_about(towards, height, u);
    const double along = dot(to_middle, wi);
    const DVec3 aside = to_middle - along * wi;
    const double depth = std::sqrt(std::max(area - dot(aside, aside), 0.0));
    // Outside along is at least the root of distance^2 - radius^2, whatever rounding makes of it.
    const double to_surface = is_inside ? std::max(along + depth, 0.0)
                                        : (distance - radius) * (distance + radius) /
                                              std::max(along + depth, distance - radius);
    // Of a quadratic one: radiance times solid angle / pi.
    light *= falloff == scene::Falloff::quadratic ? 2.0 * height_per_area : fall(distance_squared);
    const float density = is_met ? finite_float(1.0 / cone_solid_angle(height)) : 0.0f;
    return LightSample{Vec3(wi), finite_distance(to_surface), light_color(color, light), density};
}

float BallLight::pdf(DVec3 point, Vec3 wi) const {
    if (!is_met) return 0.0f;
    const DVec3 to_middle = position - point;
    const double distance_squared = dot(to_middle, to_middle);
    const double area = radius * radius;
    if (!(distance_squared > area)) return finite_float(1.0 / cone_solid_angle(2.0));
    const DVec3 direction(wi);
    const double along = dot(to_middle, direction);
    const DVec3 aside = to_middle - along * direction;
    if (!(along > 0.0 && dot(aside, aside) < area)) return 0.0f;
    return finite_float(1.0 /
                        cone_solid_angle(cone_height_per_area(radius, distance_squared) * area));
}

std::optional<float> BallLight::hit(const Ray& ray, Interval interval) const {
    const DVec3 to_middle = position - DVec3(ray.origin);
    const DVec3 direction(ray.dir);
    const double along = dot(to_middle, direction);
    const DVec3 aside = to_middle - along * direction;
    const double area = radius * radius;
    const double depth_squared = area - dot(aside, aside);
    if (!(depth_squared >= 0.0)) return std::nullopt;
    const double depth = std::sqrt(depth_squared);
    for (const double t : {along - depth, along + depth}) {
        const float rounded = static_cast<float>(t);
        if (interval.contains(rounded)) return rounded;
    }
    return std::nullopt;
}

Color BallLight::radiance() const {
    return light_color(color, strength / (radius * radius));
}

}  // namespace lray::shade
