#include "bvh/spheres/sphere_tree.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <numeric>

#include "base/assert.h"

namespace lray::bvh {

namespace {

/// Below so many objects a task is not worth its making.
constexpr std::uint32_t kParallelCount = 4096;

/// In proportion to the area of the sphere around a box: the square of its radius.
double area_around(const Bounds& box) {
    const DVec3 diagonal = DVec3{box.max} - DVec3{box.min};
    return dot(diagonal, diagonal);
}

/// A way to split: the first `left_count` objects in the order of the axis.
struct Split {
    double cost = std::numeric_limits<double>::infinity();
    int axis = 0;
    std::uint32_t left_count = 0;
};

/// Objects [first, last) of each order, and the slot of their root. A tree of n objects has at most
/// 2 n - 1 nodes, so each part has slots of its own from the start.
struct Part {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::uint32_t slot = 0;
    std::uint32_t depth = 0;

    std::uint32_t count() const { return last - first; }
};

class Builder {
 public:
    explicit Builder(std::span<const BoundingSphere> objects)
        : objects_(objects),
          boxes_(objects.size()),
          is_left_(objects.size()),
          areas_(objects.size()),
          buffer_(objects.size()),
          slots_(2 * objects.size() - 1) {
        for (std::size_t i = 0; i < objects.size(); ++i) boxes_[i] = box_around(objects[i]);
        tbb::parallel_for(0, 3, [&](int axis) { sort(axis); });
    }

    SphereTree run() {
        const auto count = static_cast<std::uint32_t>(objects_.size());
        build({0, count, 0, 1});
        SphereTree tree;
        tree.nodes.reserve(slots_.size());
        collect(tree);
        tree.order = std::move(orders_[0]);
        return tree;
    }

 private:
    float center(std::uint32_t object, int axis) const { return objects_[object].center[axis]; }

    void sort(int axis) {
        std::vector<std::uint32_t>& order = orders_[static_cast<std::size_t>(axis)];
        order.resize(objects_.size());
        std::iota(order.begin(), order.end(), 0u);
        tbb::parallel_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            const float x = center(a, axis);
            const float y = center(b, axis);
            return x < y || (x == y && a < b);
        });
    }

    std::span<std::uint32_t> order(int axis, const Part& part) {
        return std::span(orders_[static_cast<std::size_t>(axis)]).subspan(part.first, part.count());
    }

    // NOLINTNEXTLINE(misc-no-recursion): kMaxSphereDepth deep at most
    void build(const Part& part) {
        SphereNode& node = slots_[part.slot];
        Bounds box;
        for (const std::uint32_t object : order(0, part)) box.add(boxes_[object]);
        node.sphere = sphere_of(box, order(0, part));
        const Split split = choose_split(part, box);
        if (split.left_count == 0) {
            node.first = part.first;
            node.object_count = part.count();
            return;
        }
        divide(part, split);
        const std::uint32_t middle = part.first + split.left_count;
        const Part left{part.first, middle, part.slot + 1, part.depth + 1};
        const Part right{middle, part.last, part.slot + 2 * split.left_count, part.depth + 1};
        node.first = right.slot;
        if (part.count() >= kParallelCount) {
            tbb::parallel_invoke([&] { build(left); }, [&] { build(right); });
        } else {
            build(left);
            build(right);
        }
    }

    /// The sphere with the centre of the box around the spheres, as large as they need.
    BoundingSphere sphere_of(const Bounds& box, std::span<const std::uint32_t> members) const {
        if (members.size() == 1) return objects_[members[0]];
        BoundingSphere result;
        result.center = Vec3{0.5 * (DVec3{box.min} + DVec3{box.max})};
        double radius = 0.0;
        for (const std::uint32_t member : members) {
            const DVec3 offset = DVec3{objects_[member].center} - DVec3{result.center};
            const double reach = std::sqrt(dot(offset, offset)) * (1.0 + gamma<double>(4)) +
                                 static_cast<double>(objects_[member].radius);
            radius = std::max(radius, reach);
        }
        result.radius = round_up(radius * (1.0 + gamma<double>(1)));
        return result;
    }

