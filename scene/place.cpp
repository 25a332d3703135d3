#include "scene/place.h"

#include <algorithm>

#include "base/assert.h"

namespace lray::scene {

EnteredPlace enter(const World& world, const Geometry& geometry, PlaceOffset place) {
    LRAY_ASSERT(place > 0 && place < geometry.place_count);
    // Places ascend with the instances: the last one that does not begin behind it holds it.
    const std::vector<WorldInstance>& instances = geometry.instances;
    const auto next = std::ranges::upper_bound(instances, place, {}, &WorldInstance::first_place);
    LRAY_ASSERT(next != instances.begin());
    const WorldInstance& instance = *std::prev(next);
    const PrimitiveId id(PrimitiveKind::instance,
                         static_cast<std::size_t>(std::prev(next) - instances.begin()));
    return {{&instance, &geometry.object(geometry.object_of(id))},
            &world.prototypes[instance.prototype],
            place - instance.first_place};
}

PlacePath path_to(const World& world, PlaceOffset place) {
    PlacePath path;
    path.geometry = &world;
    while (place > 0) {
        const EnteredPlace entered = enter(world, *path.geometry, place);
        path.steps.push_back(entered.step);
        path.geometry = entered.geometry;
        place = entered.place;
    }
    return path;
}

const Geometry& geometry_at(const World& world, PlaceOffset place) {
    const Geometry* geometry = &world;
    while (place > 0) {
        const EnteredPlace entered = enter(world, *geometry, place);
        geometry = entered.geometry;
        place = entered.place;
    }
    return *geometry;
}

std::uint32_t material_at(const World& world, PlaceOffset place, PrimitiveId id) {
    std::uint32_t material = Object::kInherited;
    const auto settle = [&material](const Object& object) {
        if (object.material != Object::kInherited) material = object.material;
    };
    const Geometry* geometry = &world;
    while (place > 0) {
        const EnteredPlace entered = enter(world, *geometry, place);
        settle(*entered.step.object);
        geometry = entered.geometry;
        place = entered.place;
    }
    settle(geometry->object(geometry->object_of(id)));
    LRAY_ASSERT(material != Object::kInherited);
    return material;
}

}  // namespace lray::scene
