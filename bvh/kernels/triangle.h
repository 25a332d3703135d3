// Ray against triangle, watertight: no ray slips between triangles that share vertices.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "bvh/kernels/kernel_hit.h"
#include "bvh/prepared_ray.h"
#include "bvh/slab.h"

namespace lray::bvh {

/// The plane of a triangle in double; the normal has the length of twice the area.
struct TrianglePlane {
    DVec3 edge_b{};
    DVec3 edge_c{};
    DVec3 normal{};

    TrianglePlane(Vec3 a, Vec3 b, Vec3 c)
        : edge_b(DVec3{b} - DVec3{a}), edge_c(DVec3{c} - DVec3{a}), normal(cross(edge_b, edge_c)) {}
};

/// Returns t where the ray meets the plane of the triangle, kept within the stretch of the ray in
/// the triangle's box: seen edge-on, the plane alone may say anything. NaN when the ray is parallel
/// to the plane, the triangle has no area, or the ray misses the box: then the sheared vertices are
/// far off, as the ray passes much closer to one end of a long triangle than to the other.
/// In double, so that the side of the plane a ray begins on is known to the error bound that
/// surface_at() gives; float would find a ray that leaves the triangle on it again (pbrt 4th ed.,
/// 6.8.7, rejects such hits by a bound on t, and real ones with them).
inline double triangle_t(Vec3 a, Vec3 b, Vec3 c, const PreparedRay& ray) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    Bounds box;
    box.add(a);
    box.add(b);
    box.add(c);
    const Stretch stretch = stretch_in(box, ray);
    const double least = static_cast<double>(stretch.entry * kEntryFactor);
    const double most = static_cast<double>(stretch.exit);
    if (!(stretch.entry <= stretch.exit)) return kNone;
    const TrianglePlane plane(a, b, c);
    const double slope = dot(plane.normal, ray.dir);
    if (slope == 0.0) return kNone;
    const double t = dot(plane.normal, DVec3{a} - ray.origin) / slope;
    return t < least ? least : (t > most ? most : t);
}

/// A corner in the axes of the ray, moved so that the ray is the z axis.
struct ShearedCorner {
    float x = 0.0f;
    float y = 0.0f;
};

inline ShearedCorner sheared(Vec3 p, const PreparedRay& ray) {
    const auto q = std::bit_cast<std::array<float, 3>>(p - ray.origin_float);
    const float z = q[static_cast<std::size_t>(ray.kz)];
    return {q[static_cast<std::size_t>(ray.kx)] - ray.shear_x * z,
            q[static_cast<std::size_t>(ray.ky)] - ray.shear_y * z};
}

/// Twice the signed areas, as the ray sees them, opposite the corners a, b and c.
template <class Number>
struct EdgeAreas {
    Number a{};
    Number b{};
    Number c{};

    bool have_two_signs() const {  // NaN has none
        return (a < Number{0} || b < Number{0} || c < Number{0}) &&
               (a > Number{0} || b > Number{0} || c > Number{0});
    }
};

template <class Number>
EdgeAreas<Number> edge_areas(ShearedCorner a, ShearedCorner b, ShearedCorner c) {
    const auto area = [](ShearedCorner p, ShearedCorner q) {
        return static_cast<Number>(p.x) * static_cast<Number>(q.y) -
               static_cast<Number>(p.y) * static_cast<Number>(q.x);
    };
    return {area(c, b), area(a, c), area(b, a)};
}

/// Returns the hit of a triangle whose areas do not have two signs: intersect_triangle()'s second
/// half.
inline KernelHit finish_triangle(Vec3 a, Vec3 b, Vec3 c, const EdgeAreas<float>& areas,
                                 const PreparedRay& ray, Interval interval) {
    const float sum = areas.a + areas.b + areas.c;
    const float magnitude = std::fabs(sum);
    float u = areas.b / sum;
    float v = areas.c / sum;
    if (areas.a == 0.0f || areas.b == 0.0f || areas.c == 0.0f ||
        !(magnitude >= std::numeric_limits<float>::min() && magnitude < kInfinity)) {
        const EdgeAreas<double> exact =
            edge_areas<double>(sheared(a, ray), sheared(b, ray), sheared(c, ray));
        if (exact.have_two_signs()) return {};
        const double exact_sum = exact.a + exact.b + exact.c;
        if (!(exact_sum != 0.0)) return {};
        u = static_cast<float>(exact.b / exact_sum);
        v = static_cast<float>(exact.c / exact_sum);
    }
    const float t = static_cast<float>(triangle_t(a, b, c, ray));
    return interval.contains(t) ? KernelHit{t, u, v} : KernelHit{};
}

/// Returns the hit on either side of the triangle; u and v are the barycentric coordinates of b
/// and c. Through a shared edge or vertex a ray hits at least one of the triangles around it, often
/// more, at the t of each; a triangle seen exactly edge-on is not hit.
/// The signs of the edge functions are exact for the sheared vertices: a product rounds
/// monotonically, so the difference of two has the right sign or is 0, and a 0 is worked out again
/// in double, where products of floats are exact. The same vertices give the same sheared ones,
/// and an edge run through backwards the same function negated.
/// Source: Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection".
inline KernelHit intersect_triangle(Vec3 a, Vec3 b, Vec3 c, const PreparedRay& ray,
                                    Interval interval) {
    const EdgeAreas<float> areas =
        edge_areas<float>(sheared(a, ray), sheared(b, ray), sheared(c, ray));
    return areas.have_two_signs() ? KernelHit{} : finish_triangle(a, b, c, areas, ray, interval);
}

}  // namespace lray::bvh
