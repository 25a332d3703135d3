#include "bvh/boxes/clip_triangle.h"

#include <algorithm>
#include <array>

#include "base/bounds.h"
#include "bvh/kernels/triangle.h"

namespace lray::bvh {

namespace {

/// Adds where the edge from a to b passes a plane, if it does.
void add_crossing(Bounds& bounds, DVec3 a, DVec3 b, int axis, double plane) {
    const double from = a[axis] - plane;
    const double to = b[axis] - plane;
    if ((from < 0.0) == (to < 0.0)) return;
    DVec3 point = a + (b - a) * (from / (from - to));
    point[axis] = plane;
    bounds.add(point);
}

/// The bounds of what of a triangle is in [low, high] along an axis.
Bounds bounds_between(const std::array<DVec3, 3>& corners, int axis, double low, double high) {
    Bounds bounds;
    for (std::size_t i = 0; i < 3; ++i) {
        const DVec3 corner = corners[i];
        const DVec3 next = corners[(i + 1) % 3];
        if (corner[axis] >= low && corner[axis] <= high) bounds.add(corner);
        add_crossing(bounds, corner, next, axis, low);
        add_crossing(bounds, corner, next, axis, high);
    }
    return bounds;
}

}  // namespace

BuildRef part_of(const scene::Geometry& geometry, const BuildRef& ref, int axis, double low,
                 double high) {
    const RefCorners whole = corners_of(geometry, ref);
    const std::array<DVec3, 3> corners{DVec3{whole.a}, DVec3{whole.b}, DVec3{whole.c}};
    const DVec3 pad = part_pad(triangle_bounds(whole.a, whole.b, whole.c));
    const Bounds bounds = bounds_between(corners, axis, low - pad[axis], high + pad[axis]);
    BuildRef part = ref;
    for (int i = 0; i < 3; ++i) {
        const float lower = round_down(static_cast<double>(bounds.min[i]) - pad[i]);
        const float upper = round_up(static_cast<double>(bounds.max[i]) + pad[i]);
        part.min[i] = std::max(ref.min[i], lower) + 0.0f;
        part.max[i] = std::min(ref.max[i], upper) + 0.0f;
    }
    return part;
}

}  // namespace lray::bvh
