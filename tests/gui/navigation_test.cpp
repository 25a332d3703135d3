#include "gui/navigation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "gui/project.h"
#include "render/camera_rays.h"
#include "tests/support/random.h"

namespace lray::gui {
namespace {

using scene::Camera;
using scene::Projection;

constexpr double kPi = std::numbers::pi;
constexpr double kScales[] = {1e-6, 1e-3, 1.0, 1e3, 1e6};

double length(DVec3 v) {
    return std::sqrt(dot(v, v));
}
double distance(const Camera& camera) {
    return length(camera.look_at - camera.position);
}
DVec3 forward(const Camera& camera) {
    return render::camera_frame(camera.position, camera.look_at, camera.up).forward;
}
double pitch(const Camera& camera) {
    return std::asin(dot(forward(camera), camera.up) / length(camera.up));
}

/// Not closer than 0.1 of its scale to what it looks at, and not steep.
Camera random_camera(test::Random& random, double scale) {
    Camera camera;
    do {
        camera.position = DVec3(random.vec3(-1.0, 1.0)) * scale;
        camera.look_at = DVec3(random.vec3(-1.0, 1.0)) * scale;
        camera.up = DVec3(random.vec3(-1.0, 1.0));
    } while (distance(camera) < 0.1 * scale || length(camera.up) < 0.1 ||
             std::fabs(pitch(camera)) > 1.2);
    camera.fov = random.uniform(0.2, 2.5);
    return camera;
}

void expect_near(DVec3 actual, DVec3 expected, double tolerance) {
    EXPECT_LE(length(actual - expected), tolerance)
        << actual.x << ' ' << actual.y << ' ' << actual.z;
}

void expect_usable(const Camera& camera) {
    for (int axis = 0; axis < 3; ++axis) {
        ASSERT_TRUE(std::isfinite(camera.position[axis]));
        ASSERT_TRUE(std::isfinite(camera.look_at[axis]));
    }
    ASSERT_GT(distance(camera), 0.0);
    ASSERT_GT(camera.height, 0.0);
    const render::CameraFrame frame =
        render::camera_frame(camera.position, camera.look_at, camera.up);
    ASSERT_NEAR(dot(cross(frame.right, frame.up), -frame.forward), 1.0, 1e-9);
    ASSERT_NEAR(length(frame.right), 1.0, 1e-9);
}

/// Calls test(camera, scale, random) for cameras of all scales.
template <class Test>
void for_random_cameras(Test test) {
    constexpr std::uint64_t kSeed = 41;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    for (const double scale : kScales) {
        for (int i = 0; i < 200; ++i) test(random_camera(random, scale), scale, random);
    }
}

TEST(Moved, TheFourWaysOfTheDefaultCamera) {
    const Camera camera;  // at (0, 0, 5), looks along -z
    expect_near(moved(camera, {1.0, 0.0, 0.0}).position, {1.0, 0.0, 5.0}, 1e-15);
    expect_near(moved(camera, {0.0, 1.0, 0.0}).position, {0.0, 1.0, 5.0}, 1e-15);
    expect_near(moved(camera, {0.0, 0.0, 1.0}).position, {0.0, 0.0, 4.0}, 1e-15);
    expect_near(moved(camera, {0.0, 0.0, 1.0}).look_at, {0.0, 0.0, -1.0}, 1e-15);
}

TEST(Moved, KeepsDistanceAndDirection) {
    for_random_cameras([](const Camera& camera, double scale, test::Random& random) {
        const DVec3 step = DVec3(random.vec3(-1.0, 1.0)) * scale;
        const Camera after = moved(camera, step);
        EXPECT_NEAR(distance(after) / distance(camera), 1.0, 1e-13);
        expect_near(forward(after), forward(camera), 1e-13);
        EXPECT_NEAR(length(after.position - camera.position) / length(step), 1.0, 1e-13);
        EXPECT_EQ(after.up, camera.up);
        EXPECT_EQ(after.fov, camera.fov);
    });
}

TEST(Moved, ForwardZoomsAnOrthographicView) {
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.height = 4.0;
    const Camera after = moved(camera, {0.0, 0.0, 4.0});
    EXPECT_NEAR(after.height, 4.0 / std::numbers::e, 1e-14);
    EXPECT_EQ(after.position, camera.position);
    EXPECT_GT(moved(camera, {0.0, 0.0, -1.0}).height, 4.0);
    EXPECT_GT(moved(camera, {0.0, 0.0, 1e300}).height, 0.0);
    EXPECT_TRUE(std::isfinite(moved(camera, {0.0, 0.0, -1e300}).height));
}

TEST(Moved, FarAwayTheDirectionIsKeptThoughTheDistanceIsLost) {
    Camera camera;
    camera.position = {0.0, 0.0, 1e-6};
    camera.look_at = {-3e-7, -4e-7, 0.0};
    const DVec3 before = forward(camera);
    camera = moved(camera, {1e6, 2e6, 3e6});
    expect_near(forward(camera), before, 1e-7);
    expect_usable(camera);
}

TEST(Moved, NeverFartherThanTheLimit) {
    const Camera camera;
    EXPECT_TRUE(std::isfinite(moved(camera, {0.0, 0.0, 1e308}).position.z));
    EXPECT_EQ(moved(camera, {0.0, 0.0, -1e13}).position, camera.position);
    Camera lost = camera;
    lost.position.z = 2e12;
    EXPECT_NEAR(moved(lost, {0.0, 0.0, 1e12}).position.z, 1e12, 1.0);  // may come back
}

TEST(Turned, ToTheLeftAndUpwards) {
    const Camera camera;  // looks along -z
    expect_near(forward(turned(camera, kPi / 2.0, 0.0)), {-1.0, 0.0, 0.0}, 1e-15);
    expect_near(forward(turned(camera, 0.0, kPi / 4.0)), {0.0, std::sqrt(0.5), -std::sqrt(0.5)},
                1e-15);
    EXPECT_EQ(turned(camera, 1.0, 0.5).position, camera.position);
}

TEST(Turned, KeepsDistanceAndAddsItsAngles) {
    for_random_cameras([](const Camera& camera, double, test::Random& random) {
        const double yaw = random.uniform(-kPi, kPi);
        const double rise = random.uniform(-0.3, 0.3);
        const Camera after = turned(camera, yaw, rise);
        EXPECT_NEAR(distance(after) / distance(camera), 1.0, 1e-13);
        EXPECT_NEAR(pitch(after), pitch(camera) + rise, 1e-9);
        // Around `up` only the part across it turns.
        const DVec3 up = camera.up / length(camera.up);
        const auto across = [&](const Camera& c) {
            const DVec3 f = forward(c);
            const DVec3 flat = f - dot(f, up) * up;
            return flat / length(flat);
        };
        EXPECT_NEAR(dot(across(camera), across(after)), std::cos(yaw), 1e-9);
        EXPECT_NEAR(dot(cross(across(camera), across(after)), up), std::sin(yaw), 1e-9);
    });
}

TEST(Turned, PitchEndsShortOfThePoles) {
    for_random_cameras([](const Camera& camera, double, test::Random& random) {
        EXPECT_NEAR(pitch(turned(camera, random.uniform(-9.0, 9.0), 10.0)), kSteepestPitch, 1e-9);
        EXPECT_NEAR(pitch(turned(camera, random.uniform(-9.0, 9.0), -10.0)), -kSteepestPitch, 1e-9);
    });
}

TEST(Turned, StraightDownComesBackWithinTheLimit) {
    Camera camera;
    camera.position = {0.0, 4.0, 0.0};
    const Camera after = turned(camera, 0.1, 0.0);
    EXPECT_NEAR(pitch(after), -kSteepestPitch, 1e-12);
    EXPECT_EQ(turned(camera, 0.0, 0.0).look_at, camera.look_at);
    expect_usable(after);
}

TEST(Turned, WithoutAnUpDirectionStillTurns) {
    Camera camera;
    camera.up = DVec3(0.0);
    expect_usable(turned(camera, 0.3, 0.2));
}

TEST(Orbited, ThereAndBackIsTheSamePlace) {
    for_random_cameras([](const Camera& camera, double scale, test::Random& random) {
        const double yaw = random.uniform(-kPi, kPi);
        const double rise = random.uniform(-0.3, 0.3);
        const Camera there = orbited(camera, yaw, rise);
        EXPECT_NEAR(distance(there) / distance(camera), 1.0, 1e-13);
        EXPECT_EQ(there.look_at, camera.look_at);
        expect_near(orbited(there, -yaw, -rise).position, camera.position, 1e-9 * scale);
    });
}

TEST(Orbited, TheCameraGoesToTheRightAndBelow) {
    const Camera camera;
    expect_near(orbited(camera, kPi / 2.0, 0.0).position, {5.0, 0.0, 0.0}, 1e-14);
    EXPECT_LT(orbited(camera, 0.0, 0.5).position.y, 0.0);
}

TEST(Orbited, AFullCircleInManyStepsComesBack) {
    for_random_cameras([](const Camera& camera, double scale, test::Random&) {
        Camera after = camera;
        for (int i = 0; i < 360; ++i) after = orbited(after, kPi / 180.0, 0.0);
        expect_near(after.position, camera.position, 1e-10 * scale);
    });
}

TEST(Panned, WhatWasGrabbedFollowsTheMouse) {
    constexpr scene::Resolution kResolution{640, 480};
    for_random_cameras([&](Camera camera, double, test::Random& random) {
        if (random.below(2) == 0) {
            camera.projection = Projection::orthographic;
            camera.height = distance(camera) * random.uniform(0.1, 3.0);
        }
        const DVec2 pixels{random.uniform(-200.0, 200.0), random.uniform(-200.0, 200.0)};
        const Camera after = panned(camera, pixels, kResolution);
        // Any point of the plane through look_at that faces the camera.
        const render::CameraFrame frame =
            render::camera_frame(camera.position, camera.look_at, camera.up);
        const DVec3 point = camera.look_at + 0.3 * distance(camera) * frame.right -
                            0.2 * distance(camera) * frame.up;
        const auto was = Projector(camera, kResolution).point(point);
        const auto is = Projector(after, kResolution).point(point);
        ASSERT_TRUE(was && is);
        EXPECT_NEAR(is->x - was->x, pixels.x, 1e-6);
        EXPECT_NEAR(is->y - was->y, pixels.y, 1e-6);
        EXPECT_NEAR(distance(after) / distance(camera), 1.0, 1e-12);
    });
}

TEST(Panned, APanoramaMovesAgainstTheMouse) {
    Camera camera;
    camera.projection = Projection::panorama;
    const Camera after = panned(camera, {10.0, 0.0}, {400, 200});
    EXPECT_NEAR(after.position.x, -5.0 * kPi / 20.0, 1e-14);
}

TEST(Panned, APictureWithoutRowsMovesNowhereFar) {
    expect_usable(panned(Camera{}, {1.0, 1.0}, {0, 0}));
}

TEST(Dollied, ScalesTheDistanceAndKeepsTheRest) {
    for_random_cameras([](Camera camera, double, test::Random& random) {
        camera.projection = Projection::orthographic;
        const double factor = std::exp(random.uniform(-3.0, 3.0));
        const Camera after = dollied(camera, factor);
        EXPECT_NEAR(distance(after) / distance(camera), factor, 1e-12 * factor);
        EXPECT_NEAR(after.height, camera.height * factor, 1e-12 * factor);
        EXPECT_EQ(after.look_at, camera.look_at);
        expect_near(forward(after), forward(camera), 1e-12);
    });
}

TEST(Dollied, NeverArrivesAndNeverGetsLost) {
    Camera camera;
    camera.look_at = {3.0, 4.0, 0.0};
    const DVec3 before = forward(camera);
    for (int i = 0; i < 2000; ++i) camera = dollied(camera, 0.5);
    expect_usable(camera);
    expect_near(forward(camera), before, 1e-6);
    for (int i = 0; i < 2000; ++i) camera = dollied(camera, 2.0);
    expect_usable(camera);
    EXPECT_NEAR(distance(camera) / kGreatestDistance, 1.0, 1e-12);
    expect_near(forward(camera), before, 1e-6);
    expect_usable(dollied(camera, std::numeric_limits<double>::infinity()));
    expect_usable(dollied(camera, 5e-324));
}

TEST(Dollied, ACameraBeyondTheLimitDoesNotJump) {
    Camera camera;
    camera.position = {0.0, 0.0, 1e14};
    EXPECT_EQ(dollied(camera, 2.0).position.z, 1e14);
    EXPECT_NEAR(dollied(camera, 0.5).position.z, 5e13, 1.0);
}

TEST(BaseSpeed, FollowsTheSceneOrElseTheDistance) {
    const Camera camera;  // 5 away
    EXPECT_NEAR(base_speed({Vec3(0.0f), Vec3(2.0f, 3.0f, 6.0f)}, camera), 7.0 / 4.0, 1e-15);
    EXPECT_EQ(base_speed(Bounds{}, camera), 5.0);
    EXPECT_EQ(base_speed({Vec3(1.0f), Vec3(1.0f)}, camera), 5.0);
    EXPECT_EQ(base_speed({Vec3(-kInfinity), Vec3(kInfinity)}, camera), 5.0);
    EXPECT_EQ(base_speed({Vec3(0.0f), Vec3(1.0f, 1.0f, kInfinity)}, camera), 5.0);
    Camera flat = camera;
    flat.projection = Projection::orthographic;
    flat.height = 3.0;
    EXPECT_EQ(base_speed(Bounds{}, flat), 1.5);
}

TEST(Navigation, TenThousandMovesOfAllKindsLeaveAUsableCamera) {
    constexpr std::uint64_t kSeed = 43;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    for (const Projection projection :
         {Projection::perspective, Projection::orthographic, Projection::panorama}) {
        for (const double scale : kScales) {
            Camera camera = random_camera(random, scale);
            camera.projection = projection;
            for (int i = 0; i < 10000; ++i) {
                const double x = random.uniform(-1.0, 1.0);
                const double y = random.uniform(-1.0, 1.0);
                switch (random.below(5)) {
                    case 0:
                        camera = moved(camera, DVec3(x, y, x * y) * scale);
                        break;
                    case 1:
                        camera = turned(camera, x, y);
                        break;
                    case 2:
                        camera = orbited(camera, x, y);
                        break;
                    case 3:
                        camera = panned(camera, DVec2(x, y) * 100.0, {640, 480});
                        break;
                    default:
                        camera = dollied(camera, std::exp(x));
                }
                expect_usable(camera);
                ASSERT_LE(std::fabs(pitch(camera)), kSteepestPitch + 1e-6);
            }
        }
    }
}

TEST(Navigation, TenThousandTurnsKeepTheDistance) {
    constexpr std::uint64_t kSeed = 47;
    LRAY_TRACE_SEED(kSeed);
    test::Random random(kSeed);
    for (const double scale : kScales) {
        const Camera before = random_camera(random, scale);
        Camera camera = before;
        for (int i = 0; i < 10000; ++i) {
            const double yaw = random.uniform(-1.0, 1.0);
            const double rise = random.uniform(-1.0, 1.0);
            camera = i % 2 == 0 ? turned(camera, yaw, rise) : orbited(camera, yaw, rise);
        }
        EXPECT_NEAR(distance(camera) / distance(before), 1.0, 1e-9);
    }
}

}  // namespace
}  // namespace lray::gui
