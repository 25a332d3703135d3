// The walk down a hierarchy, and on into its instances, to the volumes of one level.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "bvh/bounding_volume.h"
#include "scene/world.h"

namespace lray::bvh {

/// The map from the space of a prototype, in one of its places, to the world.
struct Placement {
    DMat3 linear{1.0};
    DVec3 offset{0.0};

    Placement inside(const scene::AffineFrame& frame) const {
        return {linear * glm::inverse(DMat3{frame.object_from_world}),
                linear * DVec3{frame.origin} + offset};
    }
    BoundingVolume carried(BoundingVolume volume) const {
        volume.center = linear * volume.center + offset;
        for (DVec3& axis : volume.half_axes) axis = linear * axis;
        return volume;
    }
};

inline bool is_finite(const BoundingVolume& volume) {
    DVec3 sum = volume.center;
    for (const DVec3& axis : volume.half_axes) sum += glm::abs(axis);
    return std::isfinite(sum.x) && std::isfinite(sum.y) && std::isfinite(sum.z);
}

/// The cut through the trees of a world. What it asks of them:
///     Part, Node                  a `geometry` with its tree, and a node of it
///     world(), prototype(i)       -> const Part&
///     prototype_count()
///     depth(part)                 -> std::uint32_t, nodes on the longest path
///     root(part)                  -> std::optional<Node>; none of an empty tree
///     is_leaf(part, node)
///     each_child(part, node, f)   of an inner node: f(Node)
///     each_object(part, node, f)  of a leaf: f(const scene::WorldInstance*), null for primitives
///     volume(part, node)          -> BoundingVolume, shape and extent, in the space of the part
/// A leaf with instances counts as an inner node, whose children are the roots of what those place;
/// with primitives beside them it is a leaf of these as well. Instances of nothing count as
/// primitives.
template <class Trees>
class VolumeCut {
 public:
    explicit VolumeCut(const Trees& trees) : trees_(trees) {}

    /// Returns the cut, without its level_count. Goes down level by level, and puts the volumes
    /// below one in its place as long as there is room for all of them. Memory is in proportion to
    /// `max_count` at most, and time to that and the depth of instances: whatever is looked at has
    /// two below it, or one instance.
    BoundingVolumes run(std::uint32_t level, std::size_t max_count) {
        const std::optional<Node> root = trees_.root(trees_.world());
        if (!root) return {};
        if (max_count == 0) return {{}, true, 0};
        std::vector<Step> steps{{*root, &trees_.world()}};
        for (std::uint32_t depth = 0; depth < level && !steps.empty(); ++depth) {
            steps = one_level_down(steps, max_count);
            if (result_.is_cut_short) break;
        }
        for (const Step& step : steps) add(step, !leads_on(step));
        return std::move(result_);
    }

    /// Returns how many levels there are until nothing is added. No more than kMaxInstanceDepth
    /// trees lie below one of the world: the sum of their depths is a small number.
    std::uint32_t count_levels() {
        level_counts_.reserve(trees_.prototype_count());
        for (std::uint32_t i = 0; i < trees_.prototype_count(); ++i) {
            level_counts_.push_back(levels_of(trees_.prototype(i)));
        }
        return levels_of(trees_.world());
    }

 private:
    using Node = typename Trees::Node;
    using Part = typename Trees::Part;

    struct Step {
        Node node{};
        const Part* part = nullptr;
        std::uint32_t depth = 0;
        bool is_instance = false;
        Placement placement{};
    };

    std::optional<Node> root_of(const scene::WorldInstance* instance) const {
        if (instance == nullptr) return std::nullopt;
        return trees_.root(trees_.prototype(instance->prototype));
    }

    bool leads_on(const Step& step) const {
        if (!trees_.is_leaf(*step.part, step.node)) return true;
        bool result = false;
        trees_.each_object(*step.part, step.node, [&](const scene::WorldInstance* instance) {
            result |= root_of(instance).has_value();
        });
        return result;
    }

