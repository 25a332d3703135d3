// What a picture shows of what its rays hit: the choice among the shaders, each in its own file.
#pragma once

#include "base/ray.h"
#include "base/vec.h"
#include "bvh/accel.h"
#include "bvh/hit.h"
#include "scene/world.h"
#include "shade/settings.h"

namespace lray::shade {

/// What shaders know beside the ray and its hit.
struct ShadeInput {
    const scene::World& world;
    Settings settings{};
};

/// Returns the colour of one ray, by any shader but `full`, for which rays are followed on
/// (transport/follow_light.h). `counts` are those of that ray alone, which only `cost` looks at.
Color shade(const ShadeInput& input, const Ray& ray, const bvh::Hit& hit,
            const bvh::TraceCounts& counts);

}  // namespace lray::shade
