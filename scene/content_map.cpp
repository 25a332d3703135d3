#include "scene/content_map.h"

#include <map>
#include <tuple>

#include "base/assert.h"

namespace lray::scene {

namespace {

enum class State : std::uint8_t { unseen, open, done };

std::vector<std::uint32_t> find_equal_uses(const Scene& scene) {
    std::map<std::tuple<std::uint32_t, std::uint32_t, bool, bool>, std::uint32_t> first_uses;
    std::vector<std::uint32_t> equal;
    equal.reserve(scene.mesh_uses.size());
    for (const MeshUse& use : scene.mesh_uses) {
        const auto index = static_cast<std::uint32_t>(equal.size());
        const bool shows_materials = has_materials(scene, use);
        equal.push_back(
            first_uses
                .try_emplace({use.mesh_id.value, use.part, use.z_is_up, shows_materials}, index)
                .first->second);
    }
    return equal;
}

}  // namespace

ContentMap::ContentMap(const Scene& scene)
    : first_instance_(scene.groups.size()),
      first_mesh_use_(first_instance_ + scene.instances.size()),
      equal_mesh_use_(find_equal_uses(scene)) {
    leads_to_.resize(count());
    first_nodes_.resize(count());
    order(scene);
}

std::uint8_t ContentMap::leaf_leads_to(const Scene& scene, const Node& node) const {
    if (node.kind == NodeKind::light) return kLight;
    if (node.kind == NodeKind::plane) return kPrimitive | kPlane;
    if (node.kind != NodeKind::mesh) return kPrimitive;
    return triangle_count(scene, scene.mesh_uses[node.index]) > 0 ? kPrimitive : 0;
}

void ContentMap::order(const Scene& scene) {
    struct Step {
        NodeId id{};
        std::size_t next_child = 0;
    };
    std::vector<State> states(first_mesh_use_);
    std::vector<Step> stack{{scene.root, 0}};
    states[content_of(scene.node(scene.root))] = State::open;
    while (!stack.empty()) {
        Step& step = stack.back();
        const Node& node = scene.node(step.id);
        const auto children = children_of(scene, node);
        std::uint8_t& found = leads_to_[content_of(node)];
        bool is_entered = false;
        while (step.next_child < children.size() && !is_entered) {
            const NodeId child_id = children[step.next_child];
            const Node& child = scene.node(child_id);
            if (!is_inner(child)) {
                found |= leaf_leads_to(scene, child);
                if (child.kind == NodeKind::mesh) first_nodes_[content_of(child)] = child_id;
            } else if (State& state = states[content_of(child)]; state == State::done) {
                found |= leads_to_[content_of(child)];
            } else {
                LRAY_ASSERT(state == State::unseen);  // open: a cycle
                state = State::open;
                stack.push_back({child_id, 0});  // seen again, done, when this one is resumed
                is_entered = true;
                break;
            }
            ++step.next_child;
        }
        if (is_entered) continue;
        states[content_of(node)] = State::done;
        first_nodes_[content_of(node)] = stack.back().id;
        below_first_.push_back(stack.back().id);
        stack.pop_back();
    }
}

bool has_materials(const Scene& scene, const MeshUse& use) {
    return use.shows_materials && !scene.meshes[use.mesh_id.index()].materials.empty();
}

std::vector<TriangleRange> triangles_of(const Scene& scene, const MeshUse& use) {
    const Mesh& mesh = scene.meshes[use.mesh_id.index()];
    if (use.part == MeshUse::kAllParts) return {{0, mesh.triangles.size()}};
    std::vector<TriangleRange> ranges;
    for (const std::uint32_t index : parts_named(mesh, mesh.parts[use.part].name)) {
        const MeshPart& part = mesh.parts[index];
        ranges.push_back({part.first_triangle, part.triangle_count});
    }
    return ranges;
}

std::uint64_t triangle_count(const Scene& scene, const MeshUse& use) {
    std::uint64_t count = 0;
    for (const TriangleRange range : triangles_of(scene, use)) count += range.count;
    return count;
}

}  // namespace lray::scene
