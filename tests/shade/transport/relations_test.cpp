// What must hold between pictures of related scenes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include "tests/shade/lit_scene.h"
#include "tests/support/random.h"

namespace lray::test {
namespace {

/// A scene with something of everything, all of its lengths times `scale`.
std::string everything(double scale, const std::string& lights) {
    return lights +
           fmt::format(
               "group {{ scale: {}\n"
               "  rectangle {{ size: [20, 20], material {{ diffuse: 0.6, reflect: 0.2 }} }}\n"
               "  sphere {{ center: [0, 1, 0], material {{ diffuse: 0.1, transmit: 0.9\n"
               "    absorption: [{}, {}, 0] }} }}\n"
               "  box {{ center: [2, 0.5, 0], material {{ model: \"cook_torrance\" }} }}\n"
               "  cylinder {{ from: [-2, 0, 0], to: [-2, 2, 1], material {{ model: \"phong\" }} "
               "}}\n"
               "  triangle {{ a: [-1, 0, -2], b: [1, 0, -2], c: [0, 3, -2], material {{ reflect: "
               "1, "
               "diffuse: 0 }} }}\n}}\n",
               scale, 0.25 / scale, 0.5 / scale);
}

std::string light_at(DVec3 position, double intensity, const std::string& more = "") {
    return fmt::format("point_light {{ position: [{}, {}, {}], intensity: {}{} }}\n", position.x,
                       position.y, position.z, intensity, more);
}

std::vector<std::pair<DVec3, DVec3>> views(double scale) {
    Random random(77);
    std::vector<std::pair<DVec3, DVec3>> result;
    for (int i = 0; i < 400; ++i) {
        const DVec3 eye{0.5, 2.0, 7.0};
        const DVec3 aim{random.uniform(-4.0, 4.0), random.uniform(0.0, 2.5),
                        random.uniform(-2.0, 2.0)};
        result.emplace_back(scale * eye, aim - eye);
    }
    return result;
}

std::vector<Color> seen_in(const LitScene& scene, double scale = 1.0) {
    std::vector<Color> result;
    for (const auto& [origin, direction] : views(scale)) {
        result.push_back(scene.seen(origin, direction));
    }
    return result;
}

TEST(Relations, PowersOfTwoOfTheScaleGiveTheSameBits) {
    const std::vector<Color> expected =
        seen_in(LitScene(everything(1.0, light_at({3, 6, 4}, 800))));
    for (const double scale : {0x1p-10, 0.5, 8.0, 0x1p20}) {
        const LitScene scaled(
            everything(scale, light_at(scale * DVec3{3, 6, 4}, 800.0 * scale * scale)));
        const std::vector<Color> seen = seen_in(scaled, scale);
        int different_count = 0;
        for (std::size_t i = 0; i < seen.size(); ++i) different_count += seen[i] != expected[i];
        EXPECT_EQ(different_count, 0) << "scale " << scale;
    }
}

TEST(Relations, LightsAddUpAndScale) {
    const std::string a = light_at({3, 6, 4}, 800, ", color: [1, 0.5, 0.2]");
    const std::string b = "directional_light { direction: [1, -2, -1], intensity: 0.5 }\n";
    const std::string twice_a = light_at({3, 6, 4}, 1600, ", color: [1, 0.5, 0.2]");
    const std::vector<Color> only_a = seen_in(LitScene(everything(1.0, a)));
    const std::vector<Color> only_b = seen_in(LitScene(everything(1.0, b)));
    const std::vector<Color> both = seen_in(LitScene(everything(1.0, a + b)));
    const std::vector<Color> doubled = seen_in(LitScene(everything(1.0, twice_a)));
    for (std::size_t i = 0; i < both.size(); ++i) {
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(both[i][channel], only_a[i][channel] + only_b[i][channel], 1e-5f);
            EXPECT_NEAR(doubled[i][channel], 2.0f * only_a[i][channel], 1e-5f);
        }
    }
}

TEST(Relations, InstancesLookLikeCopies) {
    const std::string ball =
        "sphere { material { transmit: 0.8, diffuse: 0.1, absorption: 0.5 } }\n";
    const std::string light = light_at({3, 6, 4}, 800) + "rectangle { size: [20, 20] }\n";
    const LitScene instances(light + "let ball = group {\n" + ball +
                             "box { center: [0, 2, 0], material { reflect: 0.5 } } }\n"
                             "ball { translate: [-1.5, 1, 0] }\nball { translate: [1.5, 1, 0] }");
    const LitScene copies(light + "group { translate: [-1.5, 1, 0]\n" + ball +
                          "box { center: [0, 2, 0], material { reflect: 0.5 } } }\n"
                          "group { translate: [1.5, 1, 0]\n" +
                          ball + "box { center: [0, 2, 0], material { reflect: 0.5 } } }");
    const std::vector<Color> a = seen_in(instances);
    const std::vector<Color> b = seen_in(copies);
    int different_count = 0;  // edges may fall to either side
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Color off = glm::abs(a[i] - b[i]);
        different_count += std::max({off.r, off.g, off.b}) > 1e-4f;
    }
    EXPECT_LE(different_count, 4);
}

TEST(Relations, HierarchiesGiveTheSameBits) {
    const std::string text =
        "render { transparent_shadows: true }\n" +
        everything(1.0, light_at({3, 6, 4}, 800) + "area_light { center: [0, 5, 0] }\n");
    const std::vector<Color> expected = seen_in(LitScene(text, bvh::AccelKind::none));
    EXPECT_TRUE(seen_in(LitScene(text, bvh::AccelKind::spheres)) == expected);
    EXPECT_TRUE(seen_in(LitScene(text, bvh::AccelKind::boxes)) == expected);
}

TEST(Relations, OneRayOrManyTogetherGiveTheSameBits) {
    for (const char* integrator : {"whitted", "path"}) {
        const LitScene scene(fmt::format("render {{ integrator: \"{}\" }}\n", integrator) +
                             everything(1.0, light_at({3, 6, 4}, 800, ", radius: 0.5")));
        constexpr std::size_t kCount = shade::kMaxWaveSize;
        std::array<Ray, kCount> rays;
        std::array<shade::RayCone, kCount> cones{};
        std::array<PixelSample, kCount> samples;
        std::array<bvh::Hit, kCount> hits;
        std::array<Color, kCount> together;
        const auto all = views(1.0);
        bvh::TraceCounts counts;
        for (std::size_t i = 0; i < kCount; ++i) {
            const auto& [origin, direction] = all[i];
            rays[i] = {Vec3{origin}, Vec3{direction / std::sqrt(dot(direction, direction))}};
            samples[i] =
                PixelSample::of(SamplerKind::sobol, 1, static_cast<std::uint32_t>(i), 3, 0);
            hits[i] = scene.lit().accel.nearest_hit(rays[i], {}, counts);
        }
        const std::atomic<bool> cancel = false;
        shade::LightCounts cost;
        const auto follow = [&](std::size_t first, std::size_t count, std::span<Color> colors) {
            ASSERT_TRUE(shade::follow_light(
                scene.lit(), scene.settings, {},
                {std::span(rays).subspan(first, count), std::span(cones).subspan(first, count),
                 std::span(samples).subspan(first, count), std::span(hits).subspan(first, count)},
                colors, cost, cancel));
        };
        follow(0, kCount, together);
        for (std::size_t i = 0; i < kCount; ++i) {
            Color alone{};
            follow(i, 1, std::span(&alone, 1));
            EXPECT_EQ(alone, together[i]) << integrator << " ray " << i;
        }
    }
}

}  // namespace
}  // namespace lray::test
