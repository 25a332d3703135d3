// The scene as it was authored: a graph of nodes with names, places in the source and hierarchy.
// It keeps what diagnostics, picking and the dump need; what is traced is scene/world.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/source.h"
#include "base/transform.h"
#include "scene/camera.h"
#include "scene/ids.h"
#include "scene/light.h"
#include "scene/material.h"
#include "scene/mesh.h"
#include "scene/shapes.h"
#include "scene/texture.h"

namespace lray::scene {

enum class NodeKind : std::uint8_t {
    group,
    sphere,
    rectangle,
    triangle,
    cylinder,
    disk,
    box,
    plane,
    torus,
    mesh,
    instance,
    light,
};
inline constexpr std::size_t kNodeKindCount = static_cast<std::size_t>(NodeKind::light) + 1;

/// Returns the word for it in messages: "sphere".
std::string_view name_of(NodeKind kind);

/// One thing in the scene, 32 bytes: scenes of millions of literal shapes hold one for each.
/// Nodes form a directed graph without cycles: a node value placed twice is one node with two
/// instances.
struct Node {
    NodeKind kind = NodeKind::group;
    bool visible = true;
    bool casts_shadow = true;
    std::uint32_t index = 0;     // into the array of its kind
    TransformId transform_id{};  // parent_from_object; none: the identity
    MaterialId material_id{};    // none: inherited
    LabelId label_id{};          // none: unnamed
    Span span{};                 // the block that made it
};

struct Group {
    std::vector<NodeId> children{};
};

/// Another use of a node, with the transform and material of the node that holds it on top.
struct Instance {
    NodeId target{};
};

/// A use of a mesh: all of it, or a part.
struct MeshUse {
    static constexpr std::uint32_t kAllParts = 0xffffffffu;

    MeshId mesh_id{};
    std::uint32_t part = kAllParts;
    bool z_is_up = false;
    bool shows_materials = false;  // those of its file, where they are read
};

struct Scene {
    std::vector<Node> nodes{};
    std::vector<Group> groups{};
    std::vector<SphereShape> spheres{};
    std::vector<RectangleShape> rectangles{};
    std::vector<TriangleShape> triangles{};
    std::vector<CylinderShape> cylinders{};
    std::vector<DiskShape> disks{};
    std::vector<BoxShape> boxes{};
    std::vector<PlaneShape> planes{};
    std::vector<TorusShape> tori{};
    std::vector<MeshUse> mesh_uses{};
    std::vector<Instance> instances{};
    std::vector<Light> lights{};

    std::vector<TriangleAttributes> triangle_attributes{};
    std::vector<Mesh> meshes{};
    std::vector<Transform> transforms{};
    std::vector<Material> materials{};
    std::vector<Texture> textures{};
    bool shows_vertex_colors = false;  // one of these does
    std::vector<Picture> pictures{};
    std::vector<std::string> labels{};

    std::vector<Camera> cameras{};  // the first is the default
    RenderSettings render{};
    std::optional<Animation> animation{};
    std::vector<std::pair<std::string, std::string>> info{};

    NodeId root{};  // a group

    const Node& node(NodeId id) const { return nodes[id.index()]; }
};

/// Returns the nodes directly below a group or instance; of other nodes none.
std::span<const NodeId> children_of(const Scene& scene, const Node& node);

}  // namespace lray::scene
