// A material in one point: its coefficients after all textures were looked up.
#pragma once

#include "base/vec.h"
#include "scene/material.h"

namespace lray::shade {

/// What each one means: scene/material.h.
struct MaterialPoint {
    scene::ReflectionModel model = scene::ReflectionModel::blinn_phong;
    bool two_sided = true;
    float opacity = 1.0f;
    float shininess = 32.0f;
    float ior = 1.5f;
    Vec2 roughness{0.3f};
    Color ambient{0.0f};
    Color diffuse{0.0f};
    Color specular{0.0f};
    Color fresnel{0.0f};
    Color reflect{0.0f};
    Color transmit{0.0f};
    Color absorption{0.0f};
    Color emission{0.0f};
};

}  // namespace lray::shade
