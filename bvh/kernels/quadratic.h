// Roots of quadratics without cancellation, and the ball that two kinds share.
#pragma once

#include <cmath>

#include "bvh/kernels/kernel_hit.h"

namespace lray::bvh {

struct Roots {
    double lo = 0.0;
    double hi = 0.0;
};

/// Returns the roots of a t^2 + 2 b t + c in ascending order; `discriminant` is b^2 - a c >= 0.
/// a is not 0; when it is tiny, one root is very large or infinite and the other accurate.
/// Source: Higham 2002, "Accuracy and Stability of Numerical Algorithms", sec. 1.8.
inline Roots quadratic_roots(double a, double b, double c, double discriminant) {
    const double root = std::sqrt(discriminant);
    const double q = -(b + (b < 0.0 ? -root : root));
    if (q == 0.0) return {0.0, 0.0};
    const double t0 = q / a;
    const double t1 = c / q;
    return t0 < t1 ? Roots{t0, t1} : Roots{t1, t0};
}

/// Returns where a ray crosses the sphere of that radius around the origin of its space. A tangent
/// counts as two equal crossings.
/// The discriminant is taken from the foot of the perpendicular: b^2 - a c would lose the radius
/// of a small or distant sphere to cancellation.
/// Source: Haines, Gunther, Akenine-Moller 2019, "Precision Improvements for Ray/Sphere
/// Intersection", Ray Tracing Gems ch. 7.
inline Crossings ball_crossings(DVec3 origin, DVec3 dir, double radius) {
    Crossings result;
    const double a = dot(dir, dir);
    const double b = dot(origin, dir);
    const DVec3 foot = origin - (b / a) * dir;
    const double discriminant = a * (radius * radius - dot(foot, foot));
    if (!(discriminant >= 0.0)) return result;  // also NaN
    const double c = dot(origin, origin) - radius * radius;
    const Roots roots = quadratic_roots(a, b, c, discriminant);
    result.add(roots.lo);
    result.add(roots.hi);
    return result;
}

}  // namespace lray::bvh
