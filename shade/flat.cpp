#include "shade/flat.h"

#include "base/assert.h"
#include "scene/place.h"

namespace lray::shade {

Color flat(const scene::World& world, const bvh::Hit& hit, Color background) {
    if (hit.is_none()) return background;
    const std::uint32_t material = scene::material_at(world, hit.place, hit.primitive_id);
    LRAY_DCHECK(material < world.materials.size());
    return world.materials[material].diffuse.constant;
}

}  // namespace lray::shade
