#include "bvh/spheres/sphere_volumes.h"

#include <optional>

namespace lray::bvh {

namespace {

/// What VolumeCut asks of trees of spheres.
struct SphereTrees {
    using Part = SpherePart;
    using Node = std::uint32_t;  // index into SphereTree::nodes

    const SphereParts& parts;

    const Part& world() const { return parts.world; }
    const Part& prototype(std::uint32_t index) const { return parts.prototypes[index]; }
    std::size_t prototype_count() const { return parts.prototypes.size(); }

    static std::uint32_t depth(const Part& part) { return part.tree.depth; }
    static std::optional<Node> root(const Part& part) {
        if (part.tree.nodes.empty()) return std::nullopt;
        return 0;
    }
    static bool is_leaf(const Part& part, Node node) { return part.tree.nodes[node].is_leaf(); }

    template <class F>
    static void each_child(const Part& part, Node node, F f) {
        f(node + 1);
        f(part.tree.nodes[node].first);
    }

    template <class F>
    static void each_object(const Part& part, Node leaf, F f) {
        const SphereNode& node = part.tree.nodes[leaf];
        for (std::uint32_t i = 0; i < node.object_count; ++i) {
            const scene::PrimitiveId id = part.objects[node.first + i];
            f(id.kind() == scene::PrimitiveKind::instance ? &part.geometry->instances[id.index()]
                                                          : nullptr);
        }
    }

    static BoundingVolume volume(const Part& part, Node node) {
        const BoundingSphere& sphere = part.tree.nodes[node].sphere;
        BoundingVolume result;
        result.shape = BoundingVolume::Shape::ellipsoid;
        result.center = DVec3{sphere.center};
        for (int axis = 0; axis < 3; ++axis) {
            result.half_axes[static_cast<std::size_t>(axis)][axis] =
                static_cast<double>(sphere.radius);
        }
        return result;
    }
};

}  // namespace

BoundingVolumes sphere_volumes(const SphereParts& parts, const LevelCount& level_count,
                               std::uint32_t level, std::size_t max_count) {
    return cut_volumes(SphereTrees{parts}, level_count, level, max_count);
}

}  // namespace lray::bvh
