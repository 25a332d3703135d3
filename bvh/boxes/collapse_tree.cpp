#include "bvh/boxes/collapse_tree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/assert.h"
#include "bvh/boxes/box_tree.h"
#include "bvh/boxes/split_cost.h"

namespace lray::bvh {

namespace {

/// Subtrees over more references are made by tasks of their own.
constexpr std::uint32_t kTaskCount = 1u << 13;

BoxChildKind leaf_kind(RefClass ref_class) {
    switch (ref_class) {
        case RefClass::triangle:
            return BoxChildKind::triangles;
        case RefClass::sphere:
            return BoxChildKind::spheres;
        case RefClass::framed:
            return BoxChildKind::framed;
        case RefClass::instance:
            break;
    }
    return BoxChildKind::instances;
}

std::uint32_t leaf_size(BoxChildKind kind, std::uint32_t ref_count) {
    const bool is_in_blocks = kind == BoxChildKind::triangles || kind == BoxChildKind::spheres;
    return is_in_blocks ? (ref_count + kBoxWidth - 1) / kBoxWidth : ref_count;
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

/// The children of a wide node.
struct Children {
    std::array<const BinaryNode*, kBoxWidth> nodes{};
    std::size_t count = 0;

    /// Adds a subtree as at most so many children.
    // NOLINTNEXTLINE(misc-no-recursion): kBoxWidth deep at most
    void add(const BinaryNode& node, unsigned slots) {
        while (slots > 1 && node.left != nullptr && node.slots_of_left(slots) == 0) --slots;
        if (slots == 1 || node.left == nullptr) {
            nodes[count++] = &node;
            return;
        }
        const unsigned of_left = node.slots_of_left(slots);
        add(*node.left, of_left);
        add(*node.right, slots - of_left);
    }
};

class Collapser {
 public:
    explicit Collapser(std::span<BuildRef> refs) : refs_(refs) {}

    /// Makes what is below a node: of large ones by a task for each child.
    // NOLINTNEXTLINE(misc-no-recursion): kMaxBoxDepth deep at most
    WidePart run(const BinaryNode& root, std::uint32_t depth) {
        const bool has_branches = root.count() >= kTaskCount && !root.is_leaf;
        part_.root = has_branches ? branch(root, depth) : make(root, depth);
        part_.counts.nodes = static_cast<std::uint32_t>(part_.nodes.size());
        return std::move(part_);
    }

 private:
    // NOLINTNEXTLINE(misc-no-recursion): kMaxBoxDepth deep at most
    BoxChild make(const BinaryNode& node, std::uint32_t depth) {
        part_.depth = std::max(part_.depth, depth);
        if (node.is_leaf) return make_leaf_of(node);
        const Children children = add_node(node, depth);
        const std::size_t index = part_.nodes.size() - 1;
        for (std::size_t lane = 0; lane < children.count; ++lane) {
            const BoxChild child = make(*children.nodes[lane], depth + 1);
            part_.nodes[index].children[lane] = child;
        }
        return make_node(index);
    }

    // NOLINTNEXTLINE(misc-no-recursion): kMaxBoxDepth deep at most
    BoxChild branch(const BinaryNode& node, std::uint32_t depth) {
        const Children children = add_node(node, depth);
        part_.branches.resize(children.count);
        tbb::parallel_for(
            std::size_t{0}, children.count,
            [&](std::size_t lane) {
                part_.branches[lane] = {lane,
                                        Collapser(refs_).run(*children.nodes[lane], depth + 1)};
            },
            tbb::simple_partitioner{});
        return 0;
    }

    /// Adds a node with the boxes of its children.
    Children add_node(const BinaryNode& node, std::uint32_t depth) {
        LRAY_ASSERT(depth < kMaxBoxDepth && part_.nodes.size() < kMaxBoxNodes);
        const unsigned of_left = node.slots_of_left(kBoxWidth);
        Children children;
        children.add(*node.left, of_left);
        children.add(*node.right, kBoxWidth - of_left);
        part_.nodes.push_back(empty_node());
        for (std::size_t lane = 0; lane < children.count; ++lane) {
            set_box(part_.nodes.back(), lane, children.nodes[lane]->box);
        }
        part_.cost += half_area(node.box) * kNodeCost;
        return children;
    }

    BoxChild make_leaf_of(const BinaryNode& node) {
        if (node.left != nullptr) gather(node);
        const BoxChildKind kind = leaf_kind(node.ref_class);
        const std::uint32_t size = leaf_size(kind, node.count());
        std::uint32_t& next = part_.counts.of(kind);
        LRAY_ASSERT(size > 0 && size <= kMaxLeafCount && next <= kMaxLeafFirst - size);
        const BoxChild leaf = make_leaf(kind, size, next);
        next += size;
        part_.leaves.push_back({node.first, node.count(), kind});
        part_.ref_count += node.count();
        const std::uint32_t weight = kRefWeights[static_cast<std::size_t>(node.ref_class)];
        part_.cost += half_area(node.box) * leaf_cost(std::uint64_t{node.count()} * weight);
        return leaf;
    }

    static void set_box(BoxNode& node, std::size_t lane, const Box4& box) {
        float lower[4];
        float upper[4];
        store_four(lower, box.lower);
        store_four(upper, box.upper);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            node.planes[axis][0][lane] = lower[axis];
            node.planes[axis][1][lane] = upper[axis];
        }
    }

    /// Brings the references of a leaf that was divided before it became one together again; those
    /// of the same triangle, cut in two below, become one.
    void gather(const BinaryNode& leaf) {
        BuildRef* const begin = refs_.data() + leaf.first;
        BuildRef* end = begin;
        append(leaf, end);
        if (static_cast<std::size_t>(end - begin) == leaf.count()) return;
        const auto key = [](const BuildRef& ref) { return std::pair(ref.id, ref.tag); };
        std::ranges::sort(begin, end, {}, key);
        end = std::ranges::unique(begin, end, {}, key).begin();
        LRAY_ASSERT(static_cast<std::size_t>(end - begin) == leaf.count());
    }

    /// Moves references to the front only: what is divided lies in the stretch of its parent.
    // NOLINTNEXTLINE(misc-no-recursion): kMaxBoxDepth deep at most
    void append(const BinaryNode& node, BuildRef*& end) {
        if (node.left != nullptr) {
            append(*node.left, end);
            append(*node.right, end);
            return;
        }
        const BuildRef* const from = refs_.data() + node.first;
        if (from == end) {
            end += node.count();
        } else {
            end = std::copy_n(from, node.count(), end);
        }
    }

    std::span<BuildRef> refs_;
    WidePart part_{};
};

}  // namespace

WidePart collapse_tree(const BinaryTree& tree, std::span<BuildRef> refs) {
    return Collapser(refs).run(*tree.root, 1);
}

}  // namespace lray::bvh
