// Which nodes of a scene a dump writes as definitions of their own, and in which order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace lray::parser {

struct DumpPlan {
    std::vector<scene::NodeId> order{};        // all that is reachable, each behind what is below
    std::vector<scene::NodeId> definitions{};  // those written as `let`, likewise
    std::vector<std::uint32_t> names{};        // by NodeId: 1 for `n1`; 0: written in its place
};

/// Errors: asserts that the graph has no cycles.
DumpPlan plan_dump(const scene::Scene& scene);

/// The nodes directly below a node.
std::span<const scene::NodeId> nodes_below(const scene::Scene& scene, const scene::Node& node);

}  // namespace lray::parser
