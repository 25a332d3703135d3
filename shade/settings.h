// What shaders show, and how light is followed: the settings of a picture.
#pragma once

#include <cstdint>

#include "base/vec.h"
#include "scene/camera.h"

namespace lray::shade {

enum class Shader : std::uint8_t { full, flat, normals, uv, depth, cost };

struct Settings {
    Shader shader = Shader::flat;
    Color background{0.0f};   // of full and flat; the others show black where nothing was hit
    double depth_unit = 1.0;  // of depth (shade/depth.h)

    // Of full:
    scene::Integrator integrator = scene::Integrator::whitted;
    Color ambient{0.0f};
    std::uint32_t max_depth = 8;  // of reflections and refractions one after the other
    bool transparent_shadows = false;
    /// No light is given more samples at a point than this, whatever it asks for: previews are
    /// content with one.
    std::uint32_t max_light_samples = ~std::uint32_t{0};
};

}  // namespace lray::shade
