#include "render/camera_rays.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/angle.h"
#include "base/sampler.h"
#include "render/decisions.h"
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

TEST(DiskPoint, CornersSidesAndCentre) {
    const double s = std::sqrt(0.5);
    const auto expect = [](DVec2 pair, DVec2 expected) {
        EXPECT_NEAR(disk_point(pair).x, expected.x, 1e-15);
        EXPECT_NEAR(disk_point(pair).y, expected.y, 1e-15);
    };
    EXPECT_EQ(disk_point(kLensCenter), DVec2(0.0, 0.0));
    expect({1.0, 0.5}, {1.0, 0.0});
    expect({0.0, 0.5}, {-1.0, 0.0});
    expect({0.5, 1.0}, {0.0, 1.0});
    expect({0.5, 0.0}, {0.0, -1.0});
    expect({1.0, 1.0}, {s, s});
    expect({0.0, 1.0}, {-s, s});
    expect({0.0, 0.0}, {-s, -s});
    expect({1.0, 0.0}, {s, -s});
}

// A map that keeps areas takes evenly spread pairs to points that fall evenly on rings of the same
// area, and on sectors of the same angle.
TEST(DiskPoint, KeepsAreas) {
    constexpr std::uint32_t kCount = 1u << 18;
    constexpr std::size_t kRings = 8;
    constexpr std::size_t kSectors = 16;
    std::array<double, kRings> rings{};
    std::array<double, kSectors> sectors{};
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const DVec2 point =
            disk_point(PixelSample::of(SamplerKind::sobol, 1, 2, 3, i).pair(kLensDecision));
        const double square = dot(point, point);
        ASSERT_LT(square, 1.0);
        ++rings[static_cast<std::size_t>(square * kRings)];
        const double turn = std::atan2(point.y, point.x) / (2.0 * std::acos(-1.0)) + 0.5;
        ++sectors[static_cast<std::size_t>(turn * kSectors) % kSectors];
    }
    for (const double count : rings) EXPECT_NEAR(count * kRings, kCount, 0.005 * kCount);
    for (const double count : sectors) EXPECT_NEAR(count * kSectors, kCount, 0.005 * kCount);
}

/// Where a ray meets the plane z = 0.
DVec2 on_plane(const Ray& ray) {
    const double t = static_cast<double>(ray.origin.z) / -static_cast<double>(ray.dir.z);
    return {static_cast<double>(ray.origin.x) + t * static_cast<double>(ray.dir.x),
            static_cast<double>(ray.origin.y) + t * static_cast<double>(ray.dir.y)};
}

constexpr std::array<DVec2, 6> kLensPairs{
    {{0.5, 0.5}, {0.0, 0.0}, {0.999, 0.0}, {0.25, 0.75}, {0.5, 0.999}, {0.1, 0.45}}};

TEST(CameraRays, AllOfTheLensSeesOnePointInThePlaneOfFocus) {
    for (const auto projection :
         {scene::Projection::perspective, scene::Projection::orthographic}) {
        scene::Camera camera = camera_with(60.0);
        camera.projection = projection;
        camera.height = 3.0;
        const Vec3 pinhole_origin = CameraRays(camera, {40, 30}).through({7.25, 3.5}).origin;
        const DVec2 sharp = on_plane(CameraRays(camera, {40, 30}).through({7.25, 3.5}));
        camera.aperture = 0.5;
        camera.focus = 5.0;  // the plane z = 0
        const CameraRays rays(camera, {40, 30});
        for (const DVec2 lens : kLensPairs) {
            const Ray ray = rays.through({7.25, 3.5}, lens);
            EXPECT_NEAR(dot(ray.dir, ray.dir), 1.0f, 4e-7f);
            EXPECT_EQ(ray.origin.z, 5.0f);
            const Vec3 aside = ray.origin - pinhole_origin;
            const DVec2 expected = 0.25 * disk_point(lens);
            EXPECT_NEAR(static_cast<double>(aside.x), expected.x, 1e-6);
            EXPECT_NEAR(static_cast<double>(aside.y), expected.y, 1e-6);
            EXPECT_NEAR(on_plane(ray).x, sharp.x, 2e-6);
            EXPECT_NEAR(on_plane(ray).y, sharp.y, 2e-6);
        }
    }
}

