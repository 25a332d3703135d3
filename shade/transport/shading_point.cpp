#include "shade/transport/shading_point.h"

#include <algorithm>
#include <cmath>

#include "scene/place.h"
#include "shade/across.h"
#include "shade/material_normal.h"

namespace lray::shade {

namespace {

/// Of a normal that was bent away from the eye so much is left towards it: the cosine at which
/// surfaces that vertex normals or bumps have turned away are shaded.
constexpr float kLeastFacing = 1e-3f;

Vec3 unit(Vec3 v) {
    const DVec3 d{v};
    return Vec3{d / std::sqrt(dot(d, d))};
}

/// Returns the normal, turned towards the eye as little as needed to be seen from there.
Vec3 turned_to(Vec3 wo, Vec3 normal) {
    const float cosine = dot(normal, wo);
    if (cosine >= kLeastFacing) return normal;
    return unit(normal + (kLeastFacing - cosine) * wo);
}

/// Returns the part of `along` at right angles to the normal, unit; any direction if there is none.
Vec3 tangent_along(Vec3 along, Vec3 normal) {
    const DVec3 n{normal};
    const DVec3 aside = DVec3{along} - dot(n, DVec3{along}) * n;
    const double length2 = dot(aside, aside);
    if (!(length2 > 0.0 && std::isfinite(length2))) return Vec3{across(n).x};
    return Vec3{aside / std::sqrt(length2)};
}

/// How far a pixel reaches in uv, along u and v on average.
double uv_width(const bvh::SurfaceDetail& detail, double width) {
    const DVec3 along_u{detail.dp_du};
    const DVec3 along_v{detail.dp_dv};
    const double area = std::sqrt(dot(along_u, along_u) * dot(along_v, along_v));
    return area > 0.0 ? width / std::sqrt(area) : 0.0;
}

/// The plane of the surface in the space of the shape. A normal is brought there as the plane that
/// it stands on is: by the inverse transpose.
DVec3 object_normal(const bvh::SurfaceDetail& detail, Vec3 normal) {
    const DMat3& m = detail.object_from_world;
    const DVec3 n{normal};
    // The cofactors of the map, which has an inverse, up to a factor that does not matter.
    const DVec3 across =
        cross(m[1], m[2]) * n.x + cross(m[2], m[0]) * n.y + cross(m[0], m[1]) * n.z;
    const double length2 = dot(across, across);
    return length2 > 0.0 ? across / std::sqrt(length2) : DVec3{0.0};
}

TexturePoint texture_point(const bvh::SurfacePoint& surface, const bvh::SurfaceDetail& detail,
                           float width) {
    const double world_width = static_cast<double>(width);
    return {detail.uv,
            detail.position_object,
            DVec3{surface.position},
            uv_width(detail, world_width),
            world_width * detail.object_per_world,
            world_width,
            object_normal(detail, surface.normal),
            DVec3{surface.normal},
            detail.vertex_color};
}

}  // namespace

ShadingPoint shading_point(const LitWorld& lit, const TransportRay& ray, const bvh::Hit& hit) {
    ShadingPoint point;
    point.surface = bvh::surface_at(lit.world, ray.ray, hit);
    point.wo = -ray.ray.dir;
    point.is_outside = dot(point.surface.normal, point.wo) >= 0.0f;
    point.material_id = scene::material_at(lit.world, hit.place, hit.primitive_id);
    Vec3 outward{};
    Vec3 along{0.0f};
    if (lit.materials.needs_detail(point.material_id)) {
        const bvh::SurfaceDetail detail = bvh::surface_detail(lit.world, hit, point.surface);
        const TexturePoint where = texture_point(point.surface, detail, ray.cone.width_at(hit.t));
        point.material = lit.materials.is_textured(point.material_id)
                             ? lit.materials.at(point.material_id, where)
                             : lit.materials.average(point.material_id);
        outward = material_normal(lit.materials.authored(point.material_id), detail,
                                  point.surface.normal, where, lit.textures);
        along = detail.dp_du;
    } else {
        point.material = lit.materials.average(point.material_id);
        outward = bvh::shading_normal(lit.world, hit, point.surface);
    }
    point.normal = turned_to(point.wo, point.is_outside ? outward : -outward);
    if (along == Vec3{0.0f}) {
        const Across frame = across(DVec3{point.normal});
        point.tangent = Vec3{frame.x};
        point.bitangent = Vec3{frame.y};
    } else {
        point.tangent = tangent_along(along, point.normal);
        point.bitangent = cross(point.normal, point.tangent);
    }
    return point;
}

}  // namespace lray::shade
