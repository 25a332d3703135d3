// The lights of a world together: which there are, which is chosen, which a ray meets.
#include "shade/lights/light_table.h"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "tests/shade/lights/light_means.h"

namespace lray::shade {
namespace {

scene::WorldLight light_of(scene::LightShape shape, double intensity = 500.0) {
    scene::WorldLight light;
    light.light.shape = std::move(shape);
    light.light.intensity = intensity;
    return light;
}

scene::AreaLight lamp_above(double height, std::uint32_t samples = 16) {
    return {{-1.0, -1.0, height}, {0.0, 2.0, 0.0}, {2.0, 0.0, 0.0}, samples};
}

scene::World world_of(std::vector<scene::WorldLight> lights) {
    scene::World world;
    world.lights = std::move(lights);
    return world;
}

/// What is asked of a world's lights. It stays where it is: the table refers to it.
struct Lights {
    explicit Lights(std::vector<scene::WorldLight> lights)
        : world(world_of(std::move(lights))), textures(world), table(world, textures) {}
    Lights(const Lights&) = delete;
    Lights& operator=(const Lights&) = delete;

    scene::World world;
    TextureSet textures;
    LightTable table;
};

TEST(LightTable, OnlyLightsThatShineAreInIt) {
    auto black = light_of(scene::PointLight{});
    black.light.color = Color{0.0f};
    auto quiet = light_of(scene::DirectionalLight{}, 1.0);
    quiet.casts_shadow = false;
    const Lights lights({light_of(scene::PointLight{}, 0.0), black, quiet,
                         light_of(lamp_above(1.0, 9)),
                         light_of(scene::PointLight{DVec3{0.0}, {}, 0.5, 4}),
                         light_of(scene::PointLight{DVec3{0.0}, {}, 0.0, 4}),
                         light_of(scene::SpotLight{DVec3{0.0}, {0, 0, -1}, 1.0, 0.0, {}, 0.5, 3}),
                         light_of(scene::DirectionalLight{{0, 0, -1}, 0.1, 7}, 1.0)});
    const LightTable& table = lights.table;
    ASSERT_EQ(table.count(), 6u);
    EXPECT_FALSE(table.casts_shadow(0));
    EXPECT_TRUE(table.casts_shadow(1));
    const std::array<std::uint32_t, 6> samples = {1, 9, 4, 1, 3, 7};
    for (std::uint32_t i = 0; i < 6; ++i) EXPECT_EQ(table.sample_count(i), samples[i]) << i;
    EXPECT_FALSE(table.has_environment());
}

TEST(LightTable, WithoutLightsThereIsNothingToChoose) {
    const Lights lights({});
    EXPECT_EQ(lights.table.count(), 0u);
    EXPECT_FALSE(lights.table.choose(DVec3{0.0}, 0.5));
    EXPECT_FALSE(lights.table.nearest_hit({{0, 0, 0}, {0, 0, 1}}, {}));
}

TEST(LightTable, EnvironmentIsThereOnceAndKnowsItsNumber) {
    const auto sky = light_of(scene::EnvironmentLight{{}, DMat3{1.0}, 5}, 0.5);
    const Lights lights({light_of(scene::PointLight{}), sky, sky});
    ASSERT_EQ(lights.table.count(), 2u);
    ASSERT_TRUE(lights.table.has_environment());
    EXPECT_EQ(lights.table.environment_light(), 1u);
    EXPECT_EQ(lights.table.sample_count(1), 5u);
    EXPECT_EQ(lights.table.environment({0.0f, 1.0f, 0.0f}), Color{0.5f});
    const Vec3 up{0.0f, 1.0f, 0.0f};
    EXPECT_NEAR(lights.table.pdf(1, DVec3{0.0}, up, up), std::numbers::inv_pi, 1e-6);
}

TEST(LightTable, BlackEnvironmentIsSeenAndGivesNoLight) {
    const Lights lights({light_of(scene::EnvironmentLight{}, 0.0)});
    ASSERT_TRUE(lights.table.has_environment());
    EXPECT_EQ(lights.table.environment({0.0f, 1.0f, 0.0f}), Color{0.0f});
    EXPECT_FALSE(lights.table.choose(DVec3{0.0}, 0.5));
}

TEST(LightTable, HiddenEnvironmentLightsAndIsNotSeen) {
    auto sky = light_of(scene::EnvironmentLight{}, 0.5);
    sky.visible = false;
    const Lights lights({sky});
    EXPECT_FALSE(lights.table.has_environment());
    const Vec3 up{0.0f, 1.0f, 0.0f};
    const auto sample = lights.table.sample(0, DVec3{0.0}, up, {0.5, 0.5});
    ASSERT_TRUE(sample);
    EXPECT_NEAR(sample->irradiance.r, 0.5f, 1e-6f);
    EXPECT_EQ(sample->pdf, 0.0f);
    EXPECT_EQ(lights.table.pdf(0, DVec3{0.0}, up, up), 0.0f);
}

TEST(LightTable, RaysMeetTheNearestBallOrLampThatIsVisible) {
    auto hidden = light_of(lamp_above(1.0));
    hidden.visible = false;
    const Lights lights({hidden, light_of(lamp_above(8.0)),
                         light_of(scene::PointLight{{0, 0, 5}, {}, 1.0, 1}),
                         light_of(scene::PointLight{{0, 0, 2}, scene::Falloff::linear, 0.5, 1}),
                         light_of(scene::SpotLight{{0, 0, 3}, {0, 0, -1}, 1.0, 0.0, {}, 0.5, 3})});
    const Ray up{{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
    const auto ball = lights.table.nearest_hit(up, {});
    ASSERT_TRUE(ball);
    EXPECT_EQ(ball->t, 4.0f);
    EXPECT_EQ(ball->light, 2u);
    EXPECT_NEAR(ball->radiance.r, 500.0 / (4.0 * std::numbers::pi), 1e-5);
    const auto lamp = lights.table.nearest_hit(up, {6.0f, kInfinity});
    ASSERT_TRUE(lamp);
    EXPECT_EQ(lamp->t, 8.0f);
    EXPECT_EQ(lamp->light, 1u);
    EXPECT_EQ(lamp->radiance.r, 125.0f);
    EXPECT_FALSE(lights.table.nearest_hit(up, {0.0f, 4.0f}));
    EXPECT_FALSE(lights.table.nearest_hit({{0, 0, 0}, {0, 0, -1}}, {}));
}

/// How often each light is chosen, of evenly spread numbers, is its probability.
void expect_choices(const LightTable& table, DVec3 point) {
    constexpr int kCount = 200'000;
    std::vector<int> found(table.count(), 0);
    for (int i = 0; i < kCount; ++i) {
        const auto choice = table.choose(point, (i + 0.5) / kCount);
        ASSERT_TRUE(choice);
        EXPECT_EQ(choice->probability, table.probability(choice->light, point));
        ++found[choice->light];
    }
    double sum = 0.0;
    for (std::uint32_t light = 0; light < table.count(); ++light) {
        const double probability = double{table.probability(light, point)};
        EXPECT_NEAR(found[light], probability * kCount, 2.0) << light;
        sum += probability;
        if (table.sample(light, point, {0.0f, 0.0f, 1.0f}, {0.5, 0.5})) {
            EXPECT_GT(probability, 0.0) << light;
        }
    }
    EXPECT_NEAR(sum, 1.0, 1e-6);
}

TEST(LightTable, FewLightsAreChosenByWhatTheyAreWorthAtThePoint) {
    const Lights lights(
        {light_of(scene::PointLight{{0, 0, 5}, {}, 1.0, 1}), light_of(lamp_above(2.0)),
         light_of(scene::DirectionalLight{}, 1.0), light_of(scene::EnvironmentLight{}, 0.5),
         light_of(scene::SpotLight{{0, 0, 3}}),
         light_of(scene::PointLight{{9, 0, 3}, scene::Falloff::none, 0.0, 1}, 3.0)});
    for (const DVec3 point : {DVec3{0.0}, DVec3{0.0, 0.0, 2.0}, DVec3{50.0, 3.0, -1.0},
                              DVec3{0.0, 0.0, 5.0}, DVec3{1e18, 0.0, 0.0}}) {
        expect_choices(lights.table, point);
    }
    EXPECT_EQ(lights.table.probability(1, {0.0, 0.0, 3.0}), 0.0f);  // behind the lamp
    EXPECT_GT(lights.table.probability(0, {0.0, 0.0, 6.5}), 0.5f);
}

TEST(LightTable, ManyLightsAreChosenByPowerAndEachSometimes) {
    std::vector<scene::WorldLight> many;
    for (int i = 0; i < 300; ++i) {
        many.push_back(light_of(scene::PointLight{DVec3{i, 0.0, 1.0}, {}, 0.0, 1}, i + 1.0));
    }
    many.push_back(light_of(scene::DirectionalLight{}, 1.0));
    many.push_back(light_of(scene::EnvironmentLight{}, 1.0));
    many.push_back(light_of(scene::SpotLight{}, 100.0));
    const Lights lights(std::move(many));
    expect_choices(lights.table, DVec3{0.0});
    EXPECT_GT(lights.table.probability(299, DVec3{0.0}),
              2.0f * lights.table.probability(0, DVec3{0.0}));
}

TEST(LightTable, LightsOfExtremeStrengthAreChosenWithFiniteProbability) {
    const Lights lights({light_of(scene::PointLight{}, 1e300),
                         light_of(scene::PointLight{}, 1e-300), light_of(lamp_above(1.0), 1e300)});
    for (const DVec3 point : {DVec3{0.0}, DVec3{1e18, 0.0, 0.0}, DVec3{1e-160, 0.0, 0.0}}) {
        const auto choice = lights.table.choose(point, 0.3);
        ASSERT_TRUE(choice);
        EXPECT_GT(choice->probability, 0.0f);
        EXPECT_LE(choice->probability, 1.0f);
    }
}

TEST(LightTable, SumOfLightsIsThatOfEachByChoice) {
    const Lights lights({light_of(scene::PointLight{{0, 0, 5}, {}, 0.0, 1}, 400.0),
                         light_of(lamp_above(4.0)), light_of(scene::DirectionalLight{}, 3.0),
                         light_of(scene::EnvironmentLight{}, 0.5)});
    const DVec3 point{0.3, -0.2, 0.0};
    const Vec3 up{0.0f, 0.0f, 1.0f};
    double all = 0.0;
    for (std::uint32_t light = 0; light < lights.table.count(); ++light) {
        all += test::irradiance([&](DVec2 u) { return lights.table.sample(light, point, up, u); },
                                DVec3(up));
    }
    test::Random random(6);
    double sum = 0.0;
    constexpr int kCount = 400'000;
    for (int i = 0; i < kCount; ++i) {
        const auto choice = lights.table.choose(point, random.uniform());
        ASSERT_TRUE(choice);
        const double u = random.uniform();
        const auto s = lights.table.sample(choice->light, point, up, {u, random.uniform()});
        ASSERT_TRUE(s);
        sum += double{s->irradiance.g} * std::max(dot(DVec3(s->wi), DVec3(up)), 0.0) /
               double{choice->probability};
    }
    EXPECT_NEAR(sum / kCount / all, 1.0, 5e-3);
}

}  // namespace
}  // namespace lray::shade
