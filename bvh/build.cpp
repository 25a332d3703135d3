#include "base/assert.h"
#include "bvh/accel.h"
#include "bvh/brute_force.h"

namespace lray::bvh {

std::unique_ptr<Accel> build(const scene::World& world, AccelKind kind) {
    switch (kind) {
        case AccelKind::none:
            return make_brute_force(world);
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::bvh
