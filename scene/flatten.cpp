#include "scene/flatten.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/assert.h"
#include "scene/flatten_plan.h"
#include "scene/graph_walk.h"
#include "scene/placer.h"

namespace lray::scene {

namespace {

/// Groups and instances take time but make no primitives: a chain of a million shared a million
/// times would never end. So many nodes may be entered for each primitive of the limit.
constexpr std::uint64_t kNodesPerPrimitive = 16;

/// "12", or "more than 18446744073709551615".
std::string format_count(std::uint64_t count) {
    const bool is_saturated = count == std::numeric_limits<std::uint64_t>::max();
    return fmt::format("{}{}", is_saturated ? "more than " : "", count);
}

/// True if the counts stay within the limits and what a World can number; otherwise reports E0513.
bool is_within(const FlattenPlan& plan, const FlattenLimits& limits, const Scene& scene,
               Diagnostics& diagnostics) {
    const FlattenCounts& counts = plan.counts;
    const Span span = scene.node(scene.root).span;
    constexpr std::uint64_t kMost = std::uint64_t{PrimitiveId::kMaxIndex} + 1;
    if (counts.primitives > std::min(limits.primitives, kMost)) {
        const bool is_above_limit = counts.primitives > limits.primitives;
        Diagnostic& error = diagnostics.error(
            Code::E0513, span,
            is_above_limit
                ? fmt::format("the scene has {} primitives, more than the limit of {} "
                              "(`--max-primitives`)",
                              format_count(counts.primitives), limits.primitives)
                : fmt::format("the scene has {} primitives; whatever `--max-primitives` says, the "
                              "most is {}",
                              counts.primitives, kMost));
        if (is_above_limit) error.with_help("raise it with `--max-primitives`");
        if (plan.is_nested_too_deep) {
            error.with_note(
                fmt::format("what is placed often is stored once, but not with more "
                            "than {} instances within each other",
                            kMaxInstanceDepth));
        }
        return false;
    }
    if (counts.lights > limits.lights) {
        diagnostics
            .error(Code::E0513, span,
                   fmt::format("the scene has {} lights, more than the limit of {} "
                               "(`--max-lights`)",
                               format_count(counts.lights), limits.lights))
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
    if (counts.places >= kMaxPlaceCount) {
        diagnostics.error(Code::E0513, span,
                          fmt::format("the scene's instances lead to {} places; the most is {}",
                                      format_count(counts.places), kMaxPlaceCount - 1));
        return false;
    }
    return true;
}

void reserve(World& world, const FlattenCounts& counts) {
    const auto reserve_kind = [&world](auto& primitives, PrimitiveKind kind, std::uint64_t count) {
        primitives.reserve(count);
        world.object_ids[static_cast<std::size_t>(kind)].reserve(count);
    };
    const std::uint64_t literal_triangles = counts.world_shapes_of(NodeKind::triangle);
    reserve_kind(world.triangles, PrimitiveKind::triangle,
                 literal_triangles + counts.world_mesh_triangles);
    reserve_kind(world.rectangles, PrimitiveKind::rectangle,
                 counts.world_shapes_of(NodeKind::rectangle));
    reserve_kind(world.cylinders, PrimitiveKind::cylinder,
                 counts.world_shapes_of(NodeKind::cylinder));
    reserve_kind(world.disks, PrimitiveKind::disk, counts.world_shapes_of(NodeKind::disk));
    reserve_kind(world.boxes, PrimitiveKind::box, counts.world_shapes_of(NodeKind::box));
    reserve_kind(world.planes, PrimitiveKind::plane, counts.world_shapes_of(NodeKind::plane));
    reserve_kind(world.tori, PrimitiveKind::torus, counts.world_shapes_of(NodeKind::torus));
    // Most spheres stay spheres; ellipsoids grow as they come.
    reserve_kind(world.spheres, PrimitiveKind::sphere, counts.world_shapes_of(NodeKind::sphere));
    // A closed mesh has half as many vertices as triangles.
    world.vertices.reserve(3 * literal_triangles + counts.world_mesh_triangles / 2);
    reserve_kind(world.instances, PrimitiveKind::instance, counts.world_instances);
    std::uint64_t objects = counts.world_instances;
    for (const std::uint64_t count : counts.world_shapes) objects += count;
    world.objects.reserve(objects);
    world.lights.reserve(counts.lights);
}

/// Gives back what arrays that grew by doubling do not use.
void shrink(Geometry& geometry) {
    const auto shrink_all = [](auto&... arrays) { (arrays.shrink_to_fit(), ...); };
    shrink_all(geometry.vertices, geometry.triangles, geometry.rectangles, geometry.spheres,
               geometry.ellipsoids, geometry.cylinders, geometry.disks, geometry.boxes,
               geometry.tori, geometry.instances, geometry.normals, geometry.uvs,
               geometry.triangle_normals, geometry.triangle_uvs, geometry.objects, geometry.colors,
               geometry.mean_colors);
    geometry.object_spaces.shrink_to_fit();
    for (std::vector<ObjectId>& object_ids : geometry.object_ids) shrink_all(object_ids);
}

/// Returns the middle of bounds that are so far from the origin, for their size, that coordinates
/// about it are the more precise ones.
std::optional<DVec3> far_middle(const Bounds& bounds) {
    if (bounds.is_empty()) return std::nullopt;
    const DVec3 middle = 0.5 * (DVec3{bounds.min} + DVec3{bounds.max});
    const DVec3 half = DVec3{bounds.max} - middle;
    if (reach(middle) <= 2.0 * reach(half)) return std::nullopt;
    return middle;
}

/// Makes the world's prototypes, and then the world.
class Flattening {
 public:
    Flattening(const Scene& scene, const FlattenPlan& plan, KeptSpaces spaces, World& world,
               Diagnostics& diagnostics)
        : scene_(scene),
          plan_(plan),
          space_rule_(scene, spaces),
          world_(world),
          diagnostics_(diagnostics) {}

    /// True if everything was placed.
    bool run() {
        world_.prototypes.reserve(plan_.prototypes.size());
        for (const NodeId id : plan_.prototypes) {
            if (error_count_ < kMaxFlattenErrors) add_prototype(id);
        }
        if (error_count_ < kMaxFlattenErrors) {
            world_.node_id = scene_.root;
            Placer placer(scene_, space_rule_, world_, diagnostics_);
            GraphWalk walk(scene_, plan_, prototypes_, placer, &world_.lights, diagnostics_);
            walk.place(scene_.root);
            placer.finish();
            error_count_ += walk.error_count();
        }
        return error_count_ == 0;
    }

 private:
    void add_prototype(NodeId id) {
        Prototype prototype;
        prototype.index = static_cast<std::uint32_t>(prototypes_.size());
        Geometry geometry = make_prototype(id, prototype, diagnostics_);
        prototype.bounds = finite_bounds(geometry);
        if (const auto middle = far_middle(prototype.bounds)) {
            prototype.origin_object = *middle;
            Diagnostics told_already;
            geometry = make_prototype(id, prototype, told_already);
            prototype.bounds = finite_bounds(geometry);
        }
        prototype.place_count = geometry.place_count;
        shrink(geometry);
        prototypes_.push_back(prototype);
        world_.prototypes.push_back(std::move(geometry));
    }

    Geometry make_prototype(NodeId id, Prototype& prototype, Diagnostics& diagnostics) {
        Geometry geometry;
        geometry.node_id = id;
        Placement placement;
        placement.world_from_object = Transform::translation(-prototype.origin_object);
        placement.material = Object::kInherited;
        Placer placer(scene_, space_rule_, geometry, diagnostics);
        GraphWalk walk(scene_, plan_, prototypes_, placer, nullptr, diagnostics);
        walk.place_content(id, placement);
        placer.finish();
        prototype.thinness = placer.thinness();
        error_count_ += walk.error_count();
        return geometry;
    }

    const Scene& scene_;
    const FlattenPlan& plan_;
    ObjectSpaceRule space_rule_;
    World& world_;
    Diagnostics& diagnostics_;
    std::vector<Prototype> prototypes_{};
    std::size_t error_count_ = 0;
};

}  // namespace

std::optional<World> flatten(const Scene& scene, const FlattenLimits& limits,
                             Diagnostics& diagnostics) {
    LRAY_ASSERT(!scene.root.is_none());
    const FlattenPlan plan = plan_flatten(scene, limits.sharing);
    if (!is_within(plan, limits, scene, diagnostics)) return std::nullopt;

    std::optional<World> world(std::in_place);
    world->materials.reserve(scene.materials.size() + 1);
    world->materials.emplace_back();
    world->materials.insert(world->materials.end(), scene.materials.begin(), scene.materials.end());
    world->textures = scene.textures;
    world->pictures = scene.pictures;
    reserve(*world, plan.counts);
    if (!Flattening(scene, plan, limits.spaces, *world, diagnostics).run()) return std::nullopt;
    return world;
}

}  // namespace lray::scene
