// Ray against rectangle: two watertight triangles that share the diagonal.
#pragma once

#include "bvh/kernels/triangle.h"
#include "scene/world.h"

namespace lray::bvh {

/// Returns the nearer hit of the triangles (p00, p10, p11) and (p00, p11, p01), at equal t that of
/// the first. u and v are the parameters of the parallelogram; the first triangle is where v <= u.
inline KernelHit intersect_rectangle(const scene::Rectangle& rectangle, const PreparedRay& ray,
                                     Interval interval) {
    const auto& [p00, p10, p11, p01] = rectangle.corners;
    const KernelHit lower = intersect_triangle(p00, p10, p11, ray, interval);
    const KernelHit upper = intersect_triangle(p00, p11, p01, ray, interval);
    if (upper.t < lower.t) return {upper.t, upper.u, upper.u + upper.v, upper.normal};
    if (lower.is_none()) return {};
    return {lower.t, lower.u + lower.v, lower.v, lower.normal};
}

}  // namespace lray::bvh
