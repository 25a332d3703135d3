#include "scene/world.h"

#include <cmath>

#include "base/assert.h"

namespace lray::scene {

namespace {

/// The inverse of a frame's map, in double. The true inverse differs from it in row i by at most
/// `error` times the sum of the row's absolute entries, in any direction.
struct WorldFromObject {
    DVec3 origin{};
    DMat3 linear{1.0};
    double error = 0.0;
};

DVec3 absolute(DVec3 v) {
    return {std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)};
}

/// Inverts, and bounds the error of the result by its own residual: with M W = I + R the true
/// inverse is W (I + R)^-1, which differs from W by at most |W| rho / (1 - rho), rho = |R|.
/// Source: Higham 2002, "Accuracy and Stability of Numerical Algorithms", sec. 14.1.
WorldFromObject invert(const AffineFrame& frame) {
    const DMat3 map{frame.object_from_world};
    WorldFromObject result;
    result.origin = DVec3{frame.origin};
    result.linear = glm::inverse(map);
    const DMat3 product = map * result.linear;
    double residual = 0.0;
    for (int row = 0; row < 3; ++row) {
        double sum = 0.0;
        for (int column = 0; column < 3; ++column) {
            double terms = 0.0;  // of the product, for its own rounding
            for (int k = 0; k < 3; ++k) {
                terms += std::fabs(map[k][row] * result.linear[column][k]);
            }
            sum += std::fabs(product[column][row] - (row == column ? 1.0 : 0.0)) +
                   gamma<double>(4) * terms;
        }
        residual = sum > residual ? sum : residual;
    }
    LRAY_ASSERT(residual < 0.5);  // flatten() refuses frames that cannot be inverted
    result.error = 2.0 * residual;
    return result;
}

/// Adds the box around `center` (object space) that reaches `extent` from it in each world axis.
/// The extent is widened by the error of the inverse and of the sums that made the box.
void add_around(Bounds& bounds, const WorldFromObject& frame, DVec3 center_object, DVec3 extent) {
    const DVec3 offset = frame.linear * center_object;
    const DVec3 row_sums =
        absolute(frame.linear[0]) + absolute(frame.linear[1]) + absolute(frame.linear[2]);
    // 2: points of the canonical shapes lie within [-1, 1]^3 around centres within the same.
    const DVec3 slack = 2.0 * (frame.error + gamma<double>(16)) * row_sums +
                        gamma<double>(4) * absolute(frame.origin);
    bounds.add(frame.origin + offset - (extent + slack));
    bounds.add(frame.origin + offset + (extent + slack));
}

/// Half the size of the world box around a unit circle of the object's x and z axes.
DVec3 circle_extent(const WorldFromObject& frame) {
    const DVec3 a = frame.linear[0];
    const DVec3 b = frame.linear[2];
    return {std::sqrt(a.x * a.x + b.x * b.x), std::sqrt(a.y * a.y + b.y * b.y),
            std::sqrt(a.z * a.z + b.z * b.z)};
}

Bounds bounds_of(const Geometry& geometry, const Triangle& triangle) {
    Bounds result;
    for (const std::uint32_t vertex : triangle.vertices) result.add(geometry.vertices[vertex]);
    return result;
}

Bounds bounds_of(const Rectangle& rectangle) {
    Bounds result;
    for (const Vec3 corner : rectangle.corners) result.add(corner);
    return result;
}

Bounds bounds_of(const Sphere& sphere) {
    const DVec3 center{sphere.center};
    // The sum of two floats may be inexact in double by one rounding.
    const DVec3 reach = DVec3{static_cast<double>(sphere.radius)} * (1.0 + gamma<double>(2)) +
                        gamma<double>(1) * absolute(center);
    Bounds result;
    result.add(center - reach);
    result.add(center + reach);
    return result;
}

/// Of the ellipsoid q -> W q, |q| = 1, the reach along an axis is the length of that row of W.
Bounds bounds_of(const Ellipsoid& ellipsoid) {
    const WorldFromObject frame = invert(ellipsoid.frame);
    DVec3 extent{};
    for (int axis = 0; axis < 3; ++axis) {
        const DVec3 row{frame.linear[0][axis], frame.linear[1][axis], frame.linear[2][axis]};
        extent[axis] = std::sqrt(dot(row, row));
    }
    Bounds result;
    add_around(result, frame, DVec3{0.0}, extent);
    return result;
}

/// A truncated cone is the convex hull of its rims.
Bounds bounds_of(const Cylinder& cylinder) {
    const WorldFromObject frame = invert(cylinder.frame);
    const DVec3 rim = circle_extent(frame);
    Bounds result;
    add_around(result, frame, DVec3{0.0}, rim);
    add_around(result, frame, DVec3{0.0, 1.0, 0.0}, static_cast<double>(cylinder.top_radius) * rim);
    return result;
}

Bounds bounds_of(const Disk& disk) {
    const WorldFromObject frame = invert(disk.frame);
    Bounds result;
    add_around(result, frame, DVec3{0.0}, circle_extent(frame));
    return result;
}

Bounds bounds_of(const Box& box) {
    const WorldFromObject frame = invert(box.frame);
    const DVec3 extent =
        absolute(frame.linear[0]) + absolute(frame.linear[1]) + absolute(frame.linear[2]);
    Bounds result;
    add_around(result, frame, DVec3{0.0}, extent);
    return result;
}

/// The convex hull is that of balls along a circle: their reaches add up.
Bounds bounds_of(const Torus& torus) {
    const WorldFromObject frame = invert(torus.frame);
    const DVec3 circle = circle_extent(frame);
    DVec3 extent{};
    for (int axis = 0; axis < 3; ++axis) {
        const DVec3 row{frame.linear[0][axis], frame.linear[1][axis], frame.linear[2][axis]};
        extent[axis] = torus.radius() * circle[axis] +
                       static_cast<double>(torus.tube) * std::sqrt(dot(row, row));
    }
    Bounds result;
    add_around(result, frame, DVec3{0.0}, extent);
    return result;
}

}  // namespace

