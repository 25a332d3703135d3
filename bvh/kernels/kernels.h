// All kernels behind one name, for loops over primitives of one kind. intersect.h has the dispatch
// for a primitive of any kind.
#pragma once

#include "bvh/kernels/box.h"
#include "bvh/kernels/cylinder.h"
#include "bvh/kernels/disk.h"
#include "bvh/kernels/ellipsoid.h"
#include "bvh/kernels/plane.h"
#include "bvh/kernels/rectangle.h"
#include "bvh/kernels/sphere.h"
#include "bvh/kernels/torus.h"
#include "bvh/kernels/triangle.h"

namespace lray::bvh {

/// Returns the nearest hit of primitive `index` of the kind in the open interval.
template <scene::PrimitiveKind kind>
KernelHit intersect_kind(const scene::Geometry& geometry, std::size_t index, const PreparedRay& ray,
                         Interval interval) {
    using enum scene::PrimitiveKind;
    if constexpr (kind == triangle) {
        const auto& [a, b, c] = geometry.triangles[index].vertices;
        return intersect_triangle(geometry.vertices[a], geometry.vertices[b], geometry.vertices[c],
                                  ray, interval);
    } else if constexpr (kind == rectangle) {
        return intersect_rectangle(geometry.rectangles[index], ray, interval);
    } else if constexpr (kind == sphere) {
        return first_in(crossings(geometry.spheres[index], ray), interval);
    } else if constexpr (kind == ellipsoid) {
        return first_in(crossings(geometry.ellipsoids[index], ray), interval);
    } else if constexpr (kind == cylinder) {
        return first_in(crossings(geometry.cylinders[index], ray), interval);
    } else if constexpr (kind == disk) {
        return first_in(crossings(geometry.disks[index], ray), interval);
    } else if constexpr (kind == box) {
        return first_in(crossings(geometry.boxes[index], ray), interval);
    } else if constexpr (kind == plane) {
        return first_in(crossings(geometry.planes[index], ray), interval);
    } else {
        static_assert(kind == torus);  // an instance has no surface of its own
        return intersect_torus(geometry.tori[index], ray, interval);
    }
}

}  // namespace lray::bvh
