// Normals that run smoothly over the faces of a mesh.
#pragma once

#include <cstdint>
#include <span>

#include "scene/mesh.h"

namespace lray::scene {

/// The triangles from one on, up to the next run, are in a smoothing group; those of group 0, and
/// those before the first run, in none.
struct SmoothingRun {
    std::uint32_t first_triangle = 0;
    std::uint32_t group = 0;
};

/// Replaces the normals of a mesh: two faces are smooth along an edge that they share if they meet
/// there at less than `angle` (0: in one plane). Corners at one point that smooth edges there
/// connect share a normal: the mean of their faces' by the angles of the corners. A triangle that
/// is smooth with none, or has no area, has no normals.
/// Points that are equal are one point, whatever their indices. The normals do not depend on the
/// order of the triangles. Takes little more time than sorting, however many faces meet at a point
/// or an edge.
/// Space/units: radians.
/// Source: Thuermer and Wuethrich 1998, "Computing Vertex Normals from Polygonal Facets": the
/// weights.
void smooth_by_angle(Mesh& mesh, double angle);

/// Gives the triangles that have no normals, and are in a group, those of their group: as
/// smooth_by_angle(), where two faces are smooth along an edge if they are in one group. Does
/// nothing if there is no group.
/// Shape: the runs rise.
void smooth_by_groups(Mesh& mesh, std::span<const SmoothingRun> runs);

}  // namespace lray::scene
