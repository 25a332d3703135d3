#include "bvh/site.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/assert.h"
#include "bvh/kernels/kernels.h"

namespace lray::bvh {

namespace {

/// Returns the crossing that was rounded to the hit's t.
template <class Shape>
Crossing crossing_of(const Shape& shape, const PreparedRay& ray, const Hit& hit) {
    const Crossings found = crossings(shape, ray);
    Crossing best = found.values[0];
    for (int i = 1; i < found.count; ++i) {
        const Crossing& other = found.values[static_cast<std::size_t>(i)];
        const double t = static_cast<double>(hit.t);
        if (std::fabs(other.t - t) < std::fabs(best.t - t)) best = other;
    }
    return best;
}

DVec3 at(const PreparedRay& ray, double t) {
    return ray.origin + t * ray.dir;
}

/// What of a curved surface F = 0 one step of Newton's method needs, at the hit's float t.
struct NewtonStart {
    double value = 0.0;  // of F
    DVec3 gradient{};
    DVec3 dir{};        // of the ray, in the same space
    double size = 1.0;  // its least radius of curvature, about
};

/// Returns t where F is 0, next to the hit's: much less work than the crossings. None where that
/// takes more than one step: the ray grazes the surface, or a float next to t is a long way.
std::optional<double> step_to_root(const NewtonStart& start, const Hit& hit) {
    constexpr double kLongest2 = 0x1p-20;  // so that the rest is below 2^-10 of the step
    const double slope = dot(start.gradient, start.dir);
    const double speed2 = dot(start.dir, start.dir);
    if (!(slope * slope >= kGrazing * dot(start.gradient, start.gradient) * speed2)) {
        return std::nullopt;
    }
    const double step = -start.value / slope;
    if (!(step * step * speed2 <= kLongest2 * start.size * start.size)) return std::nullopt;
    return static_cast<double>(hit.t) + step;
}

/// Returns triangle_hit_t(), which but at the rims of the box is where the plane is met.
double t_of_triangle(Vec3 a, Vec3 b, Vec3 c, const TrianglePlane& plane, const PreparedRay& ray,
                     const Hit& hit) {
    const double t = dot(plane.normal, DVec3{a} - ray.origin) / dot(plane.normal, ray.dir);
    if (static_cast<float>(t) == hit.t && !is_grazing(plane, ray)) return t;
    PreparedRay whole = ray;
    prepare_floats(whole);
    return triangle_hit_t(a, b, c, plane, whole);
}

Site site_of_triangle(Vec3 a, Vec3 b, Vec3 c, const PreparedRay& ray, const Hit& hit) {
    const TrianglePlane plane(a, b, c);
    Site site;
    site.position = at(ray, t_of_triangle(a, b, c, plane, ray, hit));
    site.gradient = plane.normal;
    const DVec3 offset = site.position - DVec3{a};
    site.value = std::fabs(dot(plane.normal, offset));
    // The cross product cancels in slivers: its terms count, not its length.
    const DVec3 e = absolute(plane.edge_b);
    const DVec3 f = absolute(plane.edge_c);
    const DVec3 terms{e.y * f.z + e.z * f.y, e.z * f.x + e.x * f.z, e.x * f.y + e.y * f.x};
    site.magnitude = dot(terms, absolute(offset));
    return site;
}

/// The two halves of a rectangle whose corners were rounded are not quite in one plane: the fold
/// adds to the error, so that a ray that leaves one half does not meet the other.
Site site_of_rectangle(const scene::Rectangle& rectangle, const PreparedRay& ray, const Hit& hit) {
    const auto& [p00, p10, p11, p01] = rectangle.corners;
    const bool is_lower = hit.v <= hit.u;
    Site site = is_lower ? site_of_triangle(p00, p10, p11, ray, hit)
                         : site_of_triangle(p00, p11, p01, ray, hit);
    const DVec3 opposite = DVec3{is_lower ? p01 : p10} - DVec3{p00};
    site.value += std::fabs(dot(site.gradient, opposite));
    if (rectangle.is_mirrored) site.gradient = -site.gradient;
    return site;
}

Site site_of_sphere(const scene::Sphere& sphere, const PreparedRay& ray, const Hit& hit) {
    const DVec3 center{sphere.center};
    const double radius = static_cast<double>(sphere.radius);
    const DVec3 about = at(ray, static_cast<double>(hit.t)) - center;
    const auto t =
        step_to_root({dot(about, about) - radius * radius, 2.0 * about, ray.dir, radius}, hit);
    Site site;
    site.gradient = at(ray, t ? *t : crossing_of(sphere, ray, hit).t) - center;
    site.gradient *= 1.0 / std::sqrt(dot(site.gradient, site.gradient));
    site.position = center + radius * site.gradient;
    site.magnitude = 2.0 * radius;
    site.curvature = 1.0 / radius;
    return site;
}

/// A position and its image in the object space of a frame.
struct FramePoint {
    DVec3 world{};
    DVec3 object{};
    DVec3 magnitude_object{};  // sums of the absolute terms of `object`
};

FramePoint frame_point(const scene::AffineFrame& frame, DVec3 p) {
    return {p, point_object(frame, p),
            absolute(DMat3{frame.object_from_world}) * absolute(p - DVec3{frame.origin})};
}

Site site_of_ellipsoid(const scene::Ellipsoid& ellipsoid, const PreparedRay& ray, const Hit& hit) {
    const scene::AffineFrame& frame = ellipsoid.frame;
    const DVec3 center{frame.origin};
    const ObjectRay local = object_ray(frame, ray);
    const DVec3 about = local.origin + static_cast<double>(hit.t) * local.dir;
    const auto t = step_to_root({dot(about, about) - 1.0, 2.0 * about, local.dir, 1.0}, hit);
    const DVec3 met = at(ray, t ? *t : crossing_of(ellipsoid, ray, hit).t);
    // Scaled about the centre onto the surface, in the world: no inverse is needed.
    const DVec3 met_object = point_object(frame, met);
    const FramePoint p =
        frame_point(frame, center + (met - center) / std::sqrt(dot(met_object, met_object)));
    Site site;
    site.position = p.world;
    // F = |q|^2 - 1
    site.gradient = world_gradient(frame, 2.0 * p.object);
    site.value = std::fabs(dot(p.object, p.object) - 1.0);
    site.magnitude = 2.0 * dot(absolute(p.object), p.magnitude_object) + 2.0;
    site.curvature = 2.0 * sum_of_squares(frame.object_from_world) /
                     std::sqrt(dot(site.gradient, site.gradient));
    return site;
}

/// A flat side, F = sign (q[axis] - level), where the ray crosses it.
Site site_of_side(const scene::AffineFrame& frame, const PreparedRay& ray, int axis, double sign,
                  double level) {
    const Mat3& map = frame.object_from_world;
    const DVec3 row{Vec3{map[0][axis], map[1][axis], map[2][axis]}};
    const DVec3 origin{frame.origin};
    const double t = (level - dot(row, ray.origin - origin)) / dot(row, ray.dir);
    Site site;
    site.position = at(ray, t);
    const DVec3 offset = site.position - origin;
    site.gradient = sign * row;
    site.value = std::fabs(dot(row, offset) - level);
    site.magnitude = dot(absolute(row), absolute(offset)) + std::fabs(level);
    return site;
}

/// The side of a truncated cone, F = x^2 + z^2 - (1 - k y)^2.
struct ConeSide {
    double k = 0.0;

