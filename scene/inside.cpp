#include "scene/inside.h"

#include <cmath>

#include "base/assert.h"

namespace lray::scene {

namespace {

/// Of the size. Far above the rounding of the inverse maps, and too little to be seen.
constexpr double kMargin = 1e-3;
constexpr double kInner = 1.0 - kMargin;

DVec3 to_object(const AffineFrame& frame, DVec3 point) {
    return DMat3{frame.object_from_world} * (point - DVec3{frame.origin});
}

double square(double x) {
    return x * x;
}

bool is_inside(const Cylinder& cylinder, DVec3 point) {
    if (!cylinder.caps) return false;
    const DVec3 q = to_object(cylinder.frame, point);
    if (!(q.y >= kMargin && q.y <= kInner)) return false;
    const double radius = 1.0 + (static_cast<double>(cylinder.top_radius) - 1.0) * q.y - kMargin;
    return radius > 0.0 && square(q.x) + square(q.z) <= square(radius);
}

bool is_inside(const Torus& torus, DVec3 point) {
    const DVec3 q = to_object(torus.frame, point);
    const double from_middle = std::sqrt(square(q.x) + square(q.z)) - torus.radius();
    return square(from_middle) + square(q.y) <= square(static_cast<double>(torus.tube) * kInner);
}

}  // namespace

bool is_inside(const Geometry& geometry, PrimitiveId id, DVec3 point) {
    switch (id.kind()) {
        case PrimitiveKind::sphere: {
            const Sphere& sphere = geometry.spheres[id.index()];
            const DVec3 offset = point - DVec3{sphere.center};
            return dot(offset, offset) <= square(static_cast<double>(sphere.radius) * kInner);
        }
        case PrimitiveKind::ellipsoid: {
            const DVec3 q = to_object(geometry.ellipsoids[id.index()].frame, point);
            return dot(q, q) <= square(kInner);
        }
        case PrimitiveKind::cylinder:
            return is_inside(geometry.cylinders[id.index()], point);
        case PrimitiveKind::box: {
            const DVec3 q = to_object(geometry.boxes[id.index()].frame, point);
            return std::fabs(q.x) <= kInner && std::fabs(q.y) <= kInner && std::fabs(q.z) <= kInner;
        }
        case PrimitiveKind::torus:
            return is_inside(geometry.tori[id.index()], point);
        case PrimitiveKind::triangle:
        case PrimitiveKind::rectangle:
        case PrimitiveKind::disk:
        case PrimitiveKind::plane:
        case PrimitiveKind::instance:
            return false;
    }
    LRAY_ASSERT(false);
}

}  // namespace lray::scene
