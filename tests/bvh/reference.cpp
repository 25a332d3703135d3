#include "tests/bvh/reference.h"

#include <algorithm>
#include <cmath>

namespace lray::bvh {

namespace {

using scene::PrimitiveId;
using scene::PrimitiveKind;

struct LongRay {
    LVec3 origin;
    LVec3 dir;
    LVec3 at(Long t) const { return origin + t * dir; }
};

LongRay object_ray(const scene::AffineFrame& frame, const LongRay& ray) {
    const LMat3 map{frame.object_from_world};
    return {map * (ray.origin - LVec3{frame.origin}), map * ray.dir};
}

/// Moller, Trumbore 1997.
void meet_triangle(Vec3 a, Vec3 b, Vec3 c, const LongRay& ray, std::vector<Long>& found) {
    const LVec3 e1 = LVec3{b} - LVec3{a};
    const LVec3 e2 = LVec3{c} - LVec3{a};
    const LVec3 p = glm::cross(ray.dir, e2);
    const Long determinant = glm::dot(e1, p);
    if (determinant == 0) return;
    const LVec3 s = ray.origin - LVec3{a};
    const Long u = glm::dot(s, p) / determinant;
    const LVec3 q = glm::cross(s, e1);
    const Long v = glm::dot(ray.dir, q) / determinant;
    if (u < 0 || v < 0 || u + v > 1) return;
    found.push_back(glm::dot(e2, q) / determinant);
}

/// Roots of a t^2 + b t + c.
std::vector<Long> roots(Long a, Long b, Long c) {
    if (a == 0) return b == 0 ? std::vector<Long>{} : std::vector<Long>{-c / b};
    const Long discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return {};
    const Long root = std::sqrt(discriminant);
    return {(-b - root) / (2 * a), (-b + root) / (2 * a)};
}

std::vector<Long> meet_ball(const LongRay& ray, Long radius) {
    return roots(glm::dot(ray.dir, ray.dir), 2 * glm::dot(ray.origin, ray.dir),
                 glm::dot(ray.origin, ray.origin) - radius * radius);
}

void meet_cylinder(const scene::Cylinder& cylinder, const LongRay& world_ray,
                   std::vector<Long>& found) {
    const LongRay ray = object_ray(cylinder.frame, world_ray);
    const Long top = static_cast<Long>(cylinder.top_radius);
    const LVec3 o = ray.origin;
    const LVec3 d = ray.dir;
    // The radius at height y is 1 + (top - 1) y.
    const Long r0 = 1 + (top - 1) * o.y;
    const Long r1 = (top - 1) * d.y;
    for (const Long t :
         roots(d.x * d.x + d.z * d.z - r1 * r1, 2 * (o.x * d.x + o.z * d.z - r0 * r1),
               o.x * o.x + o.z * o.z - r0 * r0)) {
        const Long y = ray.at(t).y;
        if (y >= 0 && y <= 1) found.push_back(t);
    }
    if (!cylinder.caps || d.y == 0) return;
    for (const auto& [y, radius] : {std::pair<Long, Long>{0, 1}, std::pair<Long, Long>{1, top}}) {
        const Long t = (y - o.y) / d.y;
        const LVec3 p = ray.at(t);
        if (p.x * p.x + p.z * p.z <= radius * radius) found.push_back(t);
    }
}

void meet_box(const scene::Box& box, const LongRay& world_ray, std::vector<Long>& found) {
    const LongRay ray = object_ray(box.frame, world_ray);
    for (int axis = 0; axis < 3; ++axis) {
        for (const Long side : {Long{-1}, Long{1}}) {
            if (ray.dir[axis] == 0) continue;
            const Long t = (side - ray.origin[axis]) / ray.dir[axis];
            const LVec3 p = ray.at(t);
            const bool is_inside =
                std::fabs(p[(axis + 1) % 3]) <= 1 && std::fabs(p[(axis + 2) % 3]) <= 1;
            if (is_inside) found.push_back(t);
        }
    }
}

void meet_disk(const scene::Disk& disk, const LongRay& world_ray, std::vector<Long>& found) {
    const LongRay ray = object_ray(disk.frame, world_ray);
    if (ray.dir.y == 0) return;
    const Long t = -ray.origin.y / ray.dir.y;
    const LVec3 p = ray.at(t);
    const Long radius = std::hypot(p.x, p.z);
    if (radius <= 1 && radius >= static_cast<Long>(disk.hole)) found.push_back(t);
}

Long value_of(const std::vector<Long>& polynomial, Long s) {
    Long value = 0;
    for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) value = value * s + *c;
    return value;
}

/// Returns the places in [lo, hi] at which the polynomial (constant term first) changes its sign,
/// by halving between those of its derivative.
std::vector<Long> sign_changes(const std::vector<Long>& polynomial, Long lo, Long hi) {
    if (polynomial.size() < 2) return {};
    std::vector<Long> derivative;
    for (std::size_t i = 1; i < polynomial.size(); ++i) {
        derivative.push_back(static_cast<Long>(i) * polynomial[i]);
    }
    std::vector<Long> ends = sign_changes(derivative, lo, hi);
    ends.insert(ends.begin(), lo);
    ends.push_back(hi);
    std::vector<Long> found;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        Long a = ends[i];
        Long b = ends[i + 1];
        const bool is_negative = value_of(polynomial, a) < 0;
        if (is_negative == (value_of(polynomial, b) < 0)) continue;
        for (int step = 0; step < 80; ++step) {
            const Long middle = (a + b) / 2;
            ((value_of(polynomial, middle) < 0) == is_negative ? a : b) = middle;
        }
        found.push_back((a + b) / 2);
    }
    return found;
}

