#include "bvh/intersect.h"

#include "base/assert.h"
#include "bvh/kernels/kernels.h"

namespace lray::bvh {

namespace {

KernelHit dispatch(const scene::World& world, scene::PrimitiveId id, const PreparedRay& ray,
                   Interval interval) {
    using enum scene::PrimitiveKind;
    switch (id.kind()) {
        case triangle:
            return intersect_kind<triangle>(world, id.index(), ray, interval);
        case rectangle:
            return intersect_kind<rectangle>(world, id.index(), ray, interval);
        case sphere:
            return intersect_kind<sphere>(world, id.index(), ray, interval);
        case ellipsoid:
            return intersect_kind<ellipsoid>(world, id.index(), ray, interval);
        case cylinder:
            return intersect_kind<cylinder>(world, id.index(), ray, interval);
        case disk:
            return intersect_kind<disk>(world, id.index(), ray, interval);
        case box:
            return intersect_kind<box>(world, id.index(), ray, interval);
        case plane:
            return intersect_kind<plane>(world, id.index(), ray, interval);
        case torus:
            return intersect_kind<torus>(world, id.index(), ray, interval);
    }
    LRAY_ASSERT(false);
}

}  // namespace

Hit intersect(const scene::World& world, scene::PrimitiveId id, const PreparedRay& ray,
              Interval interval) {
    const KernelHit hit = dispatch(world, id, ray, interval);
    if (hit.is_none()) return {};
    return {hit.t, hit.u, hit.v, id};
}

}  // namespace lray::bvh
