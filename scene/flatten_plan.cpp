#include "scene/flatten_plan.h"

#include <algorithm>
#include <utility>

namespace lray::scene {

namespace {

constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();

std::uint64_t saturating_multiply(std::uint64_t a, std::uint64_t b) {
    return b != 0 && a > kMost / b ? kMost : a * b;
}

void add(std::uint64_t& sum, std::uint64_t x) {
    sum = sum > kMost - x ? kMost : sum + x;
}

class Planner {
 public:
    Planner(const Scene& scene, const SharingRule& rule)
        : scene_(scene), rule_(rule), plan_{ContentMap(scene)} {
        plan_.prototype_of.assign(contents().count(), FlattenPlan::kNotShared);
    }

    FlattenPlan make() {
        count_paths();
        choose();
        count_stored();
        number_prototypes();
        count_places();
        return std::move(plan_);
    }

 private:
    const ContentMap& contents() const { return plan_.contents; }
    std::size_t content_of(NodeId id) const { return contents().content_of(scene_.node(id)); }

    bool leads_to_something(const Node& node) const {
        return contents().has_primitive(node) || contents().has_light(node);
    }

    /// Calls visit(content, node, children) from the root down.
    template <class Visit>
    void from_above(Visit visit) const {
        const std::vector<NodeId>& order = contents().below_first();
        for (auto id = order.rbegin(); id != order.rend(); ++id) {
            const Node& node = scene_.node(*id);
            if (leads_to_something(node)) {
                visit(contents().content_of(node), node, children_of(scene_, node));
            }
        }
    }

    /// Every path to a content counts, and to a light.
    void count_paths() {
        paths_.resize(contents().count());
        paths_[content_of(scene_.root)] = 1;
        from_above([&](std::size_t content, const Node& node, std::span<const NodeId> children) {
            const std::uint64_t paths = paths_[content];
            if (contents().has_light(node)) add(plan_.counts.visits, paths);
            for (const NodeId child_id : children) {
                const Node& child = scene_.node(child_id);
                if (ContentMap::has_content(child)) {
                    add(paths_[contents().content_of(child)], paths);
                } else if (child.kind == NodeKind::light) {
                    add(plan_.counts.lights, paths);
                    add(plan_.counts.visits, paths);
                }
            }
        });
    }

    /// What a content would hold if it were shared.
    struct Holding {
        std::uint64_t primitives = 0;  // an instance in it is one
        std::uint32_t depth = 0;       // of instances in it
    };

    void choose(std::size_t content, const Holding& holding) {
        const std::uint64_t paths = paths_[content];
        const bool is_worth_it =
            paths > 1 && holding.primitives >= rule_.min_primitives &&
            saturating_multiply(paths - 1, holding.primitives) >= rule_.min_saved;
        const bool is_too_deep = holding.depth >= kMaxInstanceDepth;
        is_shared_[content] = is_worth_it && !is_too_deep;
        plan_.is_nested_too_deep = plan_.is_nested_too_deep || (is_worth_it && is_too_deep);
    }

    void choose() {
        holdings_.resize(contents().count());
        is_shared_.resize(contents().count());
        for (const NodeId id : contents().first_nodes()) {
            if (id.is_none() || scene_.node(id).kind != NodeKind::mesh) continue;
            Holding& holding = holdings_[content_of(id)];
            holding.primitives = triangle_count(scene_, scene_.mesh_uses[scene_.node(id).index]);
            choose(content_of(id), holding);
        }
        for (const NodeId id : contents().below_first()) {
            const Node& node = scene_.node(id);
            const std::size_t content = contents().content_of(node);
            if (!contents().has_plane(node)) {
                holdings_[content] = holding_of(node, true);
                choose(content, holdings_[content]);
            }
            if (!is_shared_[content]) holdings_[content] = holding_of(node, false);
        }
    }

    /// `is_with_own`: what is shared already but only ever met in this node, once, becomes part of
    /// it.
    Holding holding_of(const Node& node, bool is_with_own) const {
        const std::uint64_t paths = paths_[contents().content_of(node)];
        Holding result;
        for (const NodeId child_id : children_of(scene_, node)) {
            const Node& child = scene_.node(child_id);
            if (!ContentMap::has_content(child)) {
                add(result.primitives, child.kind == NodeKind::light ? 0 : 1);
                continue;
            }
            const std::size_t below = contents().content_of(child);
            const bool is_own = is_with_own && paths_[below] == paths && paths < kMost;
            const bool is_instance = is_shared_[below] && !is_own;
            add(result.primitives, is_instance ? 1 : holdings_[below].primitives);
            result.depth = std::max(result.depth, holdings_[below].depth + (is_instance ? 1 : 0));
        }
        return result;
    }

