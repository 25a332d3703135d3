// What a picture shows of what its rays hit: the choice among the shaders, each in its own file.
#pragma once

#include <cstdint>

#include "base/ray.h"
#include "base/vec.h"
#include "bvh/accel.h"
#include "bvh/hit.h"
#include "scene/world.h"
#include "shade/depth.h"

namespace lray::shade {

enum class Shader : std::uint8_t { flat, normals, depth, cost };

/// What shaders know beside the ray and its hit.
struct ShadeInput {
    const scene::World& world;
    Shader shader = Shader::flat;
    Color background{0.0f};  // of flat; the others show black where nothing was hit
    double depth_unit = 1.0;
};

/// Returns the colour of one ray. `counts` are those of that ray alone, which only `cost` looks at.
Color shade(const ShadeInput& input, const Ray& ray, const bvh::Hit& hit,
            const bvh::TraceCounts& counts);

}  // namespace lray::shade
