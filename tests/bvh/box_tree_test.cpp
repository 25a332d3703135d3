// The tree of boxes: that its leaves hold everything once, below boxes that hold it, and that it
// ends. How it is traced is tested elsewhere.
#include "bvh/boxes/box_tree.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "scene/each_primitive.h"
#include "tests/bvh/worlds.h"

namespace lray::bvh {
namespace {

using scene::PrimitiveId;
using scene::PrimitiveKind;

/// The bounds of the triangle in a lane.
Bounds lane_bounds(const TriangleBlock& block, std::uint32_t lane) {
    Bounds bounds;
    for (const auto& corner : block.corners) {
        bounds.add(Vec3{corner[0][lane], corner[1][lane], corner[2][lane]});
    }
    return bounds;
}

/// Walks a tree and checks what every tree promises; collects what is in it.
class Checker {
 public:
    explicit Checker(const scene::Geometry& geometry, const BoxTree& tree)
        : geometry_(geometry), tree_(tree) {
        if (!tree.view.is_empty) visit(tree.view.root, nullptr, 1);
    }

    /// Ids, sorted: those of rectangles twice.
    std::vector<std::uint32_t> held() {
        std::ranges::sort(held_);
        return held_;
    }
    std::uint32_t depth() const { return depth_; }
    std::uint64_t leaves() const { return leaf_count_; }
    std::uint64_t nodes() const { return node_count_; }
    std::uint32_t longest_leaf() const { return longest_leaf_; }

 private:
    void visit(BoxChild child, const Bounds* box, std::uint32_t depth) {
        depth_ = std::max(depth_, depth);
        ASSERT_LE(depth, kMaxBoxDepth);
        switch (kind_of(child)) {
            case BoxChildKind::node:
                visit_node(node_of(tree_.view, child), box, depth);
                return;
            case BoxChildKind::triangles:
                visit_triangles(child, box);
                break;
            case BoxChildKind::spheres:
                visit_spheres(child, box);
                break;
            case BoxChildKind::framed:
                visit_framed(child, box);
                break;
            case BoxChildKind::instances:
                visit_instances(child, box);
                break;
        }
        ++leaf_count_;
        longest_leaf_ = std::max(longest_leaf_, leaf_count(child));
    }

    void visit_node(const BoxNode& node, const Bounds* box, std::uint32_t depth) {
        ++node_count_;
        bool is_over = false;
        for (std::uint32_t lane = 0; lane < kBoxWidth; ++lane) {
            const Bounds inner = box_of(node, lane);
            if (inner.is_empty()) {
                is_over = true;
                EXPECT_EQ(inner.min, Vec3{kInfinity});
                EXPECT_EQ(inner.max, Vec3{-kInfinity});
                continue;
            }
            EXPECT_FALSE(is_over) << "lanes are filled from the first on";
            EXPECT_TRUE(box == nullptr || box->contains(inner));
            visit(node.children[lane], &inner, depth + 1);
        }
        EXPECT_FALSE(box_of(node, 1).is_empty()) << "a node with one child";
    }

    void visit_triangles(BoxChild child, const Bounds* box) {
        for (std::uint32_t i = 0; i < leaf_count(child); ++i) {
            const TriangleBlock& block = tree_.view.triangles[leaf_first(child) + i];
            bool is_over = false;
            EXPECT_NE(block.ids[0], kNoLane);
            for (std::uint32_t lane = 0; lane < kBoxWidth; ++lane) {
                if (block.ids[lane] == kNoLane) {
                    is_over = true;
                    EXPECT_EQ(lane_bounds(block, lane).min, Vec3{0.0f});
                    EXPECT_EQ(lane_bounds(block, lane).max, Vec3{0.0f});
                    continue;
                }
                EXPECT_FALSE(is_over);
                const PrimitiveId id = PrimitiveId::of_value(block.ids[lane]);
                EXPECT_TRUE(id.kind() == PrimitiveKind::triangle ||
                            id.kind() == PrimitiveKind::rectangle);
                EXPECT_TRUE(primitive_bounds(geometry_, id).contains(lane_bounds(block, lane)));
                hold(id, lane_bounds(block, lane), box);
            }
        }
    }

