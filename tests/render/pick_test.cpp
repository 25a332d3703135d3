#include "render/pick.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/parser/loaded.h"

namespace lray::render {
namespace {

/// A scene that is looked at along -Z, ten units of it in 100 x 100 pixels.
class Picked {
 public:
    explicit Picked(std::string_view text, const std::vector<test::Companion>& companions = {},
                    const scene::SharingRule& sharing = {},
                    bvh::AccelKind kind = bvh::AccelKind::boxes)
        : loaded_(test::load_text(text, parser::LoadSettings{}, companions)) {
        EXPECT_FALSE(loaded_.has_errors()) << loaded_.text();
        if (!loaded_.scene) return;
        auto world = scene::flatten(*loaded_.scene, {.sharing = sharing}, loaded_.diagnostics);
        EXPECT_TRUE(world.has_value());
        if (world) world_ = std::move(*world);
        accel_ = bvh::build(world_, {.kind = kind});
    }

    std::optional<Pick> at(double x, double y) const {
        if (!accel_) return std::nullopt;
        scene::Camera camera;
        camera.position = {0.0, 0.0, 10.0};
        camera.projection = scene::Projection::orthographic;
        camera.height = 10.0;
        return pick(*loaded_.scene, world_, *accel_, loaded_.sources, camera, {100, 100},
                    {50.0 + 10.0 * x, 50.0 - 10.0 * y}, cancel_);
    }

    /// What is written of a pick: "name @ 2:3 < 7:1", places in the main file without its name.
    std::string words_at(double x, double y) const {
        const std::optional<Pick> found = at(x, y);
        if (!found) return "nothing";
        std::string words = found->name + " @ " + short_place(found->place);
        if (!found->placed_at.empty()) words += " < " + short_place(found->placed_at);
        return words;
    }

    const scene::World& world() const { return world_; }
    test::Loaded& loaded() { return loaded_; }
    std::atomic<bool>& cancel() { return cancel_; }

 private:
    std::string short_place(const std::string& place) const {
        const std::string main = loaded_.sources[0].path + ":";
        if (place.starts_with(main)) return place.substr(main.size());
        return place.substr(place.rfind('/') + 1);
    }

    test::Loaded loaded_;
    scene::World world_{};
    std::unique_ptr<bvh::Accel> accel_{};
    std::atomic<bool> cancel_ = false;
};

void expect_near(DVec3 a, DVec3 b) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], 1e-6);
}

TEST(Pick, NamesTheGroupsOnTheWayThatHaveALabel) {
    const Picked picked(R"(group "tree" {
  group {
    sphere "apple" { center: [0, 0, 2], radius: 1.5 }
    sphere { center: [3, 0, 0] }
  }
}
)");
    EXPECT_EQ(picked.words_at(0, 0), "group `tree` > sphere `apple` @ 3:5");
    EXPECT_EQ(picked.words_at(3, 0), "group `tree` > sphere @ 4:5");
    EXPECT_EQ(picked.words_at(0, 4), "nothing");
    const std::optional<Pick> apple = picked.at(0, 0);
    ASSERT_TRUE(apple.has_value());
    expect_near(apple->point, {0, 0, 3.5});
    expect_near(apple->normal, {0, 0, 1});
    EXPECT_NEAR(apple->distance, 6.5, 1e-6);
}

TEST(Pick, OfALoopIsTheBlockItself) {
    const Picked picked(
        "for i in [0, 1, 2] {\n  sphere { center: [2 * i, 0, 0], radius: 0.5 }\n}\n");
    EXPECT_EQ(picked.words_at(0, 0), "sphere @ 2:3");
    EXPECT_EQ(picked.words_at(4, 0), "sphere @ 2:3");
    ASSERT_TRUE(picked.at(4, 0).has_value());
    EXPECT_NEAR(picked.at(4, 0)->point.x, 4.0, 1e-6);
}

constexpr std::string_view kGates = R"(let gate = group "gate" {
  sphere "ball" { radius: 0.5 }
  box { size: [0.5, 0.5, 0.5], translate: [1, 0, 0] }
}
let pair = group "pair" {
  gate { translate: [0, 1, 0] }
  gate "lower" { translate: [0, -1, 0] }
}
pair "left" { translate: [-3, 0, 0] }
pair { rotate_z: 180, translate: [3, 0, 0] }
)";

