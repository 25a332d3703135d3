#include "scene/graph_walk.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "scene/place_light.h"

namespace lray::scene {

namespace {

/// True if the map has an inverse.
bool is_invertible(const Transform& transform) {
    if (!transform.is_finite()) return false;
    if (transform.is_similarity()) {
        return std::isnormal(transform.similarity_scale());  // saves most nodes the inversion
    }
    return transform.inverse().has_value();
}

}  // namespace

void GraphWalk::place(NodeId id) {
    enter(id, Placement{}, Wanted::all);
    run();
}

void GraphWalk::place_content(NodeId id, const Placement& placement) {
    if (!ContentMap::is_inner(scene_.node(id))) return placer_.place(id, placement);
    stack_.push_back({id, Wanted::all, 0, placement});
    run();
}

void GraphWalk::run() {
    while (!stack_.empty() && error_count() < kMaxFlattenErrors) {
        Step& step = stack_.back();
        const auto children = children_of(scene_, scene_.node(step.id));
        if (step.next_child < children.size()) {
            const NodeId child = children[step.next_child];
            ++step.next_child;
            enter(child, step.placement, step.wanted);
        } else {
            stack_.pop_back();
        }
    }
}

/// Places a shape or instance, or puts what is below on the stack. `placement` is of the node
/// above, by value: that may live on the stack.
void GraphWalk::enter(NodeId id, Placement placement, Wanted wanted) {
    const Node& node = scene_.node(id);
    if (!is_wanted(node, wanted) || !settle(node, placement)) return;
    if (node.kind == NodeKind::light) return place_light(id, node, placement);
    const std::uint32_t prototype = plan_.prototype_of_node(node);
    if (prototype != FlattenPlan::kNotShared) {
        if (wanted == Wanted::all) {
            const NodeId above = stack_.back().id;
            const bool is_placed_there = scene_.node(above).kind == NodeKind::instance;
            placer_.place_instance(is_placed_there ? above : id, prototypes_[prototype], placement);
        }
        wanted = Wanted::lights;
        if (!is_wanted(node, wanted)) return;
    }
    if (ContentMap::is_inner(node)) {
        stack_.push_back({id, wanted, 0, placement});
    } else {
        placer_.place(id, placement);
    }
}

bool GraphWalk::is_wanted(const Node& node, Wanted wanted) const {
    return (wanted == Wanted::all && plan_.contents.has_primitive(node)) ||
           (lights_ != nullptr && plan_.contents.has_light(node));
}

/// Adds the node's own settings; false if its transform is refused.
bool GraphWalk::settle(const Node& node, Placement& placement) {
    placement.visible = placement.visible && node.visible;
    placement.casts_shadow = placement.casts_shadow && node.casts_shadow;
    // materials[0] of the world is the default; the scene's follow.
    if (!node.material_id.is_none()) placement.material = node.material_id.value + 1;
    if (node.transform_id.is_none()) return true;
    placement.world_from_object =
        scene_.transforms[node.transform_id.index()].then(placement.world_from_object);
    if (!is_invertible(placement.world_from_object)) {
        refuse(Code::E0310, node, "the transform of this node cannot be inverted");
        return false;
    }
    placement.is_mirrored = placement.world_from_object.is_mirrored();
    return true;
}

void GraphWalk::place_light(NodeId id, const Node& node, const Placement& placement) {
    const Light& light = scene_.lights[node.index];
    if (std::holds_alternative<EnvironmentLight>(light.shape)) {
        if (!environment_.is_nowhere()) {
            Diagnostic& second =
                refuse(Code::E0405, node, "a second `environment`; a scene has one");
            if (environment_ != node.span) {  // the same one may be placed twice
                second.with_label(environment_, "the first one is here");
            }
            return;
        }
        environment_ = node.span;
    }
    const auto placed = scene::place_light(light, placement.world_from_object);
    if (const LightProblem* problem = std::get_if<LightProblem>(&placed)) {
        if (*problem == LightProblem::no_area) {
            refuse(Code::E0310, node, "what is above this light leaves it no area");
        } else {
            refuse(Code::E0304, node,
                   fmt::format("this light is farther from the origin than {}, which the "
                               "world does not hold",
                               kMaxCoordinate));
        }
        return;
    }
    lights_->push_back({std::get<Light>(placed), id, placement.visible, node.casts_shadow});
}

Diagnostic& GraphWalk::refuse(Code code, const Node& node, std::string message) {
    ++refused_count_;
    return diagnostics_.error(code, node.span, std::move(message));
}

}  // namespace lray::scene
