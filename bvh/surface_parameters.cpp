#include "bvh/surface_parameters.h"

#include <array>
#include <cmath>
#include <numbers>

#include "base/assert.h"
#include "base/portable_math.h"
#include "bvh/kernels/cylinder.h"
#include "bvh/kernels/object_ray.h"

namespace lray::bvh {

namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;

/// Returns the angle around +Y in turns: 0 at -Z, then by -X, +Z and +X, which is to the right for
/// who looks from outside with Y up. A picture has its middle in front, at +Z.
double turns_around_y(DVec3 q) {
    return turns_of({-q.z, -q.x});
}

/// How a point that turns around +Y moves, in one turn.
DVec3 along_turn(DVec3 q) {
    return {kFullTurn * q.z, 0.0, -kFullTurn * q.x};
}

double axis_distance(DVec3 q) {
    return std::sqrt(q.x * q.x + q.z * q.z);
}

/// Parameters in the object space of a frame, brought out of it.
SurfaceParameters placed(const SurfaceParameters& object, const scene::AffineFrame& frame) {
    const DMat3 world_from_object = glm::inverse(DMat3{frame.object_from_world});
    return {object.uv, world_from_object * object.dp_du, world_from_object * object.dp_dv};
}

/// The square [-1, 1]^2 around the circle of that radius is 0 to 1, u along x and v against z; of a
/// side that faces down, v along z.
SurfaceParameters on_disk(DVec3 q, double radius, bool faces_down) {
    const double side = faces_down ? 1.0 : -1.0;
    return {{0.5 + 0.5 * q.x / radius, 0.5 + side * 0.5 * q.z / radius},
            {2.0 * radius, 0.0, 0.0},
            {0.0, 0.0, side * 2.0 * radius}};
}

/// The unit sphere: v is the angle from the south pole, in half turns.
SurfaceParameters on_unit_sphere(DVec3 q) {
    const double rho = axis_distance(q);
    SurfaceParameters result;
    const double latitude = turns_of({rho, std::fabs(q.y)});
    result.uv = {turns_around_y(q), 0.5 + 2.0 * std::copysign(latitude, q.y)};
    if (rho == 0.0) return result;
    result.dp_du = along_turn(q);
    result.dp_dv = std::numbers::pi * DVec3{-q.y * q.x / rho, rho, -q.y * q.z / rho};
    return result;
}

SurfaceParameters on_sphere(const scene::Sphere& sphere, const scene::ObjectSpace* space,
                            DVec3 position) {
    const double radius = static_cast<double>(sphere.radius);
    const DVec3 about = position - DVec3{sphere.center};
    const DMat3 turn = space ? space->linear : DMat3{1.0};  // and a factor: it is a similarity
    const DVec3 turned = turn * about;
    const double length = std::sqrt(dot(turned, turned));
    const double factor = length / std::sqrt(dot(about, about));
    SurfaceParameters result = on_unit_sphere(turned / length);
    // The inverse of a rotation is its transpose.
    result.dp_du = (result.dp_du * turn) * (radius / factor);
    result.dp_dv = (result.dp_dv * turn) * (radius / factor);
    return result;
}

/// v runs from the end that the shape begins with, at y = 0 of a frame that is turned back.
SurfaceParameters on_cylinder(const scene::Cylinder& cylinder, const Hit& hit, DVec3 position) {
    const DVec3 canonical = point_object(cylinder.frame, position);
    const bool is_turned = cylinder.is_turned;
    const DVec3 back = is_turned ? DVec3{1.0, -1.0, -1.0} : DVec3{1.0};  // half a turn about x
    DVec3 q = canonical * back;
    if (is_turned) q.y += 1.0;
    SurfaceParameters result;
    const double top_radius = static_cast<double>(cylinder.top_radius);
    const int part = static_cast<int>(hit.u);
    if (part == kCylinderSide) {
        const double rho = axis_distance(q);
        result.uv = {turns_around_y(q), q.y};
        if (rho > 0.0) {
            const double widening = is_turned ? 1.0 - top_radius : top_radius - 1.0;
            result.dp_du = along_turn(q);
            result.dp_dv = {widening * q.x / rho, 1.0, widening * q.z / rho};
        }
    } else {
        const bool is_narrow_end = part == kCylinderTop;
        result = on_disk(q, is_narrow_end ? top_radius : 1.0, is_narrow_end == is_turned);
    }
    result.dp_du *= back;
    result.dp_dv *= back;
    return placed(result, cylinder.frame);
}

/// Each face is 0 to 1, upright for who looks at it from outside; the upper and lower one for who
/// bows from the front (+Z).
SurfaceParameters on_box(const scene::Box& box, const Hit& hit, DVec3 position) {
    struct Face {
        DVec3 u{};
        DVec3 v{};
    };
    // By the number of the face: -X, +X, -Y, +Y, -Z, +Z.
    static constexpr std::array<Face, 6> kFaces{{
        {{0, 0, 1}, {0, 1, 0}},
        {{0, 0, -1}, {0, 1, 0}},
        {{1, 0, 0}, {0, 0, 1}},
        {{1, 0, 0}, {0, 0, -1}},
        {{-1, 0, 0}, {0, 1, 0}},
        {{1, 0, 0}, {0, 1, 0}},
    }};
    const Face& face = kFaces[static_cast<std::size_t>(hit.u)];
    const DVec3 q = point_object(box.frame, position);
    return placed(
        {{0.5 + 0.5 * dot(q, face.u), 0.5 + 0.5 * dot(q, face.v)}, 2.0 * face.u, 2.0 * face.v},
        box.frame);
}

SurfaceParameters on_plane(const scene::Plane& plane, DVec3 position) {
    const DVec3 about = position - DVec3{plane.point};
    const DVec3 gradient_u{plane.gradient_u};
    const DVec3 gradient_v{plane.gradient_v};
    const DVec3 normal{plane.normal};
    SurfaceParameters result{{dot(gradient_u, about), dot(gradient_v, about)}, {}, {}};
    // Along u v does not change, and the other way round.
    const DVec3 along_u = cross(gradient_v, normal);
    const DVec3 along_v = cross(normal, gradient_u);
    const double volume = dot(gradient_u, along_u);
    if (volume == 0.0) return result;
    result.dp_du = along_u / volume;
    result.dp_dv = along_v / volume;
    return result;
}

/// v is the angle around the tube: 0 inside, 1/4 at the bottom, 1/2 outside, 3/4 on top.
SurfaceParameters on_torus(const scene::Torus& torus, DVec3 position) {
    const DVec3 q = point_object(torus.frame, position);
    const double rho = axis_distance(q);
    const double over = rho - torus.radius();
    SurfaceParameters result{{turns_around_y(q), turns_of({-over, -q.y})}, {}, {}};
    if (rho == 0.0) return result;
    result.dp_du = along_turn(q);
    result.dp_dv = kFullTurn * DVec3{-q.y * q.x / rho, over, -q.y * q.z / rho};
    return placed(result, torus.frame);
}

SurfaceParameters on_rectangle(const scene::Rectangle& rectangle, const Hit& hit) {
    const auto& corners = rectangle.corners;
    return {{hit.u, hit.v},
            DVec3{corners[1]} - DVec3{corners[0]},
            DVec3{corners[3]} - DVec3{corners[0]}};
}

bool is_finite(DVec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Without texture coordinates u and v are the shares of b and c.
SurfaceParameters on_triangle(const scene::Geometry& geometry, const scene::ObjectSpace* space,
                              const Hit& hit) {
    const std::size_t index = hit.primitive_id.index();
    const auto& [a, b, c] = geometry.triangles[index].vertices;
    const DVec3 origin{geometry.vertices[a]};
    const DVec3 edge_b = DVec3{geometry.vertices[b]} - origin;
    const DVec3 edge_c = DVec3{geometry.vertices[c]} - origin;
    const DVec2 shares{hit.u, hit.v};
    const scene::IndexTriple* const triple =
        geometry.triangle_uvs.empty() ? nullptr : &geometry.triangle_uvs[index];
    if (triple == nullptr || (*triple)[0] == scene::Mesh::kNone) {
        // Of a mirrored triangle b and c are exchanged.
        const bool is_mirrored = space != nullptr && glm::determinant(space->linear) < 0.0;
        if (is_mirrored) return {{shares.y, shares.x}, edge_c, edge_b};
        return {shares, edge_b, edge_c};
    }
    const DVec2 uv_a{geometry.uvs[(*triple)[0]]};
    const DVec2 uv_b = DVec2{geometry.uvs[(*triple)[1]]} - uv_a;
    const DVec2 uv_c = DVec2{geometry.uvs[(*triple)[2]]} - uv_a;
    SurfaceParameters result{uv_a + shares.x * uv_b + shares.y * uv_c, {}, {}};
    const double area = uv_b.x * uv_c.y - uv_b.y * uv_c.x;
    const DVec3 dp_du = (uv_c.y * edge_b - uv_b.y * edge_c) / area;
    const DVec3 dp_dv = (uv_b.x * edge_c - uv_c.x * edge_b) / area;
    if (is_finite(dp_du) && is_finite(dp_dv)) {  // else u and v do not span the triangle
        result.dp_du = dp_du;
        result.dp_dv = dp_dv;
    }
    return result;
}

}  // namespace

SurfaceParameters surface_parameters(const scene::Geometry& geometry, const Hit& hit,
                                     DVec3 position) {
    using enum scene::PrimitiveKind;
    const std::size_t index = hit.primitive_id.index();
    const auto find_space = [&] {
        return geometry.object_spaces.find(geometry.object_of(hit.primitive_id));
    };
    switch (hit.primitive_id.kind()) {
        case triangle:
            return on_triangle(geometry, find_space(), hit);
        case rectangle:
            return on_rectangle(geometry.rectangles[index], hit);
        case sphere:
            return on_sphere(geometry.spheres[index], find_space(), position);
        case ellipsoid: {
            const scene::AffineFrame& frame = geometry.ellipsoids[index].frame;
            return placed(on_unit_sphere(point_object(frame, position)), frame);
        }
        case cylinder:
            return on_cylinder(geometry.cylinders[index], hit, position);
        case disk: {
            const scene::AffineFrame& frame = geometry.disks[index].frame;
            return placed(on_disk(point_object(frame, position), 1.0, false), frame);
        }
        case box:
            return on_box(geometry.boxes[index], hit, position);
        case plane:
            return on_plane(geometry.planes[index], position);
        case torus:
            return on_torus(geometry.tori[index], position);
        case instance:
            break;
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::bvh
