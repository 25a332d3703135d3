#include "scene/object_path.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "base/assert.h"
#include "scene/flatten_count.h"

namespace lray::scene {

namespace {

/// Of the instances that lead to an object, the innermost are shown.
constexpr std::size_t kMaxInstancesShown = 2;

/// The nodes directly below; none of a shape, mesh or light.
std::span<const NodeId> children_of(const Scene& scene, const Node& node) {
    if (node.kind == NodeKind::group) return scene.groups[node.index].children;
    if (node.kind == NodeKind::instance) return {&scene.instances[node.index].target, 1};
    return {};
}

}  // namespace

ObjectPath path_of(const Scene& scene, const World& world, ObjectId id) {
    if (scene.instances.empty() && scene.labels.empty()) return {world.object(id).node_id};
    const Occupied occupied = plan_flatten(scene).occupied;
    struct Step {
        NodeId id{};
        std::size_t next_child = 0;
    };
    std::vector<Step> stack{{scene.root, 0}};
    for (std::size_t object_count = 0; !stack.empty();) {
        Step& step = stack.back();
        const auto children = children_of(scene, scene.node(step.id));
        if (step.next_child == children.size()) {
            stack.pop_back();
            continue;
        }
        const NodeId child_id = children[step.next_child];
        ++step.next_child;
        const Node& child = scene.node(child_id);
        if (!occupied.has_something(child) || child.kind == NodeKind::light) continue;
        stack.push_back({child_id, 0});
        const bool is_object = child.kind != NodeKind::group && child.kind != NodeKind::instance;
        if (!is_object || object_count++ != id.index()) continue;
        LRAY_ASSERT(world.object(id).node_id == child_id);
        ObjectPath path;
        for (std::size_t i = 1; i < stack.size(); ++i) path.push_back(stack[i].id);
        return path;
    }
    LRAY_ASSERT(false);
}

std::string title_of(const Scene& scene, const Node& node) {
    const std::string_view kind = name_of(node.kind);
    if (node.label_id.is_none()) return std::string(kind);
    return fmt::format("{} `{}`", kind, scene.labels[node.label_id.index()]);
}

void add_place(Diagnostic& diagnostic, const Scene& scene, const World& world, ObjectId id,
               std::string message) {
    const ObjectPath path = path_of(scene, world, id);
    const Node& shape = scene.node(path.back());
    diagnostic.with_label(shape.span, std::move(message));
    std::string names;
    std::size_t shown = 0;
    for (std::size_t i = path.size() - 1; i-- > 0;) {
        const Node& node = scene.node(path[i]);
        if (!node.label_id.is_none()) {
            names = fmt::format("`{}` > {}", scene.labels[node.label_id.index()], names);
        }
        if (node.kind != NodeKind::instance || node.span == shape.span) continue;
        if (shown++ < kMaxInstancesShown) diagnostic.with_label(node.span, "placed here");
    }
    if (names.empty()) return;
    diagnostic.with_note(
        fmt::format("the {} is {}{}", name_of(shape.kind), names, title_of(scene, shape)));
}

}  // namespace lray::scene
