// The surface parameters u and v of every kind of primitive, and its tangents along them.
#pragma once

#include "base/vec.h"
#include "bvh/hit.h"
#include "scene/world.h"

namespace lray::bvh {

/// Space: of the geometry that holds the primitive. The tangents tell how the position changes with
/// u and v; both are 0 where u and v have no direction.
struct SurfaceParameters {
    DVec2 uv{0.0};
    DVec3 dp_du{0.0};
    DVec3 dp_dv{0.0};
};

/// Returns the parameters at a hit, as grammar.md describes them for each shape. All of them belong
/// to the shape, whatever steps it was placed by; of a sphere, and of a triangle without texture
/// coordinates that was mirrored, only where the geometry keeps the object's space.
/// Space: `position` in the geometry that holds the primitive.
SurfaceParameters surface_parameters(const scene::Geometry& geometry, const Hit& hit,
                                     DVec3 position);

}  // namespace lray::bvh