    /// No objects on the left: it becomes a leaf.
    Split choose_split(const Part& part, const Bounds& box) {
        const std::uint32_t count = part.count();
        if (count == 1) return {};
        // A balanced tree of what is left has to fit below.
        const auto levels = static_cast<std::uint32_t>(std::bit_width(count));
        Split best;
        if (part.depth + levels < kMaxSphereDepth) {
            for (int axis = 0; axis < 3; ++axis) {
                const Split split = sweep(part, axis, area_around(box));
                if (split.cost < best.cost) best = split;
            }
        }
        const double leaf_cost = count * kSphereObjectCost;
        if (count <= kMaxSphereLeaf && !(best.cost < leaf_cost)) return {};
        if (best.left_count == 0) best = {leaf_cost, 0, count / 2};
        return best;
    }

    Split sweep(const Part& part, int axis, double parent_area) {
        const std::span<const std::uint32_t> members = order(axis, part);
        const std::uint32_t count = part.count();
        // Each part writes the areas of its own stretch.
        const std::span<double> areas = std::span(areas_).subspan(part.first, count);
        Bounds box;
        for (std::uint32_t i = count; i-- > 1;) {
            box.add(boxes_[members[i]]);
            areas[i] = area_around(box);
        }
        Split best;
        best.axis = axis;
        box = {};
        for (std::uint32_t i = 1; i < count; ++i) {
            box.add(boxes_[members[i - 1]]);
            // The plane through the centre of i: those before it are left only if theirs are less.
            if (!(center(members[i - 1], axis) < center(members[i], axis))) continue;
            const double objects = area_around(box) * i + areas[i] * (count - i);
            const double cost =
                2.0 * kSphereVolumeCost +
                (parent_area > 0.0 ? objects / parent_area : count) * kSphereObjectCost;
            if (cost < best.cost) {
                best.cost = cost;
                best.left_count = i;
            }
        }
        return best;
    }

    /// Brings the objects of the left side to the front of each order, and keeps the orders.
    void divide(const Part& part, const Split& split) {
        const std::span<const std::uint32_t> chosen = order(split.axis, part);
        for (std::uint32_t i = 0; i < chosen.size(); ++i)
            is_left_[chosen[i]] = i < split.left_count;
        for (int axis = 0; axis < 3; ++axis) {
            if (axis == split.axis) continue;
            const std::span<std::uint32_t> members = order(axis, part);
            const std::span<std::uint32_t> right =
                std::span(buffer_).subspan(part.first, part.count() - split.left_count);
            std::uint32_t left_count = 0;
            std::uint32_t right_count = 0;
            for (const std::uint32_t member : members) {
                if (is_left_[member] != 0) {
                    members[left_count++] = member;
                } else {
                    right[right_count++] = member;
                }
            }
            std::ranges::copy(right, members.begin() + left_count);
        }
    }

    /// Moves the nodes together, in the order of a walk that goes left first.
    void collect(SphereTree& tree) const {
        struct Step {
            std::uint32_t slot = 0;
            std::uint32_t depth = 0;
            std::uint32_t parent = kNone;  // of a right child, in the tree
        };
        const auto area = [](const SphereNode& node) {
            return static_cast<double>(node.sphere.radius) *
                   static_cast<double>(node.sphere.radius);
        };
        const double root_area = area(slots_[0]);
        std::vector<Step> stack{{0, 1, kNone}};
        while (!stack.empty()) {
            const Step step = stack.back();
            stack.pop_back();
            const auto index = static_cast<std::uint32_t>(tree.nodes.size());
            const SphereNode& node = tree.nodes.emplace_back(slots_[step.slot]);
            if (step.parent != kNone) tree.nodes[step.parent].first = index;
            tree.depth = std::max(tree.depth, step.depth);
            const double share = root_area > 0.0 ? area(node) / root_area : 1.0;
            tree.cost += share * (node.is_leaf() ? node.object_count * kSphereObjectCost
                                                 : 2.0 * kSphereVolumeCost);
            if (node.is_leaf()) continue;
            stack.push_back({node.first, step.depth + 1, index});
            stack.push_back({step.slot + 1, step.depth + 1, kNone});
        }
    }

    static constexpr std::uint32_t kNone = 0xffffffffu;

    std::span<const BoundingSphere> objects_;
    std::vector<Bounds> boxes_;
    std::array<std::vector<std::uint32_t>, 3> orders_;
    std::vector<std::uint8_t> is_left_;
    std::vector<double> areas_;
    std::vector<std::uint32_t> buffer_;
    std::vector<SphereNode> slots_;
};

}  // namespace

SphereTree build_sphere_tree(std::span<const BoundingSphere> objects) {
    if (objects.empty()) return {};
    LRAY_ASSERT(objects.size() <= std::size_t{1} << 30);
    return Builder(objects).run();
}

}  // namespace lray::bvh
