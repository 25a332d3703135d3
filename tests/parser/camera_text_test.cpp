#include "parser/tools/camera_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "base/angle.h"
#include "parser/tools/format.h"
#include "tests/parser/loaded.h"
#include "tests/support/random.h"

namespace lray::test {
namespace {

using parser::camera_text;
using parser::CameraDetail;
using parser::is_cameras_alone;

template <class Value>
bool same_bits(const Value& a, const Value& b) {
    return std::memcmp(&a, &b, sizeof(Value)) == 0;
}

void expect_same(const scene::Camera& a, const scene::Camera& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_TRUE(same_bits(a.position, b.position));
    EXPECT_TRUE(same_bits(a.look_at, b.look_at));
    EXPECT_TRUE(same_bits(a.up, b.up));
    EXPECT_EQ(a.projection, b.projection);
    EXPECT_TRUE(same_bits(a.fov, b.fov)) << a.fov - b.fov;
    EXPECT_TRUE(same_bits(a.height, b.height));
    EXPECT_TRUE(same_bits(a.aperture, b.aperture));
    EXPECT_EQ(a.focus, b.focus);
    EXPECT_EQ(a.resolution, b.resolution);
    EXPECT_EQ(a.samples, b.samples);
    EXPECT_EQ(a.background, b.background);
}

/// The camera that is read from its text.
void expect_read_back(const scene::Camera& camera, CameraDetail detail = CameraDetail::changes) {
    const std::string text = camera_text(camera, detail);
    SCOPED_TRACE(text);
    EXPECT_TRUE(is_cameras_alone(text) || camera.name.empty());
    const Loaded loaded = load_text(text + "\n");
    ASSERT_TRUE(loaded.scene) << loaded.text();
    ASSERT_EQ(loaded.scene->cameras.size(), 1u);
    expect_same(loaded.scene->cameras[0], camera);
}

TEST(CameraText, TellsOnlyWhatDiffers) {
    scene::Camera camera;
    EXPECT_EQ(camera_text(camera), "camera { position: [0, 0, 5], look_at: [0, 0, 0] }");
    camera.name = "a \"b\"";
    camera.position = {0.1 + 0.2, 1e21, -3.0};
    camera.fov = radians(30.0);
    EXPECT_EQ(
        camera_text(camera),
        "camera \"a \\\"b\\\"\" { position: [0.30000000000000004, 1e+21, -3], look_at: [0, 0, "
        "0], fov: 30 }");
    camera = {};
    EXPECT_EQ(
        camera_text(camera, CameraDetail::all),
        "camera {\n  position: [0, 0, 5]\n  look_at: [0, 0, 0]\n  up: [0, 1, 0]\n  fov: 45\n  "
        "projection: \"perspective\"\n  height: 2\n}");
}

TEST(CameraText, OfEveryPropertyIsReadBackToTheBit) {
    scene::Camera camera;
    camera.up = {-0.0, 1.0, 0.0};
    expect_read_back(camera);
    camera.name = "every one";
    camera.projection = scene::Projection::orthographic;
    camera.height = 1.0 / 3.0;
    camera.aperture = 5e-324;
    camera.focus = 0.1;
    camera.resolution = scene::Resolution{1, 1048576};
    camera.samples = 32768;
    camera.background = Color{0.1f, 1e-30f, 3.0f};
    expect_read_back(camera);
    expect_read_back(camera, CameraDetail::all);
    EXPECT_NE(camera_text(camera).find('\n'), std::string::npos);
}

TEST(CameraText, OfRandomCamerasIsReadBackToTheBit) {
    constexpr std::uint64_t kSeed = 20;
    LRAY_TRACE_SEED(kSeed);
    Random random(kSeed);
    for (int i = 0; i < 200; ++i) {
        scene::Camera camera;
        camera.name = "view 1";
        for (int k = 0; k < 3; ++k) {
            camera.position[k] = random.uniform(-1.0, 1.0) * std::exp2(random.uniform(-60.0, 60.0));
            camera.look_at[k] = random.uniform(-1.0, 1.0);
            camera.up[k] = random.uniform(-1.0, 1.0);
        }
        camera.fov = radians(random.uniform(1e-3, 179.0));
        expect_read_back(camera);
    }
}

TEST(CameraText, IsInTheCanonicalStyle) {
    scene::Camera camera;
    camera.name = "view 1";
    for (const double x : {1.0, 1.0 / 3.0, -1e-9 / 7.0}) {
        camera.position = {x, x, x};
        camera.up = {x, 2.0, x};
        const std::string text = camera_text(camera) + "\n";
        Sources sources;
        Diagnostics diagnostics;
        const SourceId id = sources.add("view.lrs", Text(text));
        EXPECT_EQ(parser::format(id, sources, {}, diagnostics), text);
    }
}

TEST(IsCamerasAlone, TrueForCamerasHoweverTheyAreSpelled) {
    EXPECT_TRUE(is_cameras_alone(""));
    EXPECT_TRUE(is_cameras_alone("\r\n\t "));
    EXPECT_TRUE(
        is_cameras_alone("camera \"a\" { }\ncamera \"b\"{position:[1.50,-2,3e4];fov:30deg}"));
    EXPECT_TRUE(
        is_cameras_alone("camera \"a\" {\n  projection: \"panorama\"\n  background: #fff\n}"));
    EXPECT_TRUE(is_cameras_alone("camera \"a\" { background: rgb(1, 2.5, 3), samples: 4 };"));
}

TEST(IsCamerasAlone, FalseForAllThatWouldBeLost) {
    for (const char* text : {"// note\ncamera \"a\" { }",
                             "camera \"a\" { /* note */ }",
                             "camera \"a\" { } // note",
                             "camera { }",
                             "sphere { }",
                             "let a = 1",
                             "camera \"a\" { fov: 15 * 2 }",
                             "camera \"a\" { fov: wide }",
                             "camera \"a\" { position: [x, 0, 0] }",
                             "camera \"a\" { if true { fov: 3 } }",
                             "camera \"a\" { let a = 1 }",
                             "camera \"a\" { position: vec3(1, 2, 3) }",
                             "let c = camera { }",
                             "camera \"a\" { background: gray(1) }",
                             "include \"a.lrs\"",
                             "param n = 1",
                             "lrs 1.0\ncamera \"a\" { }",
                             "camera \"a\" {",
                             "camera \"a\" { fov: }",
                             "camera \"a",
                             "camera \"a\" { } }",
                             "print(1)",
                             "camera \"a\" { position: [[1], 2, 3] }",
                             "\xff",
                             "camera \"a\" { fov: 1.2.3 }",
                             "camera \"a\" { fov: - }"}) {
        EXPECT_FALSE(is_cameras_alone(text)) << text;
    }
    EXPECT_FALSE(is_cameras_alone(std::string_view("camera \"a\" { }\0", 15)));
}

}  // namespace
}  // namespace lray::test
