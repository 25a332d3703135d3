#include "shade/transport/path.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/shade/lit_scene.h"
#include "tests/support/random.h"

namespace lray::test {
namespace {

constexpr const char* kPath = "render { integrator: \"path\", max_depth: 256 }\n";

/// The mean over rays in many directions from a point, each with samples of its own.
DVec3 mean_around(const LitScene& scene, DVec3 origin, std::uint32_t ray_count,
                  std::uint32_t sample_count) {
    Random random(99);
    DVec3 sum{0.0};
    for (std::uint32_t i = 0; i < ray_count; ++i) {
        DVec3 direction{0.0};
        do {
            direction = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                         random.uniform(-1.0, 1.0)};
        } while (dot(direction, direction) > 1.0 || dot(direction, direction) < 0.01);
        for (std::uint32_t sample = 0; sample < sample_count; ++sample) {
            sum += DVec3{scene.seen(origin, direction, i * sample_count + sample)};
        }
    }
    return sum / static_cast<double>(ray_count * sample_count);
}

TEST(Path, FurnaceIsAsBrightAsItsAlbedoSays) {
    // In a closed room that gives off 1 everywhere and reflects the share a, light adds up to
    // 1 + a + a^2 + ... = 1 / (1 - a).
    for (const double albedo : {0.5, 0.8}) {
        const LitScene room(fmt::format(
            "{}sphere {{ material {{ model: \"lambert\", diffuse: {}, emission: 1 }} }}", kPath,
            albedo));
        const double expected = 1.0 / (1.0 - albedo);
        EXPECT_NEAR(mean_around(room, {0.2, 0.1, 0.3}, 200, 50).g, expected, 0.01 * expected)
            << albedo;
    }
}

TEST(Path, FurnaceOfABoxToo) {
    const LitScene room(
        std::string(kPath) +
        "box { size: [2, 2, 2], material { model: \"lambert\", diffuse: 0.5, emission: "
        "[1, 0.5, 0] } }");
    const DVec3 seen = mean_around(room, {0.2, 0.1, 0.3}, 200, 50);
    EXPECT_NEAR(seen.r, 2.0, 0.02);
    EXPECT_NEAR(seen.g, 1.0, 0.01);
    EXPECT_EQ(seen.b, 0.0);
}

TEST(Path, WhiteBodyInAWhiteSkyCannotBeSeen) {
    for (const char* model : {"lambert", "cook_torrance"}) {
        const LitScene scene(fmt::format(
            "{}environment {{ }}\nsphere {{ material {{ model: \"{}\", diffuse: 1, specular: 0 }} "
            "}}\nsphere {{ center: [1.5, 0, 0], material {{ diffuse: 0, specular: 0, reflect: 1 }} "
            "}}",
            kPath, model));
        const double expected = 1.0;
        const DVec3 seen = scene.mean({0.0, 0.0, 5.0}, {0.05, 0.02, -1.0}, 4096);
        if (std::string(model) == "lambert") {
            EXPECT_NEAR(seen.g, expected, 0.01);
        } else {
            EXPECT_LE(seen.g, expected + 0.01);
        }
    }
}

TEST(Path, MirrorsAndGlassOfNoLossInAWhiteSkyCannotBeSeen) {
    const LitScene scene(
        std::string(kPath) +
        "environment { }\nsphere { material { diffuse: 0, specular: 0, transmit: 1 } }\n"
        "sphere { center: [2, 0, 0], material { diffuse: 0, specular: 0, reflect: 1 } }");
    EXPECT_NEAR(scene.mean({0.0, 0.0, 5.0}, {0.05, 0.02, -1.0}, 2000).g, 1.0, 0.01);
    EXPECT_NEAR(scene.mean({2.0, 0.0, 5.0}, {0.05, 0.02, -1.0}, 200).g, 1.0, 1e-6);
}

/// What lights bring straight to a convex body is the same by both integrators.
void expect_as_whitted(const std::string& lights, const std::string& material, double tolerance) {
    const std::string text = lights + "\nsphere { material { " + material + " } }";
    LitScene scene(text);
    for (const DVec3 aim : {DVec3{0.0, 0.0, 0.0}, DVec3{0.5, 0.4, 0.0}, DVec3{-0.3, -0.6, 0.0}}) {
        const DVec3 origin{0.0, 0.5, 4.0};
        scene.settings.integrator = scene::Integrator::whitted;
        const DVec3 whitted = scene.mean(origin, aim - origin, 1024);
        scene.settings.integrator = scene::Integrator::path;
        for (const std::uint32_t depth : {0u, 4u}) {
            scene.settings.max_depth = depth;
            const DVec3 path = scene.mean(origin, aim - origin, 1u << 13);
            for (int channel = 0; channel < 3; ++channel) {
                EXPECT_NEAR(path[channel], whitted[channel],
                            tolerance * std::max(whitted[channel], 0.05))
                    << lights << " " << material << " depth " << depth;
            }
        }
    }
}

TEST(Path, LightOnAConvexBodyIsThatOfWhitted) {
    const std::string matt = "model: \"lambert\", diffuse: [0.8, 0.5, 0.1]";
    const std::string glossy = "diffuse: 0.3, specular: 0.5, shininess: 60";
    const std::string metal =
        "model: \"cook_torrance\", diffuse: 0.1, fresnel: 0.9, roughness: 0.3";
    const std::string brushed =
        "model: \"ward\", diffuse: 0.2, specular: 0.6, roughness: [0.1, 0.4]";
    const std::string point = "point_light { position: [2, 3, 4] }";
    const std::string two = point + "\npoint_light { position: [-4, 1, 2], color: [0, 1, 0] }";
    const std::string ball = "point_light { position: [2, 3, 4], radius: 1.5, samples: 16 }";
    const std::string area =
        "area_light { center: [0, 3, 1], size: [4, 3], normal: [0, -1, -0.2] }";
    const std::string sun = "directional_light { direction: [-1, -1, -2], angle: 20, samples: 16 }";
    const std::string sky = "environment { color: [1, 0.9, 0.7], samples: 64 }";
    for (const std::string& material : {matt, glossy, metal, brushed}) {
        expect_as_whitted(point, material, 1e-5);
        for (const std::string& light : {two, ball, area, sun, sky}) {
            expect_as_whitted(light, material, 0.02);
        }
    }
}

TEST(Path, LightOfAColouredWallReachesTheFloor) {
    const LitScene scene(
        "render { integrator: \"path\", max_depth: 2 }\n"
        "directional_light { direction: [1, 0, 0] }\n"
        "rectangle { corner: [1, -2, -2], edge_u: [0, 0, 4], edge_v: [0, 4, 0]\n"
        "  material { model: \"lambert\", diffuse: [1, 0.5, 0] } }\n"
        "rectangle { size: [2, 2], material { model: \"lambert\", diffuse: 1 } }");
    // The sun runs along the floor and lights only the wall, which lights the floor.
    const DVec3 seen = scene.mean({0.0, 1.0, 0.5}, {0.2, -1.0, -0.3}, 1u << 14);
    EXPECT_GT(seen.r, 0.05);
    EXPECT_NEAR(seen.g, 0.5 * seen.r, 0.02 * seen.r);
    EXPECT_EQ(seen.b, 0.0);
}

TEST(Path, EmissionLightsWhatIsAround) {
    // A large glowing ceiling lights the floor as an area light of the same radiance does.
    const std::string floor = "rectangle { size: [2, 2], material { model: \"lambert\" } }\n";
    const LitScene glowing(std::string(kPath) + floor +
                           "rectangle { center: [0, 1, 0], size: [2, 2], material { diffuse: 0, "
                           "specular: 0, emission: "
                           "2 } }");
    const LitScene lamp(std::string(kPath) + floor +
                        "area_light { center: [0, 1, 0], size: [2, 2], intensity: 8 }");
    const DVec3 a = glowing.mean({0.0, 0.5, 0.9}, {0.1, -0.5, -0.8}, 1u << 15);
    const DVec3 b = lamp.mean({0.0, 0.5, 0.9}, {0.1, -0.5, -0.8}, 1u << 13);
    EXPECT_NEAR(a.g, b.g, 0.02 * b.g);
}

TEST(Path, HolesLetTheirShareThrough) {
    const LitScene scene(std::string(kPath) +
                         "environment { }\nrectangle { normal: [0, 0, 1], size: [2, 2]\n"
                         "  material { diffuse: 0, specular: 0, opacity: 0.3 } }");
    EXPECT_NEAR(scene.mean({0.0, 0.0, 3.0}, {0.0, 0.0, -1.0}, 4096).g, 0.7, 0.01);
}

}  // namespace
}  // namespace lray::test
