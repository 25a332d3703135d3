// What point lights bring to surfaces, against the formula of the Blinn-Phong model
// L / (4 pi d^2) [rho_d N.I + rho_s (N.H)^s], worked out in long double.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/shade/lit_scene.h"
#include "tests/support/random.h"

namespace lray::test {
namespace {

struct LVec {
    long double x = 0, y = 0, z = 0;

    friend LVec operator-(LVec a, LVec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend LVec operator+(LVec a, LVec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend LVec operator*(long double s, LVec a) { return {s * a.x, s * a.y, s * a.z}; }
    friend long double dot(LVec a, LVec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
};
LVec of(DVec3 v) {
    return {v.x, v.y, v.z};
}
LVec unit(LVec v) {
    return (1.0L / std::sqrt(dot(v, v))) * v;
}

struct Lamp {
    DVec3 position{};
    double intensity = 0.0;
};

struct Matter {
    double diffuse = 0.0;
    double specular = 0.0;
    double exponent = 1.0;
};

/// The formula, for a point with its normal seen from the eye; no shadows.
long double expected_light(LVec point, LVec normal, LVec eye, const std::vector<Lamp>& lamps,
                           const Matter& matter) {
    const LVec to_eye = unit(eye - point);
    if (dot(normal, to_eye) < 0) normal = -1.0L * normal;
    long double sum = 0;
    for (const Lamp& lamp : lamps) {
        const LVec way = of(lamp.position) - point;
        const LVec to_light = unit(way);
        const long double cosine = dot(normal, to_light);
        if (cosine <= 0) continue;
        const long double half = dot(normal, unit(to_light + to_eye));
        sum += lamp.intensity / (4 * std::numbers::pi_v<long double> * dot(way, way)) *
               (matter.diffuse * cosine +
                matter.specular *
                    std::pow(std::max(half, 0.0L), static_cast<long double>(matter.exponent)));
    }
    return sum;
}

std::string text_of(const std::vector<Lamp>& lamps, bool casts_shadow) {
    std::string text;
    for (const Lamp& lamp : lamps) {
        text += fmt::format(
            "point_light {{ position: [{}, {}, {}], intensity: {}, casts_shadow: {} }}\n",
            lamp.position.x, lamp.position.y, lamp.position.z, lamp.intensity, casts_shadow);
    }
    return text;
}

std::string text_of(const Matter& matter) {
    return fmt::format("material {{ diffuse: {}, specular: {}, shininess: {} }}", matter.diffuse,
                       matter.specular, matter.exponent);
}

/// Looks at a unit sphere from all around; the formula knows nothing of what hides what, and a
/// convex body never hides a light that is before its surface.
void expect_sphere_as_formula(const Matter& matter, bool casts_shadow, double tolerance) {
    const std::vector<Lamp> lamps{
        {{3.0, 4.0, 5.0}, 500.0}, {{-2.0, 0.5, 1.0}, 20.0}, {{0.0, -1.5, 0.25}, 4.0}};
    const LitScene scene(text_of(lamps, casts_shadow) + "sphere { " + text_of(matter) + " }");
    Random random(41);
    int lit_count = 0;
    double worst = 0.0;
    for (int i = 0; i < 4000; ++i) {
        const DVec3 eye = 3.0 * DVec3{Vec3{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                                           random.uniform(0.2, 1.0)}};
        if (dot(eye, eye) < 1.5) continue;
        const DVec3 eye_float{Vec3{eye}};
        const DVec3 aim{random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9),
                        random.uniform(-0.9, 0.9)};
        const DVec3 exact_dir =
            (aim - eye_float) / std::sqrt(dot(aim - eye_float, aim - eye_float));
        const LVec dir = of(DVec3{Vec3{exact_dir}});
        const LVec origin = of(eye_float);
        const long double b = dot(origin, dir);
        const long double a = dot(dir, dir);
        const long double discriminant = b * b - a * (dot(origin, origin) - 1);
        if (discriminant < 1e-4L) continue;
        const LVec point = origin + (-b - std::sqrt(discriminant)) / a * dir;
        const long double expected = expected_light(point, unit(point), origin, lamps, matter);
        const Color seen = scene.seen(eye_float, exact_dir);
        worst = std::max(
            worst, std::fabs(static_cast<double>(static_cast<long double>(seen.g) - expected)));
        lit_count += expected > 0 ? 1 : 0;
    }
    EXPECT_GT(lit_count, 1000);
    EXPECT_LE(worst, tolerance);
}

TEST(BlinnPhong, SphereIsAsTheFormulaSays) {
    for (const double exponent : {0.0, 1.0, 10.0, 32.0, 128.0}) {
        for (const bool casts_shadow : {false, true}) {
            SCOPED_TRACE(fmt::format("exponent {}, shadows {}", exponent, casts_shadow));
            expect_sphere_as_formula({0.7, 0.4, exponent}, casts_shadow, 1e-6);
        }
    }
}

TEST(BlinnPhong, SharpestHighlightIsAsTheFormulaSays) {
    expect_sphere_as_formula({0.7, 0.4, 10000.0}, false, 1e-4);
}

TEST(BlinnPhong, FloorIsAsTheFormulaSaysNearAndFar) {
    const std::vector<Lamp> lamps{{{0.0, 0.5, 0.0}, 3.0}, {{100.0, 2.0, 0.0}, 100.0}};
    const Matter matter{0.5, 0.5, 64.0};
    const LitScene scene(text_of(lamps, true) + "plane { " + text_of(matter) + " }");
    const DVec3 eye{0.0, 2.0, 5.0};
    for (double x = -20.0; x <= 120.0; x += 0.37) {
        const DVec3 way = DVec3{x, 0.0, -1.0} - eye;
        const DVec3 dir{Vec3{way / std::sqrt(dot(way, way))}};
        const LVec point = of(eye) + (-2.0L / static_cast<long double>(dir.y)) * of(dir);
        EXPECT_NEAR(scene.seen(eye, dir).r,
                    static_cast<double>(expected_light(point, {0, 1, 0}, of(eye), lamps, matter)),
                    1e-6)
            << x;
    }
}

TEST(BlinnPhong, LightBehindTheSurfaceBringsNothing) {
    const LitScene scene("point_light { position: [0, -1, 0] }\nrectangle { size: [9, 9] }");
    EXPECT_EQ(scene.seen({0.0, 2.0, 0.0}, {0.1, -1.0, 0.0}), Color(0.0f));
    EXPECT_GT(scene.seen({0.0, -2.0, 0.0}, {0.1, 1.0, 0.0}).r, 0.1f) << "two-sided by default";
}

TEST(BlinnPhong, OneSidedSurfaceIsDarkFromBehind) {
    const LitScene scene(
        "point_light { position: [0, -1, 0] }\n"
        "rectangle { size: [9, 9], material { two_sided: false, emission: 0.25 } }");
    EXPECT_EQ(scene.seen({0.0, -2.0, 0.0}, {0.1, 1.0, 0.0}), Color(0.25f));
}

TEST(BlinnPhong, LightInTheSurfaceBringsNothingAndNoNaN) {
    const LitScene scene("point_light { position: [0, 0, 0] }\nrectangle { size: [9, 9] }");
    EXPECT_EQ(scene.seen({0.0, 2.0, 0.0}, {0.0, -1.0, 0.0}), Color(0.0f));
    EXPECT_EQ(scene.seen({1.0, 2.0, 0.0}, {0.0, -1.0, 0.0}), Color(0.0f));
}

TEST(DirectLight, AmbientAndEmissionAreAddedAsTheyAre) {
    const LitScene scene(
        "render { ambient: [0.5, 0.25, 0] }\n"
        "sphere { material { ambient: 0.5, emission: [0, 0, 2] } }");
    EXPECT_EQ(scene.seen({0.0, 0.0, 3.0}, {0.0, 0.0, -1.0}), Color(0.25f, 0.125f, 2.0f));
}

TEST(DirectLight, RayThatMissesSeesTheBackgroundOrTheEnvironment) {
    const LitScene dark("render { background: [1, 2, 3] }\nsphere { }");
    EXPECT_EQ(dark.seen({0.0, 0.0, 3.0}, {0.0, 1.0, 0.0}), Color(1.0f, 2.0f, 3.0f));
    const LitScene bright(
        "render { background: [1, 2, 3] }\nenvironment { color: [0.5, 0.25, 1], intensity: 2 }\n"
        "sphere { }");
    EXPECT_EQ(bright.seen({0.0, 0.0, 3.0}, {0.0, 1.0, 0.0}), Color(1.0f, 0.5f, 2.0f));
}

TEST(DirectLight, ColourOfTheLightIsThatOfAWhiteWall) {
    const LitScene scene(
        "point_light { position: [0, 2, 0], color: [1, 0.5, 0.25], intensity: 16 }\n"
        "plane { material { model: \"lambert\", diffuse: 1 } }");
    const Color seen = scene.seen({0.0, 1.0, 0.0}, {0.0, -1.0, 0.0});
    EXPECT_NEAR(seen.r, 1.0 / std::numbers::pi, 1e-6);
    EXPECT_NEAR(seen.g, 0.5 / std::numbers::pi, 1e-6);
    EXPECT_NEAR(seen.b, 0.25 / std::numbers::pi, 1e-6);
}

/// The mean of 64 samples and how far one is from it.
struct Spread {
    double mean = 0.0;
    double deviation = 0.0;
};

Spread spread(const LitScene& scene, DVec3 origin, DVec3 direction) {
    constexpr std::uint32_t kSamples = 64;
    double sum = 0.0;
    double squares = 0.0;
    for (std::uint32_t i = 0; i < kSamples; ++i) {
        const double seen = static_cast<double>(scene.seen(origin, direction, i).g);
        sum += seen;
        squares += seen * seen;
    }
    const double mean = sum / kSamples;
    return {mean, std::sqrt(std::max(squares / kSamples - mean * mean, 0.0))};
}

TEST(DirectLight, PolishedMetalUnderASkyIsNotGrainy) {
    for (const char* const material :
         {"model: \"cook_torrance\", diffuse: 0, fresnel: 1, roughness: 0.1",
          "model: \"ward\", diffuse: 0, specular: 1, roughness: 0.05",
          "diffuse: 0, specular: 1, shininess: 2000"}) {
        const LitScene scene(std::string("environment { color: 1, samples: 4 }\n"
                                         "sphere { material { ") +
                             material + " } }");
        const Spread seen = spread(scene, {0.0, 0.5, 4.0}, {0.05, -0.125, -1.0});
        EXPECT_GT(seen.mean, 0.0) << material;
        // By the light alone one sample in some thousand would meet the lobe.
        EXPECT_LT(seen.deviation, 1.5 * seen.mean) << material;
    }
}

TEST(DirectLight, AfterAMirrorAQuarterOfTheRaysGoToALight) {
    const std::string rest =
        "area_light { center: [0, 3, 0], normal: [0, -1, 0], samples: 16, visible: false }\n"
        "plane { material { model: \"lambert\" } }\n"
        "rectangle { center: [0, 0, -4], size: [40, 40], normal: [0, 0, 1],\n"
        "    material { model: \"lambert\", diffuse: 0, reflect: 1 } }";
    LitScene scene(rest);
    const Color straight = scene.seen({0.0, 1.0, 0.0}, {0.0, -1.0, -1.0});
    EXPECT_GT(straight.g, 0.0f);
    EXPECT_EQ(scene.counts().shadow.rays, 16u);
    LitScene mirrored(rest);
    const Color seen = mirrored.seen({0.0, 1.0, -2.0}, {0.0, -0.25, -1.0});
    EXPECT_GT(seen.g, 0.0f);
    EXPECT_EQ(mirrored.counts().shadow.rays, 4u);
}

}  // namespace
}  // namespace lray::test
