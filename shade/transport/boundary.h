// What mirrors and clear surfaces do with a ray: which way it goes on, and how much of it.
#pragma once

#include <optional>

#include "shade/transport/lit_world.h"
#include "shade/transport/shading_point.h"
#include "shade/transport/transport_ray.h"

namespace lray::shade {

/// Mirror part and refracted part of a surface; a part of no weight has no direction.
struct Boundary {
    Color mirror_weight{0.0f};   // reflect + F transmit
    Color through_weight{0.0f};  // (1 - F) transmit; 0 beyond the critical angle, where F is 1
    Vec3 mirror_direction{};
    Vec3 through_direction{};
    Media media_through{};  // what is around the ray that went through
};

/// Returns how the surface splits the ray. F is Fresnel's for the indices of refraction on both
/// sides: of what the ray is in, and of what it gets into.
Boundary boundary_at(const LitWorld& lit, const TransportRay& ray, const ShadingPoint& point);

/// Returns the media around a point, found by following a ray from it out of everything. Where the
/// counts say that it has ended, they mean nothing.
Media media_at(const LitWorld& lit, Vec3 position, bvh::TraceCounts& counts);

}  // namespace lray::shade
