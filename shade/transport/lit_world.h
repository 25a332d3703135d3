// A world and its hierarchy with all that following light through it needs.
#pragma once

#include "bvh/accel.h"
#include "scene/world.h"
#include "shade/lights/light_table.h"
#include "shade/material_table.h"
#include "shade/textures/texture_set.h"

namespace lray::shade {

/// Made once for any number of pictures. Const calls are thread-safe. The world and the hierarchy
/// must outlive it.
struct LitWorld {
    LitWorld(const scene::World& lit_world, const bvh::Accel& hierarchy)
        : world(lit_world),
          accel(hierarchy),
          textures(lit_world),
          materials(lit_world, textures),
          lights(lit_world, textures) {}
    LitWorld(const LitWorld&) = delete;  // its parts refer to one another
    LitWorld& operator=(const LitWorld&) = delete;

    const scene::World& world;
    const bvh::Accel& accel;
    TextureSet textures;
    MaterialTable materials;
    LightTable lights;
};

}  // namespace lray::shade
