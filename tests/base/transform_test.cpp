#include "base/transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace lray {
namespace {

void expect_near(DVec3 actual, DVec3 expected, double tolerance) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(actual[axis], expected[axis], tolerance);
}

TEST(Transform, ThenDoesThisOneFirst) {
    const Transform scale = Transform::scaling(2.0);
    const Transform move = Transform::translation({3.0, 0.0, 0.0});
    EXPECT_EQ(scale.then(move).point({1.0, 1.0, 0.0}), (DVec3{5.0, 2.0, 0.0}));
    EXPECT_EQ(move.then(scale).point({1.0, 1.0, 0.0}), (DVec3{8.0, 2.0, 0.0}));
}

TEST(Transform, VectorsAreNotMoved) {
    EXPECT_EQ(Transform::translation({3.0, 4.0, 5.0}).vector({1.0, 0.0, 0.0}),
              (DVec3{1.0, 0.0, 0.0}));
}

TEST(Transform, QuarterTurnsAreExactAndCounterClockwise) {
    const DVec3 x{1.0, 0.0, 0.0};
    const DVec3 y{0.0, 1.0, 0.0};
    const DVec3 z{0.0, 0.0, 1.0};
    EXPECT_EQ(Transform::rotation_x(90.0).point(y), z);
    EXPECT_EQ(Transform::rotation_y(90.0).point(z), x);
    EXPECT_EQ(Transform::rotation_z(90.0).point(x), y);
    EXPECT_EQ(Transform::rotation_z(-270.0).point(x), y);
    EXPECT_EQ(Transform::rotation_y(180.0).point(x), -x);
    EXPECT_EQ(Transform::rotation({0.0, 0.0, -7.0}, 90.0).point(y), x);
}

TEST(Transform, TurnAboutACoordinateAxisLeavesItExactlyAlone) {
    for (double angle = -360.0; angle <= 360.0; angle += 0.7) {
        EXPECT_EQ(Transform::rotation_x(angle).point({3.0, 0.0, 0.0}), (DVec3{3.0, 0.0, 0.0}));
        EXPECT_EQ(Transform::rotation_y(angle).point({0.0, 3.0, 0.0}), (DVec3{0.0, 3.0, 0.0}));
        EXPECT_EQ(Transform::rotation_z(angle).point({0.0, 0.0, 3.0}), (DVec3{0.0, 0.0, 3.0}));
    }
}

TEST(Transform, SimilarityIsTakenOnlyOfAMapThatIsOne) {
    const Transform turned =
        Transform::scaling(-3.0).then(Transform::rotation({1.0, 2.0, 3.0}, 40.0));
    const DVec3 offset{1.0, -2.0, 5.0};
    const auto same = Transform::similarity(turned.linear(), offset, 3.0);
    ASSERT_TRUE(same);
    EXPECT_TRUE(same->is_similarity());
    EXPECT_EQ(same->similarity_scale(), 3.0);
    EXPECT_EQ(same->linear(), turned.linear());
    EXPECT_EQ(same->offset(), offset);
    EXPECT_TRUE(same->is_mirrored());
    // Another scale than its own, a shear, and scales that are none.
    EXPECT_FALSE(Transform::similarity(turned.linear(), offset, 3.001));
    DMat3 shear{1.0};
    shear[1][0] = 0.5;
    EXPECT_FALSE(Transform::similarity(shear, offset, 1.0));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double scale : {0.0, -3.0, nan, infinity}) {
        EXPECT_FALSE(Transform::similarity(turned.linear(), offset, scale)) << scale;
    }
    EXPECT_FALSE(Transform::similarity(DMat3{nan}, offset, 1.0));
}

TEST(Transform, RotationAboutAnyAxisKeepsAxisAndLengths) {
    constexpr std::uint64_t kSeed = 3;
    std::mt19937_64 random(kSeed);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const DVec3 axis{number(random), number(random), number(random)};
        const DVec3 v{number(random), number(random), number(random)};
        const Transform turn = Transform::rotation(axis * 1e200, 360.0 * number(random));
        expect_near(turn.vector(axis), axis, 1e-15);
        EXPECT_NEAR(glm::length(turn.vector(v)), glm::length(v), 2e-15);
        EXPECT_FALSE(turn.is_mirrored());
    }
}

TEST(Transform, NormalStaysPerpendicularUnderNonUniformScaleAndShear) {
    const Transform map =
        Transform::scaling({3.0, 0.5, 2.0})
            .then(Transform::rotation({1.0, 2.0, 3.0}, 40.0))
            .then(Transform::affine(DMat3{1.0, 0.0, 0.0, 0.7, 1.0, 0.0, 0.0, 0.2, 1.0}, {}));
    const DVec3 u{1.0, 2.0, -1.0};
    const DVec3 v{0.5, -1.0, 3.0};
    const DVec3 n = glm::normalize(map.normal(cross(u, v)));
    EXPECT_NEAR(dot(n, glm::normalize(map.vector(u))), 0.0, 1e-15);
    EXPECT_NEAR(dot(n, glm::normalize(map.vector(v))), 0.0, 1e-15);
}

