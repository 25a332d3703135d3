// Finds flat faces that overlap in one plane.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "scene/world.h"

namespace lray::scene {

/// Two primitives, the one with the lower id first.
struct PrimitivePair {
    PrimitiveId first{};
    PrimitiveId second{};
};

/// Returns pairs of rectangles and sides of boxes, all along the axes, that lie in one plane to the
/// last few bits, overlap there, face the same way, and have a camera of the scene before them. A
/// box that stands on a rectangle faces the other way; an overlap that is covered by a closed
/// primitive is not seen. Only the first primitives are compared, and a few pairs returned.
std::vector<PrimitivePair> coplanar_faces(const Scene& scene, const World& world);

}  // namespace lray::scene
