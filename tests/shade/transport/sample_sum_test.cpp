#include "shade/transport/sample_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/random.h"

namespace lray::shade {
namespace {

TEST(SampleSum, NothingIsBlack) {
    EXPECT_EQ(SampleSum{}.color(), Color(0.0f));
}

TEST(SampleSum, OneContributionComesBack) {
    SampleSum sum;
    sum.add({0.1f, 2.5f, 1000.0f});
    EXPECT_EQ(sum.color(), Color(0.1f, 2.5f, 1000.0f));
}

TEST(SampleSum, OrderDoesNotMatter) {
    test::Random random(5);
    std::vector<Color> colors;
    for (int i = 0; i < 200; ++i) {
        const double size = std::pow(10.0, random.uniform(-8.0, 8.0));
        colors.emplace_back(size * random.uniform(0.0, 1.0), size, random.uniform(0.0, 1e-9));
    }
    SampleSum forward;
    for (const Color color : colors) forward.add(color);
    std::ranges::reverse(colors);
    SampleSum backward;
    for (const Color color : colors) backward.add(color);
    EXPECT_EQ(forward.color(), backward.color());
}

TEST(SampleSum, TooBrightStaysBright) {
    SampleSum sum;
    for (int i = 0; i < 100; ++i) sum.add(Color{std::numeric_limits<float>::infinity()});
    EXPECT_GE(sum.color().r, 0x1p29f);
    EXPECT_TRUE(std::isfinite(sum.color().r));
}

TEST(SampleSum, NotANumberIsTold) {
    SampleSum sum;
    sum.add({1.0f, std::numeric_limits<float>::quiet_NaN(), 1.0f});
    sum.add(Color{1.0f});
    EXPECT_TRUE(std::isnan(sum.color().g));
}

}  // namespace
}  // namespace lray::shade
