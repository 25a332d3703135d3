// Makes nodes of what an NFF file says.
#pragma once

#include <cstdint>

#include "scene/camera.h"
#include "scene/formats/nff_scene.h"
#include "scene/ids.h"
#include "scene/scene.h"

namespace lray::scene {

/// Neighbouring nodes of a scene: first the shapes, then the lights.
struct NffNodes {
    std::uint32_t first = 0;
    std::uint32_t shape_count = 0;
    std::uint32_t light_count = 0;
};

/// Adds the shapes and lights of an NFF file to a scene, as nodes that are placed nowhere yet, and
/// their materials.
///
/// Of `f` the matt colour is Kd times red, green and blue; Ks is a white highlight, Phong's with
/// the exponent Shine, and a white mirror; T is refraction, white too. Lights do not decrease with
/// the distance: a surface that faces a white light of strength 1 is as bright as its matt colour.
NffNodes add_nff(NffScene&& nff, Scene& scene);

/// Returns the camera of a view, without name and background.
Camera camera_of(const NffView& view);

}  // namespace lray::scene
