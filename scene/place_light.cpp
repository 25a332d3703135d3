#include "scene/place_light.h"

#include <cmath>
#include <optional>

#include "scene/placer.h"

namespace lray::scene {

namespace {

bool is_placeable(DVec3 p) {
    return std::fabs(p.x) <= kMaxCoordinate && std::fabs(p.y) <= kMaxCoordinate &&
           std::fabs(p.z) <= kMaxCoordinate;  // false for NaN
}

/// One factor for a map that may have several.
double mean_scale(const Transform& map) {
    if (map.is_similarity()) return map.similarity_scale();
    const DMat3& linear = map.linear();
    return std::sqrt(
        (dot(linear[0], linear[0]) + dot(linear[1], linear[1]) + dot(linear[2], linear[2])) / 3.0);
}

/// Changes the light's shape, one overload for each, to world space.
struct ToWorld {
    const Transform& world_from_object;

    std::optional<LightProblem> operator()(PointLight& point) const {
        point.position = world_from_object.point(point.position);
        point.radius *= mean_scale(world_from_object);
        if (!is_placeable(point.position) || !(point.radius <= kMaxCoordinate)) {
            return LightProblem::too_far;
        }
        return std::nullopt;
    }
    std::optional<LightProblem> operator()(SpotLight& spot) const {
        spot.position = world_from_object.point(spot.position);
        spot.radius *= mean_scale(world_from_object);
        const std::optional<DVec3> direction = unit(world_from_object.vector(spot.direction));
        if (!direction || !is_placeable(spot.position) || !(spot.radius <= kMaxCoordinate)) {
            return LightProblem::too_far;
        }
        spot.direction = *direction;
        return std::nullopt;
    }
    std::optional<LightProblem> operator()(DirectionalLight& sun) const {
        const std::optional<DVec3> direction = unit(world_from_object.vector(sun.direction));
        if (!direction) return LightProblem::too_far;
        sun.direction = *direction;
        return std::nullopt;
    }
    std::optional<LightProblem> operator()(AreaLight& area) const {
        const DVec3 far_corner = area.corner + area.edge_u + area.edge_v;
        DVec3 corner = area.corner;
        DVec3 edge_u = area.edge_u;
        if (world_from_object.is_mirrored()) {  // from its other end the cross product turns back
            corner += edge_u;
            edge_u = -edge_u;
        }
        area.corner = world_from_object.point(corner);
        area.edge_u = world_from_object.vector(edge_u);
        area.edge_v = world_from_object.vector(area.edge_v);
        if (!is_placeable(area.corner) || !is_placeable(world_from_object.point(far_corner)) ||
            !is_placeable(area.edge_u) || !is_placeable(area.edge_v)) {
            return LightProblem::too_far;
        }
        const DVec3 across = cross(area.edge_u, area.edge_v);
        const double least = kMinSize * kMinSize;
        if (!(dot(across, across) >= least * least)) return LightProblem::no_area;
        return std::nullopt;
    }
    std::optional<LightProblem> operator()(EnvironmentLight& environment) const {
        const std::optional<Transform> inverse = world_from_object.inverse();
        if (!inverse) return LightProblem::too_far;
        environment.light_from_world = inverse->linear();
        return std::nullopt;
    }
};

}  // namespace

std::variant<Light, LightProblem> place_light(const Light& light,
                                              const Transform& world_from_object) {
    Light placed = light;
    if (const auto problem = std::visit(ToWorld{world_from_object}, placed.shape)) return *problem;
    return placed;
}

}  // namespace lray::scene
