#include "scene/lit.h"

#include <algorithm>

namespace lray::scene {

bool is_lit(const Scene& scene, const World& world) {
    if (!world.lights.empty()) return true;
    return scene.render.integrator == Integrator::path &&
           std::any_of(world.materials.begin(), world.materials.end(),
                       [](const Material& material) {
                           return material.emission.is_textured() ||
                                  material.emission.constant != Color{0.0f};
                       });
}

void warn_unlit(const Scene& scene, const World& world, Diagnostics& diagnostics) {
    if (is_lit(scene, world) || world.primitive_count() == 0) return;
    diagnostics
        .warning(Code::W1502, Span::make(0, 0, 0),
                 "there is no light and no environment; each object is painted in one colour")
        .with_help(
            "add `directional_light { direction: [-1, -2, -1.5] }`, or ask for "
            "`--shading flat`");
}

}  // namespace lray::scene
