#include "scene/flatten_count.h"

#include <limits>
#include <span>

#include "base/assert.h"

namespace lray::scene {

namespace {

constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();

std::uint64_t saturating_add(std::uint64_t a, std::uint64_t b) {
    return a > kMost - b ? kMost : a + b;
}

std::uint64_t saturating_multiply(std::uint64_t a, std::uint64_t b) {
    return b != 0 && a > kMost / b ? kMost : a * b;
}

bool is_inner(const Node& node) {
    return node.kind == NodeKind::group || node.kind == NodeKind::instance;
}

/// The nodes directly below a group or instance.
std::span<const NodeId> children_of(const Scene& scene, const Node& node) {
    if (node.kind == NodeKind::group) return scene.groups[node.index].children;
    return {&scene.instances[node.index].target, 1};
}

enum class State : std::uint8_t { unseen, open, done };

/// A value for each group and each instance.
template <class T>
struct PerInnerNode {
    std::vector<T> groups;
    std::vector<T> instances;

    explicit PerInnerNode(const Scene& scene)
        : groups(scene.groups.size()), instances(scene.instances.size()) {}

    T& operator[](const Node& node) {
        return node.kind == NodeKind::group ? groups[node.index] : instances[node.index];
    }
};

/// Primitives that one placement of a shape or mesh makes.
std::uint64_t primitives_of(const Scene& scene, const Node& node) {
    if (node.kind == NodeKind::light) return 0;
    if (node.kind != NodeKind::mesh) return 1;
    std::uint64_t count = 0;
    for (const TriangleRange range : triangles_of(scene, scene.mesh_uses[node.index])) {
        count += range.count;
    }
    return count;
}

/// Returns the groups and instances under the root, each after all that is below it, and marks
/// those that lead to a primitive or light.
std::vector<NodeId> order_below_first(const Scene& scene, Occupied& occupied) {
    struct Step {
        NodeId id{};
        std::size_t next_child = 0;
    };
    PerInnerNode<State> states(scene);
    std::vector<NodeId> order;
    std::vector<Step> stack{{scene.root, 0}};
    states[scene.node(scene.root)] = State::open;
    while (!stack.empty()) {
        Step& step = stack.back();
        const Node& node = scene.node(step.id);
        const auto children = children_of(scene, node);
        bool is_occupied = occupied.has_something(node);
        bool is_entered = false;
        while (step.next_child < children.size() && !is_entered) {
            const NodeId child_id = children[step.next_child];
            const Node& child = scene.node(child_id);
            if (is_inner(child) && states[child] != State::done) {
                LRAY_ASSERT(states[child] == State::unseen);  // open: a cycle
                states[child] = State::open;
                stack.push_back({child_id, 0});  // seen again, done, when this one is resumed
                is_entered = true;
                break;
            }
            is_occupied = is_occupied || (is_inner(child) ? occupied.has_something(child)
                                                          : child.kind == NodeKind::light ||
                                                                primitives_of(scene, child) > 0);
            ++step.next_child;
        }
        (node.kind == NodeKind::group ? occupied.groups : occupied.instances)[node.index] =
            is_occupied;
        if (is_entered) continue;
        states[node] = State::done;
        order.push_back(stack.back().id);
        stack.pop_back();
    }
    return order;
}

}  // namespace

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

FlattenPlan plan_flatten(const Scene& scene) {
    FlattenPlan plan;
    plan.occupied.groups.resize(scene.groups.size());
    plan.occupied.instances.resize(scene.instances.size());
    const std::vector<NodeId> order = order_below_first(scene, plan.occupied);

    // From the root down: every path to a node counts.
    PerInnerNode<std::uint64_t> path_counts(scene);
    path_counts[scene.node(scene.root)] = 1;
    FlattenCounts& counts = plan.counts;
    for (auto id = order.rbegin(); id != order.rend(); ++id) {
        const Node& node = scene.node(*id);
        if (!plan.occupied.has_something(node)) continue;
        const std::uint64_t paths = path_counts[node];
        counts.visits = saturating_add(counts.visits, paths);
        for (const NodeId child_id : children_of(scene, node)) {
            const Node& child = scene.node(child_id);
            if (is_inner(child)) {
                path_counts[child] = saturating_add(path_counts[child], paths);
                continue;
            }
            const std::uint64_t made = saturating_multiply(paths, primitives_of(scene, child));
            std::uint64_t& shapes = counts.shapes[static_cast<std::size_t>(child.kind)];
            shapes = saturating_add(shapes, paths);
            if (child.kind == NodeKind::mesh) {
                counts.mesh_triangles = saturating_add(counts.mesh_triangles, made);
            }
            counts.primitives = saturating_add(counts.primitives, made);
            counts.visits = saturating_add(counts.visits, paths);
        }
    }
    return plan;
}

}  // namespace lray::scene
