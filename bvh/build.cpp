#include "base/assert.h"
#include "bvh/accel.h"
#include "bvh/brute_force.h"
#include "bvh/spheres/sphere_accel.h"

namespace lray::bvh {

std::unique_ptr<Accel> build(const scene::World& world, AccelKind kind) {
    switch (kind) {
        case AccelKind::none:
            return make_brute_force(world);
        case AccelKind::spheres:
            return make_sphere_accel(world);
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::bvh
