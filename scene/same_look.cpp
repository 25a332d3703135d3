#include "scene/same_look.h"

#include "scene/each_primitive.h"

namespace lray::scene {

namespace {

bool hides_what_it_covers(const Object& object, const Material& material) {
    return object.visible && material.opacity == ScalarCoefficient{1.0f} &&
           material.transmit == Coefficient{Color{0.0f}};
}

/// True if a surface that is seen in the prototype takes its material from the instance.
bool shows_inherited_material(const World& world, PrimitiveId instance) {
    const Geometry& prototype = world.prototypes[world.instances[instance.index()].prototype];
    bool is_found = false;
    each_primitive(prototype, [&](PrimitiveId id, const Object& object) {
        is_found = id.kind() != PrimitiveKind::instance && object.visible &&
                   object.material == Object::kInherited;
        return !is_found;
    });
    return is_found;
}

}  // namespace

bool shows_a_difference(const World& world, PrimitiveId a, PrimitiveId b) {
    const Object& object_a = world.object(world.object_of(a));
    const Object& object_b = world.object(world.object_of(b));
    const bool is_unsure =
        a.kind() == PrimitiveKind::instance && !shows_inherited_material(world, a);
    if (is_unsure) return false;
    const Material& one = world.materials[object_a.material];
    const Material& other = world.materials[object_b.material];
    if (!hides_what_it_covers(object_a, one) || !hides_what_it_covers(object_b, other)) {
        return false;
    }
    return !(one.diffuse == other.diffuse && one.specular == other.specular &&
             one.reflect == other.reflect && one.emission == other.emission);
}

}  // namespace lray::scene
