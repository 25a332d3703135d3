#include "base/assert.h"
#include "bvh/accel.h"
#include "bvh/boxes/box_accel.h"
#include "bvh/brute_force.h"
#include "bvh/spheres/sphere_accel.h"

namespace lray::bvh {

std::unique_ptr<Accel> build(const scene::World& world, const BuildOptions& options) {
    switch (options.kind) {
        case AccelKind::none:
            return make_brute_force(world);
        case AccelKind::spheres:
            return make_sphere_accel(world);
        case AccelKind::boxes:
            return make_box_accel(world, options.quality, fastest_walks());
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::bvh
