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
    const double depth = dot(offset, frame.forward);
    if (depth <= 0.0) return DVec2(HUGE_VAL);
    const double half_height = std::tan(camera.fov / 2.0);
    const double half_width = half_height * resolution.width / resolution.height;
    return {dot(offset, frame.right) / depth / half_width,
            dot(offset, frame.up) / depth / half_height};
}

/// The farthest that any corner is from the centre of the picture.
double reach(const Bounds& bounds, scene::Resolution resolution) {
    const scene::Camera camera = fit_camera(bounds, resolution);
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

}  // namespace
}  // namespace lray::render
