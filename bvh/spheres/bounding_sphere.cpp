#include "bvh/spheres/bounding_sphere.h"

namespace lray::bvh {

BoundingSphere sphere_around(const Bounds& box) {
    const DVec3 low{box.min};
    const DVec3 high{box.max};
    BoundingSphere sphere;
    sphere.center = Vec3{0.5 * (low + high)};
    // From the rounded centre to the farthest corner.
    const DVec3 center{sphere.center};
    const DVec3 reach = glm::max(high - center, center - low);
    sphere.radius = round_up(std::sqrt(dot(reach, reach)) * (1.0 + gamma<double>(4)));
    return sphere;
}

BoundingSphere bounding_sphere(const scene::Geometry& geometry, scene::PrimitiveId id) {
    if (id.kind() == scene::PrimitiveKind::sphere) {
        const scene::Sphere& sphere = geometry.spheres[id.index()];
        return {sphere.center, sphere.radius};
    }
    return sphere_around(primitive_bounds(geometry, id));
}

Bounds box_around(const BoundingSphere& sphere) {
    const DVec3 center{sphere.center};
    const DVec3 reach{static_cast<double>(sphere.radius)};
    Bounds box;
    box.add(center - reach);
    box.add(center + reach);
    return box;
}

}  // namespace lray::bvh
