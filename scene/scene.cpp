#include "scene/scene.h"

#include "base/assert.h"

namespace lray::scene {

std::string_view name_of(NodeKind kind) {
    switch (kind) {
        case NodeKind::group:
            return "group";
        case NodeKind::sphere:
            return "sphere";
        case NodeKind::rectangle:
            return "rectangle";
        case NodeKind::triangle:
            return "triangle";
        case NodeKind::cylinder:
            return "cylinder";
        case NodeKind::disk:
            return "disk";
        case NodeKind::box:
            return "box";
        case NodeKind::plane:
            return "plane";
        case NodeKind::torus:
            return "torus";
        case NodeKind::mesh:
            return "mesh";
        case NodeKind::instance:
            return "instance";
        case NodeKind::light:
            return "light";
    }
    LRAY_ASSERT(false);
}

std::span<const NodeId> children_of(const Scene& scene, const Node& node) {
    if (node.kind == NodeKind::group) return scene.groups[node.index].children;
    if (node.kind == NodeKind::instance) return {&scene.instances[node.index].target, 1};
    return {};
}

}  // namespace lray::scene
