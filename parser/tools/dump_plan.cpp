#include "parser/tools/dump_plan.h"

#include <algorithm>
#include <cstddef>

#include "base/assert.h"

namespace lray::parser {

namespace {

using scene::NodeId;
using scene::NodeKind;

/// So many blocks inside one another are written; what is deeper is a definition of its own.
constexpr std::uint8_t kMaxHeight = 12;

enum class State : std::uint8_t { unseen, open, done };

}  // namespace

std::span<const NodeId> nodes_below(const scene::Scene& scene, const scene::Node& node) {
    if (node.kind == NodeKind::group) return scene.groups[node.index].children;
    if (node.kind == NodeKind::instance) return {&scene.instances[node.index].target, 1};
    return {};
}

DumpPlan plan_dump(const scene::Scene& scene) {
    struct Step {
        NodeId id{};
        std::size_t next = 0;
    };
    DumpPlan plan;
    plan.names.resize(scene.nodes.size());
    std::vector<bool> is_shared(scene.nodes.size());
    std::vector<State> states(scene.nodes.size());
    std::vector<std::uint8_t> heights(scene.nodes.size());
    std::vector<Step> stack{{scene.root, 0}};
    while (!stack.empty()) {
        Step& step = stack.back();
        const auto below = nodes_below(scene, scene.node(step.id));
        if (step.next < below.size()) {
            const NodeId child = below[step.next++];
            State& state = states[child.index()];
            LRAY_ASSERT(state != State::open);  // a cycle
            if (state == State::done) {
                is_shared[child.index()] = true;
            } else {
                state = State::open;
                stack.push_back({child, 0});
            }
            continue;
        }
        states[step.id.index()] = State::done;
        plan.order.push_back(step.id);
        stack.pop_back();
    }
    for (const NodeId id : plan.order) {
        if (id == scene.root) continue;
        std::uint8_t height = 0;
        for (const NodeId child : nodes_below(scene, scene.node(id))) {
            if (plan.names[child.index()] == 0) height = std::max(height, heights[child.index()]);
        }
        heights[id.index()] = ++height;
        if (!is_shared[id.index()] && height < kMaxHeight) continue;
        plan.definitions.push_back(id);
        plan.names[id.index()] = static_cast<std::uint32_t>(plan.definitions.size());
    }
    return plan;
}

}  // namespace lray::parser
