// Mirrors and clear things, seen as pictures show them.
#include "shade/transport/boundary.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/shade/lit_scene.h"
#include "tests/support/random.h"

namespace lray::test {
namespace {

/// A wall that gives off a colour for each place, so that what is seen tells where a ray went.
const std::string kWall =
    "rectangle { corner: [-10, -10, -5], edge_u: [20, 0, 0], edge_v: [0, 20, 0]\n"
    "  material { diffuse: 0, specular: 0\n"
    "    emission: gradient { axis: \"x\", space: \"uv\" } } }\n";

const std::string kClear = "diffuse: 0, specular: 0, transmit: 1";

/// Where on the wall a ray along -z from there ends, in world units.
double wall_place(const LitScene& scene, DVec3 origin, DVec3 direction = {0.0, 0.0, -1.0}) {
    return 20.0 * static_cast<double>(scene.seen(origin, direction).r) - 10.0;
}

TEST(Boundary, MirrorShowsWhatIsBeforeIt) {
    const LitScene scene(
        "render { background: [1, 0.5, 0.25] }\n"
        "plane { material { diffuse: 0, specular: 0, reflect: [0.5, 1, 0] } }");
    EXPECT_EQ(scene.seen({0.0, 1.0, 0.0}, {1.0, -1.0, 0.0}), Color(0.5f, 0.5f, 0.0f));
}

TEST(Boundary, MirrorsFacingEachOtherEndAtTheDepth) {
    // Each mirror gives off a little: the sum is a geometric series.
    LitScene scene(
        "plane { point: [0, 0, 0], material { diffuse: 0, specular: 0, reflect: 0.5, emission: 1 } "
        "}\n"
        "plane { point: [0, 1, 0], material { diffuse: 0, specular: 0, reflect: 0.5, emission: 1 } "
        "}");
    for (const std::uint32_t depth : {0u, 1u, 2u, 5u}) {
        scene.settings.max_depth = depth;
        EXPECT_FLOAT_EQ(scene.seen({0.0, 0.5, 0.0}, {0.0, -1.0, 0.0}).r,
                        2.0f - std::pow(0.5f, static_cast<float>(depth)));
    }
    scene.settings.max_depth = 256;
    EXPECT_NEAR(scene.seen({0.0, 0.5, 0.0}, {0.0, -1.0, 0.0}).r, 2.0f, 2.0f / 1024.0f)
        << "what carries less than a thousandth is not followed";
}

TEST(Boundary, IndexOneIsInvisible) {
    const LitScene with(kWall + "sphere { material { ior: 1, " + kClear + " } }");
    const LitScene without(kWall);
    Random random(11);
    for (int i = 0; i < 500; ++i) {
        const DVec3 origin{random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9), 3.0};
        const DVec3 direction{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), -1.0};
        EXPECT_NEAR(with.seen(origin, direction).r, without.seen(origin, direction).r, 1e-6f);
    }
}

TEST(Boundary, SlabMovesRaysAside) {
    const LitScene scene(kWall + "box { size: [20, 20, 1], material { ior: 1.5, " + kClear +
                         " } }");
    for (const double degrees : {0.0, 10.0, 30.0, 50.0}) {
        const double angle = degrees * std::numbers::pi / 180.0;
        const double inside = std::asin(std::sin(angle) / 1.5);
        const double place = 7.0 * std::tan(angle) + std::tan(inside);  // on the wall, 8 away
        const double across =
            degrees == 0.0 ? 0.04
                           : std::pow(std::sin(angle - inside) / std::sin(angle + inside), 2.0);
        const double parallel =
            degrees == 0.0 ? 0.04
                           : std::pow(std::tan(angle - inside) / std::tan(angle + inside), 2.0);
        const double through = 1.0 - 0.5 * (across + parallel);
        // What is mirrored twice inside leaves beside it, and brings a few thousandths.
        const Color seen = scene.seen({0.0, 0.0, 3.0}, {std::sin(angle), 0.0, -std::cos(angle)});
        EXPECT_NEAR(static_cast<double>(seen.r), through * through * (place + 10.0) / 20.0, 0.005)
            << degrees;
    }
}

