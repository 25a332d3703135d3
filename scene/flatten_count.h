// What flattening a scene would make, worked out on the graph without expanding it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace lray::scene {

/// Counts saturate at 2^64 - 1.
struct FlattenCounts {
    std::array<std::uint64_t, kNodeKindCount> shapes{};  // by NodeKind: placements of each
    std::uint64_t mesh_triangles = 0;
    std::uint64_t primitives = 0;
    std::uint64_t visits = 0;  // nodes entered by a walk over every path that leads to something

    std::uint64_t shapes_of(NodeKind kind) const { return shapes[static_cast<std::size_t>(kind)]; }
};

/// Which groups and instances lead to a primitive or light: a walk need not enter the others.
struct Occupied {
    std::vector<bool> groups{};     // by Node::index
    std::vector<bool> instances{};  // likewise

    bool has_something(const Node& node) const {
        if (node.kind == NodeKind::group) return groups[node.index];
        if (node.kind == NodeKind::instance) return instances[node.index];
        return true;
    }
};

struct FlattenPlan {
    FlattenCounts counts{};
    Occupied occupied{};
};

/// Returns the counts of everything under the root, in time proportional to the graph, however
/// often its nodes are shared.
/// Errors: asserts that the graph has no cycles.
FlattenPlan plan_flatten(const Scene& scene);

/// Triangles [first, first + count) of a mesh.
struct TriangleRange {
    std::size_t first = 0;
    std::size_t count = 0;
};

/// Returns the triangles that a use of a mesh shows: all, or those of every part that has the name
/// of the part used, as a name may return after another one in a file.
std::vector<TriangleRange> triangles_of(const Scene& scene, const MeshUse& use);

}  // namespace lray::scene
