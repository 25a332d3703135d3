#include "scene/blocker_tree.h"

#include <algorithm>
#include <array>

#include "base/assert.h"

namespace lray::scene {

namespace {

/// True if all of the box is to the right of the line from a to b. Rounded operations are
/// monotonic, so the same formula at the leftmost corner speaks for every point inside.
bool is_box_right_of(DVec2 a, DVec2 b, DVec2 low, DVec2 high) {
    const DVec2 leftmost(b.y - a.y > 0 ? low.x : high.x, b.x - a.x > 0 ? high.y : low.y);
    return orientation(a, b, leftmost) < 0;
}

}  // namespace

void BlockerTree::build(std::span<const Blocker> blockers, std::size_t corner_count) {
    blockers_.assign(blockers.begin(), blockers.end());
    leaves_.resize(corner_count);
    nodes_.assign(1, Node{});
    work_ = 0;
    build_node(0, 0, 0, static_cast<std::uint32_t>(blockers_.size()));
}

/// Halves by count, across the longer side: the depth is at most 32, so recursion is safe.
void BlockerTree::build_node(std::uint32_t index, std::uint32_t parent, std::uint32_t begin,
                             std::uint32_t end) {
    constexpr std::uint32_t kLeafSize = 8;
    Node node;
    node.begin = begin;
    node.left = end - begin;
    node.parent = parent;
    if (begin < end) node.low = node.high = blockers_[begin].point;
    for (std::uint32_t i = begin; i < end; ++i) {
        node.low = glm::min(node.low, blockers_[i].point);
        node.high = glm::max(node.high, blockers_[i].point);
    }
    if (end - begin <= kLeafSize) {
        // By corner: how nth_element() leaves them differs between libraries.
        std::sort(blockers_.begin() + std::ptrdiff_t{begin},
                  blockers_.begin() + std::ptrdiff_t{end},
                  [](const Blocker& a, const Blocker& b) { return a.corner < b.corner; });
        for (std::uint32_t i = begin; i < end; ++i) leaves_[blockers_[i].corner] = index;
        nodes_[index] = node;
        return;
    }
    node.children = static_cast<std::uint32_t>(nodes_.size());
    nodes_[index] = node;
    nodes_.resize(nodes_.size() + 2);

    const DVec2 size = node.high - node.low;
    const int axis = size.x >= size.y ? 0 : 1;
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::uint32_t i) { return blockers_.begin() + std::ptrdiff_t{i}; };
    // Equal coordinates by corner: the halves are the same with every library.
    std::nth_element(at(begin), at(middle), at(end), [axis](const Blocker& a, const Blocker& b) {
        return a.point[axis] != b.point[axis] ? a.point[axis] < b.point[axis] : a.corner < b.corner;
    });
    build_node(node.children, index, begin, middle);
    build_node(node.children + 1, index, middle, end);
}

std::uint32_t BlockerTree::find_in_triangle(DVec2 a, DVec2 b, DVec2 c) {
    const DVec2 low = glm::min(glm::min(a, b), c);
    const DVec2 high = glm::max(glm::max(a, b), c);
    std::array<std::uint32_t, 64> stack{};
    std::size_t stack_size = 1;
    while (stack_size > 0) {
        const Node& node = nodes_[stack[--stack_size]];
        ++work_;
        if (node.left == 0 || node.low.x > high.x || node.high.x < low.x || node.low.y > high.y ||
            node.high.y < low.y || is_box_right_of(a, b, node.low, node.high) ||
            is_box_right_of(b, c, node.low, node.high) ||
            is_box_right_of(c, a, node.low, node.high)) {
            continue;
        }
        if (node.children != 0) {
            stack[stack_size++] = node.children;
            stack[stack_size++] = node.children + 1;
            continue;
        }
        work_ += node.left;
        for (std::uint32_t i = node.begin; i < node.begin + node.left; ++i) {
            const DVec2 p = blockers_[i].point;
            if (p != a && p != b && p != c && orientation(a, b, p) >= 0 &&
                orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0) {
                return blockers_[i].corner;
            }
        }
    }
    return kNone;
}

void BlockerTree::remove(std::uint32_t corner) {
    std::uint32_t index = leaves_[corner];
    const auto first = blockers_.begin() + std::ptrdiff_t{nodes_[index].begin};
    const auto last = first + std::ptrdiff_t{nodes_[index].left};
    const auto found =
        std::find_if(first, last, [&](const Blocker& held) { return held.corner == corner; });
    LRAY_DCHECK(found != last);
    std::iter_swap(found, last - 1);
    for (;; index = nodes_[index].parent) {
        --nodes_[index].left;
        if (index == 0) return;
    }
}

}  // namespace lray::scene