    double radius(DVec3 q) const { return 1.0 - k * q.y; }
    double value(DVec3 q) const { return q.x * q.x + q.z * q.z - radius(q) * radius(q); }
    DVec3 gradient(DVec3 q) const { return {2.0 * q.x, 2.0 * k * radius(q), 2.0 * q.z}; }
};

Site site_of_cylinder(const scene::Cylinder& cylinder, const PreparedRay& ray, const Hit& hit) {
    const scene::AffineFrame& frame = cylinder.frame;
    const int part = static_cast<int>(hit.u);
    if (part == kCylinderBottom) return site_of_side(frame, ray, 1, -1.0, 0.0);
    if (part == kCylinderTop) return site_of_side(frame, ray, 1, 1.0, 1.0);

    const ConeSide side{1.0 - static_cast<double>(cylinder.top_radius)};
    const ObjectRay local = object_ray(frame, ray);
    const DVec3 about = local.origin + static_cast<double>(hit.t) * local.dir;
    const auto t =
        step_to_root({side.value(about), side.gradient(about), local.dir, side.radius(about)}, hit);
    const FramePoint p = frame_point(frame, at(ray, t ? *t : crossing_of(cylinder, ray, hit).t));
    DVec3 gradient_object = side.gradient(p.object);
    if (gradient_object == DVec3{0.0}) gradient_object.y = 1.0;  // the apex has no normal: the axis
    Site site;
    site.position = p.world;
    site.gradient = world_gradient(frame, gradient_object);
    site.value = std::fabs(side.value(p.object));
    site.magnitude =
        2.0 * (std::fabs(p.object.x) * p.magnitude_object.x +
               std::fabs(p.object.z) * p.magnitude_object.z +
               std::fabs(side.radius(p.object)) * (1.0 + side.k * p.magnitude_object.y));
    site.curvature = 2.0 * sum_of_squares(frame.object_from_world) /
                     std::sqrt(dot(site.gradient, site.gradient));
    return site;
}

Site site_of_box(const scene::Box& box, const PreparedRay& ray, const Hit& hit) {
    const int face = static_cast<int>(hit.u);
    const double side = face % 2 == 0 ? -1.0 : 1.0;
    return site_of_side(box.frame, ray, face / 2, side, side);
}

Site site_of_plane(const scene::Plane& plane, const PreparedRay& ray) {
    Site site;
    site.position = at(ray, crossings(plane, ray).values[0].t);
    site.gradient = DVec3{plane.normal};
    const DVec3 offset = site.position - DVec3{plane.point};
    site.value = std::fabs(dot(site.gradient, offset));
    site.magnitude = dot(absolute(site.gradient), absolute(offset));
    return site;
}

/// F = (rho - R)^2 + y^2 - r^2, rho the distance from the axis.
struct TorusSide {
    double radius = 0.0;
    double tube = 0.0;

