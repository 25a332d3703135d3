// Ray against sphere.
#pragma once

#include "bvh/kernels/quadratic.h"
#include "bvh/prepared_ray.h"
#include "scene/world.h"

namespace lray::bvh {

/// u and v of the hit are 0: directions on the sphere follow from the position.
inline Crossings crossings(const scene::Sphere& sphere, const PreparedRay& ray) {
    return ball_crossings(ray.origin - DVec3{sphere.center}, ray.dir,
                          static_cast<double>(sphere.radius));
}

}  // namespace lray::bvh
