#include "bvh/boxes/binary_tree.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

#include "base/assert.h"
#include "bvh/boxes/binned_split.h"
#include "bvh/boxes/box_tree.h"
#include "bvh/boxes/spatial_split.h"
#include "bvh/boxes/split_cost.h"

namespace lray::bvh {

namespace {

/// Subtrees over more references are made by tasks of their own.
constexpr std::uint32_t kTaskCount = 1u << 12;

/// Levels that a set may need beside those of halving it: one for each class it is parted from, and
/// one for halves that are rounded up to blocks.
constexpr std::uint32_t kSpareLevels = kRefClassCount;

/// The cost of a subtree as at most so many children of one wide node, from 1 on.
using CostBySlots = std::array<double, kBoxWidth>;

struct Subtree {
    const BinaryNode* node = nullptr;
    CostBySlots costs{};
};

class Builder {
 public:
    Builder(const SplitRules& rules, std::span<BuildRef> refs) : rules_(rules), refs_(refs) {}

    BinaryTree run(const RefSet& all) {
        BinaryTree tree;
        tree.root = build(all, 1).node;
        for (BinaryNodes& nodes : nodes_) tree.nodes.push_back(std::move(nodes));
        return tree;
    }

 private:
    // NOLINTNEXTLINE(misc-no-recursion): kMaxBoxDepth deep at most
    Subtree build(const RefSet& set, std::uint32_t depth) {
        LRAY_ASSERT(depth <= kMaxBoxDepth);
        BinaryNode& node = nodes_.local().add();
        node.box = set.summary.box;
        node.first = set.first;
        node.last = set.last;
        const double area = rules_.measure(set.summary.box);
        const double leaf_cost = cost_of_leaf(set, area);
        Subtree result{&node, {}};
        const Split split = choose_split(set, depth);
        if (split.kind == SplitKind::none) {
            node.ref_class = set.summary.only_class();
            result.costs.fill(leaf_cost);
            return result;
        }
        const TwoSets sides = divide_set(set, split);
        Subtree left;
        Subtree right;
        if (set.count() >= kTaskCount) {
            tbb::parallel_invoke([&] { left = build(sides.left, depth + 1); },
                                 [&] { right = build(sides.right, depth + 1); });
        } else {
            left = build(sides.left, depth + 1);
            right = build(sides.right, depth + 1);
        }
        node.left = left.node;
        node.right = right.node;
        result.costs = share_slots(node, left.costs, right.costs);
        const double inner_cost = result.costs[0] + area * kNodeCost;
        // Of boxes that reach to infinity both may be infinite.
        node.is_leaf = can_be_leaf(set) && leaf_cost <= inner_cost;
        if (node.is_leaf) node.ref_class = set.summary.only_class();
        result.costs[1] = std::min(leaf_cost, inner_cost);
        for (std::size_t slots = 2; slots < kBoxWidth; ++slots) {
            if (result.costs[slots] < result.costs[slots - 1]) continue;
            result.costs[slots] = result.costs[slots - 1];
            node.left_slots &= ~(15u << 4 * (slots - 2));
        }
        return result;
    }

    TwoSets divide_set(const RefSet& set, const Split& split) const {
        if (split.kind != SplitKind::cut) return divide(refs_, set, split);
        const TwoSets sides = divide_by_cut(rules_.geometry, refs_, set, split);
        if (sides.left.count() > 0 && sides.right.count() > 0) return sides;
        // All have come to lie on one side, and nothing was cut.
        return divide(refs_, set, Split{.kind = SplitKind::middle});
    }

    /// Infinite for what has to be divided.
    static double cost_of_leaf(const RefSet& set, double area) {
        if (!can_be_leaf(set)) return std::numeric_limits<double>::infinity();
        const auto ref_class = static_cast<std::size_t>(set.summary.only_class());
        return area * leaf_cost(std::uint64_t{set.count()} * kRefWeights[ref_class]);
    }

    Split choose_split(const RefSet& set, std::uint32_t depth) const {
        // Halving it from here on has to end in time.
        const auto levels = static_cast<std::uint32_t>(std::bit_width(set.count()));
        if (depth + levels + kSpareLevels < kMaxBoxDepth) {
            return find_split(rules_, refs_, set);
        }
        Split split;
        if (!can_be_leaf(set)) {
            split.kind = set.summary.is_of_one_class() ? SplitKind::middle : SplitKind::by_class;
        }
        return split;
    }

    /// Finds for each number of slots how many each side had best. Returns the costs; the first is
    /// that of all slots of a wide node.
    /// Source: Ylitie, Karras, Laine 2017, "Efficient Incoherent Ray Traversal on GPUs Through
    /// Compressed Wide BVHs", sec. 3.1.
    static CostBySlots share_slots(BinaryNode& node, const CostBySlots& left,
                                   const CostBySlots& right) {
        CostBySlots costs;
        costs[1] = std::numeric_limits<double>::infinity();
        for (std::size_t slots = 2; slots <= kBoxWidth; ++slots) {
            double least = std::numeric_limits<double>::infinity();
            std::uint32_t choice = 1;
            for (std::size_t of_left = 1; of_left < slots; ++of_left) {
                const double cost = left[of_left] + right[slots - of_left];
                if (cost < least) {
                    least = cost;
                    choice = static_cast<std::uint32_t>(of_left);
                }
            }
            costs[slots % kBoxWidth] = least;
            node.left_slots |= choice << 4 * (slots - 2);
        }
        return costs;
    }

    const SplitRules& rules_;
    std::span<BuildRef> refs_;
    tbb::enumerable_thread_specific<BinaryNodes> nodes_{};
};

}  // namespace

BinaryNode& BinaryNodes::add() {
    constexpr std::size_t kFirstChunk = 64;
    constexpr std::size_t kLastChunk = 4096;
    if (chunks_.empty() || chunks_.back().size() == chunks_.back().capacity()) {
        const std::size_t size =
            chunks_.empty() ? kFirstChunk : std::min(2 * chunks_.back().capacity(), kLastChunk);
        chunks_.emplace_back().reserve(size);
    }
    return chunks_.back().emplace_back();
}

BinaryTree build_binary_tree(const scene::Geometry& geometry, std::span<BuildRef> refs,
                             std::uint32_t count, BuildQuality quality) {
    LRAY_ASSERT(count > 0);
    const RefSet all{0, count, static_cast<std::uint32_t>(refs.size()),
                     summarize(refs.first(count))};
    const SplitRules rules{geometry, quality, Measure(all.summary.box)};
    return Builder(rules, refs).run(all);
}

}  // namespace lray::bvh
