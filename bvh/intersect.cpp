#include "bvh/intersect.h"

#include "base/assert.h"
#include "bvh/kernels/kernels.h"

namespace lray::bvh {

namespace {

KernelHit dispatch(const scene::Geometry& geometry, scene::PrimitiveId id, const PreparedRay& ray,
                   Interval interval) {
    using enum scene::PrimitiveKind;
    switch (id.kind()) {
        case triangle:
            return intersect_kind<triangle>(geometry, id.index(), ray, interval);
        case rectangle:
            return intersect_kind<rectangle>(geometry, id.index(), ray, interval);
        case sphere:
            return intersect_kind<sphere>(geometry, id.index(), ray, interval);
        case ellipsoid:
            return intersect_kind<ellipsoid>(geometry, id.index(), ray, interval);
        case cylinder:
            return intersect_kind<cylinder>(geometry, id.index(), ray, interval);
        case disk:
            return intersect_kind<disk>(geometry, id.index(), ray, interval);
        case box:
            return intersect_kind<box>(geometry, id.index(), ray, interval);
        case plane:
            return intersect_kind<plane>(geometry, id.index(), ray, interval);
        case torus:
            return intersect_kind<torus>(geometry, id.index(), ray, interval);
        case instance:
            break;
    }
    LRAY_ASSERT(false);
}

}  // namespace

Hit intersect(const scene::Geometry& geometry, scene::PrimitiveId id, const PreparedRay& ray,
              Interval interval) {
    const KernelHit hit = dispatch(geometry, id, ray, interval);
    if (hit.is_none()) return {};
    return {.t = hit.t, .u = hit.u, .v = hit.v, .primitive_id = id, .normal = hit.normal};
}

}  // namespace lray::bvh
