// Normals tilted by heights that are known, and by codes of a normal map.
#include "shade/bump.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lray::shade {
namespace {

/// A floor whose texture coordinates are two to the metre, in an object scaled by 0.5.
bvh::SurfaceDetail floor_detail() {
    bvh::SurfaceDetail detail;
    detail.shading_normal = {0, 1, 0};
    detail.dp_du = {0.5f, 0, 0};
    detail.dp_dv = {0, 0, -0.5f};
    detail.object_from_world = DMat3{2.0};
    detail.object_per_world = 2.0;
    return detail;
}

constexpr Vec3 kUp{0, 1, 0};

void expect_direction(Vec3 found, DVec3 expected) {
    const DVec3 unit = glm::normalize(expected);
    EXPECT_NEAR(glm::length(DVec3{found} - unit), 0.0, 1e-5)
        << found.x << ' ' << found.y << ' ' << found.z;
}

template <class Height>
Vec3 bumped(const bvh::SurfaceDetail& detail, const TexturePoint& point, const Height& height) {
    const DVec3 gradient = bump_gradient(detail, point, height);
    return above_surface(DVec3{detail.shading_normal} - gradient, detail.shading_normal, kUp);
}

TEST(Bump, SlopeInTheWorldTiltsTheNormalAgainstIt) {
    for (const double width : {0.0, 0.01}) {
        TexturePoint point;
        point.world = {3, 0, 1};
        point.world_width = width;
        const auto height = [](const TexturePoint& at) {
            return static_cast<float>(0.5 * (at.world.x - 3.0));
        };
        expect_direction(bumped(floor_detail(), point, height), {-0.5, 1, 0});
    }
}

TEST(Bump, SlopeInObjectSpaceIsSteeperByItsScale) {
    const auto height = [](const TexturePoint& at) { return static_cast<float>(at.object.z); };
    expect_direction(bumped(floor_detail(), {}, height), {0, 1, -2});
}

TEST(Bump, SlopeInUvIsThatOfItsDirections) {
    const auto along_u = [](const TexturePoint& at) { return static_cast<float>(at.uv.x); };
    expect_direction(bumped(floor_detail(), {}, along_u), {-2, 1, 0});
    const auto along_v = [](const TexturePoint& at) { return static_cast<float>(at.uv.y); };
    expect_direction(bumped(floor_detail(), {}, along_v), {0, 1, 2});
    // Skewed coordinates.
    bvh::SurfaceDetail skewed = floor_detail();
    skewed.dp_dv = {0.5f, 0, -0.5f};
    expect_direction(bumped(skewed, {}, along_u), {-2, 1, -2});
    expect_direction(bumped(skewed, {}, along_v), {0, 1, 2});
}

TEST(Bump, InUnitsOfUvItIsTheSameAtAnySize) {
    const auto height = [](const TexturePoint& at) {
        return static_cast<float>(0.5 * at.uv.x - at.uv.y);
    };
    for (const float scale : {1.0f, 0x1p-20f, 0x1p20f}) {
        bvh::SurfaceDetail detail = floor_detail();
        detail.dp_du *= scale;
        detail.dp_dv *= scale;
        EXPECT_EQ(uv_length(detail), 0.5 * static_cast<double>(scale));
        TexturePoint point;
        point.world_width = 0x1p-13 * static_cast<double>(scale);
        const DVec3 gradient = uv_length(detail) * bump_gradient(detail, point, height);
        EXPECT_NEAR(glm::length(gradient - DVec3(0.5, 0, 1)), 0.0, 1e-3) << scale;
    }
}

TEST(Bump, UvWithoutDirectionHasNoLength) {
    bvh::SurfaceDetail detail = floor_detail();
    detail.dp_dv = 3.0f * detail.dp_du;
    EXPECT_EQ(uv_length(detail), 0.0);
    detail.dp_dv = Vec3{std::numeric_limits<float>::infinity()};
    EXPECT_EQ(uv_length(detail), 0.0);
}

TEST(Bump, OfSolidTexturesNeedsNoDirectionOfUv) {
    bvh::SurfaceDetail pole = floor_detail();
    pole.dp_du = Vec3{0.0f};
    pole.dp_dv = Vec3{0.0f};
    const auto solid = [](const TexturePoint& at) { return static_cast<float>(at.object.x); };
    expect_direction(bumped(pole, {}, solid), {-2, 1, 0});
    const auto flat = [](const TexturePoint& at) { return static_cast<float>(at.uv.x + at.uv.y); };
    expect_direction(bumped(pole, {}, flat), {0, 1, 0});
}

TEST(Bump, WhatIsFinerThanAPixelIsAveraged) {
    TexturePoint point;
    point.world_width = 1.0;
    const auto height = [](const TexturePoint& at) {
        return static_cast<float>(0.1 * at.world.x + 0.3 * std::sin(6.2831853 * 2.0 * at.world.x));
    };
    expect_direction(bumped(floor_detail(), point, height), {-0.1, 1, 0});
}

TEST(Bump, NeverTurnsTheNormalBelowTheSurface) {
    for (const double slope : {1e3, 1e9, -1e9}) {
        const auto height = [&](const TexturePoint& at) {
            return static_cast<float>(slope * at.world.x);
        };
        // The shading normal leans, as near the rim of a smooth mesh: that may be below.
        bvh::SurfaceDetail leaning = floor_detail();
        leaning.shading_normal = Vec3{glm::normalize(DVec3{0.9, 0.1, 0})};
        for (const bvh::SurfaceDetail& detail : {floor_detail(), leaning}) {
            const Vec3 normal = bumped(detail, {}, height);
            EXPECT_GT(dot(normal, kUp), 0.0f);
            EXPECT_NEAR(glm::length(normal), 1.0f, 1e-6f);
        }
    }
}

TEST(Bump, HeightsThatAreNoNumbersLeaveTheNormal) {
    const auto height = [](const TexturePoint&) { return std::nanf(""); };
    EXPECT_EQ(bumped(floor_detail(), {}, height), kUp);
}

TEST(NormalMap, CodesAreDirectionsInTheTangentFrame) {
    const bvh::SurfaceDetail detail = floor_detail();
    const auto normal_of = [&](Color code) {
        return above_surface(mapped_normal(detail, code), detail.shading_normal, kUp);
    };
    expect_direction(normal_of({0.5f, 0.5f, 1.0f}), {0, 1, 0});
    expect_direction(normal_of({1.0f, 0.5f, 1.0f}), {1, 1, 0});
    expect_direction(normal_of({0.5f, 0.75f, 1.0f}), {0, 1, -0.5});
    EXPECT_EQ(normal_of({0.5f, 0.5f, 0.5f}), kUp);  // no direction
    EXPECT_GT(dot(normal_of({1.0f, 0.5f, 0.0f}), kUp), 0.0f);
}

TEST(NormalMap, OfAMirroredSurfaceKeepsUAndV) {
    bvh::SurfaceDetail mirrored = floor_detail();
    mirrored.dp_du = -mirrored.dp_du;
    expect_direction(Vec3{glm::normalize(mapped_normal(mirrored, {1.0f, 0.75f, 1.0f}))},
                     {-1, 1, -0.5});
}

TEST(NormalMap, IsNothingWhereUvHasNoDirection) {
    bvh::SurfaceDetail pole = floor_detail();
    pole.dp_du = Vec3{0.0f};
    pole.dp_dv = Vec3{0.0f};
    EXPECT_EQ(Vec3{mapped_normal(pole, {1.0f, 0.5f, 0.5f})}, kUp);
    EXPECT_FALSE(tangent_frame(pole).has_value());
}

TEST(TangentFrame, AroundAnyNormalIsOrthonormal) {
    for (const DVec3 direction :
         {DVec3{0, 0, 1}, DVec3{0, 0, -1}, DVec3{1, 2, 3}, DVec3{-1, 1e-9, -5}}) {
        const TangentFrame frame = any_frame(Vec3{glm::normalize(direction)});
        EXPECT_NEAR(glm::length(frame.u), 1.0, 1e-6);
        EXPECT_NEAR(glm::length(frame.v), 1.0, 1e-6);
        EXPECT_NEAR(dot(frame.u, frame.v), 0.0, 1e-6);
        EXPECT_NEAR(dot(frame.u, frame.normal), 0.0, 1e-6);
        EXPECT_NEAR(dot(frame.v, frame.normal), 0.0, 1e-6);
    }
}

}  // namespace
}  // namespace lray::shade
