// Ray against cylinder, truncated cone and cone, open or with caps.
#pragma once

#include <algorithm>
#include <limits>

#include "bvh/kernels/kernel_hit.h"
#include "bvh/kernels/object_ray.h"
#include "bvh/kernels/quadratic.h"

namespace lray::bvh {

/// Parts of a cylinder, in u of the hit.
enum CylinderPart : int { kCylinderSide = 0, kCylinderBottom = 1, kCylinderTop = 2 };

/// A stretch of a ray; empty unless lo <= hi.
struct ConeStretch {
    double lo = -std::numeric_limits<double>::infinity();
    double hi = std::numeric_limits<double>::infinity();

    static ConeStretch empty() {
        return {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    }
    bool is_empty() const { return !(lo <= hi); }  // also NaN
    bool contains(double t) const { return t >= lo && t <= hi; }
};

/// Returns the stretch inside the infinite cone x^2 + z^2 <= (1 - k y)^2, of its two halves the
/// one below the apex; what is above it is outside 0 <= y <= 1 and may be in the result.
inline ConeStretch inside_cone(const ObjectRay& ray, double k) {
    const DVec3 o = ray.origin;
    const DVec3 d = ray.dir;
    const double m = 1.0 - k * o.y;
    const double n = k * d.y;
    const double a = d.x * d.x + d.z * d.z - n * n;
    const double b = o.x * d.x + o.z * d.z + n * m;
    const double c = o.x * o.x + o.z * o.z - m * m;
    ConeStretch result;
    if (a == 0.0) {  // along the axis of a cylinder, or parallel to the side of a cone
        if (b > 0.0) {
            result.hi = -c / (2.0 * b);
        } else if (b < 0.0) {
            result.lo = -c / (2.0 * b);
        } else if (!(c <= 0.0)) {
            return ConeStretch::empty();
        }
        return result;
    }
    const double discriminant = b * b - a * c;
    if (a > 0.0) {
        if (!(discriminant >= 0.0)) return ConeStretch::empty();
        const Roots roots = quadratic_roots(a, b, c, discriminant);
        return {roots.lo, roots.hi};
    }
    if (!(a < 0.0)) return ConeStretch::empty();  // NaN
    // Steeper than the side: the line runs inside both halves, and outside in between. It always
    // crosses both, so a negative discriminant (through the apex) is rounding.
    const Roots roots = quadratic_roots(a, b, c, std::max(discriminant, 0.0));
    if (d.y > 0.0) {
        result.hi = roots.lo;
    } else {
        result.lo = roots.hi;
    }
    return result;
}

/// With caps the body is the meeting of a slab and a cone, which is convex: there is no rim to
/// slip through. Without, both walls are hit from both sides.
inline Crossings crossings(const scene::Cylinder& cylinder, const PreparedRay& ray) {
    ObjectRay local = object_ray(cylinder.frame, ray);
    Crossings result;
    ConeStretch slab;
    if (local.dir.y != 0.0) {
        const double bottom = -local.origin.y / local.dir.y;
        const double top = (1.0 - local.origin.y) / local.dir.y;
        slab = local.dir.y > 0.0 ? ConeStretch{bottom, top} : ConeStretch{top, bottom};
    } else if (!(local.origin.y >= 0.0 && local.origin.y <= 1.0)) {
        return result;
    }
    // The quadratic is set up around the point of the ray nearest to the middle of the axis: its
    // coefficients are then of the size of the cylinder, however far away the ray begins.
    const DVec3 from_middle = local.origin - DVec3{0.0, 0.5, 0.0};
    const double shift = -dot(from_middle, local.dir) / dot(local.dir, local.dir);
    local.origin += shift * local.dir;
    ConeStretch cone = inside_cone(local, 1.0 - static_cast<double>(cylinder.top_radius));
    cone.lo += shift;
    cone.hi += shift;
    if (slab.is_empty() || cone.is_empty()) return result;

    if (!cylinder.caps) {
        if (slab.contains(cone.lo)) result.add(cone.lo, kCylinderSide);
        if (slab.contains(cone.hi)) result.add(cone.hi, kCylinderSide);
        return result;
    }
    const double entry = std::max(slab.lo, cone.lo);
    const double exit = std::min(slab.hi, cone.hi);
    if (!(entry <= exit)) return result;
    const bool is_rising = local.dir.y > 0.0;
    result.add(entry, cone.lo >= slab.lo ? kCylinderSide
                      : is_rising        ? kCylinderBottom
                                         : kCylinderTop);
    result.add(exit, cone.hi <= slab.hi ? kCylinderSide
                     : is_rising        ? kCylinderTop
                                        : kCylinderBottom);
    return result;
}

}  // namespace lray::bvh