    void visit_spheres(BoxChild child, const Bounds* box) {
        for (std::uint32_t i = 0; i < leaf_count(child); ++i) {
            const SphereBlock& block = tree_.view.spheres[leaf_first(child) + i];
            bool is_over = false;
            EXPECT_NE(block.ids[0], kNoLane);
            for (std::uint32_t lane = 0; lane < kBoxWidth; ++lane) {
                if (block.ids[lane] == kNoLane) {
                    is_over = true;
                    continue;
                }
                EXPECT_FALSE(is_over);
                const PrimitiveId id = PrimitiveId::of_value(block.ids[lane]);
                ASSERT_EQ(id.kind(), PrimitiveKind::sphere);
                const scene::Sphere& sphere = geometry_.spheres[id.index()];
                EXPECT_EQ(sphere.radius, block.radius[lane]);
                for (int axis = 0; axis < 3; ++axis) {
                    EXPECT_EQ(sphere.center[axis], block.center[axis][lane]);
                }
                hold(id, primitive_bounds(geometry_, id), box);
            }
        }
    }

    void visit_framed(BoxChild child, const Bounds* box) {
        for (std::uint32_t i = 0; i < leaf_count(child); ++i) {
            const PrimitiveId id =
                PrimitiveId::of_value(tree_.view.framed[leaf_first(child) + i].id);
            EXPECT_NE(id.kind(), PrimitiveKind::triangle);
            EXPECT_NE(id.kind(), PrimitiveKind::rectangle);
            EXPECT_NE(id.kind(), PrimitiveKind::sphere);
            EXPECT_NE(id.kind(), PrimitiveKind::plane);
            EXPECT_NE(id.kind(), PrimitiveKind::instance);
            hold(id, primitive_bounds(geometry_, id), box);
        }
    }

    void visit_instances(BoxChild child, const Bounds* box) {
        const std::uint32_t* const ids = tree_.view.instances + leaf_first(child);
        for (std::uint32_t i = 0; i < leaf_count(child); ++i) {
            const PrimitiveId id = PrimitiveId::of_value(ids[i]);
            ASSERT_EQ(id.kind(), PrimitiveKind::instance);
            hold(id, primitive_bounds(geometry_, id), box);
        }
    }

    void hold(PrimitiveId id, const Bounds& bounds, const Bounds* box) {
        held_.push_back(id.value);
        EXPECT_TRUE(box == nullptr || box->contains(bounds));
    }

