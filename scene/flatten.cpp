#include "scene/flatten.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/assert.h"
#include "scene/flatten_count.h"
#include "scene/place_light.h"
#include "scene/placer.h"

namespace lray::scene {

namespace {

/// Groups and instances take time but make no primitives: a chain of a million shared a million
/// times would never end. So many nodes may be entered for each primitive of the limit.
constexpr std::uint64_t kNodesPerPrimitive = 16;

/// Errors of one flattening after which it gives up: a scene that is broken in a million places
/// has been told so.
constexpr std::size_t kMaxErrors = 100;

/// True if the counts stay within the limit and what a World can number; otherwise reports E0513.
bool is_within(const FlattenCounts& counts, const FlattenLimits& limits, const Scene& scene,
               Diagnostics& diagnostics) {
    const Span span = scene.node(scene.root).span;
    constexpr std::uint64_t kMost = std::uint64_t{PrimitiveId::kMaxIndex} + 1;
    if (counts.primitives > limits.primitives) {
        const bool is_saturated = counts.primitives == std::numeric_limits<std::uint64_t>::max();
        diagnostics
            .error(
                Code::E0513, span,
                fmt::format("the scene has {}{} primitives, more than the limit of {} "
                            "(`--max-primitives`)",
                            is_saturated ? "more than " : "", counts.primitives, limits.primitives))
            .with_help("raise it with `--max-primitives`");
        return false;
    }
    if (counts.primitives > kMost) {
        diagnostics.error(Code::E0513, span,
                          fmt::format("the scene has {} primitives; whatever `--max-primitives` "
                                      "says, the most is {}",
                                      counts.primitives, kMost));
        return false;
    }
    if (const std::uint64_t lights = counts.shapes_of(NodeKind::light); lights > limits.lights) {
        const bool is_saturated = lights == std::numeric_limits<std::uint64_t>::max();
        diagnostics
            .error(Code::E0513, span,
                   fmt::format("the scene has {}{} lights, more than the limit of {} "
                               "(`--max-lights`)",
                               is_saturated ? "more than " : "", lights, limits.lights))
            .with_help("raise it with `--max-lights`; `emission` of a material is no light");
        return false;
    }
    // The graph's own nodes are paid for already.
    const std::uint64_t most_visits =
        kNodesPerPrimitive * std::min(limits.primitives, kMost) + scene.nodes.size();
    if (counts.visits > most_visits) {
        diagnostics.error(
            Code::E0513, span,
            fmt::format("the scene's groups and instances place {} nodes, more than the {} that "
                        "the limit of {} primitives (`--max-primitives`) allows",
                        counts.visits, most_visits, limits.primitives));
        return false;
    }
    return true;
}

void reserve(World& world, const FlattenCounts& counts) {
    const auto reserve_kind = [&world](auto& primitives, PrimitiveKind kind, std::uint64_t count) {
        primitives.reserve(count);
        world.object_ids[static_cast<std::size_t>(kind)].reserve(count);
    };
    const std::uint64_t literal_triangles = counts.shapes_of(NodeKind::triangle);
    reserve_kind(world.triangles, PrimitiveKind::triangle,
                 literal_triangles + counts.mesh_triangles);
    reserve_kind(world.rectangles, PrimitiveKind::rectangle, counts.shapes_of(NodeKind::rectangle));
    reserve_kind(world.cylinders, PrimitiveKind::cylinder, counts.shapes_of(NodeKind::cylinder));
    reserve_kind(world.disks, PrimitiveKind::disk, counts.shapes_of(NodeKind::disk));
    reserve_kind(world.boxes, PrimitiveKind::box, counts.shapes_of(NodeKind::box));
    reserve_kind(world.planes, PrimitiveKind::plane, counts.shapes_of(NodeKind::plane));
    reserve_kind(world.tori, PrimitiveKind::torus, counts.shapes_of(NodeKind::torus));
    // Most spheres stay spheres; ellipsoids grow as they come.
    reserve_kind(world.spheres, PrimitiveKind::sphere, counts.shapes_of(NodeKind::sphere));
    // A closed mesh has half as many vertices as triangles.
    world.vertices.reserve(3 * literal_triangles + counts.mesh_triangles / 2);
    std::uint64_t objects = 0;
    for (const std::uint64_t count : counts.shapes) objects += count;
    world.objects.reserve(objects - counts.shapes_of(NodeKind::light));
    world.lights.reserve(counts.shapes_of(NodeKind::light));
}

/// True if the map has an inverse.
bool is_invertible(const Transform& transform) {
    if (!transform.is_finite()) return false;
    if (transform.is_similarity()) {
        return std::isnormal(transform.similarity_scale());  // saves most nodes the inversion
    }
    return transform.inverse().has_value();
}

/// Walks every path from the root to a shape, in the order of the graph. The stack is its own: how
/// deep groups nest is up to the scene.
class Walk {
 public:
    Walk(const Scene& scene, const Occupied& occupied, Placer& placer, World& world,
         Diagnostics& diagnostics)
        : scene_(scene),
          occupied_(occupied),
          placer_(placer),
          world_(world),
          diagnostics_(diagnostics) {}

