// What is inside of a primitive that has an inside.
#pragma once

#include "scene/world.h"

namespace lray::scene {

/// True if the point is inside of a closed primitive and farther from its surface than about a
/// thousandth of its size. A cylinder is closed with its caps; planes, rectangles, triangles and
/// disks have no inside.
bool is_inside(const Geometry& geometry, PrimitiveId id, DVec3 point);

}  // namespace lray::scene
