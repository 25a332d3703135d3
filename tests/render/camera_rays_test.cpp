#include "render/camera_rays.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.h"
#include "tests/support/random.h"

namespace lray::render {
namespace {

void expect_near(Vec3 actual, DVec3 expected, double tolerance) {
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(static_cast<double>(actual[axis]), expected[axis], tolerance) << axis;
    }
}

constexpr double kDirectionTolerance = 2e-7;  // float rounding of unit vectors, and of the tangent

scene::Camera camera_with(double fov_degrees) {
    scene::Camera camera;  // at (0, 0, 5), looks along -z
    camera.fov = radians(fov_degrees);
    return camera;
}

TEST(CameraRays, CentreLooksAlongTheView) {
    const CameraRays rays(camera_with(45.0), {640, 480});
    const Ray ray = rays.through({320.0, 240.0});
    EXPECT_EQ(ray.origin, Vec3(0.0f, 0.0f, 5.0f));
    EXPECT_EQ(ray.dir, Vec3(0.0f, 0.0f, -1.0f));
}

TEST(CameraRays, TopEdgeIsHalfTheFieldOfViewUp) {
    const CameraRays rays(camera_with(60.0), {640, 480});
    expect_near(rays.through({320.0, 0.0}).dir, {0.0, 0.5, -std::sqrt(0.75)}, kDirectionTolerance);
    expect_near(rays.through({320.0, 480.0}).dir, {0.0, -0.5, -std::sqrt(0.75)},
                kDirectionTolerance);
}

TEST(CameraRays, CornersWithSquarePixels) {
    // At 90 degrees the picture is 2 high at distance 1, and 4 wide: the corner is (-2, 1, -1).
    const CameraRays rays(camera_with(90.0), {400, 200});
    const double length = std::sqrt(6.0);
    expect_near(rays.through({0.0, 0.0}).dir, DVec3(-2.0, 1.0, -1.0) / length, kDirectionTolerance);
    expect_near(rays.through({400.0, 200.0}).dir, DVec3(2.0, -1.0, -1.0) / length,
                kDirectionTolerance);
}

TEST(CameraRays, FirstPixelOfATallPicture) {
    const CameraRays rays(camera_with(90.0), {1, 3});
    const DVec3 expected{0.0, 2.0 / 3.0, -1.0};
    expect_near(rays.through({0.5, 0.5}).dir, expected / std::sqrt(dot(expected, expected)),
                kDirectionTolerance);
}

TEST(CameraRays, APanoramaSeesAllAround) {
    scene::Camera camera;  // at (0, 0, 5), looks along -z
    camera.projection = scene::Projection::panorama;
    const CameraRays rays(camera, {400, 200});
    EXPECT_EQ(rays.through({200.0, 100.0}).origin, Vec3(0.0f, 0.0f, 5.0f));
    expect_near(rays.through({200.0, 100.0}).dir, {0.0, 0.0, -1.0}, kDirectionTolerance);
    expect_near(rays.through({300.0, 100.0}).dir, {1.0, 0.0, 0.0}, kDirectionTolerance);
    expect_near(rays.through({100.0, 100.0}).dir, {-1.0, 0.0, 0.0}, kDirectionTolerance);
    expect_near(rays.through({0.0, 100.0}).dir, {0.0, 0.0, 1.0}, kDirectionTolerance);
    expect_near(rays.through({400.0, 100.0}).dir, {0.0, 0.0, 1.0}, kDirectionTolerance);
    expect_near(rays.through({123.0, 0.0}).dir, {0.0, 1.0, 0.0}, kDirectionTolerance);
    expect_near(rays.through({123.0, 200.0}).dir, {0.0, -1.0, 0.0}, kDirectionTolerance);
    const double s = std::sqrt(0.5);
    expect_near(rays.through({300.0, 50.0}).dir, {s, s, 0.0}, kDirectionTolerance);
}

TEST(CameraRays, LookingFromAnotherSideTurnsTheFrame) {
    scene::Camera camera = camera_with(90.0);
    camera.position = {10.0, 0.0, 0.0};
    camera.look_at = {0.0, 0.0, 0.0};  // along -x: right is -z
    const CameraRays rays(camera, {200, 200});
    expect_near(rays.through({200.0, 100.0}).dir, DVec3(-1.0, 0.0, -1.0) / std::sqrt(2.0),
                kDirectionTolerance);
    expect_near(rays.through({100.0, 0.0}).dir, DVec3(-1.0, 1.0, 0.0) / std::sqrt(2.0),
                kDirectionTolerance);
}

TEST(CameraRays, UpNeedBeNeitherUnitNorOrthogonal) {
    scene::Camera tilted = camera_with(50.0);
    tilted.up = {0.0, 1e-200, 3e-200};
    const CameraRays straight(camera_with(50.0), {320, 200});
    const CameraRays rays(tilted, {320, 200});
    expect_near(rays.through({17.0, 31.0}).dir, DVec3(straight.through({17.0, 31.0}).dir), 1e-7);
}

TEST(CameraRays, UpAlongTheViewGivesWay) {
    scene::Camera camera = camera_with(90.0);
    camera.position = {0.0, 4.0, 0.0};  // straight down, up = +y
    const CameraRays rays(camera, {100, 100});
    EXPECT_EQ(rays.through({50.0, 50.0}).dir, Vec3(0.0f, -1.0f, 0.0f));
    for (const DVec2 corner : {DVec2(0.0, 0.0), DVec2(100.0, 0.0)}) {
        const Vec3 dir = rays.through(corner).dir;
        EXPECT_NEAR(dot(dir, dir), 1.0f, 1e-6f);
    }
}

TEST(CameraRays, OrthographicRaysAreParallelAndHeightApart) {
    scene::Camera camera = camera_with(45.0);
    camera.projection = scene::Projection::orthographic;
    camera.height = 3.0;
    const CameraRays rays(camera, {400, 200});
    const Ray top_left = rays.through({0.0, 0.0});
    const Ray bottom_right = rays.through({400.0, 200.0});
    EXPECT_EQ(top_left.origin, Vec3(-3.0f, 1.5f, 5.0f));
    EXPECT_EQ(bottom_right.origin, Vec3(3.0f, -1.5f, 5.0f));
    EXPECT_EQ(top_left.dir, Vec3(0.0f, 0.0f, -1.0f));
    EXPECT_EQ(bottom_right.dir, top_left.dir);
}

TEST(CameraRays, RandomCamerasHaveUnitDirectionsAndARightHandedFrame) {
    constexpr std::uint64_t kSeed = 11;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    for (int i = 0; i < 1000; ++i) {
        scene::Camera camera = camera_with(random.uniform(1.0, 170.0));
        const double scale = std::pow(10.0, random.uniform(-6.0, 6.0));
        camera.position = DVec3(random.vec3(-1.0, 1.0)) * scale;
        camera.look_at = DVec3(random.vec3(-1.0, 1.0)) * scale;
        camera.up = DVec3(random.vec3(-1.0, 1.0));
        const CameraFrame frame = camera_frame(camera.position, camera.look_at, camera.up);
        EXPECT_NEAR(dot(cross(frame.right, frame.up), -frame.forward), 1.0, 1e-12);
        EXPECT_GT(dot(frame.up, camera.up), 0.0);
        const CameraRays rays(camera, {640, 480});
        const Vec3 dir = rays.through({random.uniform(0.0, 640.0), random.uniform(0.0, 480.0)}).dir;
        EXPECT_NEAR(dot(dir, dir), 1.0f, 4e-7f);
    }
}

TEST(CameraRays, HugeAndTinyDistancesKeepTheDirection) {
    for (const double scale : {1e-300, 1e-30, 1e30, 1e300}) {
        scene::Camera camera = camera_with(90.0);
        camera.position = {0.0, 0.0, scale};
        camera.look_at = {0.0, 0.0, 0.0};
        EXPECT_EQ(CameraRays(camera, {2, 2}).through({1.0, 1.0}).dir, Vec3(0.0f, 0.0f, -1.0f));
    }
}

}  // namespace
}  // namespace lray::render