    /// How often a content is stored or, shared, placed by a stored instance; of both those in the
    /// world's own space.
    struct Uses {
        std::uint64_t all = 0;
        std::uint64_t in_world = 0;
    };

    /// A content that is met once in all that is stored stays with what is around it.
    void count_stored() {
        uses_.resize(contents().count());
        uses_[content_of(scene_.root)] = {1, 1};
        FlattenCounts& counts = plan_.counts;
        from_above([&](std::size_t content, const Node& node, std::span<const NodeId> children) {
            if (!contents().has_primitive(node)) return;
            Uses stored = uses_[content];
            if (stored.all == 1) is_shared_[content] = false;
            if (is_shared_[content]) {
                add(counts.visits, stored.all);
                add(counts.primitives, stored.all);
                add(counts.world_instances, stored.in_world);
                stored = {1, 0};
            }
            add(counts.visits, stored.all);
            for (const NodeId child_id : children) {
                const Node& child = scene_.node(child_id);
                if (!ContentMap::is_inner(child)) add(counts.visits, stored.all);
                if (ContentMap::has_content(child)) {
                    Uses& below = uses_[contents().content_of(child)];
                    add(below.all, stored.all);
                    add(below.in_world, stored.in_world);
                } else if (child.kind != NodeKind::light) {
                    add(counts.primitives, stored.all);
                    add(counts.world_shapes[static_cast<std::size_t>(child.kind)], stored.in_world);
                }
            }
        });
        for (const NodeId id : contents().first_nodes()) {
            if (!id.is_none() && scene_.node(id).kind == NodeKind::mesh) count_mesh(content_of(id));
        }
    }

    void count_mesh(std::size_t content) {
        FlattenCounts& counts = plan_.counts;
        const Uses uses = uses_[content];
        const std::uint64_t triangles = holdings_[content].primitives;
        if (uses.all <= 1) is_shared_[content] = false;
        if (is_shared_[content]) {
            add(counts.primitives, triangles);
            add(counts.primitives, uses.all);
            add(counts.world_instances, uses.in_world);
        } else {
            add(counts.primitives, saturating_multiply(triangles, uses.all));
            add(counts.world_shapes[static_cast<std::size_t>(NodeKind::mesh)], uses.in_world);
            add(counts.world_mesh_triangles, saturating_multiply(triangles, uses.in_world));
        }
    }

    /// Meshes first: they use nothing.
    void number_prototypes() {
        const auto number = [&](NodeId id) {
            if (id.is_none() || !is_shared_[content_of(id)]) return;
            plan_.prototype_of[content_of(id)] =
                static_cast<std::uint32_t>(plan_.prototypes.size());
            plan_.prototypes.push_back(id);
        };
        for (const NodeId id : contents().first_nodes()) {
            if (!id.is_none() && scene_.node(id).kind == NodeKind::mesh) number(id);
        }
        for (const NodeId id : contents().below_first()) number(id);
    }

    void count_places() {
        if (plan_.prototypes.empty()) return;
        std::vector<std::uint64_t> below(contents().count());  // places of instances in a content
        for (const NodeId id : contents().below_first()) {
            std::uint64_t places = 0;
            for (const NodeId child_id : children_of(scene_, scene_.node(id))) {
                if (!ContentMap::has_content(scene_.node(child_id))) continue;
                const std::size_t child = content_of(child_id);
                add(places, below[child]);
                add(places, is_shared_[child] ? 1 : 0);
            }
            below[content_of(id)] = places;
        }
        add(plan_.counts.places, below[content_of(scene_.root)]);
    }

    const Scene& scene_;
    const SharingRule& rule_;
    FlattenPlan plan_;
    // By content:
    std::vector<std::uint64_t> paths_{};
    std::vector<Holding> holdings_{};
    std::vector<bool> is_shared_{};
    std::vector<Uses> uses_{};
};

}  // namespace

FlattenPlan plan_flatten(const Scene& scene, const SharingRule& rule) {
    return Planner(scene, rule).make();
}

}  // namespace lray::scene
