// The box around a node of the graph, as tight as the shapes below it allow.
#pragma once

#include <cstdint>

#include "base/vec.h"
#include "scene/scene.h"

namespace lray::scene {

struct NodeBounds {
    enum class Outcome : std::uint8_t {
        box,
        empty,      // nothing below has a size
        infinite,   // a plane is below, or coordinates are too large for numbers
        too_large,  // more work than allowed
    };

    Outcome outcome = Outcome::empty;
    DVec3 min{};
    DVec3 max{};
    std::uint64_t work = 0;  // done: a unit for each visit of a node, or a few triangles of a mesh
};

/// Returns the box around a node after its own transform, in the space of its parent. What is below
/// is measured where it is: no boxes of boxes. Nodes that are shared are measured once as long as
/// the transforms above them keep the axes; turned in many ways, once for each.
NodeBounds node_bounds(const Scene& scene, NodeId id, std::uint64_t max_work);

}  // namespace lray::scene
