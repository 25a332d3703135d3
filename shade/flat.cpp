#include "shade/flat.h"

#include "base/assert.h"

namespace lray::shade {

Color flat(const scene::World& world, const bvh::Hit& hit, Color background) {
    if (hit.is_none()) return background;
    const scene::Object& object = world.object(world.object_of(hit.primitive_id));
    LRAY_DCHECK(object.material < world.materials.size());
    return world.materials[object.material].diffuse.constant;
}

}  // namespace lray::shade
