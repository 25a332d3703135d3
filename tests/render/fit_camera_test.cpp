#include "render/fit_camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/camera_rays.h"
#include "tests/support/random.h"

namespace lray::render {
namespace {

/// The position of a point in the picture, in [-1, 1] each way; infinite if it lies behind.
DVec2 projected(const scene::Camera& camera, scene::Resolution resolution, DVec3 point) {
    const CameraFrame frame = camera_frame(camera.position, camera.look_at, camera.up);
    const DVec3 offset = point - camera.position;
    double depth = dot(offset, frame.forward);
    if (depth <= 0.0) return DVec2(HUGE_VAL);
    double half_height = std::tan(camera.fov / 2.0);
    if (camera.projection == scene::Projection::orthographic) {
        depth = 1.0;
        half_height = camera.height / 2.0;
    }
    const double half_width = half_height * resolution.width / resolution.height;
    return {dot(offset, frame.right) / depth / half_width,
            dot(offset, frame.up) / depth / half_height};
}

/// The farthest that any corner is from the centre of the picture.
double reach(const scene::Camera& camera, const Bounds& bounds, scene::Resolution resolution) {
    double result = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const DVec3 point{static_cast<double>((corner & 1) != 0 ? bounds.max.x : bounds.min.x),
                          static_cast<double>((corner & 2) != 0 ? bounds.max.y : bounds.min.y),
                          static_cast<double>((corner & 4) != 0 ? bounds.max.z : bounds.min.z)};
        const DVec2 position = projected(camera, resolution, point);
        result = std::max({result, std::fabs(position.x), std::fabs(position.y)});
    }
    return result;
}

double reach(const Bounds& bounds, scene::Resolution resolution) {
    return reach(fit_camera(bounds, resolution), bounds, resolution);
}

TEST(FitCamera, RandomBoundsAreSeenWholeAndFillThePicture) {
    constexpr std::uint64_t kSeed = 21;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    for (int i = 0; i < 2000; ++i) {
        const double scale = std::pow(10.0, random.uniform(-4.0, 6.0));
        const Vec3 center = random.vec3(-1.0, 1.0) * static_cast<float>(scale);
        const Vec3 half = random.vec3(0.0, 1.0) * static_cast<float>(scale);
        const Bounds bounds{center - half, center + half};
        const scene::Resolution resolution{static_cast<std::uint32_t>(1 + random.below(2000)),
                                           static_cast<std::uint32_t>(1 + random.below(2000))};
        EXPECT_LE(reach(bounds, resolution), 1.0);
        EXPECT_GE(reach(bounds, resolution), 0.5);
    }
}

TEST(FitCamera, LooksAtTheCentreFromAboveInFront) {
    const scene::Camera camera =
        fit_camera({Vec3(1.0f, 2.0f, 3.0f), Vec3(3.0f, 4.0f, 5.0f)}, {800, 600});
    EXPECT_EQ(camera.look_at, DVec3(2.0, 3.0, 4.0));
    EXPECT_GT(camera.position.x, 2.0);
    EXPECT_GT(camera.position.y, 3.0);
    EXPECT_GT(camera.position.z, 5.0);
    EXPECT_EQ(camera.projection, scene::Projection::perspective);
    EXPECT_NEAR(camera.fov, std::acos(-1.0) / 4.0, 1e-15);
}

TEST(FitCamera, NothingOrASinglePointStillGivesACamera) {
    const scene::Resolution resolution{800, 600};
    const scene::Camera empty = fit_camera(Bounds{}, resolution);
    EXPECT_EQ(empty.look_at, DVec3(0.0));
    EXPECT_GT(empty.position.y, 0.0);
    const scene::Camera point = fit_camera({Vec3(7.0f), Vec3(7.0f)}, resolution);
    EXPECT_EQ(point.look_at, DVec3(7.0));
    EXPECT_NE(point.position, point.look_at);
}

TEST(FitCamera, FlatBoundsAreSeenWhole) {
    EXPECT_LE(reach({Vec3(-5.0f, 0.0f, -5.0f), Vec3(5.0f, 0.0f, 5.0f)}, {640, 480}), 1.0);
}

DVec3 direction_of(const scene::Camera& camera) {
    return camera_frame(camera.position, camera.look_at, camera.up).forward;
}

/// A camera anywhere that looks anywhere, and bounds of any size and form.
struct View {
    scene::Camera camera{};
    Bounds bounds{};
    scene::Resolution resolution{};
};

View random_view(test::Random& random, scene::Projection projection) {
    View view;
    const double scale = std::pow(10.0, random.uniform(-4.0, 6.0));
    const Vec3 center = random.vec3(-1.0, 1.0) * static_cast<float>(scale);
    const Vec3 half = random.vec3(0.0, 1.0) * static_cast<float>(scale);
    view.bounds = {center - half, center + half};
    view.camera.position = DVec3{random.vec3(-5.0, 5.0)};
    view.camera.look_at = DVec3{random.vec3(-5.0, 5.0)};
    view.camera.up = DVec3{random.vec3(-1.0, 1.0)};
    view.camera.fov = random.uniform(0.02, 2.9);
    view.camera.projection = projection;
    // From as wide as a ribbon to as tall as one.
    view.resolution = {static_cast<std::uint32_t>(1 + random.below(2000)),
                       static_cast<std::uint32_t>(1 + random.below(2000))};
    return view;
}

void expect_same_look(const scene::Camera& camera, const scene::Camera& before) {
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(direction_of(camera)[axis], direction_of(before)[axis], 1e-6);
    }
    EXPECT_EQ(camera.up, before.up);
    EXPECT_EQ(camera.fov, before.fov);
    EXPECT_EQ(camera.projection, before.projection);
}

