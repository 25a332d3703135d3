// Ray against triangle, watertight: no ray slips between triangles that share vertices.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

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

inline Bounds triangle_bounds(Vec3 a, Vec3 b, Vec3 c) {
    const auto least = [](float p, float q, float r) {
        const float pq = q < p ? q : p;
        return r < pq ? r : pq;
    };
    const auto most = [](float p, float q, float r) {
        const float pq = q > p ? q : p;
        return r > pq ? r : pq;
    };
    return {{least(a.x, b.x, c.x), least(a.y, b.y, c.y), least(a.z, b.z, c.z)},
            {most(a.x, b.x, c.x), most(a.y, b.y, c.y), most(a.z, b.z, c.z)}};
}

/// Returns the stretch of the ray in the triangle's box.
inline Stretch triangle_stretch(Vec3 a, Vec3 b, Vec3 c, const FloatRay& ray) {
    return stretch_in(triangle_bounds(a, b, c), ray);
}

/// By how much what holds a part of a triangle is larger than the part: sixteen times the roundoff
/// of float in parts of the coordinates, and so much of the triangle's own extent that only a ray
/// that is as good as in its plane meets the plane farther from the point that is hit.
/// Shape: the bounds of the whole triangle.
inline DVec3 part_pad(const Bounds& whole) {
    constexpr double kPlacePad = 0x1p-20;
    constexpr double kExtentPad = 0x1p-9;
    const DVec3 least{whole.min};
    const DVec3 most{whole.max};
    return kPlacePad * glm::max(glm::abs(least), glm::abs(most)) + kExtentPad * (most - least);
}

/// Returns t where the ray meets the plane of a triangle, kept within a stretch of the ray that is
/// not empty: seen edge-on, the plane alone may say anything. NaN when the ray is parallel to the
/// plane or the triangle has no area.
/// In double, so that the side of the plane a ray begins on is known to the error bound that
/// surface_at() gives; float would find a ray that leaves the triangle on it again (pbrt 4th ed.,
/// 6.8.7, rejects such hits by a bound on t, and real ones with them).
inline double triangle_t(Vec3 a, const TrianglePlane& plane, const Stretch& stretch,
                         const PreparedRay& ray) {
    const auto least = static_cast<double>(stretch.entry * kEntryFactor);
    const auto most = static_cast<double>(stretch.exit);
    const double slope = dot(plane.normal, ray.dir);
    const double t = slope != 0.0 ? dot(plane.normal, DVec3{a} - ray.origin) / slope
                                  : std::numeric_limits<double>::quiet_NaN();
    return t < least ? least : (t > most ? most : t);
}

/// A corner in the axes of the ray, moved so that the ray is the z axis.
struct ShearedCorner {
    float x = 0.0f;
    float y = 0.0f;
};

