// What is told of a scene as a whole, and what is not: every near miss must stay silent.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/parser/loaded.h"

namespace lray::test {
namespace {

Loaded linted(std::string_view text) {
    Loaded loaded = load_text(text);
    EXPECT_TRUE(flatten_and_lint(loaded)) << loaded.text();
    return loaded;
}

std::string codes(std::string_view text) {
    return linted(text).codes();
}

std::string with_camera_inside(const std::string& shape) {
    return "camera { position: [0, 0.4, 0.1], look_at: [9, 0, 0] }\n" + shape +
           "\nsphere { center: [9, 0, 0] }\n";
}

std::string with_lamp_in(const std::string& shape) {
    return "camera { position: [0, 0, 20] }\npoint_light { position: [0, 0.4, 0] }\n" + shape +
           "\nbox { center: [5, 0, 0] }\n";
}

TEST(WarnEnclosed, CameraInsideEveryClosedShapeIsTold) {
    for (const char* const shape :
         {"sphere { }", "sphere { scale: [1, 2, 1] }", "box { size: [2, 2, 2], rotate_y: 20 }",
          "cylinder { }", "cylinder { radius: 1, radius_to: 0 }",
          "torus { radius: 0.3, tube: 0.5, rotate_x: 10 }", "group { sphere { } scale: 3 }"}) {
        EXPECT_EQ(codes(with_camera_inside(shape)), "W1203") << shape;
    }
}

TEST(WarnEnclosed, CameraOutsideOfWhatIsNearIsSilent) {
    for (const char* const shape :
         {"sphere { center: [0, -0.6005, 0.1] }",     // a hair below the camera
          "sphere { center: [0, -0.6, 0.1] }",        // on the surface
          "box { size: [1, 0.799, 1] }",              // just below
          "cylinder { caps: false }",                 // open
          "cylinder { to: [0, 0.39, 0] }",            // ends below
          "cylinder { radius: 0.15, radius_to: 0 }",  // beside the slope
          "torus { }",                                // in its hole
          "rectangle { center: [0, 0.4, 0] }", "disk { center: [0, 0.4, 0.1] }"}) {
        EXPECT_EQ(codes(with_camera_inside(shape)), "") << shape;
    }
}

TEST(WarnEnclosed, GlassSkiesHiddenShapesAndRoomsAreMeant) {
    for (const char* const shape :
         {"sphere { material { diffuse: 0, transmit: 0.9 } }",
          "sphere { material { opacity: 0.5 } }",
          "sphere { radius: 30, material { emission: #88aaff } }",
          "sphere { material { diffuse: gradient { stops: [[0, red], [1, blue]] } } }",
          "sphere { material { two_sided: false } }", "sphere { visible: false }",
          "box { size: [40, 40, 40] }",  // the ball is in it
          "box { size: [3, 3, 3] }\nplane { point: [0, -0.5, 0] }",
          "box { size: [3, 3, 3] }\nbox { size: [0.2, 0.2, 0.2], center: [1, -1, 1] }",
          "box { size: [3, 3, 3] }\npoint_light { position: [1, 1, 1] }",
          "box { size: [3, 3, 3] }\nrectangle { center: [0, 0.4, -0.5], size: [90, 90] }"}) {
        EXPECT_EQ(codes(with_camera_inside(shape)), "") << shape;
    }
}

TEST(WarnEnclosed, WhatOnlyTouchesTheObjectMakesNoRoomOfIt) {
    EXPECT_EQ(codes(with_camera_inside(
                  "box { size: [3, 3, 3] }\nbox { size: [0.5, 0.5, 0.5], center: [0, 1.7, 0] }\n"
                  "plane { point: [0, -1.5, 0] }")),
              "W1203");
    EXPECT_EQ(codes(with_camera_inside("sphere { }\nbox { size: [100, 100, 100] }")), "W1203")
        << "the room around both is none of its contents";
}

TEST(WarnEnclosed, OrthographicCamerasLookFromAWholePlane) {
    EXPECT_EQ(codes("camera { projection: \"orthographic\", position: [0, 0, 1], height: 9 }\n"
                    "sphere { radius: 2 }"),
              "");
}

TEST(WarnEnclosed, LightInsideAnOpaqueShapeIsTold) {
    EXPECT_EQ(codes(with_lamp_in("sphere { center: [0, 0.5, 0], radius: 0.3 }")), "W1204");
    EXPECT_EQ(codes(with_lamp_in("sphere { material { emission: 5 } }")), "W1204");
    EXPECT_EQ(codes(with_lamp_in("sphere { }\nbox { size: [0.2, 1, 0.2], center: [0, 1.4, 0] }")),
              "W1204")
        << "a socket makes no room of a bulb";
    EXPECT_EQ(codes("camera { position: [0, 0, 9] }\nsphere { }\nspot_light { }"), "W1204");
}

TEST(WarnEnclosed, LampsThatLetTheLightOutAreSilent) {
    for (const char* const shape : {"sphere { casts_shadow: false }", "sphere { visible: false }",
                                    "sphere { material { diffuse: 0, transmit: 1 } }",
                                    "sphere { material { opacity: checker { } } }",
                                    "cylinder { radius_to: 1, caps: false }",  // a shade
                                    "group { sphere { } casts_shadow: false }",
                                    "box { size: [40, 40, 40] }",         // a room
                                    "sphere { center: [0, 1.4, 0] }"}) {  // on its surface
        EXPECT_EQ(codes(with_lamp_in(shape)), "") << shape;
    }
    EXPECT_EQ(codes("camera { position: [0, 0, 9] }\nsphere { }\n"
                    "point_light { casts_shadow: false }\ndirectional_light { }"),
              "");
}

TEST(WarnEnclosed, TheWayToTheObjectIsNamed) {
    const Loaded loaded = linted(
        "let lamp = group \"lamp\" {\n"
        "  sphere \"bulb\" { radius: 0.3 }\n"
        "  point_light { }\n"
        "}\n"
        "camera { position: [0, 0, 20] }\n"
        "group \"street\" {\n"
        "  lamp \"first\" { casts_shadow: false }\n"
        "  lamp \"second\" { translate: [2, 0, 0] }\n"
        "}\n");
    ASSERT_EQ(loaded.codes(), "W1204");
    const Diagnostic& warning = *loaded.diagnostics.sorted().front();
    EXPECT_EQ(place_of(loaded.sources, warning.span), "3:3");
    EXPECT_EQ(warning.message, "this light is inside an opaque sphere `bulb`, which keeps it in");
    ASSERT_EQ(warning.notes.size(), 1u);
    EXPECT_EQ(warning.notes[0], "the sphere is `street` > `second` > `lamp` > sphere `bulb`");
    ASSERT_EQ(warning.labels.size(), 2u);
    EXPECT_EQ(place_of(loaded.sources, warning.labels[0].span), "2:3");
    EXPECT_EQ(place_of(loaded.sources, warning.labels[1].span), "8:3");
    EXPECT_EQ(warning.labels[1].message, "placed here");
}

TEST(WarnView, NothingBeforeTheCameraIsTold) {
    for (const char* const scene :
         {"camera { position: [0, 0, 5], look_at: [0, 0, 9] }\nsphere { }",  // behind
          "camera { position: [0, 0, 5], look_at: [9, 0, 5] }\nsphere { }",  // beside
          "camera { position: [0, 9, 5], look_at: [0, 9, 0] }\nsphere { }",  // below
          "camera { position: [0, 2, 0], look_at: [0, 5, 1] }\nplane { }",
          "camera { projection: \"orthographic\", look_at: [0, 0, 9] }\nsphere { }",
          "camera { projection: \"orthographic\", position: [0, 0, 5], look_at: [0, 0, 0] }\n"
          "sphere { center: [3, 0, 0] }",
          "camera { projection: \"panorama\" }\nsphere { visible: false }",
          "camera { }\ngroup { visible: false\n sphere { }\n plane { } }"}) {
        EXPECT_EQ(codes(scene), "W1205") << scene;
    }
}

TEST(WarnView, WhatMayShowIsSilent) {
    for (const char* const scene :
         {"camera { position: [0, 3.3, 5], look_at: [0, 3.3, 0] }\nsphere { }",  // a rim below
          "camera { position: [0, 0, 5], look_at: [0, 0, 9] }\nsphere { }\nenvironment { }",
          "camera { position: [0, 0, 5], look_at: [0, 0, 9], aperture: 0.1 }\nsphere { }",
          "camera { position: [0, 0, 5], look_at: [0, 0, 9] }\nsphere { }\n"
          "area_light { center: [0, 0, 9] }",
          "camera { position: [0, 0, 5], look_at: [0, 0, 9] }\nsphere { }\nanimation { frames: 3 }",
          "camera { projection: \"panorama\" }\nsphere { center: [0, 0, 9] }",
          "camera { position: [0, 2, 0], look_at: [0, 2, 1] }\nplane { }",  // the horizon
          "camera { projection: \"orthographic\", position: [0, 1, 5], look_at: [0, 1, 0] }\n"
          "plane { point: [0, 0.5, 0] }",
          "camera { position: [0, 0, 5] }\nsphere { }\n"
          "camera \"back\" { position: [0, 0, 5], look_at: [0, 0, 9] }"}) {
        EXPECT_EQ(codes(scene), "") << scene;
    }
}

TEST(WarnView, TheWidthOfThePictureCounts) {
    const std::string scene =
        "camera { position: [0, 0, 5], look_at: [0, 0, 0] }\nsphere { center: [5, 0, 0] }\n";
    EXPECT_EQ(codes(scene), "W1205");
    EXPECT_EQ(codes(scene + "render { resolution: [2000, 500] }"), "");
    Loaded loaded = load_text(scene);
    const auto world = scene::flatten(*loaded.scene, {}, loaded.diagnostics);
    scene::lint(*loaded.scene, *world, {.resolution = scene::Resolution{2000, 500}},
                loaded.diagnostics);
    EXPECT_EQ(loaded.codes(), "");
}

constexpr std::string_view kView = "camera { position: [1, 3, 9] }\n";

std::string twice(const std::string& shape, const std::string& other) {
    return std::string(kView) + shape + ", material { diffuse: red } }\n" + other +
           ", material { diffuse: blue } }\n";
}

TEST(WarnCoincident, EveryKindInTheSamePlaceIsTold) {
    for (const char* const shape :
         {"sphere { radius: 1", "sphere { scale: [1, 2, 1]", "box { size: [1, 1, 1]",
          "cylinder { radius: 1", "disk { hole: 0.2", "torus { tube: 0.2",
          "plane { point: [0, 0, 0]", "rectangle { size: [2, 2]",
          "triangle { a: [0, 0, 0], b: [1, 0, 0], c: [0, 1, 0]"}) {
        EXPECT_EQ(codes(twice(shape, shape)), "W1206") << shape;
    }
    EXPECT_EQ(codes(twice("triangle { a: [0, 0, 0], b: [1, 0, 0], c: [0, 1, 0]",
                          "triangle { a: [0, 1, 0], b: [-0.0, 0, 0], c: [1, 0, 0]")),
              "W1206")
        << "the same corners in another order";
}

TEST(WarnCoincident, SmallDifferencesEqualLooksAndWhatShowsThroughAreSilent) {
    EXPECT_EQ(codes(twice("sphere { radius: 1", "sphere { radius: 1.000001")), "");
    EXPECT_EQ(codes(twice("disk { hole: 0", "disk { hole: 0.5")), "");
    EXPECT_EQ(codes(twice("cylinder { radius: 1", "cylinder { radius: 1, radius_to: 0")), "");
    EXPECT_EQ(codes(twice("sphere { visible: false", "sphere { radius: 1")), "");
    const std::string view(kView);
    EXPECT_EQ(codes(view + "sphere { }\nsphere { }"), "");
    EXPECT_EQ(codes(view + "sphere { material { diffuse: red } }\n"
                           "sphere { material { diffuse: red } }"),
              "");
    EXPECT_EQ(codes(view + "rectangle { material { diffuse: red } }\n"
                           "rectangle { material { diffuse: blue, opacity: 0.5 } }"),
              "");
}

TEST(WarnCoincident, FacesThatOverlapInOnePlaneAreTold) {
    // The tops of two boxes, a rug on a box, two rugs, the fronts of boxes of other depths.
    EXPECT_EQ(codes(twice("box { size: [2, 1, 1]", "box { size: [1, 1, 2]")), "W1206");
    EXPECT_EQ(
        codes(twice("box { size: [1, 1, 1]", "rectangle { center: [0, 0.5, 0], size: [0.5, 0.5]")),
        "W1206");
    EXPECT_EQ(codes(twice("rectangle { size: [1, 2]", "rectangle { center: [0.2, 0, 0]")), "W1206");
    EXPECT_EQ(codes(twice("box { min: [0, 0, 0], max: [1, 1, 1]",
                          "box { min: [0.5, 0.2, 0.4], max: [1.5, 0.8, 1]")),
              "W1206");
}

TEST(WarnCoincident, FacesThatTouchOrAreNotSeenAreSilent) {
    for (const auto& [one, other] : std::vector<std::pair<std::string, std::string>>{
             {"rectangle { size: [9, 9]", "box { center: [0, 0.5, 0]"},   // stands on it
             {"box { center: [0, 0.5, 0]", "box { center: [0, 1.5, 0]"},  // a tower
             {"box { min: [0, 0, 0], max: [1, 1, 1]", "box { min: [1, 0, 0], max: [2, 1, 1]"},
             {"box { min: [0, 0, 0], max: [2, 1, 2]", "box { min: [0.5, 0, 0.5], max: [1, 2, 1]"},
             {"rectangle { size: [1, 1]", "rectangle { size: [1, 1], center: [1, 0, 0]"},
             {"rectangle { size: [1, 2]", "rectangle { center: [0.2, 0.0001, 0]"},
             {"box { size: [2, 1, 1]", "box { size: [1, 1, 2], visible: false"}}) {
        EXPECT_EQ(codes(twice(one, other)), "") << one << "\n" << other;
    }
    EXPECT_EQ(codes(twice("box { size: [2, 1, 1]", "box { size: [1, 1, 2]") +
                    "box { center: [0, 0.55, 0], size: [4, 0.1, 4] }"),
              "")
        << "a table top lies on both";
}

TEST(WarnCoincident, ManyAreToldByTheFirstAndTheirNumber) {
    std::string scene(kView);
    for (int i = 0; i < 7; ++i) {
        const std::string ball = "sphere { radius: 0.1, center: [" + std::to_string(i) + ", 0, 0]";
        scene += ball + ", material { diffuse: red } }\n";
        scene += ball + ", material { diffuse: blue } }\n";
    }
    const Loaded loaded = linted(scene);
    EXPECT_EQ(loaded.codes(), "W1206 W1206 W1206");
    EXPECT_EQ(loaded.diagnostics.sorted().back()->notes,
              std::vector<std::string>{"... and 4 more"});
}

TEST(WarnMirrored, OnlyWhenItIsAskedForAndOnlyWhereTheTransformIs) {
    const TempDirectory directory;
    const std::string path = directory.write(
        "main.lrs",
        "camera { }\ngroup {\n  box { }\n  sphere { scale: [-1, -1, 1] }\n  scale: [1, -1, 1]\n}");
    Loaded silent = load_file(path);
    flatten_and_lint(silent);
    EXPECT_EQ(silent.codes(), "");
    Loaded told = load_file(path, {}, all_warnings());
    flatten_and_lint(told);
    EXPECT_EQ(told.text(), "W1303 2:1 the transform of this group mirrors it\n");
}

TEST(UnusedMaterial, OnlyOfTheMainFileAndOnlyIfItPlacesSomething) {
    const auto loaded_with = [](std::string_view text) {
        return load_text(text, parser::LoadSettings{},
                         {{"parts.lrs", "let brass = material { }\nlet oak = material { }\n"}})
            .codes();
    };
    EXPECT_EQ(loaded_with("camera { }\nlet a = material { }\nsphere { }"), "W1405");
    EXPECT_EQ(loaded_with("camera { }\nlet a = material { }\nlet b = a { }\nsphere { }"), "W1405");
    EXPECT_EQ(loaded_with("camera { }\nlet a = material { }\nsphere { material: a }"), "");
    EXPECT_EQ(loaded_with("camera { }\nlet _a = material { }\nsphere { }"), "");
    EXPECT_EQ(loaded_with("camera { }\nlet a = 1\nlet b = sphere { }\nsphere { }"), "");
    EXPECT_EQ(loaded_with("camera { }\ninclude \"parts.lrs\"\nsphere { }"), "");
    EXPECT_EQ(
        loaded_with("camera { }\nimport \"parts.lrs\" as parts\nsphere { material: parts.oak }"),
        "");
    EXPECT_EQ(loaded_with("let a = material { }\nlet b = a { }"), "W1503") << "a library";
    EXPECT_EQ(loaded_with("camera { }\nlet a = material { }\nfn pick(i) = a\n"
                          "sphere { material: pick(1) }"),
              "");
    EXPECT_EQ(loaded_with("camera { }\nfn pick(i) = a\nlet a = material { }\n"
                          "sphere { material: pick(1) }"),
              "")
        << "used above its definition, by a function";
    EXPECT_EQ(loaded_with("camera { }\nlet a = material { }\nsphere { material: aa }"), "E0201")
        << "a misspelt use is told once";
}

TEST(SceneWarnings, NoExampleAndNoGoldenSceneRaisesAny) {
    std::size_t count = 0;
    for (const char* const folder : {"/examples", "/tests/golden"}) {
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(LRAY_SOURCE_DIR + std::string(folder))) {
            if (entry.path().extension() != ".lrs") continue;
            Loaded loaded = load_file(entry.path().string());
            ASSERT_TRUE(flatten_and_lint(loaded)) << entry.path() << "\n" << loaded.text();
            ++count;
            for (const Diagnostic* diagnostic : loaded.diagnostics.sorted()) {
                const bool is_said = diagnostic->code == Code::W1501 ||  // fitted_camera
                                     diagnostic->code == Code::W1503;    // materials
                EXPECT_TRUE(is_said) << entry.path() << "\n" << loaded.text();
            }
        }
    }
    EXPECT_GT(count, 10u);
}

}  // namespace
}  // namespace lray::test
