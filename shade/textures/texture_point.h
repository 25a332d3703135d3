// Where on a surface textures are looked up.
#pragma once

#include "base/vec.h"

namespace lray::shade {

/// The place in each of the spaces a texture may live in, and how far across one pixel of the
/// picture reaches there (0: a point), in units of that space: what is finer is averaged.
struct TexturePoint {
    DVec2 uv{0.0};      // (0, 0) bottom left
    DVec3 object{0.0};  // in the space of the shape, before its own steps
    DVec3 world{0.0};
    double uv_width = 0.0;
    double object_width = 0.0;
    double world_width = 0.0;

    // The plane of the surface, as its unit normal: a pixel reaches along it, not through it. 0:
    // unknown; then only what is finer than the width is averaged, and edges stay sharp.
    DVec3 object_normal{0.0};
    DVec3 world_normal{0.0};

    DVec3 vertex_color{1.0};  // of the mesh there
};

}  // namespace lray::shade
