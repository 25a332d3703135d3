#include "scene/place.h"

#include <algorithm>

#include "base/assert.h"

namespace lray::scene {

PlacePath path_to(const World& world, PlaceOffset place) {
    LRAY_ASSERT(place < world.place_count);
    PlacePath path;
    path.geometry = &world;
    while (place > 0) {
        // Places ascend with the instances: the last one that does not begin behind it holds it.
        const std::vector<WorldInstance>& instances = path.geometry->instances;
        const auto next =
            std::ranges::upper_bound(instances, place, {}, &WorldInstance::first_place);
        LRAY_ASSERT(next != instances.begin());
        const WorldInstance& instance = *std::prev(next);
        const PrimitiveId id(PrimitiveKind::instance,
                             static_cast<std::size_t>(std::prev(next) - instances.begin()));
        path.steps.push_back({&instance, &path.geometry->object(path.geometry->object_of(id))});
        place -= instance.first_place;
        path.geometry = &world.prototypes[instance.prototype];
    }
    return path;
}

std::uint32_t material_at(const World& world, PlaceOffset place, PrimitiveId id) {
    if (place == 0) return world.object(world.object_of(id)).material;
    const PlacePath path = path_to(world, place);
    std::uint32_t material = path.geometry->object(path.geometry->object_of(id)).material;
    for (auto step = path.steps.rbegin(); step != path.steps.rend(); ++step) {
        if (material != Object::kInherited) break;
        material = step->object->material;
    }
    LRAY_ASSERT(material != Object::kInherited);
    return material;
}

}  // namespace lray::scene
