#include "bvh/boxes/box_volumes.h"

#include <optional>

namespace lray::bvh {

namespace {

/// What VolumeCut asks of trees of boxes.
struct BoxTrees {
    using Part = BoxPart;
    struct Node {
        BoxChild child = 0;
        Bounds box{};
    };

    const BoxParts& parts;

    const Part& world() const { return parts.world; }
    const Part& prototype(std::uint32_t index) const { return parts.prototypes[index]; }
    std::size_t prototype_count() const { return parts.prototypes.size(); }

    static std::uint32_t depth(const Part& part) { return part.tree.stats.depth; }
    static std::optional<Node> root(const Part& part) {
        if (part.tree.view.is_empty) return std::nullopt;
        return Node{part.tree.view.root, part.tree.box};
    }
    static bool is_leaf(const Part& /*part*/, const Node& node) {
        return kind_of(node.child) != BoxChildKind::node;
    }

    template <class F>
    static void each_child(const Part& part, const Node& node, F f) {
        const BoxNode& inner = node_of(part.tree.view, node.child);
        for (std::size_t lane = 0; lane < kBoxWidth; ++lane) {
            if (inner.planes[0][0][lane] == kInfinity) break;  // no more children
            f(Node{inner.children[lane], box_of(inner, lane)});
        }
    }

    template <class F>
    static void each_object(const Part& part, const Node& leaf, F f) {
        if (kind_of(leaf.child) != BoxChildKind::instances) {
            f(nullptr);
            return;
        }
        const std::uint32_t* const ids = part.tree.view.instances + leaf_first(leaf.child);
        for (std::uint32_t i = 0; i < leaf_count(leaf.child); ++i) {
            f(&part.geometry->instances[scene::PrimitiveId::of_value(ids[i]).index()]);
        }
    }

    static BoundingVolume volume(const Part& /*part*/, const Node& node) {
        const DVec3 low{node.box.min};
        const DVec3 high{node.box.max};
        BoundingVolume result;
        result.center = 0.5 * (low + high);
        for (int axis = 0; axis < 3; ++axis) {
            result.half_axes[static_cast<std::size_t>(axis)][axis] = 0.5 * (high[axis] - low[axis]);
        }
        return result;
    }
};

}  // namespace

BoundingVolumes box_volumes(const BoxParts& parts, const LevelCount& level_count,
                            std::uint32_t level, std::size_t max_count) {
    return cut_volumes(BoxTrees{parts}, level_count, level, max_count);
}

}  // namespace lray::bvh