TEST(Transform, NormalPointsToTheSameSideUnderMirroring) {
    const Transform mirror = Transform::scaling({-1.0, 1.0, 1.0});
    EXPECT_TRUE(mirror.is_mirrored());
    EXPECT_EQ(mirror.normal({1.0, 0.0, 0.0}), (DVec3{-1.0, 0.0, 0.0}));
    EXPECT_EQ(mirror.normal({0.0, 1.0, 0.0}), (DVec3{0.0, 1.0, 0.0}));
    EXPECT_EQ(glm::normalize(Transform::scaling(-2.0).normal({0.0, 0.0, 1.0})),
              (DVec3{0.0, 0.0, -1.0}));
    EXPECT_FALSE(mirror.then(mirror).is_mirrored());
}

TEST(Transform, NormalAndMirroringSurviveHugeAndTinyScales) {
    for (const double scale : {1e-150, 1e-110, 1e150, 1e300}) {
        const DVec3 n = Transform::scaling(-scale).normal({0.0, 1.0, 0.0});
        EXPECT_EQ(glm::normalize(n), (DVec3{0.0, -1.0, 0.0})) << scale;
        EXPECT_TRUE(Transform::scaling(-scale).is_mirrored()) << scale;
        EXPECT_FALSE(Transform::scaling(scale).is_mirrored()) << scale;
    }
}

TEST(Transform, InverseUndoesTheMap) {
    constexpr std::uint64_t kSeed = 4;
    std::mt19937_64 random(kSeed);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const DVec3 axis{number(random), number(random), number(random)};
        const Transform map =
            Transform::scaling({2.0 + number(random), -2.0 + number(random), 3.0})
                .then(Transform::rotation(axis, 360.0 * number(random)))
                .then(Transform::translation({number(random), number(random), 1.0}));
        const auto inverse = map.inverse();
        ASSERT_TRUE(inverse);
        const DVec3 p{number(random), number(random), number(random)};
        expect_near(inverse->point(map.point(p)), p, 2e-15);
        expect_near(map.point(inverse->point(p)), p, 4e-15);
    }
}

TEST(Transform, InverseOfExtremeButDistinctScalesExists) {
    const auto inverse = Transform::scaling({1e-200, 1.0, 1e200}).inverse();
    ASSERT_TRUE(inverse);
    expect_near(inverse->vector({1e-200, 1.0, 1e200}), {1.0, 1.0, 1.0}, 1e-15);
}

TEST(Transform, SingularMapHasNoInverse) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(Transform::scaling(0.0).inverse());
    EXPECT_FALSE(Transform::scaling({1.0, 0.0, 1.0}).inverse());
    EXPECT_FALSE(Transform::scaling(nan).inverse());
    EXPECT_FALSE(Transform::scaling(infinity).inverse());
    EXPECT_FALSE(Transform::translation({0.0, infinity, 0.0}).inverse());
    EXPECT_FALSE(Transform::scaling(1e-310).inverse());  // its inverse is not finite
    // Two equal columns, and three in one plane of which rounding leaves a tiny determinant.
    EXPECT_FALSE(Transform::affine(DMat3{1, 2, 3, 1, 2, 3, 0, 0, 1}, {}).inverse());
    EXPECT_FALSE(
        Transform::affine(DMat3{0.1, 0.4, 0.7, 0.2, 0.5, 0.8, 0.3, 0.6, 0.9}, {}).inverse());
}

TEST(Transform, SimilarityIsKnownByTheStepsNotTheNumbers) {
    const Transform similarity = Transform::scaling(-2.0)
                                     .then(Transform::rotation({1.0, 1.0, 0.0}, 33.0))
                                     .then(Transform::scaling(3.0))
                                     .then(Transform::translation({1.0, 2.0, 3.0}));
    ASSERT_TRUE(similarity.is_similarity());
    EXPECT_EQ(similarity.similarity_scale(), 6.0);
    ASSERT_TRUE(similarity.inverse() && similarity.inverse()->is_similarity());
    EXPECT_DOUBLE_EQ(similarity.inverse()->similarity_scale(), 1.0 / 6.0);
    EXPECT_FALSE(Transform::scaling({2.0, 2.0, 2.0}).is_similarity());
    EXPECT_FALSE(Transform::affine(DMat3{1.0}, {}).then(similarity).is_similarity());
    EXPECT_FALSE(similarity.then(Transform::scaling({1.0, 2.0, 1.0})).is_similarity());
}

TEST(TransformDeathTest, ScaleOfNoSimilarityIsAsserted) {
    EXPECT_DEATH(static_cast<void>(Transform::scaling({1.0, 2.0, 1.0}).similarity_scale()),
                 "is_similarity_");
}

}  // namespace
}  // namespace lray
