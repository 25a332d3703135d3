// Functions of shapes in the scene, and of curves.
#include <gtest/gtest.h>

#include <cmath>

#include "parser/builtins/curve.h"
#include "tests/parser/builtin_caller.h"

namespace lray::test {
namespace {

using parser::Value;

class GeometryFunctions : public ::testing::Test, public BuiltinCaller {
 protected:
    /// A node of this kind, the first of its array.
    Value first(scene::NodeKind kind) {
        scene::Node node;
        node.kind = kind;
        scene_of_nodes.nodes.push_back(node);
        return this->node(scene::NodeId(scene_of_nodes.nodes.size() - 1));
    }

    const Value corner_ =
        list({numbers({0, 0, 0}), numbers({2, 0, 0}), numbers({2, 0, 2}), numbers({2, 4, 2})});
};

TEST_F(GeometryFunctions, BoundsAreARecord) {
    scene_of_nodes.boxes = {{DVec3{-1, 0, 2}, DVec3{3, 1, 2.5}}};
    EXPECT_EQ(says("bounds", {first(scene::NodeKind::box)}),
              "record { min: [-1, 0, 2], max: [3, 1, 2.5], size: [4, 1, 0.5], "
              "center: [1, 0.5, 2.25] }");
}

TEST_F(GeometryFunctions, BoundsOfWhatHasNoneAreMistakes) {
    scene_of_nodes.groups = {{}};
    scene_of_nodes.planes = {{}};
    scene_of_nodes.spheres = {{DVec3{0}, 1.7e308}};
    EXPECT_EQ(says("bounds", {first(scene::NodeKind::group)}),
              "E0505 10 this has no bounds: nothing in it has a size");
    EXPECT_EQ(says("bounds", {first(scene::NodeKind::plane)}),
              "E0503 10 this has no bounds: it is infinitely large");
    EXPECT_EQ(says("bounds", {first(scene::NodeKind::sphere)}),
              "E0503 1 `bounds(...)` has no finite value")
        << "the size is twice the radius";
    EXPECT_EQ(
        says("bounds", {number(1)}),
        "E0301 10 `node` of `bounds` needs a node, like a group or a sphere, this is a number");
}

TEST_F(GeometryFunctions, BoundsTakeStepsForWhatTheyVisit) {
    scene_of_nodes.spheres = {{}};
    const Value sphere = first(scene::NodeKind::sphere);
    for (const std::uint64_t steps : {14u, 15u, 16u}) {  // 3 visits, 12 numbers in vectors free
        budget.steps = steps;
        const std::uint64_t before = budget.steps;
        ASSERT_TRUE(says("bounds", {sphere}).starts_with("record"));
        EXPECT_EQ(before - budget.steps, 3u);
    }
    budget.steps = 2;
    EXPECT_TRUE(says("bounds", {sphere}).starts_with("E0512 1 "));
}

TEST_F(GeometryFunctions, CurvesReachTheirPoints) {
    for (int i = 0; i < 4; ++i) {
        const Value at = call("curve", {corner_, number(i / 3.0)});
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(at.numbers[axis], corner_.numbers[3 * i + axis], 1e-15);
        }
    }
    EXPECT_EQ(says("curve", {corner_, number(-1e308)}), "[0, 0, 0]");
    EXPECT_EQ(says("curve", {corner_, number(1e308)}), "[2, 4, 2]");
    EXPECT_EQ(says("curve", {list({numbers({1, 2, 3})}), number(0.5)}), "[1, 2, 3]");
}

TEST_F(GeometryFunctions, CurvesOfTwoPointsAreStraight) {
    const Value line = list({numbers({0, 0, 0}), numbers({4, 8, -4})});
    EXPECT_EQ(says("curve", {line, number(0.25)}), "[1, 2, -1]");
}

// Between b and c of a, b, c, d: (-a + 9 b + 9 c - d) / 16 in the middle.
TEST_F(GeometryFunctions, CurvesAreCatmullRom) {
    EXPECT_EQ(says("curve", {corner_, number(0.5)}), "[2.125, -0.25, 1]");
}

TEST_F(GeometryFunctions, TangentsAreThoseOfTheCurve) {
    const std::span<const double> rows(corner_.numbers, 12);
    for (double t = 0.05; t < 1.0; t += 0.1) {
        constexpr double kStep = 1e-6;
        const DVec3 across = parser::curve_point(rows, t + kStep).position -
                             parser::curve_point(rows, t - kStep).position;
        const DVec3 slope = across / (2 * kStep * 3);  // three segments
        EXPECT_LT(glm::length(parser::curve_point(rows, t).tangent - slope), 1e-6) << t;
    }
}

TEST_F(GeometryFunctions, PathFramesStandOnTheCurve) {
    const Value line = list({numbers({1, 0, 0}), numbers({5, 0, 0})});
    const Value frame = call("path_frame", {line, number(0.5)});
    ASSERT_TRUE(frame.is(parser::ValueKind::transform));
    EXPECT_LT(glm::length(frame.transform->point(DVec3{0, 0, 0}) - DVec3(3, 0, 0)), 1e-15);
    EXPECT_LT(glm::length(frame.transform->vector(DVec3{0, 0, -1}) - DVec3(1, 0, 0)), 1e-15);
    EXPECT_LT(glm::length(frame.transform->vector(DVec3{0, 1, 0}) - DVec3(0, 1, 0)), 1e-15);
    EXPECT_TRUE(frame.transform->is_similarity());
    EXPECT_EQ(says("path_frame", {list({numbers({1, 1, 1}), numbers({1, 1, 1})}), number(0)}),
              "E0503 1 the curve has no direction here: neighbouring points are the same");
}

TEST_F(GeometryFunctions, HugeAndWrongPointsAreReported) {
    const Value far = list({numbers({-1.7e308, 0, 0}), numbers({1.7e308, 0, 0})});
    EXPECT_EQ(says("curve", {far, number(0.5)}), "E0503 1 `curve(..., 0.5)` has no real value");
    EXPECT_EQ(says("curve", {numbers({1, 2, 3}), number(0)}),
              "E0301 10 `points` of `curve` needs a list of points, like [[0, 0, 0], [1, 2, 3]], "
              "this is a list of 3 numbers");
    EXPECT_TRUE(says("curve", {numbers({}), number(0)}).starts_with("E0301 10 "));
}

}  // namespace
}  // namespace lray::test
