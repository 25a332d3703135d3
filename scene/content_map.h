// What nodes of the graph hold: which of them hold the same, and what they lead to.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace lray::scene {

/// The content of a group, an instance or a use of a mesh is what it places before its own steps.
/// Contents are numbered; equal uses of a mesh hold the same. Answers for other nodes are those of
/// a shape or light.
class ContentMap {
 public:
    /// Takes time in proportion to the graph, however often its nodes are shared.
    /// Errors: asserts that the graph has no cycles.
    explicit ContentMap(const Scene& scene);

    static bool has_content(const Node& node) {
        return is_inner(node) || node.kind == NodeKind::mesh;
    }
    static bool is_inner(const Node& node) {
        return node.kind == NodeKind::group || node.kind == NodeKind::instance;
    }

    std::size_t count() const { return first_mesh_use_ + equal_mesh_use_.size(); }

    /// Less than count(). Shape: the node has content.
    std::size_t content_of(const Node& node) const {
        if (node.kind == NodeKind::group) return node.index;
        if (node.kind == NodeKind::instance) return first_instance_ + node.index;
        return first_mesh_use_ + equal_mesh_use_[node.index];
    }

    /// A walk need not enter nodes that lead to nothing.
    bool has_primitive(const Node& node) const {
        return is_inner(node) ? leads_to(node, kPrimitive) : node.kind != NodeKind::light;
    }
    bool has_light(const Node& node) const {
        return is_inner(node) ? leads_to(node, kLight) : node.kind == NodeKind::light;
    }
    bool has_plane(const Node& node) const {
        return is_inner(node) ? leads_to(node, kPlane) : node.kind == NodeKind::plane;
    }

    /// The groups and instances under the root, each after all that is below it.
    const std::vector<NodeId>& below_first() const { return below_first_; }

    /// Of each number a node with that content; none where nothing under the root has it.
    const std::vector<NodeId>& first_nodes() const { return first_nodes_; }

 private:
    static constexpr std::uint8_t kPrimitive = 1;
    static constexpr std::uint8_t kLight = 2;
    static constexpr std::uint8_t kPlane = 4;

    bool leads_to(const Node& node, std::uint8_t what) const {
        return (leads_to_[content_of(node)] & what) != 0;
    }
    std::uint8_t leaf_leads_to(const Scene& scene, const Node& node) const;
    void order(const Scene& scene);

    std::size_t first_instance_ = 0;
    std::size_t first_mesh_use_ = 0;
    std::vector<std::uint32_t> equal_mesh_use_{};  // by MeshUse: the first one equal to it
    std::vector<std::uint8_t> leads_to_{};         // by content
    std::vector<NodeId> below_first_{};
    std::vector<NodeId> first_nodes_{};  // by content
};

/// Triangles [first, first + count) of a mesh.
struct TriangleRange {
    std::size_t first = 0;
    std::size_t count = 0;
};

/// Returns the triangles that a use of a mesh shows: all, or those of every part that has the name
/// of the part used, as a name may return after another one in a file.
std::vector<TriangleRange> triangles_of(const Scene& scene, const MeshUse& use);

/// Returns how many those are.
std::uint64_t triangle_count(const Scene& scene, const MeshUse& use);

/// True if materials of its file may be seen in a use of a mesh.
bool has_materials(const Scene& scene, const MeshUse& use);

}  // namespace lray::scene
