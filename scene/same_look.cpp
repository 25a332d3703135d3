#include "scene/same_look.h"

namespace lray::scene {

namespace {

bool hides_what_it_covers(const Object& object, const Material& material) {
    return object.visible && material.opacity == ScalarCoefficient{1.0f} &&
           material.transmit == Coefficient{Color{0.0f}};
}

}  // namespace

bool shows_a_difference(const World& world, PrimitiveId a, PrimitiveId b) {
    const Object& object_a = world.object(world.object_of(a));
    const Object& object_b = world.object(world.object_of(b));
    const Material& one = world.materials[object_a.material];
    const Material& other = world.materials[object_b.material];
    if (!hides_what_it_covers(object_a, one) || !hides_what_it_covers(object_b, other)) {
        return false;
    }
    return !(one.diffuse == other.diffuse && one.specular == other.specular &&
             one.reflect == other.reflect && one.emission == other.emission);
}

}  // namespace lray::scene