TEST(CameraRays, WithoutFocusWhatIsLookedAtIsSharp) {
    scene::Camera camera = camera_with(45.0);
    camera.aperture = 1.0;
    for (const DVec2 lens : kLensPairs) {
        const DVec2 point = on_plane(CameraRays(camera, {40, 30}).through({20.0, 15.0}, lens));
        EXPECT_NEAR(point.x, 0.0, 1e-6);
        EXPECT_NEAR(point.y, 0.0, 1e-6);
    }
}

TEST(CameraRays, TheMiddleOfALensIsThePinhole) {
    scene::Camera lens = camera_with(50.0);
    lens.aperture = 0.3;
    lens.focus = 0.125;
    const CameraRays rays(lens, {64, 48});
    const CameraRays pinhole(camera_with(50.0), {64, 48});
    for (const DVec2 position : {DVec2{0.0, 0.0}, DVec2{13.5, 40.25}}) {
        EXPECT_EQ(rays.through(position).origin, pinhole.through(position).origin);
        EXPECT_EQ(rays.through(position).dir, pinhole.through(position).dir);
    }
}

TEST(CameraRays, APanoramaHasNoLens) {
    scene::Camera camera;
    camera.projection = scene::Projection::panorama;
    camera.aperture = 2.0;
    const CameraRays rays(camera, {40, 20});
    EXPECT_FALSE(rays.has_lens());
    EXPECT_EQ(rays.through({3.0, 4.0}, {0.9, 0.1}).origin, Vec3(0.0f, 0.0f, 5.0f));
    EXPECT_EQ(rays.through({3.0, 4.0}, {0.9, 0.1}).dir, rays.through({3.0, 4.0}).dir);
}

TEST(CameraRays, HugeAndTinyFocusKeepTheDirection) {
    for (const double focus : {1e-300, 1e-30, 1e30, 1e300}) {
        scene::Camera camera = camera_with(90.0);
        camera.aperture = 1e-3 * focus;
        camera.focus = focus;
        const Vec3 dir = CameraRays(camera, {2, 2}).through({1.0, 1.0}, {1.0, 0.5}).dir;
        expect_near(dir, {-0.5e-3, 0.0, -1.0}, 1e-6);
    }
}

TEST(CameraRays, AConeIsAsWideAsThePixelsOnASphereAround) {
    const CameraRays rays(camera_with(90.0), {400, 200});
    for (const DVec2 position : {DVec2{200.0, 100.0}, DVec2{0.0, 0.0}, DVec2{391.0, 17.0}}) {
        const shade::RayCone cone = rays.cone(position);
        EXPECT_EQ(cone.width, 0.0f);
        // Neighbours in the direction around the middle of the picture are that far apart.
        const DVec2 out = position - DVec2{200.0, 100.0};
        const double length = std::sqrt(dot(out, out));
        const DVec2 around = length > 0.0 ? DVec2{-out.y, out.x} / length : DVec2{1.0, 0.0};
        const DVec3 apart = DVec3(rays.through(position + 0.5 * around).dir) -
                            DVec3(rays.through(position - 0.5 * around).dir);
        EXPECT_NEAR(cone.spread, std::sqrt(dot(apart, apart)), 3e-7);
    }
    EXPECT_NEAR(rays.cone({200.0, 100.0}).spread, 0.01f, 1e-9f);
}

TEST(CameraRays, ConesOfOtherProjections) {
    scene::Camera camera;
    camera.projection = scene::Projection::orthographic;
    camera.height = 3.0;
    EXPECT_EQ(CameraRays(camera, {40, 30}).cone({1.0, 2.0}).width, 0.1f);
    EXPECT_EQ(CameraRays(camera, {40, 30}).cone({1.0, 2.0}).spread, 0.0f);
    camera.projection = scene::Projection::panorama;
    const CameraRays rays(camera, {40, 20});
    const DVec3 apart =
        DVec3(rays.through({20.0, 10.5}).dir) - DVec3(rays.through({20.0, 9.5}).dir);
    EXPECT_NEAR(rays.cone({20.0, 10.0}).spread, std::sqrt(dot(apart, apart)), 2e-4);
}

}  // namespace
}  // namespace lray::render
