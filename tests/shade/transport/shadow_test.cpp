#include "shade/transport/shadow.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/shade/lit_scene.h"
#include "tests/support/random.h"

namespace lray::test {
namespace {

const std::string kFloorAndSun =
    "directional_light { direction: [0, -1, 0] }\n"
    "plane { material { model: \"lambert\", diffuse: 1 } }\n";

/// The floor under whatever hangs above the origin, seen from the side.
Color floor_under(const std::string& things) {
    return LitScene(kFloorAndSun + things).seen({3.0, 0.5, 0.0}, {-6.0, -1.0, 0.0});
}

TEST(Shadow, NothingInTheWayLeavesAllLight) {
    EXPECT_EQ(floor_under(""), Color(1.0f));
}

TEST(Shadow, OpaqueThingsTakeAllLight) {
    EXPECT_EQ(floor_under("sphere { center: [0, 3, 0] }"), Color(0.0f));
}

TEST(Shadow, WhatCastsNoShadowTakesNone) {
    EXPECT_EQ(floor_under("sphere { center: [0, 3, 0], casts_shadow: false }"), Color(1.0f));
    EXPECT_EQ(floor_under("let ball = sphere { center: [0, 3, 0] }\n"
                          "ball { casts_shadow: false }\nball { translate: [9, 0, 0] }"),
              Color(1.0f));
}

TEST(Shadow, LightThatCastsNoShadowLightsAll) {
    const LitScene scene(
        "directional_light { direction: [0, -1, 0], casts_shadow: false }\n"
        "plane { material { model: \"lambert\", diffuse: 1 } }\nsphere { center: [0, 3, 0] }");
    EXPECT_EQ(scene.seen({3.0, 0.5, 0.0}, {-6.0, -1.0, 0.0}), Color(1.0f));
}

TEST(Shadow, ClearThingsAreOpaqueUnlessAskedFor) {
    const std::string pane =
        "rectangle { center: [0, 3, 0], size: [2, 2]\n"
        "  material { diffuse: 0, transmit: [0.5, 0.25, 0] } }";
    EXPECT_EQ(floor_under(pane), Color(0.0f));
    EXPECT_EQ(floor_under("render { transparent_shadows: true }\n" + pane),
              Color(0.5f, 0.25f, 0.0f));
}

TEST(Shadow, ColoursOfBlockersMultiply) {
    const std::string panes =
        "render { transparent_shadows: true }\n"
        "rectangle { center: [0, 3, 0], size: [2, 2], material { transmit: [0.5, 1, 1] } }\n"
        "rectangle { center: [0, 4, 0], size: [2, 2], material { transmit: [1, 0.5, 0.5] } }\n";
    EXPECT_EQ(floor_under(panes), Color(0.5f));
    EXPECT_EQ(floor_under(panes + "disk { center: [0, 5, 0] }"), Color(0.0f));
    EXPECT_EQ(floor_under(panes + "disk { center: [0, 5, 0], casts_shadow: false }"), Color(0.5f));
}

TEST(Shadow, AbsorptionCountsTheWayInside) {
    const Color seen = floor_under(
        "render { transparent_shadows: true }\n"
        "box { center: [0, 3, 0], size: [2, 0.5, 2]\n"
        "  material { transmit: 1, absorption: [0, 1, 2] } }");
    EXPECT_NEAR(seen.r, 1.0f, 1e-6f);
    EXPECT_NEAR(seen.g, std::exp(-0.5f), 1e-6f);
    EXPECT_NEAR(seen.b, std::exp(-1.0f), 1e-6f);
}

TEST(Shadow, HolesLetLightThrough) {
    const std::string veil =
        "rectangle { center: [0, 3, 0], size: [2, 2], material { opacity: 0.25 } }\n";
    EXPECT_EQ(floor_under(veil), Color(0.75f));
    EXPECT_EQ(floor_under(veil + "rectangle { center: [0, 4, 0], material { opacity: 0.5 } }"),
              Color(0.375f));
    EXPECT_EQ(floor_under(veil + "rectangle { center: [0, 4, 0] }"), Color(0.0f));
}

TEST(Shadow, WhatIsBehindTheLightCastsNone) {
    const LitScene scene(
        "point_light { position: [0, 2, 0], intensity: 100 }\n"
        "plane { material { model: \"lambert\" } }\nsphere { center: [0, 4, 0] }");
    EXPECT_GT(scene.seen({3.0, 0.5, 0.0}, {-6.0, -1.0, 0.0}).r, 0.5f);
}

TEST(Shadow, LightInTheCeilingLightsTheRoomEvenly) {
    // A lamp that lies in the ceiling must not be hidden by it here and there.
    for (const double offset : {0.0, 100.0, 1e4}) {
        const LitScene scene(
            fmt::format("group {{ translate: [{0}, {0}, {0}]\n"
                        "  area_light {{ center: [0, 2, 0], size: [1, 1], samples: 16 }}\n"
                        "  rectangle {{ size: [4, 4], center: [0, 2, 0] }}\n"
                        "  rectangle {{ size: [4, 4], material {{ model: \"lambert\" }} }}\n}}",
                        offset));
        const DVec3 eye = DVec3{offset} + DVec3{0.0, 1.0, 1.9};
        const double least = 1.0;
        for (double x = -1.0; x <= 1.0; x += 0.05) {
            EXPECT_GT(static_cast<double>(scene.seen(eye, {x, -1.0, -1.9}).r), least)
                << "at " << x << ", offset " << offset;
        }
    }
}

/// Convex bodies must not shadow themselves where they face the light, at any scale and place.
void expect_no_acne(const std::string& shape, double scale, double offset) {
    const LitScene scene(
        fmt::format("group {{ scale: {0}, translate: [{1}, {1}, {1}]\n"
                    "  {2}\n}}\ndirectional_light {{ direction: [-1, -2, -3], intensity: 1 }}",
                    scale, offset, shape));
    const LitScene unshadowed(
        fmt::format("group {{ scale: {0}, translate: [{1}, {1}, {1}]\n"
                    "  {2}\n}}\ndirectional_light {{ direction: [-1, -2, -3], intensity: 1, "
                    "casts_shadow: false }}",
                    scale, offset, shape));
    Random random(7);
    int lit_count = 0;
    int lost_count = 0;
    for (int i = 0; i < 3000; ++i) {
        const DVec3 eye =
            DVec3{offset} + scale * DVec3{random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0),
                                          random.uniform(3.0, 4.0)};
        const DVec3 aim =
            DVec3{offset} + scale * DVec3{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                                          random.uniform(-1.0, 1.0)};
        const Color bright = unshadowed.seen(eye, aim - eye);
        if (bright.r <= 0.0f) continue;
        ++lit_count;
        if (scene.seen(eye, aim - eye) != bright) ++lost_count;
    }
    EXPECT_GT(lit_count, 200);
    EXPECT_EQ(lost_count, 0) << shape << ", scale " << scale << ", offset " << offset;
}

TEST(Shadow, NoAcneAtAnyScaleOrPlace) {
    for (const char* shape : {
             "sphere { material { model: \"lambert\" } }",
             "sphere { scale: [1, 0.5, 0.7], material { model: \"lambert\" } }",
             "box { rotate: [20, 30, 40], material { model: \"lambert\" } }",
             "cylinder { rotate: [20, 30, 40], material { model: \"lambert\" } }",
             "triangle { a: [-1, -1, 0], b: [1, -1, 0.2], c: [0, 1, -0.4]\n"
             "  material { model: \"lambert\" } }",
             "rectangle { size: [2, 2], rotate: [80, 30, 0], material { model: \"lambert\" } }",
         }) {
        for (const double scale : {1e-3, 1.0, 1e3, 1e6}) expect_no_acne(shape, scale, 0.0);
        for (const double scale : {1.0, 1e2}) expect_no_acne(shape, scale, 1e4);
    }
}

TEST(Shadow, NoLightLeaksIntoAClosedRoom) {
    for (const double scale : {1e-3, 1.0, 1e6}) {
        const LitScene scene(
            fmt::format("box {{ size: [2, 2, 2], scale: {0}, rotate: [10, 20, 30], material {{ "
                        "model: \"lambert\" }} "
                        "}}\npoint_light {{ position: [{1}, {2}, {1}], intensity: {3} }}",
                        scale, 3.0 * scale, 5.0 * scale, 1e4 * scale * scale));
        Random random(3);
        for (int i = 0; i < 2000; ++i) {
            const DVec3 direction{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                                  random.uniform(-1.0, 1.0)};
            ASSERT_EQ(scene.seen(DVec3{0.0}, direction), Color(0.0f)) << "scale " << scale;
        }
    }
}

}  // namespace
}  // namespace lray::test
