// Area lights against closed forms of the light of a rectangle.
#include "shade/lights/area_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/shade/chi_square.h"
#include "tests/shade/lights/light_means.h"

namespace lray::shade {
namespace {

constexpr double kPi = std::numbers::pi;

/// Above the origin, facing down: edge_u x edge_v is -z.
AreaLight lamp(DVec3 corner, DVec3 edge_u, DVec3 edge_v) {
    return AreaLight::of(scene::AreaLight{corner, edge_u, edge_v, 1}, Color{1.0f}, 500.0, true);
}

AreaLight lamp_above(double low_x, double low_y, double width, double depth, double height) {
    return lamp({low_x, low_y, height}, {0.0, depth, 0.0}, {width, 0.0, 0.0});
}

/// The share of what a surface in the origin, facing up, sees that is a rectangle above it with one
/// corner straight above. Source: Howell, "A Catalog of Radiation Heat Transfer Configuration
/// Factors", B-4.
double facing_corner(double a, double b, double height) {
    const double x = a / height;
    const double y = b / height;
    const double rx = std::sqrt(1.0 + x * x);
    const double ry = std::sqrt(1.0 + y * y);
    return (x / rx * std::atan(y / rx) + y / ry * std::atan(x / ry)) / (2.0 * kPi);
}

TEST(AreaLight, GivesAFacingSurfaceWhatTheClosedFormSays) {
    for (const double height : {0.02, 0.1, 0.5, 1.0, 3.0, 20.0, 1e4}) {
        for (const DVec2 size : {DVec2{1.0, 1.0}, DVec2{3.0, 0.5}}) {
            const double radiance = 500.0 / (size.x * size.y);
            const auto corner = lamp_above(0.0, 0.0, size.x, size.y, height);
            const auto above = lamp_above(-0.5 * size.x, -0.5 * size.y, size.x, size.y, height);
            const double of_corner = radiance * facing_corner(size.x, size.y, height);
            const double of_middle =
                4.0 * radiance * facing_corner(0.5 * size.x, 0.5 * size.y, height);
            const DVec3 up{0.0, 0.0, 1.0};
            EXPECT_NEAR(
                test::irradiance([&](DVec2 u) { return corner.sample(DVec3{0.0}, u); }, up) /
                    of_corner,
                1.0, 1e-4)
                << height;
            EXPECT_NEAR(test::irradiance([&](DVec2 u) { return above.sample(DVec3{0.0}, u); }, up) /
                            of_middle,
                        1.0, 1e-4)
                << height;
        }
    }
}

TEST(AreaLight, GivesTheSameInEveryPlaceAndTurn) {
    test::Random random(4);
    const DVec3 x = test::sphere_direction(random);
    const DVec3 y = glm::normalize(cross(x, test::sphere_direction(random)));
    const DVec3 z = cross(x, y);
    const DVec3 point{100.0, -50.0, 20.0};
    for (const double height : {0.3, 2.0}) {
        const auto straight = lamp_above(0.2, -0.4, 1.0, 2.0, height);
        const auto turned = lamp(point + 0.2 * x - 0.4 * y + height * z, 2.0 * y, x);
        const double there =
            test::irradiance([&](DVec2 u) { return straight.sample(DVec3{0.0}, u); }, {0, 0, 1});
        const double here = test::irradiance([&](DVec2 u) { return turned.sample(point, u); }, z);
        EXPECT_NEAR(here / there, 1.0, 1e-5);
    }
}

TEST(AreaLight, ParallelogramGivesWhatItsPointsGive) {
    const DVec3 edge_u{0.5, 1.0, 0.0};
    const DVec3 edge_v{1.5, 0.25, 0.2};
    for (const double height : {0.3, 1.0, 4.0}) {
        const DVec3 corner{-0.5, -0.5, height};
        const AreaLight light = lamp(corner, edge_u, edge_v);
        const double area = glm::length(cross(edge_u, edge_v));
        double exact = 0.0;
        constexpr int kSide = 1000;
        for (int i = 0; i < kSide * kSide; ++i) {
            const DVec3 p =
                corner + (i / kSide + 0.5) / kSide * edge_u + (i % kSide + 0.5) / kSide * edge_v;
            const double d = glm::length(p);
            exact += 500.0 / kPi * p.z / d * -dot(p, light.normal) / (d * d * d);
        }
        exact /= kSide * kSide;
        EXPECT_GT(area, 0.0);
        EXPECT_NEAR(test::irradiance([&](DVec2 u) { return light.sample(DVec3{0.0}, u); },
                                     {0.0, 0.0, 1.0}) /
                        exact,
                    1.0, 1e-3)
            << height;
    }
}

void expect_density(const AreaLight& light, DVec3 point, std::uint64_t seed,
                    const test::SphereWindow& window) {
    const auto sampler = [&](double, DVec2 u) -> std::optional<Vec3> {
        const auto sample = light.sample(point, u);
        if (!sample) return std::nullopt;
        EXPECT_GT(sample->pdf, 0.0f);
        return sample->wi;
    };
    const auto density = [&](Vec3 wi) { return static_cast<double>(light.pdf(point, wi)); };
    EXPECT_GT(test::chi_square_probability(sampler, density, seed, window), 1e-3) << seed;
}

TEST(AreaLight, DensityNearAndFarIsTheOneSaid) {
    expect_density(lamp_above(-40.0, -40.0, 80.0, 80.0, 1.0), DVec3{0.0}, 5, {0.0, 1.0});
    expect_density(lamp_above(-1.0, -1.5, 2.0, 4.0, 1.0), DVec3{0.0}, 6, {0.2, 1.0, 64});
    expect_density(lamp_above(-1.0, -1.0, 2.0, 2.0, 5.0), DVec3{0.0}, 7, {0.93, 1.0, 64});
    expect_density(lamp({-1.0, -1.0, 1.0}, {1.0, 2.0, 0.0}, {2.0, 0.5, 0.0}), DVec3{0.0}, 8,
                   {0.1, 1.0, 64});
}

TEST(AreaLight, SamplesSayTheDensityOfTheirDirection) {
    test::Random random(9);
    for (const double height : {0.1, 1.0, 30.0}) {
        const auto light = lamp_above(-1.0, -1.5, 2.0, 4.0, height);
        for (int i = 0; i < 1000; ++i) {
            const auto sample = light.sample(
                DVec3{0.0}, {random.uniform(0.001, 0.999), random.uniform(0.001, 0.999)});
            ASSERT_TRUE(sample);
            const float pdf = light.pdf(DVec3{0.0}, sample->wi);
            EXPECT_NEAR(sample->pdf / pdf, 1.0f, 1e-4f) << height;
            EXPECT_NEAR(static_cast<double>(sample->irradiance.r) * static_cast<double>(pdf) * kPi /
                            static_cast<double>(light.radiance.r),
                        1.0, 1e-4);
        }
    }
}

TEST(AreaLight, BehindItAndInItsPlaneThereIsNoLight) {
    const AreaLight light = lamp_above(-1.0, -1.0, 2.0, 2.0, 1.0);
    for (const DVec3 point : {DVec3{0.0, 0.0, 2.0}, DVec3{0.0, 0.0, 1.0}, DVec3{5.0, 0.0, 1.0},
                              DVec3{-1.0, -1.0, 1.0}, DVec3{0.0, 0.0, 1e18}}) {
        EXPECT_FALSE(light.sample(point, {0.5, 0.5}));
        EXPECT_EQ(light.pdf(point, {0.0f, 0.0f, -1.0f}), 0.0f);
        EXPECT_EQ(light.strength_at(point), 0.0);
    }
}

TEST(AreaLight, OnlyTheSideThatShinesIsSeen) {
    const AreaLight light = lamp_above(-1.0, -1.0, 2.0, 2.0, 3.0);
    EXPECT_EQ(light.hit({{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}}, {}), 3.0f);
    EXPECT_EQ(light.hit({{0.99f, -0.99f, 0.0f}, {0.0f, 0.0f, 1.0f}}, {}), 3.0f);
    EXPECT_FALSE(light.hit({{1.01f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}}, {}));
    EXPECT_FALSE(light.hit({{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}}, {0.0f, 3.0f}));
    EXPECT_FALSE(light.hit({{0.0f, 0.0f, 5.0f}, {0.0f, 0.0f, -1.0f}}, {}));
    EXPECT_FALSE(light.hit({{0.0f, 0.0f, 3.0f}, {1.0f, 0.0f, 0.0f}}, {}));
}

TEST(AreaLight, HostilePlacesStayFinite) {
    const std::array lights = {
        lamp_above(-1.0, -1.0, 2.0, 2.0, 1.0),
        lamp_above(-1e9, -1e9, 2e9, 2e9, 1.0),
        lamp_above(-1e-9, -1e-9, 2e-9, 2e-9, 1.0),
        lamp_above(-1e9, -1e-9, 2e9, 2e-9, 1.0),
    };
    const double last = 1.0 - 0x1p-32;
    for (const AreaLight& light : lights) {
        for (const double below : {1e-16, 1e-12, 1e-6, 0.5, 1e6, 1e18}) {
            for (const double aside : {0.0, 1.0, 1.0000001, 1e9, 1e18}) {
                for (const DVec2 u :
                     {DVec2{0.0, 0.0}, DVec2{last, last}, DVec2{0.5, 0.5}, DVec2{0.0, last}}) {
                    const auto s = light.sample({aside, 0.0, 1.0 - below}, u);
                    if (!s) continue;
                    EXPECT_TRUE(std::isfinite(s->irradiance.r) && s->irradiance.r >= 0.0f);
                    EXPECT_TRUE(std::isfinite(s->pdf) && s->pdf >= 0.0f);
                    EXPECT_TRUE(std::isfinite(s->distance) && s->distance >= 0.0f);
                    EXPECT_NEAR(glm::length(s->wi), 1.0f, 3e-7f) << below << " " << aside;
                }
            }
        }
    }
}

TEST(AreaLight, HiddenOnesAreMetByNoRay) {
    const auto light =
        AreaLight::of(scene::AreaLight{{-1.0, -1.0, 1.0}, {0.0, 2.0, 0.0}, {2.0, 0.0, 0.0}, 1},
                      Color{1.0f}, 500.0, false);
    const auto sample = light.sample(DVec3{0.0}, {0.5, 0.5});
    ASSERT_TRUE(sample);
    EXPECT_EQ(sample->pdf, 0.0f);
    EXPECT_EQ(light.pdf(DVec3{0.0}, sample->wi), 0.0f);
}

}  // namespace
}  // namespace lray::shade
