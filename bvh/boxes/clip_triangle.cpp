#include "bvh/boxes/clip_triangle.h"

#include <algorithm>
#include <array>

#include "base/bounds.h"

namespace lray::bvh {

namespace {

/// The pad in parts of the coordinates: sixteen times the roundoff of float.
constexpr double kPlacePad = 0x1p-20;
/// And of the triangle's own extent, for triangles seen at a slant: down to a thousandth of a
/// degree for those that fill the world.
constexpr double kExtentPad = 0x1p-14;

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
    const DVec3 least = glm::min(glm::min(corners[0], corners[1]), corners[2]);
    const DVec3 most = glm::max(glm::max(corners[0], corners[1]), corners[2]);
    const DVec3 pad =
        kPlacePad * glm::max(glm::abs(least), glm::abs(most)) + kExtentPad * (most - least);
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
