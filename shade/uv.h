// The surface parameters u and v as colours.
#pragma once

#include "base/vec.h"
#include "bvh/hit.h"
#include "bvh/surface.h"
#include "scene/world.h"

namespace lray::shade {

/// Returns what of u and v is behind the point as red and green: a picture in place of it would
/// begin anew where a channel jumps. Black if nothing was hit. For spheres as they are turned the
/// world has to keep the spaces of all objects (scene::KeptSpaces::all).
Color uv(const scene::World& world, const Ray& ray, const bvh::Hit& hit);

}  // namespace lray::shade
