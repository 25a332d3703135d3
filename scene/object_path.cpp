#include "scene/object_path.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "base/assert.h"
#include "scene/content_map.h"
#include "scene/place.h"

namespace lray::scene {

namespace {

/// Of the instances that lead to an object, the innermost are shown.
constexpr std::size_t kMaxInstancesShown = 2;

/// Finds objects among the contents of a scene by counting.
class ObjectFinder {
 public:
    ObjectFinder(const Scene& scene, const World& world)
        : scene_(scene), contents_(scene), is_shared_(contents_.count()) {
        for (const Geometry& prototype : world.prototypes) {
            is_shared_[contents_.content_of(scene.node(prototype.node_id))] = true;
        }
    }

    /// Adds the way from below the node of a geometry to an object of it.
    void add_way(const Geometry& geometry, ObjectId id, ObjectPath& path) const {
        struct Step {
            NodeId id{};
            std::size_t next_child = 0;
        };
        // Shared itself, a mesh is all objects of its geometry, and on the way already.
        if (!ContentMap::is_inner(scene_.node(geometry.node_id))) return;
        std::vector<Step> stack{{geometry.node_id, 0}};
        for (std::size_t object_count = 0; !stack.empty();) {
            Step& step = stack.back();
            const auto children = children_of(scene_, scene_.node(step.id));
            if (step.next_child == children.size()) {
                stack.pop_back();
                continue;
            }
            const NodeId child_id = children[step.next_child];
            ++step.next_child;
            const Node& child = scene_.node(child_id);
            if (!contents_.has_primitive(child)) continue;
            stack.push_back({child_id, 0});
            if (ContentMap::is_inner(child) && !is_shared(child)) continue;
            const std::size_t first = object_count++;
            while (object_count < geometry.objects.size() &&
                   geometry.objects[object_count].is_continued) {
                ++object_count;
            }
            if (first <= id.index() && id.index() < object_count) {
                for (std::size_t i = 1; i < stack.size(); ++i) path.push_back(stack[i].id);
                return;
            }
            stack.pop_back();
        }
        LRAY_ASSERT(false);
    }

 private:
    bool is_shared(const Node& node) const { return is_shared_[contents_.content_of(node)]; }

    const Scene& scene_;
    ContentMap contents_;
    std::vector<bool> is_shared_;  // by content
};

}  // namespace

ObjectPath path_of(const Scene& scene, const World& world, PlaceOffset place, ObjectId id) {
    const PlacePath way = path_to(world, place);
    const bool is_plain = scene.instances.empty() && scene.labels.empty() && place == 0;
    if (is_plain) return {world.object(id).node_id};
    const ObjectFinder finder(scene, world);
    ObjectPath path;
    const Geometry* geometry = &world;
    for (const PlaceStep& step : way.steps) {
        finder.add_way(*geometry,
                       ObjectId(static_cast<std::size_t>(step.object - geometry->objects.data())),
                       path);
        geometry = &world.prototypes[step.instance->prototype];
    }
    finder.add_way(*geometry, id, path);
    return path;
}

std::string title_of(const Scene& scene, const Node& node) {
    const std::string_view kind = name_of(node.kind);
    if (node.label_id.is_none()) return std::string(kind);
    return fmt::format("{} `{}`", kind, scene.labels[node.label_id.index()]);
}

std::vector<NodeId> instances_elsewhere(const Scene& scene, const ObjectPath& path,
                                        std::size_t max_count) {
    const Span shape = scene.node(path.back()).span;
    std::vector<NodeId> result;
    for (std::size_t i = path.size() - 1; i-- > 0 && result.size() < max_count;) {
        const Node& node = scene.node(path[i]);
        if (node.kind == NodeKind::instance && node.span != shape) result.push_back(path[i]);
    }
    return result;
}

void add_place(Diagnostic& diagnostic, const Scene& scene, const World& world, ObjectId id,
               std::string message) {
    const ObjectPath path = path_of(scene, world, 0, id);
    const Node& shape = scene.node(path.back());
    diagnostic.with_label(shape.span, std::move(message));
    for (const NodeId instance : instances_elsewhere(scene, path, kMaxInstancesShown)) {
        diagnostic.with_label(scene.node(instance).span, "placed here");
    }
    std::string names;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const LabelId label_id = scene.node(path[i]).label_id;
        if (!label_id.is_none()) names += fmt::format("`{}` > ", scene.labels[label_id.index()]);
    }
    if (names.empty()) return;
    diagnostic.with_note(
        fmt::format("the {} is {}{}", name_of(shape.kind), names, title_of(scene, shape)));
}

}  // namespace lray::scene