TEST(Boundary, PaneWithoutThicknessBendsRaysOnce) {
    // Below the surface of the water a ray goes steeper, by Snell's law.
    const LitScene scene(
        "plane { material { ior: 1.33, " + kClear +
        " } }\n"
        "rectangle { corner: [-10, -2, 10], edge_u: [20, 0, 0], edge_v: [0, 0, -20]\n"
        "  material { diffuse: 0, specular: 0, emission: gradient { axis: \"x\", space: \"uv\" } } "
        "}");
    const double angle = std::numbers::pi / 4.0;
    const double below = std::asin(std::sin(angle) / 1.33);
    const double place = -1.0 + std::tan(angle) + 2.0 * std::tan(below);
    const double across = std::pow(std::sin(angle - below) / std::sin(angle + below), 2.0);
    const double parallel = std::pow(std::tan(angle - below) / std::tan(angle + below), 2.0);
    const double through = 1.0 - 0.5 * (across + parallel);
    EXPECT_NEAR(static_cast<double>(
                    scene.seen({-1.0, 1.0, 0.0}, {std::sin(angle), -std::cos(angle), 0.0}).r),
                through * (place + 10.0) / 20.0, 2e-6);
}

TEST(Boundary, LightIsSplitWithoutLoss) {
    // Where all around is equally bright, clear things cannot be seen.
    LitScene scene(
        "render { background: 1, max_depth: 64 }\n"
        "sphere { material { ior: 1.5, " +
        kClear +
        " } }\n"
        "box { center: [2.5, 0, 0], rotate: [20, 30, 0], material { ior: 2.4, " +
        kClear + " } }");
    Random random(5);
    for (int i = 0; i < 300; ++i) {
        const DVec3 aim{random.uniform(-1.0, 3.0), random.uniform(-0.9, 0.9), 0.0};
        const float seen = scene.seen({1.0, 0.5, 6.0}, aim - DVec3{1.0, 0.5, 6.0}).r;
        EXPECT_LE(seen, 1.0f + 1e-5f);
        EXPECT_GE(seen, 0.97f) << "only what carries less than a thousandth may be missing";
    }
}

TEST(Boundary, AbsorptionIsThatOfTheWayInside) {
    const LitScene scene(
        "render { background: 1 }\n"
        "box { size: [4, 4, 0.75], material { ior: 1, absorption: [0, 1, 3], " +
        kClear + " } }");
    const Color seen = scene.seen({0.0, 0.0, 2.0}, {0.0, 0.0, -1.0});
    EXPECT_NEAR(seen.r, 1.0f, 1e-6f);
    EXPECT_NEAR(seen.g, std::exp(-0.75f), 1e-6f);
    EXPECT_NEAR(seen.b, std::exp(-2.25f), 1e-6f);
}

TEST(Boundary, CameraInGlassSeesAsFromInside) {
    const std::string glass = "ior: 1.5, absorption: [0, 1, 2], " + kClear;
    const LitScene scene("render { background: 1, max_depth: 1 }\nsphere { material { " + glass +
                         " } }");
    const Color seen = scene.seen({0.0, 0.0, 0.5}, {0.0, 0.0, -1.0});
    EXPECT_NEAR(seen.r, 0.96f, 1e-5f);
    EXPECT_NEAR(seen.g, 0.96f * std::exp(-1.5f), 1e-5f);
    EXPECT_NEAR(seen.b, 0.96f * std::exp(-3.0f), 1e-5f);
    // Beyond the critical angle nothing gets out.
    LitScene slab(
        "render { background: 1, max_depth: 3 }\nbox { size: [1000, 2, 1000], material { " + glass +
        " } }");
    EXPECT_EQ(slab.seen({0.0, 0.0, 0.0}, {1.0, 0.5, 0.0}), Color(0.0f));
}

