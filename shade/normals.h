// The directions of surfaces as colours.
#pragma once

#include "base/ray.h"
#include "base/vec.h"
#include "bvh/hit.h"
#include "scene/world.h"

namespace lray::shade {

/// Returns (n + 1) / 2 of the outward unit normal n in world space: what faces right is reddish,
/// what faces up greenish, what faces the viewer bluish. Black if nothing was hit.
Color normals(const scene::World& world, const Ray& ray, const bvh::Hit& hit);

}  // namespace lray::shade
