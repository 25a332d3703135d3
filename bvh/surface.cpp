#include "bvh/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/assert.h"
#include "bvh/instance_ray.h"
#include "bvh/kernels/kernels.h"
#include "scene/place.h"

namespace lray::bvh {

namespace {

/// More rounded operations than any kernel performs between a ray's origin and the side of a
/// surface it takes it to be on.
constexpr int kKernelOperations = 32;

/// A position on a surface F = 0 that is positive outside, in double, with what tells how far the
/// position and the kernels may be off.
struct Site {
    DVec3 position{};
    DVec3 gradient{};        // of F, in the world: points outward
    double value = 0.0;      // |F| at the position
    double magnitude = 0.0;  // sum of the absolute terms of F, by which its rounding errors scale
    DVec3 position_error{};  // of the way to the position through instances
    double curvature = 0.0;  // bound on the normal curvatures, 1 / world unit
};

double sum_of_squares(const Mat3& m) {
    const DMat3 d{m};
    return dot(d[0], d[0]) + dot(d[1], d[1]) + dot(d[2], d[2]);
}

DVec3 absolute(DVec3 v) {
    return {std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)};
}

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

Site site_of_triangle(Vec3 a, Vec3 b, Vec3 c, const PreparedRay& ray) {
    const TrianglePlane plane(a, b, c);
    Site site;
    site.position = at(ray, triangle_hit_t(a, b, c, plane, ray));
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
    Site site =
        is_lower ? site_of_triangle(p00, p10, p11, ray) : site_of_triangle(p00, p11, p01, ray);
    const DVec3 opposite = DVec3{is_lower ? p01 : p10} - DVec3{p00};
    site.value += std::fabs(dot(site.gradient, opposite));
    if (rectangle.is_mirrored) site.gradient = -site.gradient;
    return site;
}

Site site_of_sphere(const scene::Sphere& sphere, const PreparedRay& ray, const Hit& hit) {
    const DVec3 center{sphere.center};
    const double radius = static_cast<double>(sphere.radius);
    Site site;
    site.gradient = at(ray, crossing_of(sphere, ray, hit).t) - center;
    site.gradient /= std::sqrt(dot(site.gradient, site.gradient));
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
    DMat3 absolute_map{frame.object_from_world};
    for (int column = 0; column < 3; ++column)
        absolute_map[column] = absolute(absolute_map[column]);
    return {p, point_object(frame, p), absolute_map * absolute(p - DVec3{frame.origin})};
}

/// Turns a gradient in object space into a covector of the world.
DVec3 world_gradient(const scene::AffineFrame& frame, DVec3 gradient_object) {
    return gradient_object * DMat3{frame.object_from_world};  // the transpose times the vector
}

Site site_of_ellipsoid(const scene::Ellipsoid& ellipsoid, const PreparedRay& ray, const Hit& hit) {
    const scene::AffineFrame& frame = ellipsoid.frame;
    const DVec3 center{frame.origin};
    const DVec3 met = at(ray, crossing_of(ellipsoid, ray, hit).t);
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

/// A flat side: F = sign (q[axis] - level).
Site site_of_side(const scene::AffineFrame& frame, DVec3 position, int axis, double sign,
                  double level) {
    const FramePoint p = frame_point(frame, position);
    DVec3 gradient_object{0.0};
    gradient_object[axis] = sign;
    Site site;
    site.position = position;
    site.gradient = world_gradient(frame, gradient_object);
    site.value = std::fabs(p.object[axis] - level);
    site.magnitude = p.magnitude_object[axis] + std::fabs(level);
    return site;
}

Site site_of_cylinder(const scene::Cylinder& cylinder, const PreparedRay& ray, const Hit& hit) {
    const scene::AffineFrame& frame = cylinder.frame;
    const Crossing crossing = crossing_of(cylinder, ray, hit);
    const DVec3 position = at(ray, crossing.t);
    if (crossing.part == kCylinderBottom) return site_of_side(frame, position, 1, -1.0, 0.0);
    if (crossing.part == kCylinderTop) return site_of_side(frame, position, 1, 1.0, 1.0);

    const FramePoint p = frame_point(frame, position);
    const double k = 1.0 - static_cast<double>(cylinder.top_radius);
    const double radius = 1.0 - k * p.object.y;
    const double x = p.object.x;
    const double z = p.object.z;
    // F = x^2 + z^2 - (1 - k y)^2
    DVec3 gradient_object{2.0 * x, 2.0 * k * radius, 2.0 * z};
    if (gradient_object == DVec3{0.0}) gradient_object.y = 1.0;  // the apex has no normal: the axis
    Site site;
    site.position = position;
    site.gradient = world_gradient(frame, gradient_object);
    site.value = std::fabs(x * x + z * z - radius * radius);
    site.magnitude =
        2.0 * (std::fabs(x) * p.magnitude_object.x + std::fabs(z) * p.magnitude_object.z +
               std::fabs(radius) * (1.0 + k * p.magnitude_object.y));
    site.curvature = 2.0 * sum_of_squares(frame.object_from_world) /
                     std::sqrt(dot(site.gradient, site.gradient));
    return site;
}

Site site_of_disk(const scene::Disk& disk, const PreparedRay& ray, const Hit& hit) {
    return site_of_side(disk.frame, at(ray, crossing_of(disk, ray, hit).t), 1, 1.0, 0.0);
}

Site site_of_box(const scene::Box& box, const PreparedRay& ray, const Hit& hit) {
    const Crossing crossing = crossing_of(box, ray, hit);
    const double side = crossing.part % 2 == 0 ? -1.0 : 1.0;
    return site_of_side(box.frame, at(ray, crossing.t), crossing.part / 2, side, side);
}

Site site_of_plane(const scene::Plane& plane, const PreparedRay& ray, const Hit& hit) {
    Site site;
    site.position = at(ray, crossing_of(plane, ray, hit).t);
    site.gradient = DVec3{plane.normal};
    const DVec3 offset = site.position - DVec3{plane.point};
    site.value = std::fabs(dot(site.gradient, offset));
    site.magnitude = dot(absolute(site.gradient), absolute(offset));
    return site;
}

/// Where the tube overlaps itself the surface ends in a tip on the axis, which has no normal.
Site site_of_torus(const scene::Torus& torus, const PreparedRay& ray, const Hit& hit) {
    // The crossing that was rounded to the hit's t.
    const auto t = torus_crossing(torus, ray, {next_down(hit.t), next_up(hit.t)});
    LRAY_ASSERT(t.has_value());
    const FramePoint p = frame_point(torus.frame, at(ray, *t));
    const double radius = torus.radius();
    const double tube = static_cast<double>(torus.tube);
    const double rho = std::sqrt(p.object.x * p.object.x + p.object.z * p.object.z);
    const double over = rho - radius;
    // F = (rho - R)^2 + y^2 - r^2
    const double per_rho = rho > 0.0 ? 2.0 * over / rho : 0.0;
    DVec3 gradient_object{per_rho * p.object.x, 2.0 * p.object.y, per_rho * p.object.z};
    if (gradient_object == DVec3{0.0}) gradient_object.y = 1.0;
    Site site;
    site.position = p.world;
    site.gradient = world_gradient(torus.frame, gradient_object);
    site.value = std::fabs(over * over + p.object.y * p.object.y - tube * tube);
    site.magnitude =
        2.0 * (std::fabs(over) * (p.magnitude_object.x + p.magnitude_object.z + rho + radius) +
               std::fabs(p.object.y) * p.magnitude_object.y + tube * tube);
    // The second derivative is 2 - 2 R rho'', and rho'' at most 1 / rho.
    site.curvature = (2.0 + 2.0 * radius / rho) * sum_of_squares(torus.frame.object_from_world) /
                     std::sqrt(dot(site.gradient, site.gradient));
    return site;
}

Site find_site(const scene::Geometry& geometry, const PreparedRay& ray, const Hit& hit) {
    using enum scene::PrimitiveKind;
    const std::size_t index = hit.primitive_id.index();
    switch (hit.primitive_id.kind()) {
        case triangle: {
            const auto& [a, b, c] = geometry.triangles[index].vertices;
            return site_of_triangle(geometry.vertices[a], geometry.vertices[b],
                                    geometry.vertices[c], ray);
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
            return site_of_disk(geometry.disks[index], ray, hit);
        case box:
            return site_of_box(geometry.boxes[index], ray, hit);
        case plane:
            return site_of_plane(geometry.planes[index], ray, hit);
        case torus:
            return site_of_torus(geometry.tori[index], ray, hit);
        case instance:
            break;
    }
    LRAY_ASSERT(false);
}

double length(DVec3 v) {
    return std::sqrt(dot(v, v));
}

DMat3 absolute(const DMat3& m) {
    return {absolute(m[0]), absolute(m[1]), absolute(m[2])};
}

/// Brings a site from the space of a prototype to that of an instance.
Site placed(const Site& site, const scene::AffineFrame& frame) {
    const DMat3 object_from_world{frame.object_from_world};
    const DMat3 world_from_object = glm::inverse(object_from_world);
    const DVec3 origin{frame.origin};
    Site result = site;
    result.position = world_from_object * site.position + origin;
    result.gradient = world_gradient(frame, site.gradient);
    // The Hessian of F takes the map on both sides, its bound the square of the map's norm.
    result.curvature = site.curvature * sum_of_squares(frame.object_from_world) *
                       length(site.gradient) / length(result.gradient);
    // The ray's way in and the position's way out: a few roundings of sums of such terms.
    const DVec3 terms = absolute(world_from_object) *
                            (absolute(object_from_world) * absolute(result.position - origin) +
                             absolute(site.position)) +
                        absolute(origin);
    result.position_error = absolute(world_from_object) * site.position_error +
                            gamma<double>(kKernelOperations) * terms;
    return result;
}

/// Returns the site of a hit in the space of the world.
Site find_placed_site(const scene::World& world, const Ray& ray, const Hit& hit) {
    PreparedRay local = prepare(ray);
    if (hit.place == 0) return find_site(world, local, hit);
    const scene::PlacePath path = scene::path_to(world, hit.place);
    for (const scene::PlaceStep& step : path.steps) local = ray_in(*step.instance, local);
    Site site = find_site(*path.geometry, local, hit);
    for (auto step = path.steps.rbegin(); step != path.steps.rend(); ++step) {
        site = placed(site, step->instance->frame);
    }
    return site;
}

}  // namespace

SurfacePoint surface_at(const scene::World& world, const Ray& ray, const Hit& hit) {
    LRAY_ASSERT(!hit.is_none());
    const Site site = find_placed_site(world, ray, hit);
    const double slope = length(site.gradient);
    const DVec3 normal = site.gradient / slope;

    // Rounding the position to float: half an ulp per axis, and at least the least float.
    constexpr double kLeast = static_cast<double>(std::numeric_limits<float>::denorm_min());
    const double u = static_cast<double>(kUnitRoundoff<float>);
    const DVec3 rounding = u * absolute(site.position) + DVec3{kLeast} + site.position_error;

    // What the rounding moves the position along the surface lifts it off a curved one by
    // curvature / 2 times its square (four times the rounding: the offset rounds again), but never
    // by more than itself: at the apex of a cone the curvature is infinite.
    const double drift = 4.0 * length(rounding);
    const double lift = std::min(site.curvature * drift * drift / 2.0, drift);
    const double along_normal =
        (site.value + gamma<double>(kKernelOperations) * site.magnitude) / slope + lift;

    const DVec3 error = rounding + along_normal * absolute(normal);
    return {Vec3{site.position}, Vec3{round_up(error.x), round_up(error.y), round_up(error.z)},
            Vec3{normal}};
}

Vec3 offset_origin(Vec3 position, Vec3 error, Vec3 normal, Vec3 direction) {
    const DVec3 n{normal};
    // (1 + gamma(4)): the float normal may be a little shorter than 1.
    const double distance =
        dot(absolute(n), DVec3{error}) * (1.0 + static_cast<double>(gamma<float>(4)));
    const DVec3 offset = dot(n, DVec3{direction}) < 0.0 ? -distance * n : distance * n;
    // Rounded away from the surface.
    Vec3 result{};
    for (int axis = 0; axis < 3; ++axis) {
        const double moved = static_cast<double>(position[axis]) + offset[axis];
        result[axis] = offset[axis] > 0.0 ? round_up(moved) : round_down(moved);
    }
    return result;
}

}  // namespace lray::bvh
