// What flattening a scene would make, and what of it is stored once: worked out on the graph
// without expanding it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "scene/content_map.h"
#include "scene/scene.h"
#include "scene/world.h"

namespace lray::scene {

/// When something that is placed more than once is stored once. An instance costs a ray more than
/// what it saves as long as that is little: a few spheres, or a few uses.
struct SharingRule {
    std::uint64_t min_primitives = 16;  // of what is shared, an instance in it counts as one
    std::uint64_t min_saved = 4096;     // (uses - 1) * primitives

    static constexpr SharingRule nothing() {
        return {std::numeric_limits<std::uint64_t>::max(), 0};
    }
};

/// Counts saturate at 2^64 - 1.
struct FlattenCounts {
    std::array<std::uint64_t, kNodeKindCount> world_shapes{};  // by NodeKind: in the world's space
    std::uint64_t world_mesh_triangles = 0;
    std::uint64_t world_instances = 0;

    std::uint64_t primitives = 0;  // stored, instances included
    std::uint64_t lights = 0;      // on every path
    std::uint64_t places = 1;      // of the world, Geometry::place_count
    std::uint64_t visits = 0;      // nodes that are entered to store and light all this

    std::uint64_t world_shapes_of(NodeKind kind) const {
        return world_shapes[static_cast<std::size_t>(kind)];
    }
};

struct FlattenPlan {
    static constexpr std::uint32_t kNotShared = 0xffffffffu;

    ContentMap contents;
    std::vector<NodeId> prototypes{};           // a node of each; each uses only those before it
    std::vector<std::uint32_t> prototype_of{};  // by content: index into prototypes, or kNotShared
    bool is_nested_too_deep = false;  // something was not shared for kMaxInstanceDepth alone
    FlattenCounts counts{};

    std::uint32_t prototype_of_node(const Node& node) const {
        return ContentMap::has_content(node) ? prototype_of[contents.content_of(node)] : kNotShared;
    }
};

/// Decides what is shared, from the shapes up: the content of a node that leads to no plane, which
/// has no bounds, when the rule is met on all paths to it, and more than one use of it is stored.
/// Takes time in proportion to the graph, however often its nodes are shared.
/// Errors: asserts that the graph has no cycles.
FlattenPlan plan_flatten(const Scene& scene, const SharingRule& rule);

}  // namespace lray::scene