DVec3 middle_of(const Bounds& bounds) {
    return 0.5 * (DVec3{bounds.min} + DVec3{bounds.max});
}

void expect_near(DVec3 a, DVec3 b, double tolerance) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], tolerance);
}

double distance_of(const scene::Camera& camera) {
    const DVec3 way = camera.look_at - camera.position;
    return std::sqrt(dot(way, way));
}

constexpr double kRim = 1.1;

TEST(Framed, APerspectiveCameraSeesAllAndATenthNearerItWouldTouchTheRim) {
    constexpr std::uint64_t kSeed = 22;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    for (int i = 0; i < 2000; ++i) {
        const auto [camera, bounds, resolution] =
            random_view(random, scene::Projection::perspective);
        scene::Camera placed = framed(camera, bounds, resolution);
        expect_same_look(placed, camera);
        expect_near(placed.look_at, middle_of(bounds), 1e-9 * distance_of(placed));
        EXPECT_LT(reach(placed, bounds, resolution), 1.0);
        placed.position = placed.look_at + (placed.position - placed.look_at) / kRim;
        EXPECT_NEAR(reach(placed, bounds, resolution), 1.0, 1e-5);
    }
}

TEST(Framed, AnOrthographicViewIsAsHighAsTheBoundsAndARim) {
    constexpr std::uint64_t kSeed = 23;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    for (int i = 0; i < 2000; ++i) {
        const auto [camera, bounds, resolution] =
            random_view(random, scene::Projection::orthographic);
        const scene::Camera placed = framed(camera, bounds, resolution);
        expect_same_look(placed, camera);
        expect_near(placed.look_at, middle_of(bounds), 1e-9 * distance_of(placed));
        EXPECT_NEAR(reach(placed, bounds, resolution), 1.0 / kRim, 1e-5);
    }
}

TEST(Framed, APanoramaIsTakenFromTheMiddle) {
    constexpr std::uint64_t kSeed = 24;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    for (int i = 0; i < 500; ++i) {
        const auto [camera, bounds, resolution] = random_view(random, scene::Projection::panorama);
        const scene::Camera placed = framed(camera, bounds, resolution);
        expect_same_look(placed, camera);
        expect_near(placed.position, middle_of(bounds), 1e-9 * distance_of(placed));
    }
}

constexpr scene::Projection kProjections[] = {
    scene::Projection::perspective, scene::Projection::orthographic, scene::Projection::panorama};

TEST(Framed, TwiceIsTheSameAsOnce) {
    test::Random random(25);
    for (const scene::Projection projection : kProjections) {
        const auto [camera, bounds, resolution] = random_view(random, projection);
        const scene::Camera once = framed(camera, bounds, resolution);
        const scene::Camera twice = framed(once, bounds, resolution);
        expect_near(twice.position, once.position, 1e-9 * distance_of(once));
        EXPECT_NEAR(twice.height, once.height, 1e-9 * once.height);
    }
}

TEST(Framed, WhatIsLookedAtIsSharp) {
    scene::Camera camera;
    camera.aperture = 0.5;
    camera.focus = 3.0;
    const scene::Camera placed = framed(camera, {Vec3(-50.0f), Vec3(50.0f)}, {640, 480});
    EXPECT_FALSE(placed.focus.has_value());
    EXPECT_EQ(placed.aperture, 0.5);
}

TEST(Framed, NothingAPointOrALineStillGiveACamera) {
    const Vec3 far{1e18f, -1e18f, 3.0f};
    const Bounds some[] = {{},
                           {Vec3(7.0f), Vec3(7.0f)},
                           {far, far},
                           {Vec3(0.0f, -1.0f, 0.0f), Vec3(0.0f, 1.0f, 0.0f)},
                           {Vec3(0.0f, 0.0f, -2.0f), Vec3(0.0f, 0.0f, 2.0f)}};
    for (const Bounds& bounds : some) {
        for (const scene::Projection projection : kProjections) {
            scene::Camera camera;
            camera.projection = projection;
            const scene::Camera placed = framed(camera, bounds, {320, 200});
            EXPECT_NE(placed.position, placed.look_at);
            EXPECT_GT(placed.height, 0.0);
            const Bounds seen = bounds.is_empty() ? Bounds{Vec3(-1.0f), Vec3(1.0f)} : bounds;
            if (projection == scene::Projection::panorama) continue;
            EXPECT_LT(reach(placed, seen, {320, 200}), 1.0);
        }
    }
}

TEST(Framed, FitCameraIsThatOfADefaultCamera) {
    const Bounds bounds{Vec3(-1.0f, 2.0f, 3.0f), Vec3(4.0f, 4.5f, 5.0f)};
    scene::Camera camera;
    camera.position = {0.4, 0.5, 1.0};
    const scene::Camera a = fit_camera(bounds, {800, 600});
    const scene::Camera b = framed(camera, bounds, {800, 600});
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.look_at, b.look_at);
}

}  // namespace
}  // namespace lray::render
