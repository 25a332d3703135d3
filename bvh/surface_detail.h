// What textures and smooth shading need of the surface at a hit, beside its position.
#pragma once

#include "base/vec.h"
#include "bvh/hit.h"
#include "bvh/surface.h"
#include "scene/world.h"

namespace lray::bvh {

/// Space: world, but for what is `_object`: that of the shape before its own steps, where the
/// geometry keeps it (scene::ObjectSpaceRule), else that of the geometry.
struct SurfaceDetail {
    /// Unit, on the side of the normal: interpolated between the normals of a mesh's or triangle's
    /// corners where it has them, else the normal.
    Vec3 shading_normal{};
    DVec2 uv{0.0};
    /// How the position changes with u and with v, in the tangent plane of `shading_normal`, at
    /// right angles to it; 0 where uv does not change or has no direction (at a pole).
    Vec3 dp_du{0.0f};
    Vec3 dp_dv{0.0f};
    DVec3 position_object{0.0};
    DMat3 object_from_world{1.0};   // of vectors
    DVec3 vertex_color{1.0};        // of a mesh that has colours and shows them, linear
    double object_per_world = 1.0;  // length there of a unit of length in the world, on average
};

/// Returns the detail at a hit whose surface point is known.
SurfaceDetail surface_detail(const scene::World& world, const Hit& hit, const SurfacePoint& point);

/// Likewise, the shading normal alone.
Vec3 shading_normal(const scene::World& world, const Hit& hit, const SurfacePoint& point);

}  // namespace lray::bvh