TEST(Boundary, GlassInTheSameGlassIsInvisible) {
    const std::string inner = "sphere { radius: 0.5, material { ior: 1.5, " + kClear + " } }\n";
    const std::string outer = "sphere { radius: 2, material { ior: 1.5, " + kClear + " } }\n";
    LitScene nested(kWall + outer + inner);
    LitScene plain(kWall + outer);
    nested.settings.max_depth = 64;  // boundaries count, also those that are nothing
    plain.settings.max_depth = 64;
    Random random(23);
    for (int i = 0; i < 300; ++i) {
        const DVec3 origin{random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 4.0};
        EXPECT_NEAR(nested.seen(origin, {0.0, 0.0, -1.0}).r, plain.seen(origin, {0.0, 0.0, -1.0}).r,
                    2e-6f);
    }
}

TEST(Boundary, MirroredGlassIsTheSameGlass) {
    const std::string lens =
        "sphere { center: [0.3, 0, 0], scale: [1, 0.8, 0.5], material { ior: 1.5, " + kClear +
        " } }\n";
    const LitScene plain(kWall + lens);
    const LitScene turned(kWall + "group { scale: [-1, 1, 1]\ngroup { scale: [-1, 1, 1]\n" + lens +
                          "} }");
    const LitScene mirrored(kWall + "group { scale: [1, 1, -1]\n" + lens + "}");
    for (double x = -0.6; x <= 1.2; x += 0.03) {
        const float expected = plain.seen({x, 0.1, 3.0}, {0.0, 0.0, -1.0}).r;
        EXPECT_NEAR(turned.seen({x, 0.1, 3.0}, {0.0, 0.0, -1.0}).r, expected, 2e-6f);
        EXPECT_NEAR(mirrored.seen({x, 0.1, 3.0}, {0.0, 0.0, -1.0}).r, expected, 2e-6f);
    }
}

TEST(Boundary, BallTurnsWhatIsBehindItUpsideDown) {
    const LitScene scene(kWall + "sphere { material { ior: 1.5, " + kClear + " } }");
    EXPECT_LT(wall_place(scene, {0.4, 0.0, 3.0}), wall_place(scene, {-0.4, 0.0, 3.0}));
}

TEST(Boundary, HolesShowWhatIsBehind) {
    const LitScene scene(
        "render { background: 1, max_depth: 0 }\n"
        "rectangle { normal: [0, 0, 1], size: [4, 4]\n"
        "  material { diffuse: 0, specular: 0, opacity: 0.25 } }\n"
        "rectangle { normal: [0, 0, 1], size: [4, 4], center: [0, 0, -1]\n"
        "  material { diffuse: 0, specular: 0, opacity: 0.5 } }");
    EXPECT_FLOAT_EQ(scene.seen({0.0, 0.0, 3.0}, {0.0, 0.0, -1.0}).r, 0.375f)
        << "holes do not count as reflections";
}

TEST(Boundary, MediaOfAPointAreThoseAroundIt) {
    const LitScene scene(
        "sphere { radius: 3, material { transmit: 1, ior: 1.3 } }\n"
        "sphere { radius: 1, material { transmit: 1, ior: 1.6 } }\n"
        "sphere { radius: 0.5, center: [0, 8, 0], material { transmit: 1, ior: 1.9 } }\n"
        "sphere { radius: 9, material { diffuse: 0.5 } }");
    bvh::TraceCounts counts;
    const auto ior_at = [&](Vec3 position) {
        const shade::Media media = shade::media_at(scene.lit(), position, counts);
        return media.is_empty() ? 1.0f : scene.lit().materials.average(media.innermost()).ior;
    };
    EXPECT_EQ(ior_at({0.0f, 0.0f, 0.0f}), 1.6f);
    EXPECT_EQ(ior_at({0.0f, 2.0f, 0.0f}), 1.3f);
    EXPECT_EQ(ior_at({0.0f, 5.0f, 0.0f}), 1.0f);
    EXPECT_EQ(ior_at({0.0f, 8.0f, 0.0f}), 1.9f);
    EXPECT_EQ(ior_at({0.0f, 20.0f, 0.0f}), 1.0f);
}

}  // namespace
}  // namespace lray::test