    std::vector<Step> one_level_down(const std::vector<Step>& steps, std::size_t max_count) {
        std::vector<Step> next;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            if (result_.is_cut_short) {
                next.push_back(steps[i]);
                continue;
            }
            if (!leads_on(steps[i])) {
                add(steps[i], true);
                continue;
            }
            const std::size_t next_size = next.size();
            const std::size_t result_size = result_.volumes.size();
            enter(steps[i], next);
            const std::size_t waiting_count = steps.size() - i - 1;
            if (result_.volumes.size() + next.size() + waiting_count <= max_count) continue;
            result_.is_cut_short = true;
            next.resize(next_size);
            result_.volumes.resize(result_size);
            next.push_back(steps[i]);
        }
        return next;
    }

    void enter(const Step& step, std::vector<Step>& next) {
        const std::uint32_t depth = step.depth + 1;
        if (!trees_.is_leaf(*step.part, step.node)) {
            trees_.each_child(*step.part, step.node, [&](const Node& child) {
                next.push_back({child, step.part, depth, false, step.placement});
            });
            return;
        }
        bool has_primitives = false;
        trees_.each_object(*step.part, step.node, [&](const scene::WorldInstance* instance) {
            const std::optional<Node> root = root_of(instance);
            if (!root) {
                has_primitives = true;
                return;
            }
            next.push_back({*root, &trees_.prototype(instance->prototype), depth, true,
                            step.placement.inside(instance->frame)});
        });
        if (has_primitives) add(step, true);
    }

    void add(const Step& step, bool is_leaf) {
        BoundingVolume volume = step.placement.carried(trees_.volume(*step.part, step.node));
        // Frames within frames overflowed, and rays do not come through them either.
        if (!is_finite(volume)) return;
        volume.is_leaf = is_leaf;
        volume.is_instance = step.is_instance;
        volume.depth = step.depth;
        result_.volumes.push_back(volume);
    }

    /// Those of the prototypes that the part uses are known.
    std::uint32_t levels_of(const Part& part) const {
        const std::optional<Node> root = trees_.root(part);
        if (!root) return 0;
        if (part.geometry->instances.empty()) return trees_.depth(part);
        std::uint32_t result = 0;
        std::vector<std::pair<Node, std::uint32_t>> waiting{{*root, 1}};
        while (!waiting.empty()) {
            const auto [node, level] = waiting.back();
            waiting.pop_back();
            std::uint32_t below = 0;
            if (trees_.is_leaf(part, node)) {
                trees_.each_object(part, node, [&](const scene::WorldInstance* instance) {
                    if (instance == nullptr) return;
                    below = std::max(below, level_counts_[instance->prototype]);
                });
            } else {
                trees_.each_child(part, node, [&, next = level + 1](const Node& child) {
                    waiting.emplace_back(child, next);
                });
            }
            result = std::max(result, level + below);
        }
        return result;
    }

    const Trees& trees_;
    BoundingVolumes result_{};
    std::vector<std::uint32_t> level_counts_{};  // by prototype
};

/// How many levels a hierarchy has, counted when it is first asked for: tracing does without.
class LevelCount {
 public:
    template <class Trees>
    std::uint32_t of(const Trees& trees) const {
        std::call_once(is_counted_, [&] { count_ = VolumeCut(trees).count_levels(); });
        return count_;
    }

 private:
    mutable std::once_flag is_counted_{};
    mutable std::uint32_t count_ = 0;
};

/// Returns the cut through the trees of a world at a level.
template <class Trees>
BoundingVolumes cut_volumes(const Trees& trees, const LevelCount& level_count, std::uint32_t level,
                            std::size_t max_count) {
    BoundingVolumes result = VolumeCut(trees).run(level, max_count);
    result.level_count = level_count.of(trees);
    return result;
}

}  // namespace lray::bvh
