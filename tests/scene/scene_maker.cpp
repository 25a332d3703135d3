#include "tests/scene/scene_maker.h"

#include <gtest/gtest.h>

namespace lray::scene {

SceneMaker::SceneMaker() {
    scene.root = add_group({});
}

NodeId SceneMaker::add_node(NodeKind kind, std::size_t index, const NodeSettings& settings) {
    Node node;
    node.kind = kind;
    node.index = static_cast<std::uint32_t>(index);
    node.visible = settings.visible;
    node.casts_shadow = settings.casts_shadow;
    node.material_id = settings.material;
    if (settings.transform) {
        node.transform_id = TransformId{scene.transforms.size()};
        scene.transforms.push_back(*settings.transform);
    }
    const std::size_t begin = 10 * scene.nodes.size();
    node.span = Span::make(0, begin, begin + 5);
    scene.nodes.push_back(node);
    return NodeId{scene.nodes.size() - 1};
}

NodeId SceneMaker::add(const SphereShape& shape, const NodeSettings& settings) {
    scene.spheres.push_back(shape);
    return add_node(NodeKind::sphere, scene.spheres.size() - 1, settings);
}

NodeId SceneMaker::add(const RectangleShape& shape, const NodeSettings& settings) {
    scene.rectangles.push_back(shape);
    return add_node(NodeKind::rectangle, scene.rectangles.size() - 1, settings);
}

NodeId SceneMaker::add(const TriangleShape& shape, const NodeSettings& settings) {
    scene.triangles.push_back(shape);
    return add_node(NodeKind::triangle, scene.triangles.size() - 1, settings);
}

NodeId SceneMaker::add(const CylinderShape& shape, const NodeSettings& settings) {
    scene.cylinders.push_back(shape);
    return add_node(NodeKind::cylinder, scene.cylinders.size() - 1, settings);
}

NodeId SceneMaker::add(const DiskShape& shape, const NodeSettings& settings) {
    scene.disks.push_back(shape);
    return add_node(NodeKind::disk, scene.disks.size() - 1, settings);
}

NodeId SceneMaker::add(const BoxShape& shape, const NodeSettings& settings) {
    scene.boxes.push_back(shape);
    return add_node(NodeKind::box, scene.boxes.size() - 1, settings);
}

NodeId SceneMaker::add(const PlaneShape& shape, const NodeSettings& settings) {
    scene.planes.push_back(shape);
    return add_node(NodeKind::plane, scene.planes.size() - 1, settings);
}

NodeId SceneMaker::add(const TorusShape& shape, const NodeSettings& settings) {
    scene.tori.push_back(shape);
    return add_node(NodeKind::torus, scene.tori.size() - 1, settings);
}

NodeId SceneMaker::add(const MeshUse& use, const NodeSettings& settings) {
    scene.mesh_uses.push_back(use);
    return add_node(NodeKind::mesh, scene.mesh_uses.size() - 1, settings);
}

NodeId SceneMaker::add_group(std::vector<NodeId> children, const NodeSettings& settings) {
    scene.groups.push_back({std::move(children)});
    return add_node(NodeKind::group, scene.groups.size() - 1, settings);
}

NodeId SceneMaker::add_instance(NodeId target, const NodeSettings& settings) {
    scene.instances.push_back({target});
    return add_node(NodeKind::instance, scene.instances.size() - 1, settings);
}

NodeId SceneMaker::add_light(std::size_t index, const NodeSettings& settings) {
    return add_node(NodeKind::light, index, settings);
}

MaterialId SceneMaker::add_material(Color diffuse) {
    Material material;
    material.diffuse = diffuse;
    scene.materials.push_back(material);
    return MaterialId{scene.materials.size() - 1};
}

MeshId SceneMaker::add_mesh(Mesh mesh) {
    index_parts(mesh);
    scene.meshes.push_back(std::move(mesh));
    return MeshId{scene.meshes.size() - 1};
}

World SceneMaker::flatten_cleanly() const {
    Diagnostics diagnostics;
    auto world = flatten(scene, {}, diagnostics);
    EXPECT_TRUE(world.has_value());
    for (const Diagnostic* diagnostic : diagnostics.sorted()) {
        ADD_FAILURE() << diagnostic->message;
    }
    return world ? std::move(*world) : World{};
}

Diagnostic expect_refused(const Scene& scene, const FlattenLimits& limits) {
    Diagnostics diagnostics;
    EXPECT_FALSE(flatten(scene, limits, diagnostics).has_value());
    EXPECT_EQ(diagnostics.error_count(), 1u);
    return diagnostics.has_errors() ? *diagnostics.sorted().front() : Diagnostic{};
}

}  // namespace lray::scene
