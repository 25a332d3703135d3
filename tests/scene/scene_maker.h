// Makes scenes for the tests, as the evaluator would.
#pragma once

#include <optional>

#include "base/diagnostics.h"
#include "scene/flatten.h"
#include "scene/scene.h"

namespace lray::scene {

/// What a node is given besides its shape.
struct NodeSettings {
    std::optional<Transform> transform{};
    MaterialId material{};
    bool visible = true;
    bool casts_shadow = true;
};

/// A scene that grows by one call for each node. Nodes do not hang in the graph until they are
/// children of the root or a group. Each node's span begins at 10 times its number.
class SceneMaker {
 public:
    SceneMaker();

    NodeId add(const SphereShape& shape, const NodeSettings& settings = {});
    NodeId add(const RectangleShape& shape, const NodeSettings& settings = {});
    NodeId add(const TriangleShape& shape, const NodeSettings& settings = {});
    NodeId add(const CylinderShape& shape, const NodeSettings& settings = {});
    NodeId add(const DiskShape& shape, const NodeSettings& settings = {});
    NodeId add(const BoxShape& shape, const NodeSettings& settings = {});
    NodeId add(const PlaneShape& shape, const NodeSettings& settings = {});
    NodeId add(const TorusShape& shape, const NodeSettings& settings = {});
    NodeId add(const MeshUse& use, const NodeSettings& settings = {});
    NodeId add_group(std::vector<NodeId> children, const NodeSettings& settings = {});
    NodeId add_instance(NodeId target, const NodeSettings& settings = {});
    /// Of Scene::lights.
    NodeId add_light(std::size_t index, const NodeSettings& settings = {});
    MaterialId add_material(Color diffuse);
    MeshId add_mesh(Mesh mesh);

    /// Makes it a child of the root.
    void place(NodeId id) { scene.groups[0].children.push_back(id); }

    /// Flattens and expects success without a diagnostic.
    World flatten_cleanly() const;

    Scene scene{};

 private:
    NodeId add_node(NodeKind kind, std::size_t index, const NodeSettings& settings);
};

/// Runs flatten() and expects it to refuse with exactly one error.
Diagnostic expect_refused(const Scene& scene, const FlattenLimits& limits = {});

}  // namespace lray::scene
