#include "bvh/surface_detail.h"

#include <cmath>
#include <limits>

#include "bvh/surface_parameters.h"
#include "scene/place.h"

namespace lray::bvh {

namespace {

/// The geometry of a place, and the map of the world's vectors to it.
struct PlaceMap {
    const scene::Geometry* geometry = nullptr;
    DMat3 local_from_world{1.0};
};

PlaceMap find_place(const scene::World& world, scene::PlaceOffset place) {
    PlaceMap result{&world, DMat3{1.0}};
    while (place > 0) {
        const scene::EnteredPlace entered = scene::enter(world, *result.geometry, place);
        result.local_from_world =
            DMat3{entered.step.instance->frame.object_from_world} * result.local_from_world;
        result.geometry = entered.geometry;
        place = entered.place;
    }
    return result;
}

/// Returns the interpolated normal in the space of the geometry, of any length; 0 if the triangle
/// has none.
DVec3 interpolated_normal(const scene::Geometry& geometry, const Hit& hit) {
    if (geometry.triangle_normals.empty()) return DVec3{0.0};
    const scene::IndexTriple& triple = geometry.triangle_normals[hit.primitive_id.index()];
    if (triple[0] == scene::Mesh::kNone) return DVec3{0.0};
    const double u = static_cast<double>(hit.u);
    const double v = static_cast<double>(hit.v);
    return (1.0 - u - v) * DVec3{geometry.normals[triple[0]]} +
           u * DVec3{geometry.normals[triple[1]]} + v * DVec3{geometry.normals[triple[2]]};
}

/// Returns the shading normal of a triangle.
Vec3 triangle_shading_normal(const PlaceMap& place, const Hit& hit, const SurfacePoint& point) {
    // Covectors take the transpose of the map back.
    const DVec3 normal = interpolated_normal(*place.geometry, hit) * place.local_from_world;
    const double square = dot(normal, normal);
    if (!(square >= std::numeric_limits<double>::min())) return point.normal;
    const double length = std::sqrt(square);
    const bool is_behind = dot(normal, DVec3{point.normal}) < 0.0;
    return Vec3{normal / (is_behind ? -length : length)};
}

/// Returns the interpolated colour of the corners of a triangle.
DVec3 interpolated_color(const scene::Geometry& geometry, const Hit& hit) {
    const scene::IndexTriple& corners = geometry.triangles[hit.primitive_id.index()].vertices;
    const double u = static_cast<double>(hit.u);
    const double v = static_cast<double>(hit.v);
    return (1.0 - u - v) * DVec3{geometry.colors[corners[0]]} +
           u * DVec3{geometry.colors[corners[1]]} + v * DVec3{geometry.colors[corners[2]]};
}

/// Returns what of a tangent is at right angles to a unit normal; 0 if a float cannot hold it.
Vec3 flattened(DVec3 tangent, DVec3 normal) {
    const Vec3 result{tangent - dot(tangent, normal) * normal};
    const bool is_held =
        std::isfinite(result.x) && std::isfinite(result.y) && std::isfinite(result.z);
    return is_held ? result : Vec3{0.0f};
}

bool is_triangle(const Hit& hit) {
    return hit.primitive_id.kind() == scene::PrimitiveKind::triangle;
}

}  // namespace

SurfaceDetail surface_detail(const scene::World& world, const Hit& hit, const SurfacePoint& point) {
    const PlaceMap place = find_place(world, hit.place);
    SurfaceParameters parameters = surface_parameters(*place.geometry, hit, point.position_local);
    if (hit.place > 0) {
        const DMat3 world_from_local = glm::inverse(place.local_from_world);
        parameters.dp_du = world_from_local * parameters.dp_du;
        parameters.dp_dv = world_from_local * parameters.dp_dv;
    }
    SurfaceDetail result;
    result.shading_normal =
        is_triangle(hit) ? triangle_shading_normal(place, hit, point) : point.normal;
    result.uv = parameters.uv;
    if (is_triangle(hit) && !place.geometry->colors.empty()) {
        result.vertex_color = interpolated_color(*place.geometry, hit);
    }
    const DVec3 normal{result.shading_normal};
    result.dp_du = flattened(parameters.dp_du, normal);
    result.dp_dv = flattened(parameters.dp_dv, normal);

    result.position_object = point.position_local;
    result.object_from_world = place.local_from_world;
    const scene::ObjectSpace* const space =
        place.geometry->object_spaces.find(place.geometry->object_of(hit.primitive_id));
    if (space != nullptr) {
        result.position_object = space->point(point.position_local);
        result.object_from_world = space->linear * place.local_from_world;
    }
    const DMat3& map = result.object_from_world;
    result.object_per_world =
        std::sqrt((dot(map[0], map[0]) + dot(map[1], map[1]) + dot(map[2], map[2])) / 3.0);
    return result;
}

Vec3 shading_normal(const scene::World& world, const Hit& hit, const SurfacePoint& point) {
    if (!is_triangle(hit)) return point.normal;
    if (hit.place == 0 && world.triangle_normals.empty()) return point.normal;  // none has any
    return triangle_shading_normal(find_place(world, hit.place), hit, point);
}

}  // namespace lray::bvh
