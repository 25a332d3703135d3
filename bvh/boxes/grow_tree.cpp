#include "bvh/boxes/grow_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "base/assert.h"
#include "bvh/boxes/binned_split.h"
#include "bvh/boxes/box_tree.h"
#include "bvh/boxes/split_cost.h"

namespace lray::bvh {

namespace {

/// From this depth on sets are halved by count: of 2^29 references, eight halves of halves of
/// halves a node, leaves of one class are at most 10 further down.
constexpr std::uint32_t kHalvingDepth = kMaxBoxDepth - 16;

/// A child of a node that is being made, and how it will be divided.
struct Candidate {
    RefSet set{};
    Split split{};
    double area = 0.0;
};

BoxChildKind leaf_kind(RefClass ref_class) {
    return ref_class == RefClass::triangle ? BoxChildKind::triangles
           : ref_class == RefClass::sphere ? BoxChildKind::spheres
                                           : BoxChildKind::list;
}

std::uint32_t leaf_size(BoxChildKind kind, std::uint32_t ref_count) {
    return kind == BoxChildKind::list ? ref_count : (ref_count + kBoxWidth - 1) / kBoxWidth;
}

BoxNode empty_node() {
    BoxNode node;
    for (auto& axis : node.planes) {
        std::ranges::fill(axis[0], kInfinity);
        std::ranges::fill(axis[1], -kInfinity);
    }
    std::ranges::fill(node.children, 0u);
    return node;
}

class Grower {
 public:
    Grower(std::span<BuildRef> refs, BuildQuality quality) : refs_(refs), quality_(quality) {}

    GrownPart run(const Candidate& root) {
        part_.root = grow(root, 1);
        part_.counts.nodes = static_cast<std::uint32_t>(part_.nodes.size());
        return std::move(part_);
    }

    Candidate make_candidate(const RefSet& set, std::uint32_t depth) const {
        Candidate result;
        result.set = set;
        result.area = half_area(set.summary.box);
        if (depth < kHalvingDepth) {
            result.split = find_split(refs_, set, quality_);
        } else if (!can_be_leaf(set)) {
            result.split.kind =
                set.summary.is_of_one_class() ? SplitKind::middle : SplitKind::by_class;
        }
        return result;
    }

 private:
    // NOLINTNEXTLINE(misc-no-recursion): kMaxBoxDepth deep at most
    BoxChild grow(const Candidate& candidate, std::uint32_t depth) {
        part_.depth = std::max(part_.depth, depth);
        if (candidate.split.kind == SplitKind::none) return make_leaf_of(candidate);
        LRAY_ASSERT(depth < kMaxBoxDepth);
        std::array<Candidate, kBoxWidth> children;
        const std::size_t count = divide_wide(candidate, depth, children);
        const std::size_t index = part_.nodes.size();
        LRAY_ASSERT(index < kMaxBoxNodes);
        part_.nodes.push_back(empty_node());
        part_.cost += candidate.area * kNodeCost;
        for (std::size_t lane = 0; lane < count; ++lane) {
            const BoxChild child = grow(children[lane], depth + 1);
            set_child(part_.nodes[index], lane, children[lane].set.summary.box, child);
        }
        return static_cast<BoxChild>(index);
    }

    /// Divides the largest until there are as many as fit a node.
    std::size_t divide_wide(const Candidate& parent, std::uint32_t depth,
                            std::array<Candidate, kBoxWidth>& children) {
        children[0] = parent;
        std::size_t count = 1;
        while (count < kBoxWidth) {
            std::size_t chosen = kBoxWidth;
            for (std::size_t i = 0; i < count; ++i) {
                if (children[i].split.kind == SplitKind::none) continue;
                if (chosen == kBoxWidth || is_larger(children[i], children[chosen], depth + 1)) {
                    chosen = i;
                }
            }
            if (chosen == kBoxWidth) break;
            const TwoSets sides = divide(refs_, children[chosen].set, children[chosen].split);
            // Keeps the order of the array.
            for (std::size_t i = count; i > chosen + 1; --i) children[i] = children[i - 1];
            children[chosen] = make_candidate(sides.left, depth + 1);
            children[chosen + 1] = make_candidate(sides.right, depth + 1);
            ++count;
        }
        return count;
    }

    static bool is_larger(const Candidate& a, const Candidate& b, std::uint32_t depth) {
        if (depth < kHalvingDepth && a.area != b.area) return a.area > b.area;
        return a.set.count() > b.set.count();
    }

    BoxChild make_leaf_of(const Candidate& candidate) {
        const RefSet& set = candidate.set;
        LRAY_ASSERT(can_be_leaf(set));
        const BoxChildKind kind = leaf_kind(set.summary.only_class());
        const std::uint32_t size = leaf_size(kind, set.count());
        std::uint32_t& next = part_.counts.of(kind);
        LRAY_ASSERT(next <= kMaxLeafFirst - size);
        const BoxChild leaf = make_leaf(kind, size, next);
        next += size;
        part_.leaves.push_back({set.first, set.count(), kind});
        ++part_.leaf_count;
        part_.ref_count += set.count();
        const auto ref_class = static_cast<std::size_t>(set.summary.only_class());
        part_.cost +=
            candidate.area * block_count(std::uint64_t{set.count()} * kRefWeights[ref_class]);
        return leaf;
    }

    static void set_child(BoxNode& node, std::size_t lane, const Box4& box, BoxChild child) {
        float lower[4];
        float upper[4];
        store_four(lower, box.lower);
        store_four(upper, box.upper);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            node.planes[axis][0][lane] = lower[axis];
            node.planes[axis][1][lane] = upper[axis];
        }
        node.children[lane] = child;
    }

    std::span<BuildRef> refs_;
    BuildQuality quality_;
    GrownPart part_{};
};

}  // namespace

GrownPart grow_tree(std::vector<BuildRef>& refs, BuildQuality quality) {
    const auto count = static_cast<std::uint32_t>(refs.size());
    const RefSet all{0, count, summarize(refs)};
    Grower grower(refs, quality);
    return grower.run(grower.make_candidate(all, 1));
}

}  // namespace lray::bvh