    /// True if everything was placed.
    bool run() {
        enter(scene_.root, Placement{});
        while (!stack_.empty() && error_count() < kMaxErrors) {
            Step& step = stack_.back();
            const Node& node = scene_.node(step.id);
            if (node.kind == NodeKind::instance && step.next_child == 0) {
                ++step.next_child;
                enter(scene_.instances[node.index].target, step.placement);
            } else if (node.kind == NodeKind::group &&
                       step.next_child < scene_.groups[node.index].children.size()) {
                const NodeId child = scene_.groups[node.index].children[step.next_child];
                ++step.next_child;
                enter(child, step.placement);
            } else {
                stack_.pop_back();
            }
        }
        return error_count() == 0;
    }

 private:
    struct Step {
        NodeId id{};
        std::size_t next_child = 0;
        Placement placement{};
    };

    std::size_t error_count() const { return refused_count_ + placer_.refused_count(); }

    /// Places a shape, or puts a group or instance on the stack. `above` is taken by value: it may
    /// live on the stack.
    void enter(NodeId id, Placement placement) {
        const Node& node = scene_.node(id);
        if (!occupied_.has_something(node)) return;
        placement.visible = placement.visible && node.visible;
        placement.casts_shadow = placement.casts_shadow && node.casts_shadow;
        // materials[0] of the world is the default; the scene's follow.
        if (!node.material_id.is_none()) placement.material = node.material_id.value + 1;
        if (!node.transform_id.is_none()) {
            placement.world_from_object =
                scene_.transforms[node.transform_id.index()].then(placement.world_from_object);
            if (!is_invertible(placement.world_from_object)) {
                ++refused_count_;
                diagnostics_.error(Code::E0310, node.span,
                                   "the transform of this node cannot be inverted");
                return;
            }
            placement.is_mirrored = placement.world_from_object.is_mirrored();
        }
        if (node.kind == NodeKind::group || node.kind == NodeKind::instance) {
            stack_.push_back({id, 0, placement});
        } else if (node.kind == NodeKind::light) {
            place(id, node, placement);
        } else {
            placer_.place(id, placement);
        }
    }

    void place(NodeId id, const Node& node, const Placement& placement) {
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
        const auto placed = place_light(light, placement.world_from_object);
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
        world_.lights.push_back(
            {std::get<Light>(placed), id, placement.visible, node.casts_shadow});
    }

    Diagnostic& refuse(Code code, const Node& node, std::string message) {
        ++refused_count_;
        return diagnostics_.error(code, node.span, std::move(message));
    }

    const Scene& scene_;
    const Occupied& occupied_;
    Placer& placer_;
    World& world_;
    Diagnostics& diagnostics_;
    std::vector<Step> stack_;
    Span environment_{};  // the first one
    std::size_t refused_count_ = 0;
};

}  // namespace

std::optional<World> flatten(const Scene& scene, const FlattenLimits& limits,
                             Diagnostics& diagnostics) {
    LRAY_ASSERT(!scene.root.is_none());
    const FlattenPlan plan = plan_flatten(scene);
    if (!is_within(plan.counts, limits, scene, diagnostics)) return std::nullopt;

    std::optional<World> world(std::in_place);
    world->materials.reserve(scene.materials.size() + 1);
    world->materials.emplace_back();
    world->materials.insert(world->materials.end(), scene.materials.begin(), scene.materials.end());
    world->textures = scene.textures;
    world->pictures = scene.pictures;
    reserve(*world, plan.counts);
    Placer placer(scene, *world, diagnostics);
    if (!Walk(scene, plan.occupied, placer, *world, diagnostics).run()) return std::nullopt;
    placer.finish();
    return world;
}

}  // namespace lray::scene