inline ShearedCorner sheared(Vec3 p, const FloatRay& ray) {
    const float q[3] = {p.x - ray.origin_float[0], p.y - ray.origin_float[1],
                        p.z - ray.origin_float[2]};
    const float z = q[ray.axes[2]];
    return {q[ray.axes[0]] - ray.shear_x * z, q[ray.axes[1]] - ray.shear_y * z};
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

/// Returns the stretch of a ray that grazes a triangle in which its hit may lie: beside the point
/// of the triangle that the areas say is hit, not anywhere in its box. There a tree that has the
/// triangle in parts finds it, as one of the parts holds that point and all about it within
/// part_pad(). The areas are of one sign and not all 0.
inline Stretch grazing_stretch(Vec3 a, Vec3 b, Vec3 c, const PreparedRay& ray) {
    const auto areas = edge_areas<double>(sheared(a, ray), sheared(b, ray), sheared(c, ray));
    const double sum = areas.a + areas.b + areas.c;
    const DVec3 point = (areas.a * DVec3{a} + areas.b * DVec3{b} + areas.c * DVec3{c}) / sum;
    Bounds box = triangle_bounds(a, b, c);
    const DVec3 pad = 0.5 * part_pad(box);  // half: the rest is for the rounding of the point
    for (int axis = 0; axis < 3; ++axis) {
        const float low = round_down(point[axis] - pad[axis]);
        const float high = round_up(point[axis] + pad[axis]);
        box.min[axis] = low > box.min[axis] ? low : box.min[axis];
        box.max[axis] = high < box.max[axis] ? high : box.max[axis];
    }
    return stretch_in(box, ray);
}

inline bool is_grazing(const TrianglePlane& plane, const PreparedRay& ray) {
    const double slope = dot(plane.normal, ray.dir);
    return !(slope * slope >= kGrazing * dot(plane.normal, plane.normal) * dot(ray.dir, ray.dir));
}

/// Returns the t of a hit before it is rounded: finish_triangle()'s.
inline double triangle_hit_t(Vec3 a, Vec3 b, Vec3 c, const TrianglePlane& plane,
                             const PreparedRay& ray) {
    const Stretch stretch =
        is_grazing(plane, ray) ? grazing_stretch(a, b, c, ray) : triangle_stretch(a, b, c, ray);
    return triangle_t(a, plane, stretch, ray);
}

/// True if areas that do not have two signs say for sure that the triangle is hit, and where: none
/// is 0, which may have been rounded to it.
inline bool are_sure(const EdgeAreas<float>& areas, float sum) {
    const float magnitude = std::fabs(sum);
    return areas.a != 0.0f && areas.b != 0.0f && areas.c != 0.0f &&
           magnitude >= std::numeric_limits<float>::min() && magnitude < kInfinity;
}

/// Returns the barycentric coordinates of the hit of b and c, worked out in double. None if the
/// areas have two signs or are 0.
inline std::optional<Vec2> exact_barycentric(Vec3 a, Vec3 b, Vec3 c, const PreparedRay& ray) {
    const auto areas = edge_areas<double>(sheared(a, ray), sheared(b, ray), sheared(c, ray));
    const double sum = areas.a + areas.b + areas.c;
    if (areas.have_two_signs() || !(sum != 0.0)) return std::nullopt;
    return Vec2{static_cast<float>(areas.b / sum), static_cast<float>(areas.c / sum)};
}

/// Where a ray meets the plane of a triangle, in its box.
struct PlaneHit {
    float t = 0.0f;  // triangle_t()
    bool is_grazing = false;
    Vec3 normal{0.0f};  // Hit::normal
};

/// `stretch`: of the ray in the triangle's box, not empty.
inline PlaneHit plane_hit(Vec3 a, Vec3 b, Vec3 c, const Stretch& stretch, const PreparedRay& ray) {
    const TrianglePlane plane(a, b, c);
    return {static_cast<float>(triangle_t(a, plane, stretch, ray)), is_grazing(plane, ray),
            Vec3{plane.normal}};
}

/// Finds the hit of a triangle whose areas do not have two signs, from where its plane is met:
/// intersect_triangle()'s last part. Returns false if there is none.
inline bool finish_triangle(Vec3 a, Vec3 b, Vec3 c, const EdgeAreas<float>& areas,
                            const PlaneHit& plane, const PreparedRay& ray, Interval interval,
                            KernelHit& hit) {
    // A ray that leaves the triangle has its plane behind it, though maybe not the point that it
    // grazes.
    if (!(plane.t > interval.lo)) return false;
    float t = plane.t;
    if (plane.is_grazing) [[unlikely]] {
        const Stretch here = grazing_stretch(a, b, c, ray);
        if (!(here.entry <= here.exit)) return false;
        t = static_cast<float>(triangle_t(a, TrianglePlane(a, b, c), here, ray));
    }
    if (!interval.contains(t)) return false;
    const float sum = areas.a + areas.b + areas.c;
    hit.u = areas.b / sum;
    hit.v = areas.c / sum;
    if (!are_sure(areas, sum)) [[unlikely]] {
        const std::optional<Vec2> exact = exact_barycentric(a, b, c, ray);
        if (!exact) return false;
        hit.u = exact->x;
        hit.v = exact->y;
    }
    hit.t = t;
    hit.normal.x = plane.normal.x;
    hit.normal.y = plane.normal.y;
    hit.normal.z = plane.normal.z;
    return true;
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
    if (areas.have_two_signs()) return {};
    // Missed, if the sheared vertices are far off: the ray passes much closer to one end of a long
    // triangle than to the other.
    const Stretch stretch = triangle_stretch(a, b, c, ray);
    if (!(stretch.entry <= stretch.exit)) return {};
    KernelHit hit;
    if (!finish_triangle(a, b, c, areas, plane_hit(a, b, c, stretch, ray), ray, interval, hit)) {
        return {};
    }
    return hit;
}

}  // namespace lray::bvh
