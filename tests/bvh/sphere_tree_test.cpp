// The tree of bounding spheres: what it holds, how it is split, and that it ends.
#include "bvh/spheres/sphere_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/bvh/worlds.h"

namespace lray::bvh {
namespace {

std::vector<BoundingSphere> random_spheres(Random& random, int count) {
    std::vector<BoundingSphere> spheres;
    for (int i = 0; i < count; ++i) {
        spheres.push_back({random.in_cube(10.0f), random.uniform(0.01f, 0.5f)});
    }
    return spheres;
}

bool holds(const BoundingSphere& outer, const BoundingSphere& inner) {
    const DVec3 offset = DVec3{inner.center} - DVec3{outer.center};
    return std::sqrt(dot(offset, offset)) + static_cast<double>(inner.radius) <=
           static_cast<double>(outer.radius) * (1.0 + 1e-15);
}

struct Extent {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
};

/// Checks a subtree; returns the stretch of the order that it holds.
Extent check(const SphereTree& tree, std::span<const BoundingSphere> objects, std::uint32_t index,
             std::uint32_t depth) {
    EXPECT_LE(depth, tree.depth);
    const SphereNode& node = tree.nodes[index];
    Extent extent{node.first, node.first + node.object_count};
    if (node.is_leaf()) {
        EXPECT_LE(node.object_count, kMaxSphereLeaf);
    } else {
        const Extent left = check(tree, objects, index + 1, depth + 1);
        const Extent right = check(tree, objects, node.first, depth + 1);
        EXPECT_EQ(left.last, right.first);
        extent = {left.first, right.last};
    }
    for (std::uint32_t i = extent.first; i < extent.last; ++i) {
        EXPECT_TRUE(holds(node.sphere, objects[tree.order[i]]));
    }
    return extent;
}

void check(const SphereTree& tree, std::span<const BoundingSphere> objects) {
    ASSERT_EQ(tree.order.size(), objects.size());
    std::vector<std::uint32_t> sorted = tree.order;
    std::ranges::sort(sorted);
    for (std::uint32_t i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], i);
    const Extent extent = check(tree, objects, 0, 1);
    EXPECT_EQ(extent.first, 0u);
    EXPECT_EQ(extent.last, objects.size());
    EXPECT_LE(tree.depth, kMaxSphereDepth);
}

TEST(SphereTree, HoldsEveryObjectInOneLeafBelowSpheresThatHoldIt) {
    Random random(7);
    for (const int count : {1, 2, 3, 4, 5, 6, 17, 100, 1000}) {
        const std::vector<BoundingSphere> objects = random_spheres(random, count);
        check(build_sphere_tree(objects), objects);
    }
    EXPECT_TRUE(build_sphere_tree({}).nodes.empty());
}

/// The cost of a split, written down once more: every object looked at for every plane.
double cost_of(std::span<const BoundingSphere> objects, int axis, float plane) {
    Bounds all;
    Bounds sides[2];
    double counts[2] = {0.0, 0.0};
    for (const BoundingSphere& object : objects) {
        const int side = object.center[axis] < plane ? 0 : 1;
        sides[side].add(box_around(object));
        all.add(box_around(object));
        counts[side] += 1.0;
    }
    if (counts[0] == 0.0) return std::numeric_limits<double>::infinity();
    const auto area = [](const Bounds& box) {
        const DVec3 diagonal = DVec3{box.max} - DVec3{box.min};
        return dot(diagonal, diagonal);
    };
    double cost = 0.0;
    for (int side = 0; side < 2; ++side) {
        cost +=
            kSphereVolumeCost + area(sides[side]) / area(all) * counts[side] * kSphereObjectCost;
    }
    return cost;
}

TEST(SphereTree, SplitsWhereTheCostIsLeastOfAllPlanesThroughCentres) {
    Random random(11);
    for (int i = 0; i < 50; ++i) {
        std::vector<BoundingSphere> objects = random_spheres(random, 5 + random.below(60));
        if (i % 2 == 0) {  // many on one plane
            for (BoundingSphere& object : objects) object.center = glm::round(object.center);
        }
        double best = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            for (const BoundingSphere& object : objects) {
                best = std::min(best, cost_of(objects, axis, object.center[axis]));
            }
        }
        const SphereTree tree = build_sphere_tree(objects);
        ASSERT_FALSE(tree.nodes[0].is_leaf());
        // The left part is a prefix of the order: the plane is the least centre of the right part
        // on the axis where that separates them.
        const Extent left = check(tree, objects, 1, 2);
        double chosen = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            float last_left = -kInfinity;
            float first_right = kInfinity;
            for (std::uint32_t k = 0; k < objects.size(); ++k) {
                const float center = objects[tree.order[k]].center[axis];
                if (k < left.last) {
                    last_left = std::max(last_left, center);
                } else {
                    first_right = std::min(first_right, center);
                }
            }
            if (last_left < first_right)
                chosen = std::min(chosen, cost_of(objects, axis, first_right));
        }
        EXPECT_NEAR(chosen, best, 1e-9 * best);
    }
}

