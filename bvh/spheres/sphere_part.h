// The trees of bounding spheres of a world, with what they are over.
#pragma once

#include <vector>

#include "bvh/spheres/sphere_tree.h"
#include "scene/world.h"

namespace lray::bvh {

/// A geometry with its tree. Planes have no bounding sphere: every ray tests them.
struct SpherePart {
    const scene::Geometry* geometry = nullptr;
    SphereTree tree{};                          // without its order
    std::vector<scene::PrimitiveId> objects{};  // in the order of the tree's leaves
    std::vector<scene::PrimitiveId> planes{};
};

struct SphereParts {
    SpherePart world{};
    std::vector<SpherePart> prototypes{};
};

}  // namespace lray::bvh