TEST(Pick, OfAnInstanceSaysWhereItIsPlaced) {
    // The same where everything is stored once and where nothing is.
    for (const bool is_shared : {true, false}) {
        const Picked picked(kGates, {},
                            is_shared ? scene::SharingRule{2, 0} : scene::SharingRule::nothing());
        EXPECT_EQ(picked.world().prototypes.size(), is_shared ? 2u : 0u);
        EXPECT_EQ(picked.words_at(-3, 1),
                  "instance `left` > group `pair` > group `gate` > sphere `ball` @ 2:3 < 6:3");
        EXPECT_EQ(
            picked.words_at(-2, -1),
            "instance `left` > group `pair` > instance `lower` > group `gate` > box @ 3:3 < 7:3");
        EXPECT_EQ(picked.words_at(3, 1),
                  "group `pair` > instance `lower` > group `gate` > sphere `ball` @ 2:3 < 7:3");
        const std::optional<Pick> turned = picked.at(2.0, 1.0);
        ASSERT_TRUE(turned.has_value());
        expect_near(turned->point, {2.0, 1.0, 0.25});
        expect_near(turned->normal, {0, 0, 1});
    }
}

TEST(Pick, OfAMeshIsItsBlock) {
    const Picked picked("group \"hall\" {\n  mesh \"floor\" { file: \"a.obj\" }\n}\n",
                        {{"a.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n"}});
    EXPECT_EQ(picked.words_at(0, 0), "group `hall` > mesh `floor` @ 2:3");
}

TEST(Pick, OfAPlaneAndOfTheSky) {
    const Picked picked("plane { point: [0, 0, -5], normal: [0, 1, 0.5] }\n");
    EXPECT_EQ(picked.words_at(0, -1), "plane @ 1:1");
    const Picked flat("plane { point: [0, -5, 0] }\n");
    EXPECT_EQ(flat.words_at(0, 0), "nothing");  // along it
    EXPECT_EQ(Picked("").words_at(0, 0), "nothing");
}

TEST(Pick, OfAnIncludedFileIsThere) {
    const Picked picked("sphere { center: [3, 0, 0] }\ninclude \"part.lrs\"\ncrate { }\n",
                        {{"part.lrs", "let crate = group {\n  box \"crate\" { }\n}\n"}});
    EXPECT_EQ(picked.words_at(0, 0), "box `crate` @ part.lrs:2:3 < 3:1");
    EXPECT_EQ(picked.words_at(3, 0), "sphere @ 1:1");
}

TEST(Pick, IsTheSameInEachHierarchy) {
    const Picked expected(kGates, {}, {2, 0}, bvh::AccelKind::none);
    int hit_count = 0;
    for (const auto kind : {bvh::AccelKind::spheres, bvh::AccelKind::boxes}) {
        const Picked picked(kGates, {}, {2, 0}, kind);
        for (double x = -4.85; x < 5.0; x += 0.1) {
            for (double y = -2.0; y < 2.0; y += 0.1) {
                const std::optional<Pick> a = expected.at(x, y);
                const std::optional<Pick> b = picked.at(x, y);
                ASSERT_EQ(a.has_value(), b.has_value());
                if (!a) continue;
                ++hit_count;
                EXPECT_EQ(picked.words_at(x, y), expected.words_at(x, y));
                EXPECT_EQ(a->point, b->point);
                EXPECT_EQ(a->normal, b->normal);
                EXPECT_EQ(a->distance, b->distance);
            }
        }
    }
    EXPECT_GT(hit_count, 500);
}

TEST(Pick, ThroughTheMiddleOfTheLens) {
    const Picked picked("sphere { }\n");
    ASSERT_TRUE(picked.at(0.5, 0).has_value());
    EXPECT_NEAR(picked.at(0.5, 0)->point.z, std::sqrt(0.75), 1e-6);
    EXPECT_FALSE(picked.at(HUGE_VAL, 0).has_value());
}

TEST(Pick, WithoutTheTextThePlaceIsTheFile) {
    Picked picked("\nsphere { }\n");
    picked.loaded().sources.release_text(0);
    ASSERT_TRUE(picked.at(0, 0).has_value());
    EXPECT_EQ(picked.at(0, 0)->place, picked.loaded().sources[0].path);
    EXPECT_EQ(picked.at(0, 0)->name, "sphere");
}

TEST(Pick, NamesCommandNoTerminal) {
    Picked picked("sphere \"a\" { }\n");
    picked.loaded().scene->labels[0] = "\x1b[31m\xe2\x80\xae red";
    ASSERT_TRUE(picked.at(0, 0).has_value());
    EXPECT_EQ(picked.at(0, 0)->name, "sphere `\\u{1b}[31m\\u{202e} red`");
    picked.loaded().scene->labels[0] = std::string(1'000'000, 'x');
    EXPECT_LT(picked.at(0, 0)->name.size(), 3000u);
}

TEST(Pick, CancelledFindsNothing) {
    Picked picked("sphere { }\n");
    EXPECT_TRUE(picked.at(0, 0).has_value());
    picked.cancel() = true;
    EXPECT_FALSE(picked.at(0, 0).has_value());
}

}  // namespace
}  // namespace lray::render
