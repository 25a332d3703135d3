#include "base/bounds.h"

#include <gtest/gtest.h>

namespace lray {
namespace {

TEST(Bounds, DefaultIsEmpty) {
    EXPECT_TRUE(Bounds{}.is_empty());
}

TEST(Bounds, OnePointIsNotEmpty) {
    Bounds bounds;
    bounds.add(Vec3{1.0f, 2.0f, 3.0f});
    EXPECT_FALSE(bounds.is_empty());
    EXPECT_EQ(bounds.min, bounds.max);
}

TEST(Bounds, EmptyAddsNothing) {
    Bounds bounds;
    bounds.add(Vec3{1.0f, 2.0f, 3.0f});
    bounds.add(Bounds{});
    EXPECT_EQ(bounds.min, (Vec3{1.0f, 2.0f, 3.0f}));
    EXPECT_EQ(bounds.max, (Vec3{1.0f, 2.0f, 3.0f}));
}

TEST(Bounds, DoublePointLiesBetweenOutwardRoundedFloats) {
    const DVec3 point{0.1, -0.1, 1e-60};
    Bounds bounds;
    bounds.add(point);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(static_cast<double>(bounds.min[axis]), point[axis]);
        EXPECT_GE(static_cast<double>(bounds.max[axis]), point[axis]);
        EXPECT_EQ(bounds.max[axis], next_up(bounds.min[axis]));
    }
}

TEST(Bounds, ContainsItselfAndTheEmptyButNotMore) {
    Bounds bounds;
    bounds.add(Vec3{0.0f});
    bounds.add(Vec3{1.0f});
    EXPECT_TRUE(bounds.contains(bounds));
    EXPECT_TRUE(bounds.contains(Bounds{}));
    Bounds larger = bounds;
    larger.add(Vec3{0.5f, 0.5f, next_up(1.0f)});
    EXPECT_FALSE(bounds.contains(larger));
    EXPECT_TRUE(larger.contains(bounds));
}

}  // namespace
}  // namespace lray
