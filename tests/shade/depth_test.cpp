#include "shade/depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lray::shade {
namespace {

bvh::Hit hit_at(float t) {
    return {t, 0.0f, 0.0f, scene::PrimitiveId(scene::PrimitiveKind::sphere, 0), 0};
}

TEST(Depth, HalfAtTheUnitAndDarkerBeyond) {
    EXPECT_EQ(depth(hit_at(5.0f), 5.0), Color(0.5f));
    EXPECT_EQ(depth(hit_at(10.0f), 5.0), Color(1.0f / 9.0f));
    EXPECT_GT(depth(hit_at(1e-6f), 5.0).r, 0.999f);
    EXPECT_GT(depth(hit_at(1e6f), 5.0).r, 0.0f);
}

TEST(Depth, MissIsBlack) {
    EXPECT_EQ(depth({}, 5.0), Color(0.0f));
}

TEST(DepthUnit, IsHowFarTheCameraLooks) {
    EXPECT_EQ(depth_unit({0.0, 0.0, 5.0}, {3.0, 4.0, 5.0}), 5.0);
}

TEST(DepthUnit, ExtremeCamerasStillGiveAValue) {
    for (const double scale : {1e-300, 1e-200, 1e200, 1e308}) {
        const double unit = depth_unit({0.0, 0.0, 0.0}, {scale, scale, 0.0});
        EXPECT_TRUE(std::isfinite(unit)) << scale;
        EXPECT_GT(unit, 0.0) << scale;
        const float value = depth(hit_at(std::numeric_limits<float>::max()), unit).r;
        EXPECT_TRUE(value >= 0.0f && value <= 1.0f) << scale;
    }
}

}  // namespace
}  // namespace lray::shade
