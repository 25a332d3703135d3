#include "shade/material_normal.h"

#include "shade/bump.h"

namespace lray::shade {

Vec3 material_normal(const scene::Material& material, const bvh::SurfaceDetail& detail,
                     Vec3 surface_normal, const TexturePoint& point, const TextureSet& textures) {
    if (material.normal_map_id.is_none() && material.bump_id.is_none()) {
        return detail.shading_normal;
    }
    DVec3 normal{detail.shading_normal};
    if (!material.normal_map_id.is_none()) {
        normal = mapped_normal(detail, textures.color(material.normal_map_id, point));
    }
    if (!material.bump_id.is_none()) {
        const double scale = material.bump_unit == scene::BumpUnit::uv ? uv_length(detail) : 1.0;
        const DVec3 gradient = bump_gradient(detail, point, [&](const TexturePoint& at) {
            return textures.number(material.bump_id, at);
        });
        normal -= material.bump_height * scale * gradient;
    }
    return above_surface(normal, detail.shading_normal, surface_normal);
}

}  // namespace lray::shade