/// By the quartic (|p|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + z^2), around the point nearest the centre.
/// Its roots with a negative left side under the square are on the inner surface of a tube that
/// overlaps itself.
void meet_torus(const scene::Torus& torus, const LongRay& world_ray, std::vector<Long>& found) {
    const LongRay ray = object_ray(torus.frame, world_ray);
    const Long tube = static_cast<Long>(torus.tube);
    const Long radius = 1 - tube;
    const Long length = glm::length(ray.dir);
    if (!(length > 0)) return;
    const LVec3 d = ray.dir / length;
    Long shift = -glm::dot(ray.origin, d);
    LVec3 o = ray.origin + shift * d;
    const Long rest = -glm::dot(o, d);
    shift += rest;
    o += rest * d;
    // |p|^2 + R^2 - r^2 = a s^2 + b s + c and x^2 + z^2 = e s^2 + f s + g
    const Long a = glm::dot(d, d);
    const Long b = 2 * glm::dot(o, d);
    const Long c = glm::dot(o, o) + radius * radius - tube * tube;
    const Long e = d.x * d.x + d.z * d.z;
    const Long f = 2 * (o.x * d.x + o.z * d.z);
    const Long g = o.x * o.x + o.z * o.z;
    if (e < 1e-20L &&
        g < 1e-20L) {  // along the axis: outer and inner surface meet, no sign changes
        if (c > 0) return;
        for (const Long s : roots(a, b, c)) found.push_back((s + shift) / length);
        return;
    }
    const Long k = 4 * radius * radius;
    const std::vector<Long> quartic{c * c - k * g, 2 * b * c - k * f, 2 * a * c + b * b - k * e,
                                    2 * a * b, a * a};
    for (const Long s : sign_changes(quartic, -1.5L, 1.5L)) {
        if (a * s * s + b * s + c >= 0) found.push_back((s + shift) / length);
    }
}

}  // namespace

std::vector<Long> reference_crossings(const scene::World& world, PrimitiveId id, const Ray& r) {
    const LongRay ray{LVec3{r.origin}, LVec3{r.dir}};
    std::vector<Long> found;
    const std::size_t i = id.index();
    switch (id.kind()) {
        case PrimitiveKind::triangle: {
            const auto& [a, b, c] = world.triangles[i].vertices;
            meet_triangle(world.vertices[a], world.vertices[b], world.vertices[c], ray, found);
            break;
        }
        case PrimitiveKind::rectangle: {
            const auto& c = world.rectangles[i].corners;
            meet_triangle(c[0], c[1], c[2], ray, found);
            meet_triangle(c[0], c[2], c[3], ray, found);
            break;
        }
        case PrimitiveKind::sphere: {
            const scene::Sphere& sphere = world.spheres[i];
            found = meet_ball({ray.origin - LVec3{sphere.center}, ray.dir},
                              static_cast<Long>(sphere.radius));
            break;
        }
        case PrimitiveKind::ellipsoid:
            found = meet_ball(object_ray(world.ellipsoids[i].frame, ray), 1);
            break;
        case PrimitiveKind::cylinder:
            meet_cylinder(world.cylinders[i], ray, found);
            break;
        case PrimitiveKind::disk:
            meet_disk(world.disks[i], ray, found);
            break;
        case PrimitiveKind::box:
            meet_box(world.boxes[i], ray, found);
            break;
        case PrimitiveKind::plane: {
            const LVec3 normal{world.planes[i].normal};
            const Long slope = glm::dot(normal, ray.dir);
            if (slope != 0) {
                found.push_back(glm::dot(normal, LVec3{world.planes[i].point} - ray.origin) /
                                slope);
            }
            break;
        }
        case PrimitiveKind::torus:
            meet_torus(world.tori[i], ray, found);
            break;
        case PrimitiveKind::instance:
            break;
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<PrimitiveId> all_ids(const scene::World& world) {
    std::vector<PrimitiveId> result;
    for (std::size_t kind = 0; kind < scene::kPrimitiveKindCount; ++kind) {
        for (std::size_t i = 0; i < world.object_ids[kind].size(); ++i) {
            result.push_back({static_cast<PrimitiveKind>(kind), i});
        }
    }
    return result;
}

std::optional<ReferenceHit> reference_nearest(const scene::World& world, const Ray& ray,
                                              Interval interval) {
    std::optional<ReferenceHit> best;
    for (const PrimitiveId id : all_ids(world)) {
        for (const Long t : reference_crossings(world, id, ray)) {
            if (!(t > static_cast<Long>(interval.lo) && t < static_cast<Long>(interval.hi))) {
                continue;
            }
            if (!best || t < best->t) best = ReferenceHit{t, id};
        }
    }
    return best;
}

}  // namespace lray::bvh
