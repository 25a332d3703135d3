// What is known of the surface that a ray hit.
#pragma once

#include "bvh/hit.h"
#include "bvh/surface.h"
#include "bvh/surface_detail.h"
#include "shade/material_point.h"
#include "shade/transport/lit_world.h"
#include "shade/transport/transport_ray.h"

namespace lray::shade {

/// Space: world.
struct ShadingPoint {
    bvh::SurfacePoint surface{};
    Vec3 wo{};               // unit, back along the ray
    Vec3 normal{};           // for shading, unit, on the side of wo
    Vec3 tangent{};          // unit, along u where that has a direction; x of the shading frame
    Vec3 bitangent{};        // y of the shading frame
    bool is_outside = true;  // wo is on the outer side of the surface
    std::uint32_t material_id = 0;
    MaterialPoint material{};

    /// The geometric normal on the side of wo.
    Vec3 facing() const { return is_outside ? surface.normal : -surface.normal; }

    /// Into the shading frame. In double: highlights of large exponents show each lost bit.
    Vec3 local(const Vec3& direction) const {
        const DVec3 d{direction};
        return Vec3{DVec3{dot(d, DVec3{tangent}), dot(d, DVec3{bitangent}), dot(d, DVec3{normal})}};
    }
    Vec3 from_local(const Vec3& direction) const {
        return direction.x * tangent + direction.y * bitangent + direction.z * normal;
    }

    /// True if a direction is on the side of the eye: what comes from behind the surface does not
    /// light it, whatever the shading normal says.
    bool is_before(const Vec3& direction) const { return dot(facing(), direction) > 0.0f; }

    /// Returns a ray that leaves the surface.
    Ray leaving(const Vec3& direction) const {
        return {bvh::offset_origin(surface.position, surface.error, surface.normal, direction),
                direction};
    }
};

/// Returns what is to be known at a hit of a ray. Errors: asserts that there is one.
ShadingPoint shading_point(const LitWorld& lit, const TransportRay& ray, const bvh::Hit& hit);

}  // namespace lray::shade
