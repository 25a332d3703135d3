#include "scene/warn_mirrored.h"

#include <fmt/format.h>

#include <vector>

#include "scene/object_path.h"

namespace lray::scene {

void warn_mirrored(const Scene& scene, Diagnostics& diagnostics) {
    std::vector<bool> is_seen(scene.nodes.size());
    std::vector<NodeId> waiting{scene.root};
    while (!waiting.empty()) {
        const NodeId id = waiting.back();
        waiting.pop_back();
        if (is_seen[id.index()]) continue;
        is_seen[id.index()] = true;
        const Node& node = scene.node(id);
        const bool is_mirrored = !node.transform_id.is_none() &&
                                 scene.transforms[node.transform_id.index()].is_mirrored();
        if (is_mirrored) {
            diagnostics.warning(
                Code::W1303, node.span,
                fmt::format("the transform of this {} mirrors it", title_of(scene, node)));
        }
        if (node.kind == NodeKind::group) {
            const std::vector<NodeId>& children = scene.groups[node.index].children;
            waiting.insert(waiting.end(), children.begin(), children.end());
        } else if (node.kind == NodeKind::instance) {
            waiting.push_back(scene.instances[node.index].target);
        }
    }
}

}  // namespace lray::scene