std::size_t Geometry::primitive_count() const {
    return triangles.size() + rectangles.size() + spheres.size() + ellipsoids.size() +
           cylinders.size() + disks.size() + boxes.size() + planes.size() + tori.size() +
           instances.size();
}

Bounds primitive_bounds(const Geometry& geometry, PrimitiveId id) {
    const std::size_t index = id.index();
    switch (id.kind()) {
        case PrimitiveKind::triangle:
            return bounds_of(geometry, geometry.triangles[index]);
        case PrimitiveKind::rectangle:
            return bounds_of(geometry.rectangles[index]);
        case PrimitiveKind::sphere:
            return bounds_of(geometry.spheres[index]);
        case PrimitiveKind::ellipsoid:
            return bounds_of(geometry.ellipsoids[index]);
        case PrimitiveKind::cylinder:
            return bounds_of(geometry.cylinders[index]);
        case PrimitiveKind::disk:
            return bounds_of(geometry.disks[index]);
        case PrimitiveKind::box:
            return bounds_of(geometry.boxes[index]);
        case PrimitiveKind::plane:
            break;
        case PrimitiveKind::torus:
            return bounds_of(geometry.tori[index]);
        case PrimitiveKind::instance:
            return geometry.instances[index].bounds;
    }
    LRAY_ASSERT(id.kind() != PrimitiveKind::plane);
    return {};
}

Bounds finite_bounds(const Geometry& geometry) {
    Bounds result;
    for (const Triangle& triangle : geometry.triangles) result.add(bounds_of(geometry, triangle));
    for (const Rectangle& rectangle : geometry.rectangles) result.add(bounds_of(rectangle));
    for (const Sphere& sphere : geometry.spheres) result.add(bounds_of(sphere));
    for (const Ellipsoid& ellipsoid : geometry.ellipsoids) result.add(bounds_of(ellipsoid));
    for (const Cylinder& cylinder : geometry.cylinders) result.add(bounds_of(cylinder));
    for (const Disk& disk : geometry.disks) result.add(bounds_of(disk));
    for (const Box& box : geometry.boxes) result.add(bounds_of(box));
    for (const Torus& torus : geometry.tori) result.add(bounds_of(torus));
    for (const WorldInstance& instance : geometry.instances) result.add(instance.bounds);
    return result;
}

Bounds placed_bounds(const Bounds& bounds_object, const AffineFrame& frame) {
    const DVec3 middle = 0.5 * (DVec3{bounds_object.min} + DVec3{bounds_object.max});
    const DVec3 half = DVec3{bounds_object.max} - middle;
    const WorldFromObject map = invert(frame);
    DVec3 extent{};
    for (int axis = 0; axis < 3; ++axis) {
        extent += absolute(map.linear[axis]) * half[axis];
    }
    // As add_around(), for coordinates that are not those of the canonical shapes.
    const DVec3 farthest = absolute(middle) + half;
    const double reach = std::fmax(farthest.x, std::fmax(farthest.y, farthest.z));
    const DVec3 row_sums =
        absolute(map.linear[0]) + absolute(map.linear[1]) + absolute(map.linear[2]);
    const DVec3 slack = 2.0 * reach * (map.error + gamma<double>(16)) * row_sums +
                        gamma<double>(4) * absolute(map.origin);
    const DVec3 center = map.origin + map.linear * middle;
    Bounds result;
    result.add(center - (extent + slack));
    result.add(center + (extent + slack));
    return result;
}

}  // namespace lray::scene
