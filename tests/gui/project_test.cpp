#include "gui/project.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random.h"

namespace lray::gui {
namespace {

using scene::Camera;
using scene::Projection;

constexpr scene::Resolution kResolution{640, 480};

double length(DVec3 v) {
    return std::sqrt(dot(v, v));
}

Camera random_camera(test::Random& random, Projection projection) {
    Camera camera;
    camera.position = DVec3(random.vec3(-3.0, 3.0));
    camera.look_at = camera.position + DVec3(random.vec3(-1.0, 1.0)) + DVec3(0.1);
    camera.up = DVec3(random.vec3(-1.0, 1.0));
    camera.fov = random.uniform(0.2, 2.5);
    camera.height = random.uniform(0.5, 5.0);
    camera.projection = projection;
    return camera;
}

TEST(Projector, TheRayThroughAPointsPixelPassesThroughThePoint) {
    constexpr std::uint64_t kSeed = 61;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    int shown_count = 0;
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        for (int i = 0; i < 2000; ++i) {
            const Camera camera = random_camera(random, projection);
            const DVec3 point = DVec3(random.vec3(-6.0, 6.0));
            const auto pixel = Projector(camera, kResolution).point(point);
            if (!pixel || std::fabs(pixel->x) > 2000.0 || std::fabs(pixel->y) > 2000.0) continue;
            ++shown_count;
            const Ray ray = render::CameraRays(camera, kResolution).through(*pixel);
            const DVec3 offset = point - DVec3(ray.origin);
            EXPECT_LE(length(cross(offset, DVec3(ray.dir))), 1e-5) << i;
            EXPECT_GT(dot(offset, DVec3(ray.dir)), 0.0);
        }
    }
    EXPECT_GT(shown_count, 1000);
}

TEST(Projector, WhatIsLookedAtIsInTheMiddle) {
    const auto pixel = Projector(Camera{}, kResolution).point(DVec3(0.0));
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x, 320.0, 1e-12);
    EXPECT_NEAR(pixel->y, 240.0, 1e-12);
}

TEST(Projector, BehindTheCameraIsNothing) {
    const Projector projector(Camera{}, kResolution);
    EXPECT_FALSE(projector.point({0.0, 0.0, 6.0}));
    EXPECT_FALSE(projector.point({1.0, 0.0, 5.0}));  // beside it
    EXPECT_FALSE(projector.segment({0.0, 0.0, 6.0}, {1.0, 1.0, 7.0}));
    EXPECT_FALSE(projector.point(DVec3(std::nan(""))));
    EXPECT_FALSE(projector.segment(DVec3(std::nan("")), DVec3(0.0)));
    EXPECT_FALSE(projector.segment(DVec3(HUGE_VAL), DVec3(0.0)));
}

TEST(Projector, APanoramaShowsNothing) {
    Camera camera;
    camera.projection = Projection::panorama;
    EXPECT_FALSE(Projector(camera, kResolution).point(DVec3(0.0)));
    EXPECT_FALSE(Projector(camera, kResolution).segment(DVec3(0.0), DVec3(1.0)));
}

TEST(Projector, ASegmentInThePictureKeepsItsEnds) {
    const Projector projector(Camera{}, kResolution);
    const auto segment = projector.segment({-1.0, 0.0, 0.0}, {1.0, 0.5, -1.0});
    ASSERT_TRUE(segment);
    EXPECT_EQ(segment->from, *projector.point({-1.0, 0.0, 0.0}));
    EXPECT_EQ(segment->to, *projector.point({1.0, 0.5, -1.0}));
}

TEST(Projector, ASegmentThatGoesBehindTheCameraEndsAtTheEdge) {
    const Projector projector(Camera{}, kResolution);
    // To the right of the camera on its way back.
    const auto segment = projector.segment({1.0, 0.0, 0.0}, {1.0, 0.0, 10.0});
    ASSERT_TRUE(segment);
    EXPECT_EQ(segment->from, *projector.point({1.0, 0.0, 0.0}));
    EXPECT_NEAR(segment->to.x, 2.0 * 640.0, 1e-9);
    EXPECT_NEAR(segment->to.y, 240.0, 1e-6);
    const auto back = projector.segment({1.0, 0.0, 10.0}, {1.0, 0.0, 0.0});
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->from.x, segment->to.x, 1e-6);
}

/// What is left of a segment lies on its picture, and what was cut off is not to be seen.
TEST(Projector, RandomSegmentsShowWhatIsInThePicture) {
    constexpr std::uint64_t kSeed = 67;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    int tested_count = 0;
    for (int i = 0; i < 3000; ++i) {
        const Camera camera =
            random_camera(random, i % 2 == 0 ? Projection::perspective : Projection::orthographic);
        const Projector projector(camera, kResolution);
        const double scale = std::pow(10.0, random.uniform(-1.0, 6.0));
        const DVec3 from = DVec3(random.vec3(-1.0, 1.0)) * scale;
        const DVec3 to = DVec3(random.vec3(-1.0, 1.0)) * scale;
        const auto segment = projector.segment(from, to);
        if (segment) {
            for (const DVec2 end : {segment->from, segment->to}) {
                EXPECT_GE(end.x, -640.0);
                EXPECT_LE(end.x, 1280.0);
                EXPECT_GE(end.y, -480.0);
                EXPECT_LE(end.y, 960.0);
            }
        }
        const DVec3 inside = from + random.uniform() * (to - from);
        const auto pixel = projector.point(inside);
        const render::CameraFrame frame =
            render::camera_frame(camera.position, camera.look_at, camera.up);
        const double depth = dot(inside - camera.position, frame.forward);
        if (!pixel || depth < 1e-4 * scale) continue;
        if (pixel->x < 0.0 || pixel->x > 640.0 || pixel->y < 0.0 || pixel->y > 480.0) continue;
        ++tested_count;
        ASSERT_TRUE(segment) << i;
        const DVec2 way = segment->to - segment->from;
        const DVec2 offset = *pixel - segment->from;
        const double size = std::sqrt(dot(way, way));
        EXPECT_LE(std::fabs(way.x * offset.y - way.y * offset.x), 1e-3 * size) << i;
        EXPECT_GE(dot(way, offset), -1e-3 * size);
        EXPECT_LE(dot(way, offset), size * size + 1e-3 * size);
    }
    EXPECT_GT(tested_count, 100);
}

}  // namespace
}  // namespace lray::gui