TEST(SphereTree, EqualCentresAreHalvedByIndex) {
    const std::vector<BoundingSphere> objects(1000, BoundingSphere{{1, 2, 3}, 0.5f});
    const SphereTree tree = build_sphere_tree(objects);
    check(tree, objects);
    EXPECT_LE(tree.depth, 11u);
}

TEST(SphereTree, DepthIsBoundedWhereEverySplitTakesOffOne) {
    // Each is much farther out and much larger than all before it together.
    std::vector<BoundingSphere> objects;
    for (int i = 0; i < 110; ++i) {
        const float x = std::ldexp(1.0f, i - 60);
        objects.push_back({{x, 0, 0}, 0.01f * x});
    }
    std::vector<BoundingSphere> many;
    for (int k = 0; k < 50; ++k) many.insert(many.end(), objects.begin(), objects.end());
    const SphereTree tree = build_sphere_tree(many);
    check(tree, many);
}

// A triangle seen edge-on is hit anywhere in the stretch of the ray in its box, which slabs widen.
TEST(SphereTree, SphereAroundABoxIsMetWhereverSlabsHaveTheRayInTheBox) {
    constexpr std::uint64_t kSeed = 14;
    Random random(kSeed);
    for (const float scale : {1e-18f, 1e-12f, 1.0f, 1e12f}) {
        for (const float place : {0.0f, 1.0f, 1e3f, 1e6f}) {
            int met_count = 0;
            for (int i = 0; i < 20000; ++i) {
                const Vec3 offset = random.in_cube(place * scale);
                Bounds box;
                for (int k = 0; k < 2; ++k) box.add(offset + random.in_cube(scale));
                const DVec3 origin = DVec3{offset} + DVec3{random.in_cube(4.0f * scale)};
                const DVec3 target = DVec3{offset} + DVec3{random.in_cube(1.5f * scale)};
                const PreparedRay ray = prepare(origin, glm::normalize(target - origin));
                const Stretch stretch = stretch_in(box, ray);
                if (!(stretch.entry <= stretch.exit)) continue;
                for (const float t : {stretch.entry * kEntryFactor, stretch.exit}) {
                    if (!(t > 0.0f)) continue;
                    ++met_count;
                    ASSERT_TRUE(entry_into(sphere_around(box), ray, {next_down(t), next_up(t)}))
                        << "seed " << kSeed << " scale " << scale << " place " << place << " i "
                        << i;
                }
            }
            EXPECT_GT(met_count, 1000);
        }
    }
}

TEST(SphereTree, LargeOnesAreTheSameHoweverManyThreadsBuildThem) {
    Random random(13);
    const std::vector<BoundingSphere> objects = random_spheres(random, 20'000);
    const SphereTree tree = build_sphere_tree(objects);
    const SphereTree again = build_sphere_tree(objects);
    EXPECT_EQ(tree.order, again.order);
    ASSERT_EQ(tree.nodes.size(), again.nodes.size());
    check(tree, objects);
}

}  // namespace
}  // namespace lray::bvh
