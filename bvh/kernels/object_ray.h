// Rays in the object space of the kinds that carry an affine frame.
#pragma once

#include "bvh/prepared_ray.h"
#include "scene/world.h"

namespace lray::bvh {

/// The direction keeps the length the frame gives it, so t stays the world's.
struct ObjectRay {
    DVec3 origin{};
    DVec3 dir{};
};

/// Space: `p` in the world, the result in object space. The difference of two floats is exact in
/// double unless their exponents differ by more than 29.
inline DVec3 point_object(const scene::AffineFrame& frame, DVec3 p) {
    return DMat3{frame.object_from_world} * (p - DVec3{frame.origin});
}

inline ObjectRay object_ray(const scene::AffineFrame& frame, const PreparedRay& ray) {
    const DMat3 object_from_world{frame.object_from_world};
    return {object_from_world * (ray.origin - DVec3{frame.origin}), object_from_world * ray.dir};
}

}  // namespace lray::bvh
