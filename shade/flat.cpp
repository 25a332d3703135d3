#include "shade/flat.h"

#include "base/assert.h"
#include "scene/place.h"

namespace lray::shade {

Color flat(const scene::World& world, const bvh::Hit& hit, Color background) {
    if (hit.is_none()) return background;
    const std::uint32_t material = scene::material_at(world, hit.place, hit.primitive_id);
    LRAY_DCHECK(material < world.materials.size());
    const scene::Coefficient& diffuse = world.materials[material].diffuse;
    const bool shows_vertex_colors =
        diffuse.is_textured() &&
        world.textures[diffuse.texture_id.index()].space == scene::TextureSpace::vertex_colors;
    if (!shows_vertex_colors) return diffuse.constant;
    const scene::Geometry& geometry = scene::geometry_at(world, hit.place);
    return geometry.mean_color(geometry.object_of(hit.primitive_id));
}

}  // namespace lray::shade