    const scene::Geometry& geometry_;
    const BoxTree& tree_;
    std::vector<std::uint32_t> held_{};
    std::uint32_t depth_ = 0;
    std::uint32_t longest_leaf_ = 0;
    std::uint64_t leaf_count_ = 0;
    std::uint64_t node_count_ = 0;
};

/// What a tree has to hold, sorted: visible, without planes, both halves of rectangles.
std::vector<std::uint32_t> expected_ids(const scene::Geometry& geometry) {
    std::vector<std::uint32_t> ids;
    scene::each_primitive(geometry, [&](PrimitiveId id, const scene::Object& object) {
        if (!object.visible || id.kind() == PrimitiveKind::plane) return true;
        ids.push_back(id.value);
        if (id.kind() == PrimitiveKind::rectangle) ids.push_back(id.value);
        return true;
    });
    std::ranges::sort(ids);
    return ids;
}

/// Checks a tree in which nothing is cut.
void check(const scene::Geometry& geometry, const BoxTree& tree) {
    Checker checker(geometry, tree);
    EXPECT_EQ(checker.held(), expected_ids(geometry));
    EXPECT_EQ(tree.stats.depth, checker.depth());
    EXPECT_EQ(tree.stats.leaves, checker.leaves());
    EXPECT_EQ(tree.stats.nodes, checker.nodes());
    EXPECT_EQ(tree.stats.references, checker.held().size() + tree.planes.size());
    EXPECT_GE(tree.stats.bytes, tree.arena.size());
}

void build_and_check(const scene::Geometry& geometry) {
    for (const BuildQuality quality : {BuildQuality::low, BuildQuality::medium}) {
        check(geometry, build_box_tree(geometry, quality));
    }
}

scene::Geometry triangle_soup(Random& random, int count, float size) {
    scene::Geometry geometry;
    for (int i = 0; i < count; ++i) {
        add_random(geometry, random, PrimitiveKind::triangle, random.in_cube(10.0f), size);
    }
    return geometry;
}

TEST(BoxTree, NothingMakesAnEmptyTree) {
    scene::Geometry geometry;
    EXPECT_TRUE(build_box_tree(geometry, BuildQuality::medium).view.is_empty);
    add_plane(geometry, {0, 0, 0}, {0, 1, 0});
    const BoxTree tree = build_box_tree(geometry, BuildQuality::medium);
    EXPECT_TRUE(tree.view.is_empty);
    ASSERT_EQ(tree.planes.size(), 1u);
    EXPECT_EQ(tree.planes[0], PrimitiveId(PrimitiveKind::plane, 0));
    EXPECT_EQ(tree.stats.references, 1u);
}

TEST(BoxTree, AFewPrimitivesAreALeafWithoutANode) {
    scene::Geometry geometry;
    const PrimitiveId id = add_sphere(geometry, {1, 2, 3}, 0.5f);
    const BoxTree tree = build_box_tree(geometry, BuildQuality::medium);
    EXPECT_EQ(kind_of(tree.view.root), BoxChildKind::spheres);
    EXPECT_EQ(tree.view.spheres[0].ids[0], id.value);
    EXPECT_EQ(tree.stats.nodes, 0u);
    EXPECT_EQ(tree.stats.depth, 1u);
}

TEST(BoxTree, HoldsEveryPrimitiveOfEveryKindBelowBoxesThatHoldIt) {
    Random random(5);
    for (const int count : {1, 2, 7, 8, 9, 30, 300, 3000}) {
        SCOPED_TRACE(count);
        scene::World world;
        scene::Geometry prototype;
        add_sphere(prototype, {0, 0, 0}, 1.0f);
        const std::uint32_t index = add_prototype(world, std::move(prototype));
        for (int i = 0; i < count; ++i) {
            const Vec3 center = random.in_cube(10.0f);
            if (random.below(10) == 0) {
                add_instance(world, world, index, scaled_frame(Vec3{0.5f}, center));
            } else {
                add_random(world, random, center, 0.3f);
            }
        }
        build_and_check(world);
    }
}

TEST(BoxTree, HoldsTrianglesOfASoup) {
    Random random(6);
    for (const int count : {1, 8, 9, 63, 64, 65, 1000, 20'000}) {
        SCOPED_TRACE(count);
        build_and_check(triangle_soup(random, count, 0.2f));
    }
}

TEST(BoxTree, WhatIsHiddenIsNotInIt) {
    Random random(7);
    scene::Geometry geometry;
    for (int i = 0; i < 200; ++i) {
        add_random(geometry, random, random.in_cube(5.0f), 0.3f);
        geometry.objects.back().visible = random.below(2) == 0;
    }
    build_and_check(geometry);
}

TEST(BoxTree, HalvesOfARectangleAreThoseItsKernelTests) {
    scene::Geometry geometry;
    const PrimitiveId id = add_rectangle(geometry, {0, 0, 0}, {2, 0, 0}, {0, 3, 0});
    const BoxTree tree = build_box_tree(geometry, BuildQuality::medium);
    ASSERT_EQ(kind_of(tree.view.root), BoxChildKind::triangles);
    const TriangleBlock& block = tree.view.triangles[leaf_first(tree.view.root)];
    const auto corner = [&](std::size_t vertex, std::size_t lane) {
        const auto& xyz = block.corners[vertex];
        return Vec3{xyz[0][lane], xyz[1][lane], xyz[2][lane]};
    };
    std::vector<std::vector<Vec3>> halves;
    for (std::size_t lane = 0; lane < 2; ++lane) {
        EXPECT_EQ(block.ids[lane], id.value);
        halves.push_back({corner(0, lane), corner(1, lane), corner(2, lane)});
    }
    const std::vector<Vec3> lower{{0, 0, 0}, {2, 0, 0}, {2, 3, 0}};
    const std::vector<Vec3> upper{{0, 0, 0}, {2, 3, 0}, {0, 3, 0}};
    EXPECT_TRUE((halves == std::vector{lower, upper}) || (halves == std::vector{upper, lower}));
    EXPECT_EQ(block.ids[2], kNoLane);
}

TEST(BoxTree, AMillionPrimitivesInOnePlaceAreHalvedByCount) {
    scene::Geometry geometry;
    for (int i = 0; i < 1'000'000; ++i) geometry.spheres.push_back({{1, 2, 3}, 0.5f});
    geometry.object_ids[static_cast<std::size_t>(PrimitiveKind::sphere)].assign(
        geometry.spheres.size(), scene::ObjectId{0});
    geometry.objects.emplace_back();
    const BoxTree tree = build_box_tree(geometry, BuildQuality::medium);
    EXPECT_LE(tree.stats.depth, 8u);
    EXPECT_EQ(tree.stats.references, 1'000'000u);
    EXPECT_EQ(Checker(geometry, tree).held().size(), 1'000'000u);
}

TEST(BoxTree, ListsInOnePlaceAreNotTooLong) {
    scene::Geometry geometry;
    for (int i = 0; i < 1000; ++i) add_torus(geometry, scaled_frame(Vec3{1.0f}, {}), 0.2f);
    const BoxTree tree = build_box_tree(geometry, BuildQuality::medium);
    check(geometry, tree);
}

TEST(BoxTree, DepthIsBoundedWhereEverySplitTakesOffFew) {
    // Each is much farther out and much larger than all before it together.
    scene::Geometry geometry;
    for (int i = 0; i < 110; ++i) {
        const float x = std::ldexp(1.0f, i - 60);
        for (int k = 0; k < 50; ++k) add_sphere(geometry, {x, 0, 0}, 0.01f * x);
    }
    build_and_check(geometry);
}

TEST(BoxTree, HugeTinyAndFlatTrianglesFindAPlace) {
    Random random(8);
    scene::Geometry geometry;
    for (int i = 0; i < 500; ++i) {
        const float scale = std::ldexp(1.0f, random.below(124) - 63);
        add_triangle(geometry, random.in_cube(scale), random.in_cube(scale), random.in_cube(scale));
        const Vec3 point = random.in_cube(scale);
        add_triangle(geometry, point, point, point);
        add_triangle(geometry, point, 2.0f * point, 3.0f * point);
        add_triangle(geometry, {0, 0, 0}, {scale, 0, 0}, {-0.0f, 0, 0});
    }
    build_and_check(geometry);
    scene::Geometry line;
    for (int i = 0; i < 5000; ++i) {
        const float x = random.uniform(-1e-18f, 1e-18f);
        add_triangle(line, {x, 0, 0}, {1.1f * x, 0, 0}, {1.2f * x, 0, 0});
    }
    build_and_check(line);
    EXPECT_LE(build_box_tree(line, BuildQuality::medium).stats.depth, 8u);
}

TEST(BoxTree, BoxesThatReachPastTheRangeOfFloatFindAPlace) {
    Random random(10);
    scene::Geometry geometry;
    for (int i = 0; i < 300; ++i) {
        add_triangle(geometry, random.in_cube(1.6e38f), random.in_cube(1.6e38f),
                     random.in_cube(1.0f));
        add_sphere(geometry, random.in_cube(1.6e38f), 3e38f);
    }
    build_and_check(geometry);
    build_box_tree(geometry, BuildQuality::high);
}

TEST(BoxTree, IsTheSameOnAnyNumberOfCores) {
    Random random(9);
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 5);
    for (const BuildQuality quality : {BuildQuality::medium, BuildQuality::high}) {
        // Enough for sets that are gone through by several tasks.
        const scene::Geometry geometry =
            triangle_soup(random, quality == BuildQuality::high ? 20'000 : 150'000, 0.5f);
        const BoxTree tree = build_box_tree(geometry, quality);
        for (const int core_count : {1, 2, 5}) {
            tbb::task_arena arena(core_count);
            const BoxTree again = arena.execute([&] { return build_box_tree(geometry, quality); });
            ASSERT_EQ(tree.arena.size(), again.arena.size());
            EXPECT_EQ(std::memcmp(tree.arena.data(), again.arena.data(), tree.arena.size()), 0);
            EXPECT_EQ(tree.view.root, again.view.root);
            EXPECT_EQ(tree.stats.cost, again.stats.cost);
        }
    }
}

}  // namespace
}  // namespace lray::bvh
