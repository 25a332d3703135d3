#include "shade/lights/area_light.h"

#include <cmath>
#include <numbers>

#include "shade/lights/spherical_rectangle.h"

namespace lray::shade {

namespace {

constexpr double kPi = std::numbers::pi;

/// From within this many diagonals of the middle directions are chosen by solid angle: farther away
/// cos / d^2 of its points, which is what varies otherwise, differs by less than a factor of 2.
constexpr double kNearDiagonals = 1.5;
/// And only where it fills this much of what is seen: a sliver from beside it is not worth it.
constexpr double kLeastSolidAngle = 0.01;

/// Returns the rectangle from a point where its directions are chosen by solid angle.
std::optional<SphericalRectangle> near_rectangle(const AreaLight& light, DVec3 to_corner,
                                                 double height) {
    if (!light.is_rectangle) return std::nullopt;
    const DVec3 diagonal = light.edge_u + light.edge_v;
    const DVec3 to_middle = to_corner + 0.5 * diagonal;
    if (dot(to_middle, to_middle) > kNearDiagonals * kNearDiagonals * dot(diagonal, diagonal)) {
        return std::nullopt;
    }
    const DVec2 low{dot(to_corner, light.x), dot(to_corner, light.y)};
    const auto rectangle = SphericalRectangle::of(low, low + light.length, height);
    if (!(rectangle.solid_angle > kLeastSolidAngle)) return std::nullopt;
    return rectangle;
}

}  // namespace

AreaLight AreaLight::of(const scene::AreaLight& light, Color color, double intensity,
                        bool is_visible) {
    AreaLight area;
    area.corner = light.corner;
    area.edge_u = light.edge_u;
    area.edge_v = light.edge_v;
    const DVec3 across = cross(light.edge_u, light.edge_v);
    area.area = glm::length(across);
    area.normal = across / area.area;
    area.u_of = cross(light.edge_v, area.normal) / area.area;
    area.v_of = cross(area.normal, light.edge_u) / area.area;
    area.length = {glm::length(light.edge_u), glm::length(light.edge_v)};
    area.x = light.edge_u / area.length.x;
    area.y = light.edge_v / area.length.y;
    area.intensity = intensity;
    area.color = color;
    area.radiance = light_color(color, intensity / area.area);
    // What is so little askew does not show: sides are the axes of the spherical rectangle.
    constexpr double kSquare = 1e-9;
    area.is_rectangle = std::abs(dot(light.edge_u, light.edge_v)) <= kSquare * area.area;
    area.is_met = is_visible;
    return area;
}

double AreaLight::strength_at(DVec3 point) const {
    const DVec3 to_corner = corner - point;
    if (!(dot(to_corner, normal) < 0.0)) return 0.0;
    const DVec3 to_middle = to_corner + 0.5 * (edge_u + edge_v);
    return intensity / (kPi * (dot(to_middle, to_middle) + area));
}

std::optional<LightSample> AreaLight::sample(DVec3 point, DVec2 u) const {
    const DVec3 to_corner = corner - point;
    const double height = -dot(to_corner, normal);
    if (!(height > 0.0)) return std::nullopt;
    const auto rectangle = near_rectangle(*this, to_corner, height);
    if (rectangle) {
        const DVec2 p = rectangle->point(u);
        const DVec3 to_light = p.x * x + p.y * y - height * normal;
        const double distance = glm::length(to_light);
        const float density = is_met ? finite_float(1.0 / rectangle->solid_angle) : 0.0f;
        return LightSample{Vec3(to_light / distance), finite_distance(distance),
                           light_color(color, intensity / area * rectangle->solid_angle / kPi),
                           density};
    }
    const DVec3 to_light = to_corner + u.x * edge_u + u.y * edge_v;
    const double distance_squared = dot(to_light, to_light);
    const double distance = std::sqrt(distance_squared);
    const double solid_per_area = height / (distance_squared * distance);
    const float density = is_met ? finite_float(1.0 / (area * solid_per_area)) : 0.0f;
    return LightSample{Vec3(to_light / distance), finite_distance(distance),
                       light_color(color, intensity / kPi * solid_per_area), density};
}

float AreaLight::pdf(DVec3 point, Vec3 wi) const {
    if (!is_met) return 0.0f;
    const DVec3 to_corner = corner - point;
    const double height = -dot(to_corner, normal);
    const DVec3 direction(wi);
    const double fall = -dot(direction, normal);
    if (!(height > 0.0 && fall > 0.0)) return 0.0f;
    const double distance = height / fall;
    const DVec3 on_light = distance * direction - to_corner;
    const double u = dot(u_of, on_light);
    const double v = dot(v_of, on_light);
    if (!(u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0)) return 0.0f;
    const auto rectangle = near_rectangle(*this, to_corner, height);
    if (rectangle) return finite_float(1.0 / rectangle->solid_angle);
    return finite_float(distance * distance / (area * fall));
}

std::optional<float> AreaLight::hit(const Ray& ray, Interval interval) const {
    const DVec3 to_corner = corner - DVec3(ray.origin);
    const DVec3 direction(ray.dir);
    const double height = -dot(to_corner, normal);
    const double fall = -dot(direction, normal);
    if (!(height > 0.0 && fall > 0.0)) return std::nullopt;
    const double t = height / fall;
    if (!(t < 1e37)) return std::nullopt;
    const float rounded = static_cast<float>(t);
    if (!interval.contains(rounded)) return std::nullopt;
    const DVec3 on_light = t * direction - to_corner;
    const double u = dot(u_of, on_light);
    const double v = dot(v_of, on_light);
    if (!(u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0)) return std::nullopt;
    return rounded;
}

}  // namespace lray::shade
