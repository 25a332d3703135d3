#include "shade/cost.h"

#include <gtest/gtest.h>

#include <limits>

namespace lray::shade {
namespace {

TEST(Cost, NodesPrimitivesAndInstancesCountAlike) {
    bvh::TraceCounts counts;
    counts.rays = 1;
    counts.node_tests = 10;
    counts.primitive_tests = 5;
    counts.instance_tests = 1;
    EXPECT_EQ(test_count(counts), 16u);
    EXPECT_EQ(cost(counts), cost_color(16));
}

TEST(CostColor, EachColourIsFourTimesTheTestsOfTheOneBefore) {
    EXPECT_EQ(cost_color(0), Color(0.0f));
    EXPECT_EQ(cost_color(1), Color(0.0f, 0.0f, 0.1f));
    EXPECT_EQ(cost_color(4), Color(0.0f, 0.0f, 0.6f));
    EXPECT_EQ(cost_color(16), Color(0.0f, 0.5f, 0.7f));
    EXPECT_EQ(cost_color(64), Color(0.0f, 0.6f, 0.0f));
    EXPECT_EQ(cost_color(256), Color(0.9f, 0.8f, 0.0f));
    EXPECT_EQ(cost_color(1024), Color(1.0f, 0.3f, 0.0f));
    EXPECT_EQ(cost_color(4096), Color(0.7f, 0.0f, 0.0f));
    EXPECT_EQ(cost_color(16384), Color(1.0f));
}

TEST(CostColor, BeyondTheScaleIsWhite) {
    EXPECT_EQ(cost_color(16385), Color(1.0f));
    EXPECT_EQ(cost_color(std::numeric_limits<std::uint64_t>::max()), Color(1.0f));
}

TEST(CostColor, BetweenTwoColoursIsAMix) {
    // 6 tests: between 4 and 8 half way, which is a quarter of the way to 16.
    const Color color = cost_color(6);
    EXPECT_NEAR(color.g, 0.125f, 1e-6f);
    EXPECT_NEAR(color.b, 0.625f, 1e-6f);
}

TEST(CostColor, NeighboursAreNearlyAlike) {
    for (std::uint64_t tests = 16; tests < 20'000; ++tests) {
        const Color step = cost_color(tests + 1) - cost_color(tests);
        ASSERT_LT(dot(step, step), 0.1f * 0.1f) << tests;
    }
}

}  // namespace
}  // namespace lray::shade