    double value(DVec3 q, double rho) const {
        const double over = rho - radius;
        return over * over + q.y * q.y - tube * tube;
    }
    DVec3 gradient(DVec3 q, double rho) const {
        const double per_rho = rho > 0.0 ? 2.0 * (rho - radius) / rho : 0.0;
        return {per_rho * q.x, 2.0 * q.y, per_rho * q.z};
    }
};

double axis_distance(DVec3 q) {
    return std::sqrt(q.x * q.x + q.z * q.z);
}

double t_of_torus(const scene::Torus& torus, const TorusSide& side, const PreparedRay& ray,
                  const Hit& hit) {
    const ObjectRay local = object_ray(torus.frame, ray);
    const DVec3 about = local.origin + static_cast<double>(hit.t) * local.dir;
    const double rho = axis_distance(about);
    const auto t = step_to_root(
        {side.value(about, rho), side.gradient(about, rho), local.dir, std::min(side.tube, rho)},
        hit);
    if (t) return *t;
    // The crossing that was rounded to the hit's t.
    const auto root = torus_crossing(torus, ray, {next_down(hit.t), next_up(hit.t)});
    LRAY_ASSERT(root.has_value());
    return *root;
}

/// Where the tube overlaps itself the surface ends in a tip on the axis, which has no normal.
Site site_of_torus(const scene::Torus& torus, const PreparedRay& ray, const Hit& hit) {
    const TorusSide side{torus.radius(), static_cast<double>(torus.tube)};
    const FramePoint p = frame_point(torus.frame, at(ray, t_of_torus(torus, side, ray, hit)));
    const double rho = axis_distance(p.object);
    DVec3 gradient_object = side.gradient(p.object, rho);
    if (gradient_object == DVec3{0.0}) gradient_object.y = 1.0;
    Site site;
    site.position = p.world;
    site.gradient = world_gradient(torus.frame, gradient_object);
    site.value = std::fabs(side.value(p.object, rho));
    site.magnitude = 2.0 * (std::fabs(rho - side.radius) *
                                (p.magnitude_object.x + p.magnitude_object.z + rho + side.radius) +
                            std::fabs(p.object.y) * p.magnitude_object.y + side.tube * side.tube);
    // The second derivative is 2 - 2 R rho'', and rho'' at most 1 / rho.
    site.curvature = (2.0 + 2.0 * side.radius / rho) *
                     sum_of_squares(torus.frame.object_from_world) /
                     std::sqrt(dot(site.gradient, site.gradient));
    return site;
}

Site site_of(const scene::Geometry& geometry, const PreparedRay& ray, const Hit& hit) {
    using enum scene::PrimitiveKind;
    const std::size_t index = hit.primitive_id.index();
    switch (hit.primitive_id.kind()) {
        case triangle: {
            const auto& [a, b, c] = geometry.triangles[index].vertices;
            return site_of_triangle(geometry.vertices[a], geometry.vertices[b],
                                    geometry.vertices[c], ray, hit);
        }
        case rectangle:
            return site_of_rectangle(geometry.rectangles[index], ray, hit);
        case sphere:
            return site_of_sphere(geometry.spheres[index], ray, hit);
        case ellipsoid:
            return site_of_ellipsoid(geometry.ellipsoids[index], ray, hit);
        case cylinder:
            return site_of_cylinder(geometry.cylinders[index], ray, hit);
        case disk:
            return site_of_side(geometry.disks[index].frame, ray, 1, 1.0, 0.0);
        case box:
            return site_of_box(geometry.boxes[index], ray, hit);
        case plane:
            return site_of_plane(geometry.planes[index], ray);
        case torus:
            return site_of_torus(geometry.tori[index], ray, hit);
        case instance:
            break;
    }
    LRAY_ASSERT(false);
}

}  // namespace

Site find_site(const scene::Geometry& geometry, const PreparedRay& ray, const Hit& hit) {
    Site site = site_of(geometry, ray, hit);
    site.position_local = site.position;
    return site;
}

}  // namespace lray::bvh
